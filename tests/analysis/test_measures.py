"""The measures of matrixworld.analysis on matrices whose answer is known, and all of runs."""

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats
from scipy.optimize import minimize
from scipy.special import expit
from scipy.stats import t

from matrices import circular, logistic, payoffs, quadruples
from matrixworld import analysis
from matrixworld.analysis.cycles import (
    MARGIN,
    strongest_checkerboards,
    transitive_share_over_episodes,
)
from matrixworld.analysis.games import game_value
from matrixworld.analysis.progress import Disengagement, lag_rise
from matrixworld.analysis.ratings import ELO_POINTS, RIDGE

# Rates in sixteenths: their differences and complements are exact, so counts cannot be rounded.
sixteenths = st.integers(0, 16).map(lambda n: n / 16)
margins = st.integers(0, 15).map(lambda n: n / 16)


def test_generalization_is_row_means_and_one_minus_column_means():
    curves = analysis.generalization([[0.0, 0.5, 1.0], [1.0, 1.0, 1.0]])
    np.testing.assert_allclose(curves.pursuers, [0.5, 1.0])
    np.testing.assert_allclose(curves.evaders, [0.5, 0.25, 0.0])  # the share that escapes


@given(payoffs())
def test_lag_profile_agrees_with_a_plain_sum(matrix):
    profile = analysis.lag_profile(matrix)
    rows, columns = matrix.shape
    for lag, mean, cells in zip(profile.lags, profile.means, profile.cells, strict=True):
        cases = [matrix[k + lag, k] for k in range(columns) if 0 <= k + lag < rows]
        assert cells == len(cases)
        assert mean == pytest.approx(sum(cases) / len(cases))
    assert profile.cells.sum() == matrix.size


def test_lag_rise_compares_a_third_of_the_run_later_with_earlier():
    matrix = logistic(31)
    expected = 1 / (1 + np.exp(-1.5)) - 1 / (1 + np.exp(1.5))
    assert lag_rise(matrix) == pytest.approx(expected)
    assert lag_rise(matrix[::-1, ::-1]) == pytest.approx(-expected)
    assert lag_rise(matrix[:4, :4]) == pytest.approx(np.tanh(0.075))


@given(payoffs(), margins, st.none() | sixteenths)
def test_checkerboards_by_loops(matrix, margin, level):
    boards = analysis.checkerboards(matrix, margin=margin, level=level)
    rows, columns = matrix.shape
    assert boards.count == sum(
        min(winners) - max(losers) > margin
        and (level is None or min(winners) > level >= max(losers))
        for winners, losers, _ in quadruples(matrix)
    )
    assert boards.possible == rows * (rows - 1) * columns * (columns - 1) // 4


@given(payoffs())
def test_the_transitive_share_is_that_of_an_additive_fit(matrix):
    rows, columns = matrix.shape
    design = np.hstack([
        np.kron(np.eye(rows), np.ones((columns, 1))), np.kron(np.ones((rows, 1)), np.eye(columns)),
    ])  # fmt: skip
    fit = design @ np.linalg.lstsq(design, matrix.ravel(), rcond=None)[0]
    if matrix.var() > 1e-9:
        expected = 1 - np.mean((matrix.ravel() - fit) ** 2) / matrix.var()
        assert analysis.transitive_share(matrix) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("truth", [logistic(15), circular(15)])
def test_the_transitive_share_is_freed_from_noise(truth):
    share, rng = analysis.transitive_share(truth), np.random.default_rng(6)
    scores = [rng.random((15, 15, 10)) < truth[:, :, None] for _ in range(40)]
    found = [transitive_share_over_episodes(each.astype(float)).value for each in scores]
    measured = [analysis.transitive_share(each.mean(axis=2)) for each in scores]
    assert abs(np.mean(found) - share) < min(0.03, abs(np.mean(measured) - share))


@given(payoffs(most=8), st.integers(1, 12), margins)
def test_strongest_boards_are_chosen_first(matrix, count, margin):
    """All are the best of their pursuers; another one is weak, late, or too like a chosen one."""
    best = {}
    for won, lost, (pursuers, evaders) in quadruples(matrix):
        if min(won) - max(lost) > best.get(pursuers, (-2.0,))[0]:
            best[pursuers] = min(won) - max(lost), evaders

    def shared(board, pursuers, evaders):
        return len({*board.pursuers} & {*pursuers}) + len({*board.evaders} & {*evaders})

    chosen = strongest_checkerboards(matrix, count=count, margin=margin)
    for one, other in combinations(chosen, 2):
        assert one.margin >= other.margin
        assert shared(one, other.pursuers, other.evaders) <= 2
    assert all(best[each.pursuers] == (each.margin, each.evaders) for each in chosen)
    for pursuers, (found, evaders) in best.items():
        stronger = [each for each in chosen if each.margin >= found]
        alike = any(shared(each, pursuers, evaders) > 2 for each in stronger)
        assert found <= margin or len(stronger) == count or alike


WON, LOST, OPEN, HALF_WON = (0.98, 0.99), (0.02, 0.0), (0.7, 0.3), (0.99, 0.5)


@pytest.mark.parametrize(
    ("rates", "expected"),
    [
        ([WON] * 2, ()),  # one generation short of a stretch
        ([WON] * 3, (Disengagement("pursuers", 1, 3),)),
        ([OPEN, *[LOST] * 4], (Disengagement("evaders", 2, 5),)),
        ([WON, WON, OPEN, WON, WON], ()),
        ([HALF_WON] * 9, ()),
        ([(0.99, 0.01)] * 6, ()),  # each team wins while it learns: a swing, not an end
        ([(0.97, 0.97)] * 6, ()),  # at the limit, not above it
        ([WON] * 3 + [LOST] * 4, (Disengagement("pursuers", 1, 3), Disengagement("evaders", 4, 7))),
    ],
)
def test_disengagement_takes_both_team_phases_three_generations_in_a_row(rates, expected):
    assert analysis.disengagements(rates) == expected


MATRIX = np.array([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6], [0.7, 0.8, 1.0]])
nan = np.nan


def test_ciao_holds_the_two_triangles_with_the_diagonal():
    pursuers, evaders = analysis.ciao(MATRIX)
    below = [[0.1, nan, nan], [0.4, 0.5, nan], [0.7, 0.8, 1.0]]
    np.testing.assert_array_equal(pursuers.payoff, below)
    above = [[0.9, nan, nan], [0.8, 0.5, nan], [0.7, 0.4, 0.0]]
    np.testing.assert_allclose(evaders.payoff, above, atol=1e-15)
    np.testing.assert_allclose(pursuers.by_age, [1.6 / 3, 0.6, 0.7])
    # Fading compares newer with older ancestors.
    assert pursuers.fading == pytest.approx(((0.5 - 0.4) + (1.0 - 0.7)) / 2)
    assert evaders.fading == pytest.approx(((0.5 - 0.8) + (0.0 - 0.7)) / 2)


@pytest.mark.parametrize("period", [3, 5])
def test_cycles_are_stripes_of_their_period(period):
    for triangle in analysis.ciao(circular(31, period)):
        assert triangle.period == period
        assert triangle.stripes == pytest.approx(1.0)
        assert abs(triangle.fading) < 0.12


def test_elo_minimises_its_documented_objective():
    rng = np.random.default_rng(3)
    matrix = rng.random((3, 4))
    x = 0.01 + 0.98 * matrix

    def objective(parameters):
        a, b, c = parameters[:3], parameters[3:7], parameters[7]
        p = expit(a[:, None] - b + c)
        cross = -(x * np.log(p) + (1 - x) * np.log(1 - p)).sum()
        return float(cross + RIDGE / 2 * (a @ a + b @ b))

    best = minimize(objective, np.zeros(8), method="BFGS", options={"gtol": 1e-7}).x
    found = analysis.elo(matrix)
    np.testing.assert_allclose(found.pursuers, best[:3], atol=1e-4)
    np.testing.assert_allclose(found.evaders, best[3:7], atol=1e-4)
    assert found.offset == pytest.approx(best[7], abs=1e-4)


@pytest.mark.slow
def test_intervals_of_ratings_are_those_of_a_jackknife():
    rng = np.random.default_rng(1)
    scores = (rng.random((5, 4, 200)) < np.tri(5)[:, :4, None] * 0.6 + 0.2).astype(float)
    found = analysis.elo_over_episodes(scores)
    left_out = [analysis.elo(np.delete(scores, e, axis=2).mean(axis=2)) for e in range(200)]
    for team in ("pursuers", "evaders"):
        each = ELO_POINTS * np.array([getattr(one, team) for one in left_out])
        ratings, error = getattr(found, team), np.sqrt(199**2 / 200 * each.var(axis=0, ddof=1))
        whole = getattr(analysis.elo(scores.mean(axis=2)), team)
        np.testing.assert_allclose(ratings.mean, ELO_POINTS * whole, atol=1e-6)
        half = (ratings.high - ratings.low) / 2
        np.testing.assert_allclose(half, t.ppf(0.975, 199) * error, rtol=0.03)


small_payoffs = payoffs(least=2, most=5)
noisy = np.random.default_rng(0)
RUNS = np.stack([noisy.binomial(40, logistic(13)) / 40 for _ in range(6)])
SCORES = (noisy.random((13, 13, 20)) < logistic(13)[:, :, None]).astype(np.float32)


def test_measures_are_those_of_the_single_functions():
    matrix = circular(13)
    found = {name: one.value for name, one in analysis.measure_all(matrix).items()}
    late = analysis.last_half(matrix)
    assert found["game_value"] == game_value(matrix)
    assert found["transitive_share"] == analysis.transitive_share(late)
    assert found["checkerboards"] == analysis.checkerboards(late, margin=MARGIN, level=None).share
    assert found["pursuer_stripes"] == analysis.ciao(matrix).pursuers.stripes
    forgetting = analysis.MEASURES["evader_forgetting"]
    drops = analysis.forgetting(matrix).evaders
    assert forgetting.of(matrix, "whole").value == drops[6:].mean()
    assert forgetting.of(matrix).value == found["evader_forgetting"] == drops[9:].mean()


def test_the_judgement_and_the_tables_have_the_same_numbers():
    for scores in (SCORES, np.stack([SCORES, SCORES[::-1]]), SCORES[:8, :8]):
        payoffs = analysis.read_payoffs(scores, per_episode=True)
        for window, findings in analysis.judge(payoffs).windows.items():
            for name, one in ((n, e) for f in findings.values() for n, e in f.estimates.items()):
                assert analysis.MEASURES[name].of(payoffs, window) == one


def test_a_single_run_has_no_intervals_and_says_so():
    found = analysis.measure_all(circular(13))
    scatter = {
        f"{team}_{name}" for team in ("pursuer", "evader") for name in ("gain", "change", "lead")
    }
    assert all(one.low is None and one.note for name, one in found.items() if name not in scatter)
    assert analysis.measure_table(circular(13)).startswith("A single run (95% interval over its")


def test_several_runs_have_intervals_over_runs():
    share = analysis.measure_all(RUNS)["transitive_share"]
    each = [analysis.transitive_share(analysis.last_half(run)) for run in RUNS]
    assert share.value == pytest.approx(np.mean(each))
    half = stats.t.ppf(0.975, 5) * np.std(each, ddof=1) / np.sqrt(6)
    assert share.ends == pytest.approx((share.value - half, share.value + half))
    assert (share.across, share.samples) == ("runs", 6)
    assert f"{share}" in analysis.measure_table(RUNS)


@settings(max_examples=8)
@given(small_payoffs)
def test_any_matrix_is_analysed_and_swapping_teams_swaps_the_numbers(matrix):
    numbers, swapped = analysis.measure_all(matrix), analysis.measure_all(1 - matrix.T)
    for name, one in numbers.items():
        value = one.value
        team, _, measure = name.partition("_")
        other = {"pursuer": f"evader_{measure}", "evader": f"pursuer_{measure}"}.get(team, name)
        expected = 1 - value if name in ("capture_rate", "game_value") else value
        np.testing.assert_allclose(swapped[other].value, expected, atol=1e-6, err_msg=name)
