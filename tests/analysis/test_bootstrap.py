"""Coverage of intervals on data whose truth is known, and their special cases."""

from __future__ import annotations

import numpy as np
import pytest

from matrices import logistic
from matrixworld import analysis


def test_intervals_over_runs_have_their_nominal_coverage() -> None:
    rng = np.random.default_rng(0)
    covered = []
    for _ in range(300):
        found = analysis.bootstrap_runs(rng.normal(0.4, 0.1, 20), resamples=500, rng=rng)
        assert found.low is not None
        assert found.high is not None
        covered.append(found.low <= 0.4 <= found.high)
    assert 0.90 < np.mean(covered) < 0.98


def test_levels_widen_intervals() -> None:
    values = np.random.default_rng(1).random(12)
    narrow, wide = (analysis.bootstrap_runs(values, level=level) for level in (0.5, 0.99))
    assert narrow.low is not None
    assert wide.low is not None
    assert wide.low < narrow.low < values.mean()
    assert narrow.value == pytest.approx(values.mean())
    assert (narrow.over, narrow.samples, narrow.note) == ("runs", 12, "")


def test_a_single_run_has_no_interval_and_says_so() -> None:
    found = analysis.bootstrap_runs([0.25])
    assert (found.value, found.low, found.high, found.over) == (0.25, None, None, "nothing")
    assert found.note == "a single run has no interval over runs"
    assert str(found) == "0.250"


def test_few_runs_and_equal_runs() -> None:
    assert analysis.bootstrap_runs([0.1, 0.2]).note == "2 runs only: the interval is too narrow"
    same = analysis.bootstrap_runs([0.5] * 6)
    assert (same.low, same.high) == (0.5, 0.5)
    all_but_one = analysis.bootstrap_runs([0.0] * 9 + [1.0])
    assert all_but_one.low is not None
    assert all_but_one.high is not None
    assert 0.0 <= all_but_one.low < 0.1 < all_but_one.high <= 1.0


def test_the_same_seed_gives_the_same_interval() -> None:
    values = np.random.default_rng(2).random(8)
    assert analysis.bootstrap_runs(values, rng=5) == analysis.bootstrap_runs(values, rng=5)
    assert analysis.bootstrap_runs(values, rng=5) != analysis.bootstrap_runs(values, rng=6)


def test_intervals_over_episodes_cover_the_noise_free_measure() -> None:
    truth = logistic(8)
    rng = np.random.default_rng(3)
    covered = []
    for _ in range(100):
        scores = (rng.random((8, 8, 20)) < truth[:, :, None]).astype(float)
        found = analysis.bootstrap_episodes(
            scores, lambda m: float(m[-1].mean()), resamples=200, rng=rng
        )
        assert found.low is not None
        assert found.high is not None
        covered.append(found.low <= truth[-1].mean() <= found.high)
    assert 0.86 < np.mean(covered) <= 0.99


def test_noise_lowers_the_transitive_share_and_the_interval_is_corrected() -> None:
    scores = np.random.default_rng(4).random((15, 15, 20)) < logistic(15)[:, :, None]
    found = analysis.bootstrap_episodes(scores, analysis.transitive_share, bounds=(0.0, 1.0))
    assert found.low is not None
    assert found.high is not None
    assert found.value < found.low <= found.high <= 1.0
    assert found.note == "biased by episode noise: outside its own interval"
    again = analysis.bootstrap_episodes(scores, analysis.transitive_share, bounds=(0.0, 1.0))
    assert found == again


def test_a_measure_that_is_not_defined_has_no_interval() -> None:
    found = analysis.bootstrap_episodes(np.full((3, 3, 4), 0.5), analysis.transitive_share)
    assert np.isnan(found.value)
    assert found.low is None
    assert found.note == "not defined for this matrix"


def test_bands_are_pointwise_and_runs_stay_whole() -> None:
    curves = np.random.default_rng(5).normal(0, 1, (30, 1)) + np.arange(4)
    band = analysis.bootstrap_band(curves)
    np.testing.assert_allclose(band.mean, curves.mean(axis=0))
    assert band.low is not None
    assert band.high is not None
    # Runs differ by a shift: every point has the same interval around its mean.
    np.testing.assert_allclose(band.high - band.mean, (band.high - band.mean)[0])
    assert (band.high - band.low)[0] == pytest.approx(
        2 * 1.96 * curves[:, 0].std() / np.sqrt(30), rel=0.1
    )
    single = analysis.bootstrap_band(curves[:1])
    assert single.low is None
    np.testing.assert_array_equal(single.mean, curves[0])


@pytest.mark.parametrize(
    ("values", "settings", "message"),
    [
        ([], {}, r"values of runs of shape \(k,\), k >= 1, got \(0,\)"),
        ([[0.1]], {}, r"got \(1, 1\)"),
        ([0.1, np.nan], {}, "finite values of runs, got"),
        ([0.1, 0.2], {"level": 1.0}, r"level in \(0, 1\), got 1.0"),
        ([0.1, 0.2], {"resamples": 0}, "at least 1 resample, got 0"),
    ],
)
def test_bad_values_are_refused(
    values: list[float], settings: dict[str, float], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        analysis.bootstrap_runs(values, **settings)  # type: ignore[arg-type]


def test_bad_episodes_and_curves_are_refused() -> None:
    with pytest.raises(ValueError, match="at least 2 episodes a cell, got 1"):
        analysis.bootstrap_episodes(np.zeros((2, 2, 1)), np.mean)
    with pytest.raises(ValueError, match=r"curves of shape \(runs, k\), got \(3,\)"):
        analysis.bootstrap_band([0.1, 0.2, 0.3])
    with pytest.raises(ValueError, match="finite curves"):
        analysis.bootstrap_band([[0.1, np.inf]])
