"""Races of tables: exact responses and NashConv beside a slow reading, and the script's words."""

import itertools
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


def slow_value(
    game: tabular.Game, plays: dict[Team, list[np.ndarray]], kept: list[np.ndarray] | None = None
) -> float:
    """Return the capture rate by recursion; a team without a play answers the other one best.

    Where states are not `kept`, both teams play as well as they can.
    """
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
        if kept is not None and not kept[turn][left][state]:
            matrix = np.array(rows)
            first, second = tabular.equilibrium(matrix)
            assert (first @ matrix).min() == pytest.approx((matrix @ second).max())
            return float(first @ matrix @ second)
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
def test_states_that_are_not_kept_are_played_as_well_as_possible(name: str) -> None:
    game, rng = tabular.Game(CONFIGS[name]), np.random.default_rng(0)
    for team in TEAMS:
        table, rival = game.random(team, rng), game.random(other(team), rng)
        plays = {
            side: game.mixed(side, [each], np.ones(1))
            for side, each in ((team, table), (other(team), rival))
        }
        met = game.met(plays["pursuer"], plays["evader"])
        often = game.reached(team, table, plays[other(team)])
        assert all((a == (b > 0.0)).all() for a, b in zip(met, often, strict=True))
        kept = [rng.random(each.shape) < 0.5 for each in met]
        for some in (met, kept):
            expected = slow_value(game, {team: plays[team]}, some)
            assert game.guarantee(team, plays[team], some) == pytest.approx(expected, abs=1e-6)
        nothing = [np.zeros_like(each) for each in met]
        assert game.guarantee(team, plays[team], nothing) == pytest.approx(game.value, abs=1e-6)


def test_tables_have_a_least_nash_conv_which_some_pair_has() -> None:
    assert tabular.Game(CONFIGS["in turns"]).mixing == 0.0
    game, rng = tabular.Game(tabular.config_of(tabular.WORLDS[29])), np.random.default_rng(0)
    captures, concedes = game.of_tables
    assert captures + 0.1 < game.value < concedes
    for _ in range(20):
        for team, best in zip(TEAMS, (captures, -concedes), strict=True):
            play = game.mixed(team, [game.random(team, rng)], np.ones(1))
            assert game.guarantee(team, play) * (1 if team == "pursuer" else -1) <= best + 1e-9
    # The tables that play best if the other team moves second have it.
    for team, sign, best in zip(TEAMS, (1, -1), (captures, concedes), strict=True):
        table, after = [np.zeros(shape[:2], np.int16) for shape in game.shapes(team)], game.payoffs
        for left in range(game.rounds):
            ends = sign * after[game.succ[0]]
            worst = ends.min(axis=2 if team == "pursuer" else 1)
            table[0][left], after = worst.argmax(axis=1), sign * worst.max(axis=1)
        play = game.mixed(team, [table], np.ones(1))
        assert game.guarantee(team, play) == pytest.approx(best, abs=1e-9)


def test_a_linear_rating_plays_alike_in_all_rounds_and_better_against_those_it_meets() -> None:
    game, rng = tabular.Game(CONFIGS["at once"]), np.random.default_rng(0)
    for team in TEAMS:
        own = [np.zeros(shape[:2], np.int16) for shape in game.shapes(team)]
        met = [game.random(other(team), rng)]
        table = tabular.rated(tabular.Task(game, team, own, met, np.ones(1), rng))
        assert all((each == each[0]).all() for each in table)
        sides = ([own, table], met) if team == "pursuer" else (met, [own, table])
        before, after = game.scores(*sides).ravel()
        best = game.respond(team, game.mixed(other(team), met, np.ones(1)))[1]
        assert (after - before) / (best - before) > 0.6
    # Offsets, cells and captures of the first start, counted by hand.
    cells = game.states.cells()[game.starts[0]]
    (down, right), (down_e, right_e) = (divmod(int(cell), 3) for cell in cells)
    expected = np.zeros(28)
    expected[cells[0]] = expected[9 + cells[1]] = 1.0
    expected[18 + abs(down - down_e) * 3 + abs(right - right_e)] = 1.0
    np.testing.assert_array_equal(game.features[0][game.starts[0]], expected)


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
    apart = {**same, "c": same["c"] - 0.04}
    wide = {name: 0.5 + rng.normal(size=15) for name in "abc"}
    for found, strict, loose in (
        (same, "do not matter", "do not matter"), (apart, "matter", "do not matter"),
        (wide, "cannot tell", "cannot tell"),
    ):  # fmt: skip
        p = perfect_learners.friedman(found)
        assert perfect_learners.verdict(found, p, 0.02) == strict
        assert perfect_learners.verdict(found, p, 0.05) == loose
    assert perfect_learners.farthest(np.array([[0.1, 0.3], [-0.2, -0.2]])) == pytest.approx(
        0.2 + 12.706 * 0.1, abs=1e-3
    )
    curves = np.array([[1, 0, 1, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 1]], float)
    at = np.array([0, 1, 2, 4, 8])
    np.testing.assert_array_equal(perfect_learners.settles(curves, at, 0.01), [4, 0, np.nan])


def test_simulated_numbers_have_no_difference_or_the_margin() -> None:
    rng = np.random.default_rng(0)
    found = {name: rng.random(9) for name in tabular.SCHEDULES}
    rows = {("in turns", "newest", learner): found for learner in ("a", "b")}
    simulated = [*itertools.islice(perfect_learners.without_difference(rows), 50)]
    for one in simulated[:5]:
        first, second = ({name: [*each] for name, each in of.items()} for of in one.values())
        assert first == second  # the same exchange for all learners
        np.testing.assert_array_equal(
            np.sort([*one["in turns", "newest", "a"].values()], axis=0),
            np.sort([*found.values()], axis=0),
        )
    moved = np.mean([one["in turns", "newest", "a"]["specialists"] for one in simulated])
    assert moved == pytest.approx(np.mean([*found.values()]), abs=0.05)
    apart = [*perfect_learners.with_difference(found, 0.1)]
    means = np.mean([[each.mean() for each in one.values()] for one in apart], axis=0)
    np.testing.assert_allclose(means, [0.1, *[0.0] * 5], atol=0.03)


def test_kept_numbers_begin_as_the_races_do() -> None:
    kept, place = np.load(RESULTS / "perfect_learners/numbers.npz"), 25
    assert [*kept["world"]] == tabular.WORLDS
    found = perfect_learners.measured(tabular.WORLDS[place], True)
    # Another SciPy may find another equilibrium.
    names = [name for name in found if name.endswith("/ curve") and "Nash" not in name]
    assert len(names) == 25
    for name in names:
        np.testing.assert_allclose(found[name], kept[name][place, :5], atol=1e-4)
        first = name.replace("curve", "newest")
        np.testing.assert_allclose(found[first][0], kept[first][place, 0], atol=1e-4)
