"""Fourteen jobs as users of Gymnasium, PettingZoo, pyribs, DEAP and scikit-learn guess them.

Each first guess works, or its error names the right call, which works then.
"""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import coevolution, plots, replay
from tiny_race import TINY, tiny_race

SMALL: dict[str, Any] = {"size": 8, "n_pursuers": 2, "n_evaders": 2, "max_steps": 20}
RACE: dict[str, Any] = {name: TINY[name] for name in TINY if name not in ("rows", "cols", "seed")}
RACE |= {"size": 6, "pursuer_epochs": 2, "evader_epochs": 2}


def names_the_call(guess: Callable[[], Any], error: type[Exception], call: str) -> None:
    with pytest.raises(error, match=re.escape(call)):
        guess()


@pytest.fixture(scope="module")
def run(race: Path) -> coevolution.SavedRun:
    return mw.open_run(race)


def test_1_an_environment_plays_at_random_and_is_drawn() -> None:
    env = mw.make("SB", n_pursuers=4, n_evaders=2, size=10, render_mode="rgb_array")
    env.reset(seed=0)
    while env.agents:
        env.step({agent: env.action_space(agent).sample() for agent in env.agents})
    assert env.state().shape == (3, 10, 10)
    assert env.render().ndim == 3


def test_2_many_worlds_step_together() -> None:
    names_the_call(lambda: mw.make_vec("SB", n_envs=64), TypeError, "did you mean num_envs?")
    names_the_call(lambda: mw.VectorEnv("SB", n_envs=64), TypeError, "did you mean n_worlds?")
    envs = mw.make_vec("SB", num_envs=64, size=10, n_pursuers=4, n_evaders=2)
    envs.reset(seed=0)
    for _ in range(100):
        observations, *_ = envs.step(envs.action_space.sample())
    assert observations.shape == (64, 6, 3, 11, 11)


def test_3_a_race_has_a_payoff_matrix(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    run = mw.evolve(variant="O", generations=3, **RACE)
    names_the_call(lambda: run.payoff_matrix, AttributeError, "did you mean run.payoff()?")
    names_the_call(lambda: np.asarray(run.payoff), TypeError, "did you mean payoff()?")
    assert np.asarray(run.payoff()).shape == (4, 4)
    assert run.path == Path("runs/O-seed0")
    # The same settings by their paths, and the same race.
    twin = mw.evolve("O", "twin", seeds=[0], generations=3, **RACE)[0]
    assert twin.settings == run.settings
    np.testing.assert_array_equal(twin.payoff(), run.payoff())


def test_4_the_best_pursuers_of_a_run_play_a_script(
    run: coevolution.SavedRun, tmp_path: Path
) -> None:
    names_the_call(lambda: mw.load_run, AttributeError, "did you mean mw.open_run(directory)?")
    best = run.best("pursuer")
    episode = mw.record(run.settings.world, best, "fleer")
    save = "mw.replay.save(episode, path)"
    names_the_call(lambda: episode.save(tmp_path / "a.gif"), ValueError, save)
    replay.save(episode, tmp_path / "a.gif")
    assert (tmp_path / "a.gif").stat().st_size > 0
    # It is the population of one that every rollout plays.
    twin = mw.record(run.settings.world, best.population(), "fleer")
    np.testing.assert_array_equal(episode.actions, twin.actions)


def test_5_a_matrix_and_a_run_are_judged(run: coevolution.SavedRun) -> None:
    matrix = np.linspace(0, 1, 144).reshape(12, 12)
    assert mw.judge(matrix) == mw.analysis.judge(matrix)
    # A payoff keeps the episodes, without which less can be told.
    rates = run.payoff().scores
    expected = mw.analysis.judge(rates, per_episode=True)
    assert mw.judge(run) == mw.judge(run.payoff()) == mw.judge(run.path) == expected
    assert mw.judge([run]) == expected


def test_6_payoff_and_ciao_are_drawn(run: coevolution.SavedRun) -> None:
    hint = "mw.plots.payoff_heatmap(run.payoff()) or mw.plots.ciao_triangles(run.payoff())"
    names_the_call(lambda: mw.plot, AttributeError, hint)
    assert plots.payoff_heatmap(run.payoff()).axes
    assert plots.ciao_triangles(run.payoff()).axes


def looks_at_one(observation: np.ndarray) -> int:
    """Go to where the first evader in view is; of several observations it makes nothing."""
    rows, cols = np.nonzero(observation[0])
    if not len(rows):
        return mw.Action.NORTH
    return mw.Action.EAST if cols[0] > 5 else mw.Action.WEST


def test_7_a_function_of_one_agent_is_scored() -> None:
    names_the_call(lambda: mw.evaluate, AttributeError, "mw.score_policy(policy,")
    config = mw.WorldConfig("O", **SMALL)
    asked: dict[str, Any] = {"team": "pursuer", "config": config, "episodes": 100}
    of_one = mw.score_policy(looks_at_one, opponents={"fleer": "fleer"}, **asked)
    of_all = mw.score_policy(
        lambda seen: [looks_at_one(each) for each in seen], opponents={"fleer": "fleer"}, **asked
    )
    np.testing.assert_array_equal(of_one.rates, of_all.rates)
    assert of_one.rates.shape == (1, 1, 100)


class Climber:
    """A learner by the habits of other libraries."""

    def __init__(self, n_params: int, seed: int) -> None:
        self.x = np.random.default_rng(seed).normal(size=n_params)

    def ask(self) -> np.ndarray:
        return self.x

    def tell(self, fitness: np.ndarray) -> None: ...


def test_8_a_learner_of_ones_own_is_derived_from_learner(tmp_path: Path) -> None:
    call = "class derived from Learner (docs/how_to_add.md)"
    for learner in (Climber, Climber(3, 0)):
        names_the_call(
            lambda learner=learner: mw.evolve("O", tmp_path / "a", learner=learner), TypeError, call
        )
    assert list(tmp_path.iterdir()) == []
    assert "## A learner" in (Path(__file__).parents[1] / "docs/how_to_add.md").read_text(
        encoding="utf-8"
    )


def test_9_a_race_goes_on(run: coevolution.SavedRun) -> None:
    call = "did you mean run.extend(generations="
    names_the_call(lambda: run.resume(generations=25), AttributeError, call)


def test_10_environments_play_the_best_of_a_run(run: coevolution.SavedRun) -> None:
    world, best = run.settings.world, run.best("evader")
    env = mw.make(world, team="pursuer", opponent=best)
    assert env.possible_agents == [f"pursuer_{i}" for i in range(world.n_pursuers)]
    assert mw.make_vec(world, 2, team="pursuer", opponent=best).agents == range(world.n_pursuers)
    names_the_call(lambda: mw.make(world, opponent=best), ValueError, "team: expected one of")


def test_10_ppo_learns_against_evolved_evaders(run: coevolution.SavedRun) -> None:
    pytest.importorskip("stable_baselines3")
    from stable_baselines3 import PPO

    from matrixworld.envs.stable_baselines3 import vec_env

    world, best = run.settings.world, run.best("evader")
    names_the_call(lambda: vec_env(world, opponent=best), TypeError, "did you mean evaders?")
    PPO("MlpPolicy", vec_env(world, evaders=best), n_steps=8, batch_size=32).learn(100)


def test_11_a_small_world_is_solved() -> None:
    config = mw.WorldConfig("O", size=3, n_pursuers=2, n_evaders=1, max_steps=3)
    assert 0 < mw.solve(config).value < 1
    assert mw.solver.solve is mw.solve


def test_12_rules_are_given_by_name() -> None:
    rules = mw.Rules(obstacle="bounce", evader="Bounce", capture="surround")
    outcome = mw.Outcome.BOUNCE
    assert rules == mw.Rules(obstacle=outcome, evader=outcome, capture=mw.Capture.SURROUND)
    call = "obstacle: expected one of DISAPPEAR, REACH, BOUNCE, got 'jump'"
    names_the_call(lambda: mw.Rules(obstacle="jump"), ValueError, call)


def test_13_infos_have_the_masks() -> None:
    env = mw.make("O", **SMALL, action_mask=True)
    _, infos = env.reset(seed=0)
    actions = {a: env.action_space(a).sample(infos[a]["action_mask"]) for a in env.agents}
    env.step(actions)
    assert not env.status.involved[:, 0].any()  # nobody ran into the border


@pytest.mark.usefixtures("no_processes")
def test_14_two_groups_are_compared(tmp_path: Path) -> None:
    runs = [tiny_race(seed=seed) for seed in range(3)]
    one = mw.evolve(runs, tmp_path / "one")
    other = mw.evolve([each.changed({"learner": "ga"}) for each in runs], tmp_path / "other")
    found = mw.compare(one, other)
    name = "pursuers against held-out opponents, capture rate"
    scores = [
        [coevolution.score(run)["pursuer"].rates[-1].mean() for run in group]
        for group in (one, other)
    ]
    expected = mw.analysis.difference_of_runs(*scores, paired=True)
    assert found.differences[name].ends == pytest.approx(expected.ends)
    assert found.means[name] == pytest.approx(tuple(map(np.mean, scores)))
    assert mw.compare(tmp_path / "one", other[::-1]) == found
    low, high = mw.compare(one[0], other[0]).differences[name].ends  # over episodes
    assert low < scores[0][0] - scores[1][0] < high
    # What is equal cannot be told apart, what is far apart can.
    assert {mw.compare(one, one).verdict(each) for each in found.means} == {"cannot tell"}
    rng = np.random.default_rng(0)
    close = rng.uniform(0.4, 0.6, (6, 8, 8))
    rising = np.clip(close + np.linspace(-0.4, 0.4, 8)[:, None], 0, 1)
    gain = "gain of the pursuers"
    assert mw.compare(rising, close).verdict(gain) == "higher"
    assert mw.compare(close, rising).verdict(gain) == "lower"
    names_the_call(lambda: mw.judge([*one, *other]), ValueError, "differ in their seed only")


@pytest.mark.parametrize("name", ["env", "vec_env", "train", "Env", "load_runs"])
def test_names_of_the_field_say_the_right_call(name: str) -> None:
    with pytest.raises(AttributeError, match=r"did you mean mw\.") as caught:
        getattr(mw, name)
    call = re.findall(r"mw\.(\w+)\(", str(caught.value))[0]
    assert call in mw.__all__
