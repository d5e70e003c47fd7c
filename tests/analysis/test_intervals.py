"""Intervals over runs: coverage of known means, SciPy's results, and special cases."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from matrixworld import analysis


@pytest.mark.parametrize("runs", [2, 3, 5, 10, 20])
def test_intervals_over_runs_cover_95_percent_of_normal_means(runs: int) -> None:
    rng = np.random.default_rng(runs)
    samples = rng.normal(0.4, 0.1, (4000, runs))
    found = np.array([analysis.interval_over_runs(values).ends for values in samples])
    covered = (found[:, 0] <= 0.4) & (found[:, 1] >= 0.4)
    assert 0.93 < covered.mean() < 0.97


def test_intervals_of_differences_cover_95_percent_of_normal_differences() -> None:
    rng = np.random.default_rng(1)
    covered = []
    for _ in range(2000):
        one, other = rng.normal(0.5, 0.3, 5), rng.normal(0.2, 0.05, 12)
        low, high = analysis.difference_of_runs(one, other).ends
        covered.append(low <= 0.3 <= high)
    assert 0.93 < np.mean(covered) < 0.97


def test_intervals_are_those_of_scipy() -> None:
    rng = np.random.default_rng(2)
    one, other = rng.random(7), rng.random(7)
    expected = stats.ttest_1samp(one, 0).confidence_interval(0.9)
    np.testing.assert_allclose(analysis.interval_over_runs(one, level=0.9).ends, expected)
    welch = stats.ttest_ind(one, other[:4], equal_var=False).confidence_interval()
    np.testing.assert_allclose(analysis.difference_of_runs(one, other[:4]).ends, welch)
    paired = analysis.difference_of_runs(one, other, paired=True)
    np.testing.assert_allclose(paired.ends, stats.ttest_rel(one, other).confidence_interval())


def test_levels_widen_intervals() -> None:
    values = np.random.default_rng(1).random(12)
    narrow, wide = (analysis.interval_over_runs(values, level=level) for level in (0.5, 0.99))
    assert wide.ends[0] < narrow.ends[0] < values.mean()
    assert narrow.value == pytest.approx(values.mean())
    assert (narrow.across, narrow.samples, narrow.note) == ("runs", 12, "")


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
