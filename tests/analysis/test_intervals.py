"""Intervals over runs and episodes, beside SciPy's and rliable's, their coverage, and curves."""

import numpy as np
import pytest
from scipy import stats

from matrixworld import analysis
from matrixworld.analysis.intervals import (
    expanded_tail,
    generalization_over_episodes,
    linear_over_episodes,
)
from rliable_numbers import LEVEL, NUMBERS, ONE, OTHER, TASK


def test_intervals_are_those_of_scipy():
    rng = np.random.default_rng(2)
    one, other = rng.random(7), rng.random(7)
    expected = stats.ttest_1samp(one, 0).confidence_interval(0.9)
    np.testing.assert_allclose(analysis.interval_over_runs(one, level=0.9).ends, expected)
    welch = stats.ttest_ind(one, other[:4], equal_var=False).confidence_interval()
    np.testing.assert_allclose(analysis.difference_of_runs(one, other[:4]).ends, welch)
    paired = analysis.difference_of_runs(one, other, paired=True)
    np.testing.assert_allclose(paired.ends, stats.ttest_rel(one, other).confidence_interval())


NO_INTERVAL = [
    (analysis.interval_over_runs, [[0.25]], "a single run has no interval over runs"),
    (analysis.interval_over_runs, [[0.1 + 0.2, 0.3, 0.3]], "no interval: all 3 runs are equal"),
    (analysis.interquartile_mean, [[[0.2, 0.8]] * 7], "no interval: all 7 runs are equal"),
    (analysis.interquartile_mean, [ONE[:5]], "no interval below 6 runs"),
]


@pytest.mark.parametrize(("function", "arguments", "note"), NO_INTERVAL)
def test_few_or_equal_runs_have_no_interval_and_say_so(function, arguments, note):
    found = function(*arguments)
    assert (found.low, found.high, str(found.note)) == (None, None, note)


@pytest.mark.parametrize(("wins", "episodes"), [(0, 4), (1, 10), (30, 200)])
def test_win_or_loss_has_the_interval_of_clopper_and_pearson(wins, episodes):
    scores = np.arange(episodes) < wins
    expected = stats.binomtest(wins, episodes).proportion_ci(method="exact")
    found = analysis.mean_over_episodes(scores)
    assert found.ends == pytest.approx(tuple(expected), abs=0.006)
    assert (found.value, found.across, found.samples) == (wins / episodes, "episodes", episodes)


def test_generalization_has_the_interval_of_each_mean():
    scores = np.random.default_rng(3).random((4, 3, 5))
    pursuers, evaders = generalization_over_episodes(scores)
    expected = analysis.generalization(scores.mean(axis=2))
    for band, curve, cells in (
        (pursuers, expected.pursuers, scores),
        (evaders, expected.evaders, 1 - scores.swapaxes(0, 1)),
    ):
        np.testing.assert_allclose(band.mean, curve)
        for g in range(len(curve)):
            one = linear_over_episodes(cells[g : g + 1], np.mean)
            assert (band.low[g], band.high[g]) == pytest.approx(one.ends)
    sure = generalization_over_episodes(np.eye(2)[..., None] * [1.0, 1.0, 0.9])[0]
    assert sure.high.max() < 1


def test_values_are_those_of_rliable():
    found = [analysis.interquartile_mean(each).value for each in (ONE, OTHER, TASK)]
    np.testing.assert_allclose(found, NUMBERS["iqm"])


def test_the_bootstrap_of_one_task_is_that_of_rliable(monkeypatch):
    # With a single task, whole runs and stratified resampling are the same.
    assert 1.0 - 2.0 * expanded_tail(len(TASK), 0.95) == pytest.approx(LEVEL)
    monkeypatch.setattr("matrixworld.analysis.intervals.RESAMPLES", 10_000)
    found = analysis.interquartile_mean(TASK)
    # The scores have two decimals, so the ends move in steps of 1/600.
    np.testing.assert_allclose(found.ends, NUMBERS["iqm_ends"], atol=0.01)
