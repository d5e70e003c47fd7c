"""Mean curves of several runs: means, intervals, and runs that lack generations."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import analysis


@pytest.fixture
def payoffs() -> list[np.ndarray]:
    rng = np.random.default_rng(0)
    return [rng.random((7, 5)) for _ in range(4)]


def test_bands_are_those_of_the_curves(payoffs: list[np.ndarray]) -> None:
    bands = analysis.race_bands(payoffs)
    curves = [analysis.generalization(payoff) for payoff in payoffs]
    profiles = [analysis.lag_profile(payoff) for payoff in payoffs]
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
    ratings = [analysis.ELO_POINTS * analysis.elo(payoff).evaders for payoff in payoffs]
    np.testing.assert_allclose(bands["evader_ratings"].mean, np.mean(ratings, axis=0))
    assert bands["evader_ratings"].low is not None
    assert bands["evader_ratings"].low.min() < -20  # ratings have no bounds


def test_runs_that_lack_generations_count_where_they_are(payoffs: list[np.ndarray]) -> None:
    short = payoffs[0][:4, :3]
    bands = analysis.race_bands([short, *payoffs[1:3]])
    np.testing.assert_array_equal(bands["pursuer_generalization"].runs, [3, 3, 3, 3, 2, 2, 2])
    np.testing.assert_array_equal(bands["evader_generalization"].runs, [3, 3, 3, 2, 2])
    np.testing.assert_array_equal(bands["lag_profile"].places, np.arange(-4, 7))
    np.testing.assert_array_equal(bands["lag_profile"].runs, [2, 2, 3, 3, 3, 3, 3, 3, 2, 2, 2])
    for lag in (-4, -2, 0, 3, 6):
        known = [p for p in (short, *payoffs[1:3]) if -p.shape[1] < lag < p.shape[0]]
        values = [analysis.lag_profile(payoff).at(lag) for payoff in known]
        expected = analysis.interval_over_runs(values, bounds=(0.0, 1.0))
        place = lag + 4
        assert bands["lag_profile"].mean[place] == pytest.approx(expected.value)
        assert bands["lag_profile"].low is not None
        assert bands["lag_profile"].low[place] == pytest.approx(expected.low)


def test_a_point_of_one_run_has_no_interval(payoffs: list[np.ndarray]) -> None:
    bands = analysis.race_bands([payoffs[0], payoffs[1][:4, :3]])
    assert bands["pursuer_generalization"].low is not None
    np.testing.assert_array_equal(
        np.isnan(bands["pursuer_generalization"].low), [False] * 4 + [True] * 3
    )
    mean = bands["pursuer_generalization"].mean
    np.testing.assert_allclose(mean[4:], payoffs[0].mean(axis=1)[4:])
    alone = analysis.race_bands(payoffs[:1])
    assert (alone["pursuer_generalization"].low, alone["lag_profile"].high) == (None, None)


def test_bad_payoffs_are_refused() -> None:
    with pytest.raises(ValueError, match="at least one run, got none"):
        analysis.race_bands([])
    with pytest.raises(ValueError, match="got 2"):
        analysis.race_bands([[[0.5, 2.0]]])
    with pytest.raises(ValueError, match="a run with a value at each point"):
        analysis.band_over_runs([[0.1, np.nan], [0.2, np.nan]])
