"""Races of tables: exact responses and NashConv beside a slow reading, and the script's words."""

from functools import cache

import numpy as np
import pytest

import matrixworld as mw
import perfect_learners
import tabular
from evolution_scripts import RESULTS
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
        own = game.random(other(team), rng)
        lazy = tabular.on_the_way(tabular.Task(game, other(team), own, past, weights, rng))
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
    race.run(game.rounds * len(game.succ))
    assert race.nash_conv() == pytest.approx(0.0, abs=1e-9)


def test_schedules_matter_only_if_told_apart_and_far_enough() -> None:
    rng = np.random.default_rng(0)
    same = {name: 0.5 + 0.001 * rng.normal(size=15) for name in "abc"}
    apart = {**same, "c": same["c"] - 0.1}
    wide = {name: 0.5 + rng.normal(size=15) for name in "abc"}
    for found, said in ((same, "do not matter"), (apart, "matter"), (wide, "cannot tell")):
        assert perfect_learners.verdict(found, perfect_learners.friedman(found)) == said
    curves = np.array([[1, 0, 1, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 1]], float)
    at = np.array([0, 1, 2, 4, 8])
    np.testing.assert_array_equal(perfect_learners.settles(curves, at), [4, 0, np.nan])


def test_kept_numbers_begin_as_the_races_do() -> None:
    kept, place = np.load(RESULTS / "perfect_learners/numbers.npz"), 3
    assert [*kept["world"]] == tabular.WORLDS[: len(kept["world"])]
    found = perfect_learners.measured(tabular.WORLDS[place], True)
    # Another SciPy may find another equilibrium.
    names = [name for name in found if name.endswith("/ newest") and "Nash" not in name]
    assert len(names) == 60
    for name in names:
        np.testing.assert_allclose(found[name], kept[name][place, :5], atol=1e-4)
