"""Interquartile mean, performance profile and probability of improvement, beside references."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from matrixworld import analysis
from matrixworld.analysis.runs import expanded_tail
from rliable_numbers import LEVEL, NUMBERS, ONE, OTHER, TASK, THRESHOLDS


def test_values_are_those_of_rliable() -> None:
    found = [analysis.interquartile_mean(each).value for each in (ONE, OTHER, TASK)]
    np.testing.assert_allclose(found, NUMBERS["iqm"])
    profile = analysis.performance_profile(ONE, THRESHOLDS)
    np.testing.assert_allclose(profile.mean, NUMBERS["profile"])
    better = analysis.probability_of_improvement(ONE, OTHER).value
    assert better == pytest.approx(NUMBERS["improvement"])
    assert analysis.probability_of_improvement(OTHER, ONE).value == pytest.approx(
        NUMBERS["no_improvement"]
    )


def test_the_bootstrap_of_one_task_is_that_of_rliable() -> None:
    # With a single task, whole runs and stratified resampling are the same.
    assert 1.0 - 2.0 * expanded_tail(len(TASK), 0.95) == pytest.approx(LEVEL)
    found = analysis.interquartile_mean(TASK, resamples=20_000)
    # The scores have two decimals, so the ends move in steps of 1/600.
    np.testing.assert_allclose(found.ends, NUMBERS["iqm_ends"], atol=0.01)


def test_the_interquartile_mean_is_a_trimmed_mean() -> None:
    rng = np.random.default_rng(0)
    for runs, tasks in ((1, 1), (1, 3), (2, 2), (7, 3), (10, 6)):
        scores = rng.random((runs, tasks))
        expected = stats.trim_mean(scores, 0.25, axis=None)
        assert analysis.interquartile_mean(scores).value == pytest.approx(expected)


def test_scores_of_one_run_are_resampled_together() -> None:
    # All tasks of a run have the same score: ten tasks say no more than one.
    one = np.random.default_rng(1).random((8, 1))
    low, high = analysis.interquartile_mean(one).ends
    lows, highs = analysis.interquartile_mean(np.repeat(one, 10, axis=1)).ends
    assert highs - lows == pytest.approx(high - low, rel=0.2)


def test_few_runs_have_no_interval() -> None:
    assert [analysis.fewest_runs(level) for level in (0.5, 0.9, 0.95, 0.99)] == [2, 5, 6, 8]
    for found in (
        analysis.interquartile_mean(ONE[:5]),
        analysis.probability_of_improvement(ONE, OTHER[:5]),
        analysis.probability_of_improvement(ONE[:5], OTHER),
    ):
        assert (found.low, found.high) == (None, None)
        assert (found.note, found.samples) == ("no interval below 6 runs", 5)
    shares = analysis.performance_profile(ONE[:5])
    assert (shares.low, shares.high) == (None, None)
    assert analysis.interquartile_mean(ONE[:6]).low is not None
    assert analysis.interquartile_mean(ONE[:5], level=0.9).low is not None


def test_equal_runs_have_no_interval() -> None:
    found = analysis.interquartile_mean([[0.2, 0.8, 0.5]] * 7)
    assert (found.low, found.note) == (None, "no interval: all 7 runs are equal")


def test_a_profile_is_the_mean_over_runs_of_their_shares() -> None:
    profile = analysis.performance_profile(ONE, THRESHOLDS)
    shares = [[np.mean(run > threshold) for threshold in THRESHOLDS] for run in ONE]
    expected = analysis.band_over_runs(shares, bounds=(0.0, 1.0))
    for name in ("mean", "low", "high"):
        np.testing.assert_allclose(getattr(profile, name), getattr(expected, name))
    assert len(analysis.performance_profile(ONE).places) == 101


def test_the_probability_of_improvement_has_the_interval_of_brunner_and_munzel() -> None:
    one, other = ONE[:, :1], OTHER[:, :1]
    found = analysis.probability_of_improvement(one, other)
    test = stats.brunnermunzel(other.ravel(), one.ravel())
    # The level at which the interval ends at 1/2 is one minus the p value.
    at = analysis.probability_of_improvement(one, other, level=1.0 - float(test.pvalue)).ends
    assert min(abs(end - 0.5) for end in at) < 1e-9
    assert found.ends[0] < found.value < found.ends[1]


def test_groups_that_do_not_overlap_have_no_interval() -> None:
    found = analysis.probability_of_improvement(ONE + 2.0, ONE)
    assert (found.value, found.low) == (1.0, None)
    assert found.note == "no interval: the scores of the two groups do not overlap"


# ---- Mean curves ---------------------------------------------------------------------------------


PAYOFFS = np.random.default_rng(0).random((4, 7, 5))


def test_bands_are_those_of_the_curves() -> None:
    bands = analysis.race_bands(PAYOFFS)
    curves = [analysis.generalization(payoff) for payoff in PAYOFFS]
    profiles = [analysis.lag_profile(payoff) for payoff in PAYOFFS]
    for band, of_runs in (
        (bands["pursuer_generalization"], [each.pursuers for each in curves]),
        (bands["evader_generalization"], [each.evaders for each in curves]),
        (bands["lag_profile"], [each.means for each in profiles]),
    ):
        expected = analysis.band_over_runs(of_runs, bounds=(0.0, 1.0))
        np.testing.assert_allclose(band.mean, expected.mean)
        np.testing.assert_allclose(band.low, expected.low)
        np.testing.assert_array_equal(band.runs, 4)
    np.testing.assert_array_equal(bands["lag_profile"].places, profiles[0].lags)
    ratings = [analysis.ELO_POINTS * analysis.elo(payoff).evaders for payoff in PAYOFFS]
    np.testing.assert_allclose(bands["evader_ratings"].mean, np.mean(ratings, axis=0))
    assert bands["evader_ratings"].low.min() < -20  # ratings have no bounds


def test_runs_that_lack_generations_count_where_they_are() -> None:
    runs = [PAYOFFS[0, :4, :3], *PAYOFFS[1:3]]
    bands = analysis.race_bands(runs)
    np.testing.assert_array_equal(bands["pursuer_generalization"].runs, [3, 3, 3, 3, 2, 2, 2])
    np.testing.assert_array_equal(bands["evader_generalization"].runs, [3, 3, 3, 2, 2])
    np.testing.assert_array_equal(bands["lag_profile"].places, np.arange(-4, 7))
    np.testing.assert_array_equal(bands["lag_profile"].runs, [2, 2, 3, 3, 3, 3, 3, 3, 2, 2, 2])
    for lag in (-4, -2, 0, 3, 6):
        known = [p for p in runs if -p.shape[1] < lag < p.shape[0]]
        values = [analysis.lag_profile(payoff).at(lag) for payoff in known]
        expected = analysis.interval_over_runs(values, bounds=(0.0, 1.0))
        place = lag + 4
        assert bands["lag_profile"].mean[place] == pytest.approx(expected.value)
        assert bands["lag_profile"].low[place] == pytest.approx(expected.low)


def test_a_point_of_one_run_has_no_interval() -> None:
    band = analysis.race_bands([PAYOFFS[0], PAYOFFS[1, :4, :3]])["pursuer_generalization"]
    assert np.isnan(band.low).tolist() == [False] * 4 + [True] * 3
    np.testing.assert_allclose(band.mean[4:], PAYOFFS[0].mean(axis=1)[4:])
    alone = analysis.race_bands(PAYOFFS[:1])
    assert (alone["pursuer_generalization"].low, alone["lag_profile"].high) == (None, None)
