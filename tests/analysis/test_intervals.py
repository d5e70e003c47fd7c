"""Intervals over runs and episodes, beside SciPy's and rliable's, their coverage, and curves."""

from itertools import permutations

import numpy as np
import pytest
from scipy import stats

from matrices import circular, logistic
from matrixworld import analysis
from matrixworld.analysis.cycles import _sums_without_noise
from matrixworld.analysis.intervals import (
    BIASED,
    difference_over_episodes,
    generalization_over_episodes,
    linear_over_episodes,
)
from matrixworld.analysis.judge import RULES
from matrixworld.analysis.progress import lag_rise
from matrixworld.analysis.ratings import ELO_POINTS
from matrixworld.analysis.runs import expanded_tail, fewest_runs, race_bands
from rliable_numbers import LEVEL, NUMBERS, ONE, OTHER, TASK, THRESHOLDS


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
    middle = analysis.interquartile_mean([[0.2, 0.8, 0.5]] * 7)
    assert (middle.low, middle.note) == (None, "no interval: all 7 runs are equal")
    assert analysis.difference_of_runs([0.3, 0.3], [0.2, 0.2]).low is None
    low, high = analysis.difference_of_runs([0.3, 0.3], [0.1, 0.2, 0.3]).ends
    assert low < 0.1 < high


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


DECIDING = {name for row in RULES.values() for name in row.measures} - {"checkerboards"}
MATRIX_MEASURES = [
    name for name in analysis.MEASURES if name not in DECIDING and "global" not in name
    and "rungs" not in name and "intransitivity" not in name and name != "effective_diversity"
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


def test_differences_cover_and_lie_within_their_bounds() -> None:
    rng = np.random.default_rng(0)
    covered = []
    for _ in range(300):
        found = difference_over_episodes(rng.random(10) < 0.9, rng.random(20) < 0.6)
        low, high = found.ends
        covered.append(low <= 0.3 <= high)
    assert np.mean(covered) > 0.94
    low, high = difference_over_episodes(np.ones(5), np.zeros(5)).ends
    assert 0.2 < low < high == 1.0


def test_linear_measures_cover_the_noise_free_measure() -> None:
    truth, rng = logistic(8), np.random.default_rng(3)
    covered = []
    for _ in range(300):
        scores = rng.random((8, 8, 5)) < truth[:, :, None]
        low, high = linear_over_episodes(scores, lag_rise).ends
        covered.append(low <= lag_rise(truth) <= high)
    assert 0.91 < np.mean(covered) < 0.99


def test_generalization_has_the_interval_of_each_mean() -> None:
    scores = np.random.default_rng(3).random((4, 3, 5))
    pursuers, evaders = generalization_over_episodes(scores, level=0.9)
    expected = analysis.generalization(scores.mean(axis=2))
    for band, curve, cells in (
        (pursuers, expected.pursuers, scores),
        (evaders, expected.evaders, 1 - scores.swapaxes(0, 1)),
    ):
        np.testing.assert_allclose(band.mean, curve)
        for g in range(len(curve)):
            one = linear_over_episodes(cells[g : g + 1], np.mean, level=0.9)
            assert (band.low[g], band.high[g]) == pytest.approx(one.ends)
    sure = generalization_over_episodes(np.eye(2)[..., None] * [1.0, 1.0, 0.9])[0]
    assert sure.high.max() < 1


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


def test_measures_say_which_interval_they_have() -> None:
    rng = np.random.default_rng(8)
    scores = rng.random((9, 9, 60)) < logistic(9)[:, :, None]
    payoffs = analysis.read_payoffs(scores, per_episode=True)
    for name in MATRIX_MEASURES:
        found = analysis.MEASURES[name].of(payoffs, "whole")
        biased = not (name in LINEAR or name == "transitive_share" or name.endswith("rating"))
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


# ---- Scores of several runs ----------------------------------------------------------------------


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


def test_scores_of_few_runs_have_no_interval() -> None:
    assert [fewest_runs(level) for level in (0.5, 0.9, 0.95, 0.99)] == [2, 5, 6, 8]
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


def test_the_probability_of_improvement_has_the_interval_of_brunner_and_munzel() -> None:
    one, other = ONE[:, :1], OTHER[:, :1]
    found = analysis.probability_of_improvement(one, other)
    test = stats.brunnermunzel(other.ravel(), one.ravel())
    # The level at which the interval ends at 1/2 is one minus the p value.
    at = analysis.probability_of_improvement(one, other, level=1.0 - float(test.pvalue)).ends
    assert min(abs(end - 0.5) for end in at) < 1e-9
    assert found.ends[0] < found.value < found.ends[1]


# ---- Mean curves ---------------------------------------------------------------------------------


PAYOFFS = np.random.default_rng(0).random((4, 7, 5))


def test_bands_are_those_of_the_curves() -> None:
    bands = race_bands(PAYOFFS)
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
    ratings = [ELO_POINTS * analysis.elo(payoff).evaders for payoff in PAYOFFS]
    np.testing.assert_allclose(bands["evader_ratings"].mean, np.mean(ratings, axis=0))
    assert bands["evader_ratings"].low.min() < -20  # ratings have no bounds


def test_runs_that_lack_generations_count_where_they_are() -> None:
    runs = [PAYOFFS[0, :4, :3], *PAYOFFS[1:3]]
    bands = race_bands(runs)
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
    band = race_bands([PAYOFFS[0], PAYOFFS[1, :4, :3]])["pursuer_generalization"]
    assert np.isnan(band.low).tolist() == [False] * 4 + [True] * 3
    np.testing.assert_allclose(band.mean[4:], PAYOFFS[0].mean(axis=1)[4:])
    alone = race_bands(PAYOFFS[:1])
    assert (alone["pursuer_generalization"].low, alone["lag_profile"].high) == (None, None)
