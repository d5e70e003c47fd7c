"""Data sets of Minari, against environments that play the same actions again."""

import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from command_line import matrixworld_command
from matrixworld.coevolution import TEAMS
from matrixworld.episodes.record import Recorder
from matrixworld.integrations.minari import to_minari
from matrixworld.version import MissingExtraError
from rows import NAMES, config_of

COSTS = ("cost", "cost_obstacle", "cost_teammate", "cost_adversary")
CONFIG = config_of("SD")


@pytest.fixture
def library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    """Minari, which keeps its data sets in an empty directory."""
    pytest.importorskip("h5py")
    monkeypatch.setenv("MINARI_DATASETS_PATH", str(tmp_path))
    return pytest.importorskip("minari")


def played(config: mw.WorldConfig = CONFIG, n: int = 3) -> list[mw.Episode]:
    return [mw.record(config, "random", "random", seed=5, episode=number) for number in range(n)]


@pytest.mark.filterwarnings("ignore:these rules can never capture")
@pytest.mark.parametrize("name", NAMES)
def test_an_environment_gives_what_is_loaded(name: str, library: Any) -> None:
    given = config_of(name, obstacles=0.2)
    for team in TEAMS:
        to_minari(played(given), f"pursuit/{team}-v0", team=team)
    both = [library.load_dataset(f"pursuit/{team}-v0") for team in TEAMS]
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


def test_costs_are_not_all_zero(library: Any) -> None:
    costs = [episode.infos["cost"] for episode in to_minari(played(), "random-v0")]
    assert sum(of_agent.sum() for cost in costs for of_agent in cost.values()) > 10


OTHER = replace(played(n=1)[0], rewards=played(n=1)[0].rewards + 1)
REFUSED: dict[str, tuple[Callable[[], Any], type[Exception], str]] = {
    "name": (lambda: to_minari(played(), "../a-v0"), ValueError, "^dataset_id: expected a name"),
    "no version": (lambda: to_minari(played(), "a"), ValueError, "^dataset_id: expected a name"),
    "team": (lambda: to_minari(played(), "a-v0", team="both"), ValueError, "^team: expected one"),
    "none": (lambda: to_minari([], "a-v0"), ValueError, "^episodes: expected at least one"),
    "one": (lambda: to_minari(played()[0], "a-v0"), TypeError, "^episodes: expected a sequence"),
    "kind": (lambda: to_minari([3], "a-v0"), TypeError, "^episodes: expected a matrixworld.Epis"),
    "worlds": (
        lambda: to_minari([*played(), *played(config_of("O"))], "a-v0"),
        ValueError,
        "^episodes: expected steps in one world",
    ),
    "course": (lambda: to_minari([OTHER], "a-v0"), ValueError, "^episodes: expected to play again"),
    "metadata": (lambda: to_minari(played(), "a-v0", seed=CONFIG), TypeError, "JSON"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_nothing_is_written_of_what_is_refused(case: str, library: Any, tmp_path: Path) -> None:
    call, error, message = REFUSED[case]
    with pytest.raises(error, match=message):
        call()
    assert not list(tmp_path.iterdir())


def test_nothing_is_left_of_what_is_interrupted(
    library: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    to_minari(played(), "pursuit/a-v0", author="A. Author")
    with pytest.raises(FileExistsError, match="^dataset_id: expected a new name"):
        to_minari(played(), "pursuit/a-v0")
    files = sorted(tmp_path.rglob("*"))
    episode, calls = Recorder.episode, iter([True, False])

    def interrupted(recorder: Recorder) -> mw.Episode:
        if next(calls):
            return episode(recorder)
        raise KeyboardInterrupt

    recorded = played()
    monkeypatch.setattr(Recorder, "episode", interrupted)
    with pytest.raises(KeyboardInterrupt):
        to_minari(recorded, "pursuit/b-v0")
    assert sorted(tmp_path.rglob("*")) == files
    assert library.load_dataset("pursuit/a-v0").storage.metadata["author"] == {"A. Author"}


def test_a_command_writes_the_match_of_scripts_or_of_a_run(library: Any, race: Path) -> None:
    world = {"rows": 9, "cols": 9, "obstacles": 0.1}
    game = [word for name, value in world.items() for word in (f"--{name}", value)]
    written = "--minari", "pursuit/sb-v0", "--episodes", 2, "--episode", 3, "--seed", 7
    said = matrixworld_command("replay", "SB", *game, "--steps", 9, *written).stdout
    assert said.startswith("2 episodes, 18 steps ")
    config = mw.WorldConfig("SB", max_steps=9, **world)
    expected = [mw.record(config, "chaser", "fleer", seed=7, episode=number) for number in (3, 4)]
    data = library.load_dataset("pursuit/sb-v0")
    told = {"algorithm_name": "chaser", "evaders": "fleer", "seed": 7, "world": config.to_json()}
    assert told.items() <= data.storage.metadata.items()
    for episode, ours in zip(data, expected, strict=True):
        actions = np.stack([episode.actions[f"pursuer_{n}"] for n in range(20)], axis=1)
        np.testing.assert_array_equal(actions, ours.actions[:, :20])
    matrixworld_command("replay", race, "--pursuer", 1, "--minari", "run-v0", "--episodes", 2)
    data = library.load_dataset("run-v0")
    assert data.storage.metadata["algorithm_name"] == f"{race}: 1"
    assert len(data) == 2


def test_a_missing_library_is_named_with_its_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "minari", None)
    with pytest.raises(MissingExtraError, match=r"matrixworld-pursuit\[minari\]"):
        to_minari(played(), "a-v0")
