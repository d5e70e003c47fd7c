"""Jobs as users of Gymnasium, PettingZoo, pyribs, DEAP and scikit-learn guess them.

Each first guess works, or its error names the right call.
"""

import re
from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import plots
from matrixworld.coevolution import score
from tiny_race import TINY, tiny_race

SMALL = {"size": 8, "n_pursuers": 2, "n_evaders": 2, "max_steps": 20}
RACE = {name: TINY[name] for name in TINY if name not in ("rows", "cols", "seed")}
RACE |= {"size": 6, "pursuer_epochs": 2, "evader_epochs": 2}


def names_the_call(guess, error, call):
    with pytest.raises(error, match=re.escape(call)):
        guess()


@pytest.fixture(scope="module")
def run(race):
    return mw.open_run(race)


class Climber:
    """A learner by the habits of other libraries."""

    def ask(self):
        return np.zeros(3)

    def tell(self, fitness): ...


LEARNER = "class derived from Learner (docs/how_to_add.md)"
GUESSES = [
    (lambda run: mw.make_vec("SB", n_envs=64), "did you mean num_envs?"),
    (lambda run: run.payoff_matrix, "did you mean run.payoff()?"),
    (lambda run: run.resume(generations=25), "did you mean run.extend(generations="),
    (
        lambda run: mw.make(run.settings.game.world, opponent=run.best("evader")),
        "team: expected one of",
    ),
    (lambda run: mw.plot, "mw.plots.payoff_heatmap(run.payoff()) or mw.plots.ciao_triangles(run.p"),
    (lambda run: mw.evaluate, "mw.score_policy(policy,"),
    (lambda run: mw.evolve("O", "a", learner=Climber), LEARNER),
    (lambda run: mw.evolve("O", "a", learner=Climber()), LEARNER),
    (lambda run: mw.Rules(obstacle="jump"), "expected one of DISAPPEAR, REACH, BOUNCE, got 'jump'"),
]


@pytest.mark.parametrize(("guess", "call"), GUESSES)
def test_an_error_names_the_right_call(guess, call, run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names_the_call(lambda: guess(run), (AttributeError, TypeError, ValueError), call)
    assert list(tmp_path.iterdir()) == []


def test_a_race_has_a_payoff_matrix(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run = mw.evolve(variant="O", generations=3, **RACE)
    assert np.asarray(run.payoff()).shape == (4, 4)
    assert run.path == Path("runs/O-seed0")
    # The same settings by their paths, and the same race.
    twin = mw.evolve("O", "twin", seeds=[0], generations=3, **RACE)[0]
    assert twin.settings == run.settings
    np.testing.assert_array_equal(twin.payoff(), run.payoff())


def test_a_matrix_and_a_run_are_judged_and_drawn(run):
    matrix = np.linspace(0, 1, 144).reshape(12, 12)
    assert mw.judge(matrix) == mw.analysis.judge(matrix)
    # A payoff keeps the episodes, without which less can be told.
    rates = run.payoff().scores
    expected = mw.analysis.judge(rates, per_episode=True)
    assert mw.judge(run) == mw.judge(run.payoff()) == mw.judge(run.path) == expected
    assert mw.judge([run]) == expected
    assert plots.payoff_heatmap(run.payoff()).axes
    assert plots.ciao_triangles(run.payoff()).axes


def looks_at_one(observation):
    """Go to where the first evader in view is; of several observations it makes nothing."""
    rows, cols = np.nonzero(observation[0])
    if not len(rows):
        return mw.Action.NORTH
    return mw.Action.EAST if cols[0] > 5 else mw.Action.WEST


def test_a_function_of_one_agent_is_scored():
    config = mw.WorldConfig("O", **SMALL)
    asked = {"team": "pursuer", "config": config, "episodes": 100}
    of_one = mw.score_policy(looks_at_one, opponents={"fleer": "fleer"}, **asked)
    of_all = mw.score_policy(
        lambda seen: [looks_at_one(each) for each in seen], opponents={"fleer": "fleer"}, **asked
    )
    np.testing.assert_array_equal(of_one.rates, of_all.rates)
    assert of_one.rates.shape == (1, 1, 100)


def test_environments_play_the_best_of_a_run(run):
    world, best = run.settings.game.world, run.best("evader")
    env = mw.make(world, team="pursuer", opponent=best)
    assert env.possible_agents == [f"pursuer_{i}" for i in range(world.n_pursuers)]
    assert mw.make_vec(world, 2, team="pursuer", opponent=best).agents == range(world.n_pursuers)


def test_rules_are_given_by_name():
    rules = mw.Rules(obstacle="bounce", evader="Bounce", capture="surround")
    outcome = mw.Outcome.BOUNCE
    assert rules == mw.Rules(obstacle=outcome, evader=outcome, capture=mw.Capture.SURROUND)


@pytest.mark.usefixtures("no_processes")
def test_two_groups_are_compared(tmp_path):
    runs = [tiny_race(seed=seed) for seed in range(2)]
    one = mw.evolve(runs, tmp_path / "one")
    other = mw.evolve([each.changed({"learner": "ga"}) for each in runs], tmp_path / "other")
    found = mw.compare(one, other)
    name = "pursuers against held-out opponents, capture rate"
    scores = [[score(run)["pursuer"].rates[-1].mean() for run in group] for group in (one, other)]
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


@pytest.mark.parametrize("name", ["env", "vec_env", "train", "Env", "load_run", "load_runs"])
def test_names_of_the_field_say_the_right_call(name):
    with pytest.raises(AttributeError, match=r"did you mean mw\.") as caught:
        getattr(mw, name)
    call = re.findall(r"mw\.(\w+)\(", str(caught.value))[0]
    assert call in mw.__all__
