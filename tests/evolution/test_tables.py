"""Races of tables, also yoked ones: responses and NashConv beside a slow reading."""

from functools import cache

import numpy as np
import pytest

import matrixworld as mw
import tabular
import yoked_worlds
from matrixworld.coevolution import TEAMS, Team
from matrixworld.coevolution.types import other
from matrixworld.solver import solve

CONFIGS = {
    "in turns": mw.WorldConfig("TO", size=3, n_pursuers=2, n_evaders=1, max_steps=2),
    "at once": mw.WorldConfig("B", size=3, n_pursuers=1, n_evaders=1, max_steps=3, diagonal=True),
}


def slow_value(game: tabular.Game, plays: dict[Team, list[np.ndarray]]) -> float:
    """Return the capture rate by recursion; a team without a play answers the other one best."""
    succ, payoffs = [each.tolist() for each in game.succ], game.payoffs.tolist()

    def weighed(team: Team, turn: int, left: int, state: int) -> list[tuple[float, int]]:
        shares = plays[team][turn][left][state]
        return [(float(share), joint) for joint, share in enumerate(shares) if share > 0]

    @cache
    def value(turn: int, left: int, state: int) -> float:
        if left < 0:
            return payoffs[state]
        after = (turn + 1, left) if turn + 1 < len(succ) else (0, left - 1)
        rows = [[value(*after, each) for each in row] for row in succ[turn][state]]
        if "pursuer" in plays:
            sums = [0.0] * len(rows[0])
            for share, p in weighed("pursuer", turn, left, state):
                sums = [total + share * each for total, each in zip(sums, rows[p], strict=True)]
            if "evader" not in plays:
                return min(sums)
            return sum(share * sums[e] for share, e in weighed("evader", turn, left, state))
        shares = weighed("evader", turn, left, state)
        return max(sum(share * row[e] for share, e in shares) for row in rows)

    return float(np.mean([value(0, game.rounds - 1, int(start)) for start in game.starts]))


@pytest.mark.parametrize("name", CONFIGS)
def test_responses_and_payoffs_agree_with_a_slow_reading(name: str) -> None:
    game, rng = tabular.Game(CONFIGS[name]), np.random.default_rng(0)
    weights = np.array([0.5, 0.3, 0.2])
    for team in TEAMS:
        past = [game.random(team, rng) for _ in weights]
        play = game.mixed(team, past, weights)
        answer, rate = game.respond(other(team), play)
        assert rate == pytest.approx(slow_value(game, {team: play}))
        one = np.ones(1)
        answered = {team: play, other(team): game.mixed(other(team), [answer], one)}
        assert rate == pytest.approx(slow_value(game, answered))
        # Off the way to where both lead nothing changes.
        lazy = tabular.on_the_way(game, other(team), game.random(other(team), rng), past, weights,
                                  rng)  # fmt: skip
        answered[other(team)] = game.mixed(other(team), [lazy], one)
        assert rate == pytest.approx(slow_value(game, answered))
        sides = ([answer], past) if team == "evader" else (past, [answer])
        pairs = [
            {
                team: game.mixed(team, [each], one),
                other(team): game.mixed(other(team), [answer], one),
            }
            for each in past
        ]
        expected = [slow_value(game, each) for each in pairs]
        np.testing.assert_allclose(game.scores(*sides).ravel(), expected)


@pytest.mark.parametrize("name", CONFIGS)
def test_perfect_play_has_no_better_response(name: str) -> None:
    game = tabular.Game(CONFIGS[name])
    solution = solve(game.states)
    for team in TEAMS:
        play = [
            np.stack(
                [solution.probabilities(team, left, turn) for left in range(1, game.rounds + 1)]
            )
            for turn in range(game.states.n_turns)
        ]
        assert game.guarantee(team, play) == pytest.approx(solution.value, abs=1e-6)


def test_perfect_specialists_play_one_turn_more_perfectly_in_each_generation() -> None:
    game = tabular.Game(CONFIGS["in turns"])
    race = tabular.Race(
        game, tabular.SCHEDULES[tabular.SPECIALISTS], tabular.LEARNERS["perfect"], 0
    )
    for _ in range(game.rounds * len(game.succ)):
        race.go()
    assert race.nash_conv() == pytest.approx(0.0, abs=1e-9)


GAME = tabular.Game(CONFIGS["at once"])
SETTINGS = tabular.SCHEDULES[tabular.GENERALISTS], tabular.LEARNERS["perfect where it plays"]


def raced(race: tabular.Race) -> tabular.Race:
    for _ in range(3):
        race.go()
    return race


def captured(table: tabular.Table, evaders: tabular.Play) -> float:
    """Return the capture rate of pursuers that play a table, forward from all starts."""
    at_last = GAME.reached("pursuer", table, evaders)[0][0]  # before the last round
    succ, actions = GAME.succ[0], table[0][0]
    after = GAME.payoffs[succ[np.arange(len(succ)), actions]]
    return float((at_last * (after * evaders[0][0]).sum(axis=1)).sum())


def test_a_yoked_race_answers_the_opponents_of_the_other_race() -> None:
    replayed = raced(tabular.Race(GAME, *SETTINGS, 1))
    yoked = raced(yoked_worlds.YokedRace(replayed, GAME, *SETTINGS, 0))
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
    same, own = raced(race), yoked_worlds.YokedRace(race, GAME, *SETTINGS, 0)
    assert yoked_worlds.shortfalls(raced(own), "newest") == yoked_worlds.shortfalls(same, "newest")
