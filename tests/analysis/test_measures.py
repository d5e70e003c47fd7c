"""The measures of matrixworld.analysis on matrices whose answer is known."""

from __future__ import annotations

import itertools
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from matrices import ROCK_PAPER_SCISSORS, additive, circular, logistic, payoffs, staircase
from matrixworld import analysis
from matrixworld.analysis.cycles import MARGIN, strongest_checkerboards
from matrixworld.analysis.payoffs import check_runs, logits, swap_teams
from matrixworld.analysis.progress import lag_rise, swing

PENNIES = np.array([[1.0, 0.0], [0.0, 1.0]])


# Rates in sixteenths: their differences and complements are exact, so counts cannot be rounded.
sixteenths = st.integers(0, 16).map(lambda n: n / 16)
margins = st.integers(0, 15).map(lambda n: n / 16)


# ---- the matrix ---------------------------------------------------------------------------------


def test_a_payoff_matrix_may_be_lists_booleans_or_float32() -> None:
    for given_matrix in ([[0, 1], [1, 0]], np.eye(2, dtype=bool), np.eye(2, dtype=np.float32)):
        checked = analysis.check_payoff(given_matrix)
        assert checked.dtype == np.float64
        assert checked.shape == (2, 2)


def test_measures_do_not_change_the_matrix() -> None:
    matrix = circular(13)
    before = matrix.copy()
    analysis.report(matrix)
    np.testing.assert_array_equal(matrix, before)


def test_the_last_half_of_31_generations_is_15_to_30() -> None:
    matrix = np.arange(31)[:, None] / 100 + np.zeros((1, 31))
    half = analysis.last_half(matrix)
    assert half.shape == (16, 16)
    np.testing.assert_allclose(half[:, 0], np.arange(15, 31) / 100)


def test_the_last_half_of_a_matrix_that_is_not_square() -> None:
    matrix = additive(5, 8)
    np.testing.assert_array_equal(analysis.last_half(matrix), matrix[2:, 4:])
    np.testing.assert_array_equal(analysis.last_half([[0.25]]), [[0.25]])


# ---- progress -----------------------------------------------------------------------------------


def test_generalization_is_row_means_and_one_minus_column_means() -> None:
    curves = analysis.generalization([[0.0, 0.5, 1.0], [1.0, 1.0, 1.0]])
    np.testing.assert_allclose(curves.pursuers, [0.5, 1.0])
    np.testing.assert_allclose(curves.evaders, [0.5, 0.25, 0.0])


def test_lag_profile_of_a_toeplitz_matrix_is_its_diagonals() -> None:
    by_lag = {lag: (lag + 3) / 10 for lag in range(-3, 5)}
    matrix = [[by_lag[g - h] for h in range(4)] for g in range(5)]
    profile = analysis.lag_profile(matrix)
    assert profile.lags.tolist() == [-3, -2, -1, 0, 1, 2, 3, 4]
    assert profile.cells.tolist() == [1, 2, 3, 4, 4, 3, 2, 1]
    np.testing.assert_allclose(profile.means, [by_lag[lag] for lag in profile.lags.tolist()])
    assert profile.at(2) == pytest.approx(by_lag[2])
    for outside in (-4, 5):
        with pytest.raises(ValueError, match=f"from -3 to 4, got {outside}"):
            profile.at(outside)


@given(payoffs())
def test_lag_profile_agrees_with_a_plain_sum(matrix: np.ndarray) -> None:
    profile = analysis.lag_profile(matrix)
    rows, columns = matrix.shape
    for lag, mean, cells in zip(profile.lags, profile.means, profile.cells, strict=True):
        cases = [matrix[k + lag, k] for k in range(columns) if 0 <= k + lag < rows]
        assert cells == len(cases)
        assert mean == pytest.approx(sum(cases) / len(cases))
    assert profile.cells.sum() == matrix.size


def test_lag_rise_compares_a_third_of_the_run_later_with_earlier() -> None:
    matrix = logistic(31)
    expected = 1 / (1 + np.exp(-1.5)) - 1 / (1 + np.exp(1.5))
    assert lag_rise(matrix) == pytest.approx(expected)
    assert lag_rise(matrix[::-1, ::-1]) == pytest.approx(-expected)
    assert lag_rise(matrix, lag=1) == pytest.approx(np.tanh(0.075))
    for lag in (0, 31):
        with pytest.raises(ValueError, match=f"lag from 1 to 30, got {lag}"):
            lag_rise(matrix, lag)


def test_team_phase_rates_are_next_to_and_on_the_diagonal() -> None:
    matrix = [[0.0, 0.1, 0.2], [0.3, 0.4, 0.5], [0.6, 0.7, 0.8], [0.9, 1.0, 1.0]]
    np.testing.assert_allclose(analysis.team_phase_rates(matrix), [[0.3, 0.4], [0.7, 0.8]])
    assert analysis.team_phase_rates([[0.5]]).shape == (0, 2)


def test_swing_is_the_mean_change_in_the_evaders_team_phase() -> None:
    matrix = np.full((9, 9), 0.5)
    answers = np.array([0.9, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7])
    matrix[np.arange(1, 9), np.arange(1, 9)] = answers
    assert swing(matrix, start=1) == pytest.approx(np.abs(answers - 0.5).mean())
    assert swing(matrix) == pytest.approx(np.abs(answers[2:] - 0.5).mean())  # from 3
    assert swing(matrix, start=8) == pytest.approx(0.2)
    for start in (0, 9):
        with pytest.raises(ValueError, match=f"start from 1 to 8, got {start}"):
            swing(matrix, start)


def test_swing_leaves_out_the_first_quarter_of_31_generations() -> None:
    matrix = np.full((31, 31), 0.5)
    matrix[7, 7] = 1.0
    assert swing(matrix) == 0.0
    matrix[8, 8] = 1.0
    assert swing(matrix) == pytest.approx(0.5 / 23)


def test_forgetting_is_the_drop_below_the_best_so_far() -> None:
    lost = analysis.forgetting([[0.2, 0.8], [0.6, 0.4], [0.5, 0.9]])
    np.testing.assert_allclose(lost.pursuers, [0.0, 0.2, 0.05])
    np.testing.assert_allclose(lost.evaders, [0.0, (0.6 + 0.0 + 0.4) / 3])


@given(payoffs())
def test_nothing_is_forgotten_where_every_generation_improves(matrix: np.ndarray) -> None:
    improving = np.sort(np.sort(matrix, axis=0), axis=1)[:, ::-1]
    lost = analysis.forgetting(improving)
    assert not lost.pursuers.any()
    assert not lost.evaders.any()


# ---- transitive share and checkerboards ---------------------------------------------------------


@pytest.mark.parametrize("logits", [False, True])
def test_a_transitive_matrix_of_zeros_and_ones_tends_to_two_thirds(logits: bool) -> None:
    share = analysis.transitive_share(staircase(400), logits=logits)
    assert share == pytest.approx(2 / 3, abs=0.005)
    assert analysis.checkerboards(staircase(40)).count == 0


def test_an_additive_matrix_is_wholly_transitive() -> None:
    assert analysis.transitive_share(additive(7, 12)) == pytest.approx(1.0)


def test_a_logistic_matrix_is_wholly_transitive_on_logits() -> None:
    matrix = logistic(21, slope=0.3)
    assert analysis.transitive_share(matrix) < 0.97
    assert analysis.transitive_share(matrix, logits=True, shrinkage=1e-9) == pytest.approx(1.0)


def test_matching_pennies_and_rock_paper_scissors() -> None:
    assert analysis.transitive_share(PENNIES) == 0.0
    assert analysis.transitive_share(ROCK_PAPER_SCISSORS) == 0.0
    pennies = analysis.checkerboards(PENNIES)
    assert (pennies.count, pennies.possible, pennies.share) == (1, 1, 1.0)
    rps = analysis.checkerboards(ROCK_PAPER_SCISSORS)
    assert (rps.count, rps.possible) == (3, 9)


def test_rock_paper_scissors_with_draws_given_to_either_team() -> None:
    for draw in (0.0, 1.0):
        matrix = np.where(ROCK_PAPER_SCISSORS == 0.5, draw, ROCK_PAPER_SCISSORS)
        for level in (0.5, None):
            boards = analysis.checkerboards(matrix, margin=0.9, level=level)
            assert (boards.count, boards.possible) == (3, 9)


def test_cycling_away_from_one_half_is_seen_without_a_level() -> None:
    low = 0.1 + 0.3 * PENNIES
    assert analysis.checkerboards(low).count == 0
    assert analysis.checkerboards(low, level=None).count == 1
    assert analysis.checkerboards(low, margin=0.25, level=None).count == 1
    assert analysis.checkerboards(low, margin=0.35, level=None).count == 0


def test_one_margin_too_small_is_no_checkerboard() -> None:
    matrix = [[0.9, 0.2], [0.8, 0.95]]  # both prefer as they should, but 0.9 hardly exceeds 0.8
    assert analysis.checkerboards(matrix, level=None).count == 1
    assert analysis.checkerboards(matrix, margin=0.15, level=None).count == 0


def test_constant_and_tiny_matrices_have_no_share() -> None:
    assert np.isnan(analysis.transitive_share(np.full((4, 5), 0.1)))
    assert np.isnan(analysis.transitive_share(np.full((4, 5), 0.1), logits=True))
    assert np.isnan(analysis.checkerboards([[0.0, 1.0]]).share)


def brute_force(matrix: np.ndarray, margin: float, level: float | None) -> int:
    """Count checkerboards by definition, in four loops."""

    def is_one(p1: int, p2: int, e1: int, e2: int) -> bool:
        winners = (matrix[p1, e1], matrix[p2, e2])
        losers = (matrix[p1, e2], matrix[p2, e1])
        clear = all(w - loser > margin for w in winners for loser in losers)
        beats = level is None or (
            all(w > level for w in winners) and all(loser <= level for loser in losers)
        )
        return clear and beats

    rows, columns = matrix.shape
    return sum(
        is_one(p1, p2, e1, e2) or is_one(p1, p2, e2, e1)
        for p1, p2 in combinations(range(rows), 2)
        for e1, e2 in combinations(range(columns), 2)
    )


@given(payoffs(), margins, st.none() | sixteenths)
def test_checkerboards_agree_with_four_loops(
    matrix: np.ndarray, margin: float, level: float | None
) -> None:
    boards = analysis.checkerboards(matrix, margin=margin, level=level)
    rows, columns = matrix.shape
    assert boards.count == brute_force(matrix, margin, level)
    assert boards.possible == rows * (rows - 1) * columns * (columns - 1) // 4


@given(st.integers(0, 2**32 - 1), st.integers(2, 12), st.integers(2, 12))
def test_an_additive_matrix_with_noise_has_no_checkerboards_at_the_margin(
    seed: int, rows: int, columns: int
) -> None:
    # The four margins of a quadruple sum to twice the interaction of its noise, which is at most
    # four times the largest: above four margins takes noise above the margin over two.
    noise = np.random.default_rng(seed).uniform(-MARGIN / 2, MARGIN / 2, (rows, columns))
    matrix = additive(rows, columns, seed) + noise
    assert analysis.checkerboards(matrix, margin=MARGIN, level=None).count == 0


@given(payoffs(), margins)
def test_swapping_the_teams_swaps_the_results(matrix: np.ndarray, margin: float) -> None:
    swapped = swap_teams(matrix)
    np.testing.assert_array_equal(swap_teams(swapped), matrix)
    for ours, theirs in zip(
        analysis.generalization(matrix), list(analysis.generalization(swapped))[::-1], strict=True
    ):
        np.testing.assert_allclose(ours, theirs)
    for ours, theirs in zip(
        analysis.forgetting(matrix), list(analysis.forgetting(swapped))[::-1], strict=True
    ):
        np.testing.assert_allclose(ours, theirs, atol=1e-12)
    np.testing.assert_allclose(
        analysis.lag_profile(swapped).means, 1 - analysis.lag_profile(matrix).means[::-1]
    )
    for on_logits in (False, True):
        np.testing.assert_allclose(
            analysis.transitive_share(matrix, logits=on_logits),
            analysis.transitive_share(swapped, logits=on_logits),
            atol=1e-9,
        )
    boards = analysis.checkerboards(matrix, margin=margin, level=None)
    assert analysis.checkerboards(swapped, margin=margin, level=None) == boards


@given(payoffs(), margins, st.randoms(use_true_random=False))
def test_the_order_of_generations_does_not_change_cycles(
    matrix: np.ndarray, margin: float, random: object
) -> None:
    rng = np.random.default_rng(random.getrandbits(32))  # type: ignore[attr-defined]
    shuffled = matrix[rng.permutation(matrix.shape[0])][:, rng.permutation(matrix.shape[1])]
    assert analysis.checkerboards(shuffled, margin=margin) == analysis.checkerboards(
        matrix, margin=margin
    )
    np.testing.assert_allclose(
        analysis.transitive_share(shuffled), analysis.transitive_share(matrix), atol=1e-9
    )


@given(payoffs())
def test_checkerboards_without_level_or_margin_depend_on_order_only(matrix: np.ndarray) -> None:
    boards = analysis.checkerboards(matrix, level=None)
    assert analysis.checkerboards(matrix**2, level=None) == boards


@given(payoffs())
def test_the_parts_of_a_matrix_add_up_and_are_orthogonal(matrix: np.ndarray) -> None:
    mean, pursuers, evaders, cyclic = analysis.two_way_parts(matrix)
    np.testing.assert_allclose(mean + pursuers[:, None] + evaders + cyclic, matrix, atol=1e-12)
    for sums in ([pursuers.sum(), evaders.sum()], cyclic.sum(axis=0), cyclic.sum(axis=1)):
        np.testing.assert_allclose(sums, 0.0, atol=1e-12)
    total = np.sum((matrix - mean) ** 2)
    if total > 1e-9:
        expected = 1 - np.sum(cyclic**2) / total
        assert analysis.transitive_share(matrix) == pytest.approx(expected, abs=1e-9)
    swapped = analysis.two_way_parts(1 - matrix.T)
    np.testing.assert_allclose(swapped.pursuers, -evaders, atol=1e-12)


def test_logits_of_shrunken_rates() -> None:
    np.testing.assert_allclose(
        logits([[0.0, 0.5, 1.0]]), [[-np.log(99), 0.0, np.log(99)]], atol=1e-12
    )


def test_runs_are_stacked() -> None:
    assert check_runs(PENNIES).shape == (1, 2, 2)
    assert check_runs([PENNIES, PENNIES]).shape == (2, 2, 2)


# ---- The strongest checkerboards -----------------------------------------------------------------


def margin_of(matrix: np.ndarray, p: int, q: int, a: int, b: int) -> float:
    better, worse = (matrix[p, a], matrix[q, b]), (matrix[p, b], matrix[q, a])
    return float(min(better) - max(worse))


def all_margins(matrix: np.ndarray) -> list[float]:
    rows, columns = matrix.shape
    pairs = itertools.combinations(range(rows), 2)
    orders = itertools.permutations(range(columns), 2)
    return [margin_of(matrix, p, q, a, b) for (p, q), (a, b) in itertools.product(pairs, orders)]


@pytest.mark.parametrize("seed", range(5))
def test_the_first_one_is_the_strongest_of_all(seed: int) -> None:
    matrix = np.random.default_rng(seed).random((5, 6))
    first = strongest_checkerboards(matrix)[0]
    assert first.margin == pytest.approx(max(all_margins(matrix)))
    assert first.margin == pytest.approx(margin_of(matrix, *first.pursuers, *first.evaders))


def test_margins_descend_and_boards_differ() -> None:
    boards = strongest_checkerboards(circular(12), count=8)
    margins = [board.margin for board in boards]
    assert len(boards) == 8
    assert margins == sorted(margins, reverse=True)
    for one, other in itertools.combinations(boards, 2):
        common = len(set(one.pursuers) & set(other.pursuers))
        assert common + len(set(one.evaders) & set(other.evaders)) <= 2


@pytest.mark.parametrize("matrix", [staircase(8), additive(6, 7)])
def test_an_order_of_strength_has_none(matrix: np.ndarray) -> None:
    assert strongest_checkerboards(matrix) == ()


@pytest.mark.parametrize("margin", [0.0, 0.3, 0.6])
def test_there_is_one_if_and_only_if_they_are_counted(margin: float) -> None:
    for seed in range(20):
        matrix = np.random.default_rng(seed).random((3, 3))
        counted = analysis.checkerboards(matrix, margin=margin, level=None).count > 0
        assert bool(strongest_checkerboards(matrix, margin=margin)) == counted
