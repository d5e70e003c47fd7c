"""Intervals: agreement with SciPy's, coverage of noise-free numbers, and special cases."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest
from scipy import stats

from matrices import circular, logistic
from matrixworld import analysis
from matrixworld.analysis.cycles import _sums_without_noise
from matrixworld.analysis.intervals import BIASED
from matrixworld.analysis.judge import RULES
from matrixworld.analysis.progress import lag_rise


def test_intervals_are_those_of_scipy() -> None:
    rng = np.random.default_rng(2)
    one, other = rng.random(7), rng.random(7)
    expected = stats.ttest_1samp(one, 0).confidence_interval(0.9)
    np.testing.assert_allclose(analysis.interval_over_runs(one, level=0.9).ends, expected)
    welch = stats.ttest_ind(one, other[:4], equal_var=False).confidence_interval()
    np.testing.assert_allclose(analysis.difference_of_runs(one, other[:4]).ends, welch)
    paired = analysis.difference_of_runs(one, other, paired=True)
    np.testing.assert_allclose(paired.ends, stats.ttest_rel(one, other).confidence_interval())


def test_a_single_run_has_no_interval_and_says_so() -> None:
    found = analysis.interval_over_runs([0.25])
    assert (found.value, found.low, found.high, found.across) == (0.25, None, None, "nothing")
    assert found.note == "a single run has no interval over runs"
    assert str(found) == "0.250"
    assert analysis.difference_of_runs([0.25], [0.1, 0.2]).low is None


def test_equal_runs_have_no_interval() -> None:
    same = analysis.interval_over_runs([0.1 + 0.2, 0.3, 0.3])
    assert (same.low, same.high) == (None, None)
    assert same.note == "no interval: all 3 runs are equal"
    assert analysis.difference_of_runs([0.3, 0.3], [0.2, 0.2]).low is None
    low, high = analysis.difference_of_runs([0.3, 0.3], [0.1, 0.2, 0.3]).ends
    assert low < 0.1 < high


def test_few_runs_and_bounds() -> None:
    found = analysis.interval_over_runs([0.1, 0.2], bounds=(0.0, 1.0))
    assert found.note == "2 runs only: the interval is wide"
    assert found.ends == (0.0, pytest.approx(0.15 + 12.706 * 0.05, abs=1e-3))


def test_bands_are_pointwise() -> None:
    curves = np.random.default_rng(5).normal(0, 1, (30, 1)) + np.arange(4)
    band = analysis.band_over_runs(curves)
    for k in range(4):
        estimate = analysis.interval_over_runs(curves[:, k])
        assert (band.low[k], band.high[k]) == pytest.approx(estimate.ends)
        assert band.mean[k] == pytest.approx(estimate.value)
    clipped = analysis.band_over_runs(curves, bounds=(0.0, 3.0))
    assert clipped.low.min() == 0.0
    single = analysis.band_over_runs(curves[:1])
    assert single.low is None
    np.testing.assert_array_equal(single.mean, curves[0])


# ---- Over the episodes of one run ----------------------------------------------------------------


DECIDING = {name for names, _ in RULES.values() for name in names} - {"checkerboards"}
MATRIX_MEASURES = [
    name for name in analysis.MEASURES if name not in DECIDING and "global" not in name
    and "rungs" not in name
]  # fmt: skip
LINEAR = {
    "capture_rate", "lag_rise",
    *(f"{team}_{name}" for team in ("pursuer", "evader")
      for name in ("generalization", "local_gain", "historical_gain", "fading")),
}  # fmt: skip


@pytest.mark.parametrize(("wins", "episodes"), [(0, 4), (1, 10), (5, 10), (10, 10), (30, 200)])
def test_win_or_loss_has_the_interval_of_clopper_and_pearson(wins: int, episodes: int) -> None:
    scores = np.arange(episodes) < wins
    expected = stats.binomtest(wins, episodes).proportion_ci(method="exact")
    found = analysis.mean_over_episodes(scores)
    assert found.ends == pytest.approx(tuple(expected), abs=0.006)
    assert (found.value, found.across, found.samples) == (wins / episodes, "episodes", episodes)


def test_scores_that_vary_little_have_narrower_intervals() -> None:
    steady = analysis.mean_over_episodes([0.5, 0.45, 0.55, 0.5] * 25).ends
    win_or_loss = analysis.mean_over_episodes([0.0, 1.0] * 50).ends
    assert win_or_loss[0] < steady[0] < 0.5 < steady[1] < win_or_loss[1]


def test_differences_cover_and_lie_within_their_bounds() -> None:
    rng = np.random.default_rng(0)
    covered = []
    for _ in range(300):
        found = analysis.difference_over_episodes(rng.random(10) < 0.9, rng.random(20) < 0.6)
        low, high = found.ends
        covered.append(low <= 0.3 <= high)
    assert np.mean(covered) > 0.94
    low, high = analysis.difference_over_episodes(np.ones(5), np.zeros(5)).ends
    assert 0.2 < low < high == 1.0


def test_linear_measures_cover_the_noise_free_measure() -> None:
    truth, rng = logistic(8), np.random.default_rng(3)
    covered = []
    for _ in range(300):
        scores = rng.random((8, 8, 5)) < truth[:, :, None]
        low, high = analysis.linear_over_episodes(scores, lag_rise).ends
        covered.append(low <= lag_rise(truth) <= high)
    assert 0.91 < np.mean(covered) < 0.99


def test_generalization_has_the_interval_of_each_mean() -> None:
    scores = np.random.default_rng(3).random((4, 3, 5))
    pursuers, evaders = analysis.generalization_over_episodes(scores, level=0.9)
    expected = analysis.generalization(scores.mean(axis=2))
    for band, curve, cells in (
        (pursuers, expected.pursuers, scores),
        (evaders, expected.evaders, 1 - scores.swapaxes(0, 1)),
    ):
        np.testing.assert_allclose(band.mean, curve)
        for g in range(len(curve)):
            one = analysis.linear_over_episodes(cells[g : g + 1], np.mean, level=0.9)
            assert (band.low[g], band.high[g]) == pytest.approx(one.ends)
    sure = analysis.generalization_over_episodes(np.eye(2)[..., None] * [1.0, 1.0, 0.9])[0]
    assert sure.high.max() < 1


def test_cells_may_share_their_episodes() -> None:
    rng = np.random.default_rng(4)
    shared = rng.random((300, 1, 1, 6)) * np.ones((1, 4, 4, 1))
    found = [analysis.linear_over_episodes(each, np.mean).ends for each in shared]
    assert 0.91 < np.mean([low <= 0.5 <= high for low, high in found]) < 0.98


def test_sums_without_noise_are_those_of_pairs_of_episodes() -> None:
    scores = np.random.default_rng(5).random((3, 4, 5))
    parts = [analysis.two_way_parts(scores[:, :, e]) for e in range(5)]
    pairs = list(permutations(range(5), 2))
    residual = np.mean([np.sum(parts[e].cyclic * parts[f].cyclic) for e, f in pairs])
    centered = [scores[:, :, e] - parts[e].mean for e in range(5)]
    total = np.mean([np.sum(centered[e] * centered[f]) for e, f in pairs])
    np.testing.assert_allclose(_sums_without_noise(scores)[0], [residual, total])


@pytest.mark.parametrize(("truth", "name"), [(logistic(15), "race"), (circular(15), "cycle")])
def test_the_transitive_share_is_freed_from_noise(truth: np.ndarray, name: str) -> None:
    share, rng = analysis.transitive_share(truth), np.random.default_rng(6)
    covered, values, measured = [], [], []
    for _ in range(100):
        scores = rng.random((15, 15, 10)) < truth[:, :, None]
        found = analysis.transitive_share_over_episodes(scores)
        low, high = found.ends
        covered.append(low <= share <= high)
        values.append(found.value)
        measured.append(analysis.transitive_share(scores.mean(axis=2)))
    assert np.mean(covered) > 0.9, name
    assert abs(np.mean(values) - share) < min(0.02, abs(np.mean(measured) - share))
    assert found.note == "episode noise subtracted"


def test_shares_without_an_interval() -> None:
    noise = np.random.default_rng(7).random((6, 6, 10)) < 0.5
    found = analysis.transitive_share_over_episodes(noise)
    assert found.note == "biased by episode noise: no interval, no variation beyond it"
    assert found.low is None
    assert found.value == pytest.approx(analysis.transitive_share(noise.mean(axis=2)))
    few = analysis.transitive_share_over_episodes(noise[:, :, :3])
    assert few.note == "biased by episode noise: no interval below 4 episodes"
    assert np.isnan(analysis.transitive_share_over_episodes(np.full((3, 3, 4), 0.5)).value)


def test_measures_say_which_interval_they_have() -> None:
    rng = np.random.default_rng(8)
    scores = rng.random((9, 9, 60)) < logistic(9)[:, :, None]
    payoffs = analysis.read_payoffs(scores, per_episode=True)
    for name in MATRIX_MEASURES:
        found = analysis.MEASURES[name].of(payoffs, "whole")
        biased = name not in LINEAR and name != "transitive_share"
        assert (found.low is None) == (found.note == BIASED) == biased, found


@pytest.mark.parametrize("name", MATRIX_MEASURES)
def test_linear_measures_are_linear(name: str) -> None:
    one, other = np.random.default_rng(9).random((2, 9, 9))
    mixed, *parts = (
        analysis.MEASURES[name].of(matrix, "whole").value
        for matrix in (0.3 * one + 0.7 * other, one, other)
    )
    is_linear = mixed == pytest.approx(0.3 * parts[0] + 0.7 * parts[1], abs=1e-9)
    # Stripes of random matrices are all 0, which is linear by chance.
    assert is_linear == (name in LINEAR) or name.endswith("stripes")


def test_episodes_without_variation_have_no_interval() -> None:
    found = analysis.linear_over_episodes(np.ones((3, 3, 5)), np.mean)
    assert (found.value, found.low) == (1.0, None)
    assert found.note == "no interval: all episodes are equal"
