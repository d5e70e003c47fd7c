"""Data sets of Minari, against environments that play the same actions again."""

import importlib
from dataclasses import replace

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.world.policy import TEAMS
from rows import NAMES, config_of

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning:minari")  # of missing metadata

COSTS = ("cost", "cost_obstacle", "cost_teammate", "cost_adversary")
CONFIG = config_of("SD")


@pytest.fixture
def library(tmp_path, monkeypatch):
    """Minari, which keeps its data sets in an empty directory."""
    pytest.importorskip("h5py")  # one by one: .ci/run repeats what was skipped
    monkeypatch.setenv("MINARI_DATASETS_PATH", str(tmp_path))
    return pytest.importorskip("minari")


def to_minari(*args, **keywords):
    """Call the function of the recipe, which imports the library."""
    return importlib.import_module("minari_episodes").to_minari(*args, **keywords)


def played(config=CONFIG, n=3):
    return [mw.record(config, "random", "random", seed=5, episode=number) for number in range(n)]


@pytest.mark.filterwarnings("ignore:these rules can never capture")
@pytest.mark.parametrize("name", NAMES)
def test_an_environment_gives_what_is_loaded(name, library):
    given = config_of(name, obstacles=0.2)
    for team in TEAMS:
        to_minari(played(given), f"pursuit/{team}-v0", team=team)
    both = [library.load_dataset(f"pursuit/{team}-v0") for team in TEAMS]
    paid = sum(array.sum() for each in both for e in each for array in e.infos["cost"].values())
    assert paid > 0
    config = mw.WorldConfig.from_json(both[0].storage.metadata["world"])
    assert config.to_json() == given.to_json()
    options = [told["options"] for told in both[0].storage.get_episode_metadata(range(3))]
    for start, *teams in zip(options, *both, strict=True):
        actions = teams[0].actions | teams[1].actions
        seen = teams[0].observations | teams[1].observations
        env = mw.aec_env(config)
        env.reset(options=start)
        for agent in env.agent_iter():
            view, _, terminated, truncated, _ = env.last()
            step, ended = env.unwrapped.world.steps, terminated or truncated
            if not ended:
                np.testing.assert_array_equal(view, seen[agent][step])
            env.step(None if ended else actions[agent][step])
        parallel = mw.parallel_env(config)
        parallel.reset(options=start)
        for step in range(len(teams[0])):
            living = {agent: actions[agent][step] for agent in parallel.agents}
            views, rewards, _, _, infos = parallel.step(living)
            for team, episode in zip(TEAMS, teams, strict=True):
                earned = [rewards[agent] for agent in rewards if agent.startswith(team)]
                assert episode.rewards[step] == pytest.approx(sum(earned), abs=1e-4)
                for agent in episode.actions:
                    of_agent = {key: episode.infos[key][agent][step + 1] for key in episode.infos}
                    alive = parallel.world.alive[parallel._index[agent]]
                    assert of_agent.pop("alive") == alive
                    assert alive or not seen[agent][step + 1].any()
                    assert of_agent.pop("reward") == pytest.approx(rewards.get(agent, 0))
                    told = infos.get(agent, dict.fromkeys(COSTS, 0.0))
                    assert of_agent == {key: told[key] for key in COSTS}
            last = step == len(teams[0]) - 1
            for episode in teams:
                assert episode.terminations[step] == (last and parallel.world.terminated)
                assert episode.truncations[step] == (last and not parallel.world.terminated)
        for agent, view in views.items():
            np.testing.assert_array_equal(seen[agent][-1], view)


OTHER = replace(played(n=1)[0], positions=played(n=1)[0].positions[:, ::-1].copy())
REFUSED = {"one world": [*played(n=1), *played(config_of("O"), n=1)], "as it was recorded": [OTHER]}


@pytest.mark.parametrize("message", REFUSED)
def test_nothing_is_written_of_what_is_refused(message, library, tmp_path):
    with pytest.raises(ValueError, match=message):
        to_minari(REFUSED[message], "a-v0")
    assert not list(tmp_path.iterdir())


def test_metadata_is_that_of_the_library_and_any_other(library):
    storage = to_minari(played(), "pursuit/a-v0", author="A. Author", seed=5).storage
    told = {"author": {"A. Author"}, "seed": 5, "world": CONFIG.to_json()}
    assert told.items() <= storage.metadata.items()
