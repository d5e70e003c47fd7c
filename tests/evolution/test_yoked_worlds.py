"""Yoked races of tables: whom they meet, and what is said of the differences."""

import numpy as np
import pytest

import matrixworld as mw
import tabular
import yoked_worlds
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
    same, own = race.run(3), yoked_worlds.YokedRace(race, GAME, *SETTINGS, 0)
    assert yoked_worlds.shortfalls(own.run(3), "newest") == yoked_worlds.shortfalls(same, "newest")


def test_words_on_differences() -> None:
    rng = np.random.default_rng(0)
    for mean, p, said in (
        (0.1, 0.01, "pay"), (-0.1, 0.01, "cost"), (0.0, 0.9, "alike"), (0.1, 0.2, "cannot tell"),
    ):  # fmt: skip
        assert yoked_worlds.verdict(mean + 0.01 * rng.normal(size=9), p) == said
    seeds = np.stack([each + 0.01 * rng.normal(size=20) for each in (0.1, -0.1, 0.0)])
    assert yoked_worlds.single_worlds(seeds) == (1, 1)
    strengths = np.add.outer([0.1, 0.2, 0.4], [0.0, 0.3, 0.1])
    assert yoked_worlds.interaction(strengths) == pytest.approx(0.0, abs=1e-9)
    assert yoked_worlds.interaction(np.eye(2)) == pytest.approx(1.0)
