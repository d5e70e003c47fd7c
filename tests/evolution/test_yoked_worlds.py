"""Yoked races of tables: whom they meet, and what is said of the differences."""

import numpy as np
import pytest

import matrixworld as mw
import perfect_learners
import tabular
import yoked_worlds
from evolution_scripts import RESULTS
from matrixworld.coevolution import TEAMS

GAME = tabular.Game(
    mw.WorldConfig("B", size=3, n_pursuers=1, n_evaders=1, max_steps=3, diagonal=True)
)
SETTINGS = tabular.SCHEDULES[tabular.GENERALISTS], tabular.LEARNERS["perfect where it plays"]


def captured(table: tabular.Table, evaders: tabular.Play) -> float:
    """Return the capture rate of pursuers that play a table, forward from all starts."""
    at_last = GAME.reached("pursuer", table, evaders)[0][0]  # before the last round
    succ, actions = GAME.succ[0], table[0][0]
    after = GAME.payoffs[succ[np.arange(len(succ)), actions]]
    return float((at_last * (after * evaders[0][0]).sum(axis=1)).sum())


def test_a_yoked_race_answers_the_opponents_of_the_other_race() -> None:
    replayed = tabular.Race(GAME, *SETTINGS, 1).run(3)
    yoked = yoked_worlds.YokedRace(replayed, GAME, *SETTINGS, 0).run(3)
    race = tabular.Race(GAME, *SETTINGS, 0)
    for team in TEAMS:
        np.testing.assert_array_equal(yoked.tables[team][0][0], race.tables[team][0][0])
    # Its last pursuers are the best response to the first three evaders of the other race.
    met = GAME.mixed("evader", replayed.tables["evader"][:3], np.full(3, 1 / 3))
    best, last = GAME.respond("pursuer", met)[0], yoked.tables["pursuer"][-1]
    assert captured(last, met) == pytest.approx(captured(best, met))
    expected = GAME.scores(yoked.tables["pursuer"], replayed.tables["evader"])
    np.testing.assert_allclose(yoked.scores("pursuer"), expected)
    expected = 1.0 - GAME.scores(replayed.tables["pursuer"], yoked.tables["evader"]).T
    np.testing.assert_allclose(yoked.scores("evader"), expected)
    # A race that is yoked to itself is that race.
    found = yoked_worlds.played(race, (1, 3))
    assert found == yoked_worlds.played(yoked_worlds.YokedRace(race, GAME, *SETTINGS, 0), (1, 3))
    assert found[1][0][0] == pytest.approx(race.nash_conv(), abs=1e-4)


def test_words_on_differences() -> None:
    rng = np.random.default_rng(0)
    for mean, p, strict, loose in (
        (0.1, 0.01, "pay", "pay"), (-0.1, 0.01, "cost", "cost"), (0.0, 0.9, "alike", "alike"),
        (0.03, 0.01, "pay", "alike"), (0.1, 0.2, "cannot tell", "cannot tell"),
    ):  # fmt: skip
        values = mean + 0.01 * rng.normal(size=9)
        assert yoked_worlds.verdict(values, p, 0.02) == strict
        assert yoked_worlds.verdict(values, p, 0.05) == loose


def test_answers_pay_by_the_difference_of_yoked_races_and_races() -> None:
    shape = (2, 1, 2, len(tabular.CHOICES), len(yoked_worlds.PARTS))
    numbers = {"together": np.array([False, True]), "evaders": np.array([0.5, 0.9]),
               "pursuers": np.array([0.5, 0.1])}  # fmt: skip
    for race in yoked_worlds.RACES:
        numbers |= {f"{race} / race": np.zeros(shape), f"{race} / yoked": np.zeros(shape)}
    kind = yoked_worlds.RACES[0]
    numbers[f"{kind} / yoked"][1, 0, -1, 2, 0] = 0.25  # at once, at last, mixture, all states
    assert yoked_worlds.pay(numbers, ("at once", "mixture", kind)) == [0.25]
    others = [("in turns", "newest", kind), ("at once", "average", kind)]
    assert all(yoked_worlds.pay(numbers, row) == [0.0] for row in others)
    assert yoked_worlds.pay(numbers, ("at once", "mixture", kind), part=1) == [0.0]
    assert yoked_worlds.pay(numbers, ("at once", "mixture", kind), horizon=0) == [0.0]
    numbers["evaders"][1] = 1.0  # the least NashConv of tables is .9, below .95
    assert len(yoked_worlds.pay(numbers, ("at once", "newest", kind))) == 1
    numbers["pursuers"][1] = 0.0
    assert len(yoked_worlds.pay(numbers, ("at once", "newest", kind))) == 0


def test_a_yoked_race_of_a_learner_without_a_past_repeats_the_other_race() -> None:
    game = tabular.Game(tabular.config_of(tabular.WORLDS[2]))
    of = {"together": np.array([False]), "evaders": np.ones(1), "pursuers": np.ones(1)}
    for learner, same in (("linear rating", 1), ("improves what it meets", 0)):
        settings = tabular.SCHEDULES[tabular.SPECIALISTS], tabular.LEARNERS[learner]
        races = [tabular.Race(game, *settings, seed) for seed in range(3)]
        own = [yoked_worlds.played(race, (4,)) for race in races]
        replayed = [*races[1:], races[0]]
        yoked = [
            yoked_worlds.played(yoked_worlds.YokedRace(each, game, *settings, seed), (4,))
            for seed, each in enumerate(replayed)
        ]
        kind = f"{learner}; {tabular.SPECIALISTS}"
        numbers = {**of, f"{kind} / race": np.array([own]), f"{kind} / yoked": np.array([yoked])}
        assert yoked_worlds.repeats(numbers, "in turns", kind) == (same, 1)


def test_kept_numbers_are_those_of_the_races() -> None:
    kept, place = np.load(RESULTS / "yoked_worlds/numbers.npz"), 25
    assert [*kept["world"]] == tabular.WORLDS
    game, kind = tabular.Game(tabular.config_of(tabular.WORLDS[place])), yoked_worlds.RACES[2]
    learner, schedule = kind.split("; ")
    settings = tabular.SCHEDULES[schedule], tabular.LEARNERS[learner]
    races = [tabular.Race(game, *settings, perfect_learners.FIRST_SEED + seed) for seed in (0, 1)]
    found = [yoked_worlds.played(race, (8,)) for race in races]
    first = yoked_worlds.YokedRace(races[1], game, *settings, perfect_learners.FIRST_SEED)
    # Another SciPy may find another equilibrium: not the mixture.
    np.testing.assert_allclose(
        np.array(found)[:, :, :2], kept[f"{kind} / race"][place, :, :1, :2], atol=1e-4
    )
    np.testing.assert_allclose(
        np.array(yoked_worlds.played(first, (8,)))[:, :2],
        kept[f"{kind} / yoked"][place, 0, :1, :2], atol=1e-4,
    )  # fmt: skip
