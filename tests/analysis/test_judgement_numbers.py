"""The numbers behind a judgement, each against an independent or slower computation."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats

from matrices import circular, payoffs
from matrixworld import analysis
from matrixworld.analysis import strength
from matrixworld.analysis.cycles import squared_intransitivity, transitive_fit
from matrixworld.analysis.measures import over_runs
from matrixworld.analysis.progress import one_sidedness

rates = payoffs(least=3, most=8, parts=8)


def played(chance, episodes, seed=0):
    rng = np.random.default_rng(seed)
    return (rng.random((*chance.shape, episodes)) < chance[..., None]).astype(float)


def test_gain_agrees_with_a_sum_over_a_grid():
    """Of drifts, steps and fluctuations, with full covariances, as at commit 8e1a8000."""
    y = np.array([0.2, 0.25, 0.23, 0.31, 0.36, 0.33, 0.42, 0.5])
    found = strength.strength_gain(y, np.full(len(y), 1e-3))
    assert [found.value, found.low, found.high] == pytest.approx([0.28, 0.091, 0.483], abs=0.01)


def test_a_jump_has_a_change_and_no_trend():
    steady, jump = np.linspace(0.3, 0.7, 15), np.where(np.arange(15) < 7, 0.3, 0.7)
    noise = np.full(15, 1e-4)
    assert strength.strength_gain(steady, noise).low > 0.3
    assert strength.strength_gain(jump, noise).low < 0.0
    assert strength.strength_change(jump, noise).low > 0.3


@pytest.mark.parametrize("runs", [3, 5, 10])
def test_runs_that_jump_once_at_their_own_times_do_not_gain(runs):
    rng, t = np.random.default_rng(runs), np.linspace(0, 1, 31)
    known = np.full((runs, 31), 0.01**2)
    gains = []
    for _ in range(40):
        noise, moments = rng.normal(0, 0.01, (runs, 31)), rng.uniform(0.1, 0.9, (runs, 1))
        jumps, climbs = 0.3 + 0.4 * (t > moments) + noise, 0.3 + 0.4 * t + noise
        assert strength.gain_of_runs(climbs, known).low > 0.3
        gains.append(strength.gain_of_runs(jumps, known).low > 0.0)
        assert gains[-1] == (strength.gain_of_runs(1 - jumps, known).high < 0.0)
    assert sum(gains) <= 5  # 2 of 40 are allowed; more than 5 are unlikely by chance


@pytest.mark.parametrize("runs", [1, 5, 40])
def test_more_runs_make_the_interval_of_a_gain_narrower(runs):
    sigmoid = 0.3 + 0.4 / (1 + np.exp(-np.linspace(-6, 6, 15)))
    rng = np.random.default_rng(runs)
    courses = sigmoid + rng.normal(0, 0.02, (runs, 15))
    found = strength.gain_of_runs(courses, np.full((runs, 15), 0.02**2))
    width = found.high - found.low
    assert width < {1: 0.8, 5: 0.1, 40: 0.02}[runs]
    assert found.low <= found.value <= found.high
    assert (runs < 4) == (width > 0.3)
    # A team that falls is a team that rises, upside down.
    fallen = strength.gain_of_runs(1 - courses, np.full((runs, 15), 0.02**2))
    assert (fallen.low, fallen.high) == pytest.approx((-found.high, -found.low))


def test_change_is_a_regression_with_known_noise():
    rng = np.random.default_rng(0)
    y = rng.random(9)
    found = strength.strength_change(y, np.full(9, 0.01))
    slope, _ = np.polyfit(np.arange(9), y, 1)
    assert found.value == pytest.approx(8 * slope)
    assert found.high - found.value == pytest.approx(1.96 * 8 * 0.1 / np.sqrt(60), rel=1e-3)
    # Unknown noise: the interval of ordinary regression.
    line = stats.linregress(np.arange(9), y)
    unknown = strength.strength_change(y, np.zeros(9))
    reach = 8 * line.stderr * stats.t.ppf(0.975, 7)
    assert (unknown.low, unknown.high) == pytest.approx((8 * slope - reach, 8 * slope + reach))


@settings(deadline=None)
@given(rates, st.integers(0, 2**32 - 1))
def test_the_transitive_fit_is_the_nearest_monotone_matrix(matrix, seed):
    order = np.ix_(*(np.argsort(matrix.mean(axis), kind="stable") for axis in (1, 0)))
    values, fit = matrix[order], transitive_fit(matrix)[order]
    assert (np.diff(fit, axis=0) >= -1e-3).all()
    assert (np.diff(fit, axis=1) >= -1e-3).all()
    # A projection on a convex cone: no monotone matrix lies on the other side of it.
    rng = np.random.default_rng(seed)
    other = np.sort(np.sort(rng.random(values.shape), axis=0), axis=1)
    assert ((values - fit) * (other - fit)).sum() <= 1e-2
    assert ((values - fit) * fit).sum() == pytest.approx(0.0, abs=1e-2)


def test_the_amplitude_of_a_cycle_is_found_under_noise():
    chance = circular(31)
    exact = squared_intransitivity(chance, np.zeros_like(chance))
    # A part of the cosine, which has .32, lies in the nearest order.
    assert 0.26 < exact.value**0.5 < 0.45 / 2**0.5
    scores = played(chance, 10)
    noise = scores.var(axis=2, ddof=1) / 10
    found = squared_intransitivity(scores.mean(axis=2), noise)
    # The order of equally strong generations is chance, and with it that part.
    assert found.value**0.5 == pytest.approx(exact.value**0.5, abs=0.03)
    assert found.low > 0.2**2


@given(rates)
def test_forgetting_agrees_with_its_definition(matrix):
    found = analysis.forgetting(matrix)
    n, m = matrix.shape
    for g in range(n):
        drops = [max(matrix[: g + 1, h]) - matrix[g, h] for h in range(m)]
        assert found.pursuers[g] == pytest.approx(np.mean(drops))
    for h in range(m):
        drops = [matrix[g, h] - min(matrix[g, : h + 1]) for g in range(n)]
        assert found.evaders[h] == pytest.approx(np.mean(drops))


def test_late_forgetting_of_two_sets_of_episodes_by_hand():
    one = np.array([[0.9], [0.2], [0.5]])
    other = np.array([[0.6], [0.7], [0.1]])
    # `one` chooses row 0 always; measured 0, .6 - .7, .6 - .1. `other` chooses rows 0, 1, 1;
    # measured 0, 0, .2 - .5. The later half is the last two.
    found = strength.late_forgetting_over_episodes(
        (one, other), np.zeros((3, 1)), slice(0, 3), 0.95
    )
    assert found.biased_low == pytest.approx(((-0.1 + 0.0) / 2 + (0.5 - 0.3) / 2) / 2)


def test_one_sidedness_has_the_interval_of_clopper_and_pearson():
    found = one_sidedness(np.full((1, 2), 0.9), 50, level=0.95)
    exact = stats.binomtest(90, 100).proportion_ci(0.95, method="exact")
    assert (found.low, found.high) == pytest.approx((exact.low, exact.high))
    assert one_sidedness(np.full((1, 2), 0.1), 50, level=0.95) == found
    # Two stretches of one generation share the level.
    wider = stats.binomtest(90, 100).proportion_ci(0.975, method="exact")
    assert one_sidedness(np.full((2, 2), 0.9), 50, level=0.95).low == pytest.approx(wider.low)
    assert one_sidedness(np.ones((4, 2)), 10, level=0.95).high == 1.0


def test_means_over_runs_rest_on_values_that_err_to_a_known_side():
    singles = [
        analysis.Estimate(0.2, 0.0, 0.5, biased_low=x - 0.1, biased_high=x + 0.1)
        for x in (0.1, 0.2, 0.3)
    ]
    assert over_runs(singles, 0.95).ends == (0.0, 0.5)  # of few runs, what contains all of them
    # Of two more, which are the mean: the standard deviation is .1 / 2**.5.
    reach = stats.t.ppf(0.975, 4) * 0.1 / 10**0.5
    assert over_runs([*singles, *singles[1:2] * 2], 0.95).ends == pytest.approx(
        (0.1 - reach, 0.3 + reach)
    )


def outlying(course, noise=0.0):
    """Return the generations that a judgement of progress leaves out."""
    scores = np.repeat(np.asarray(course, float)[:, None], 3, axis=1)
    left = strength.without_outliers(scores, np.full(len(scores), noise))
    changed = np.flatnonzero(np.abs(left - scores).max(axis=1) > 1e-12)
    places = np.arange(len(scores))
    kept = np.setdiff1d(places, changed)
    np.testing.assert_allclose(left[:, 0], np.interp(places, kept, scores[kept, 0]))
    return changed.tolist()


def test_generations_that_fail_are_left_out_and_jumps_are_not():
    climb = np.linspace(0.2, 0.8, 24)
    failed = climb.copy()
    failed[[3, 10, 11, 23]] -= 0.4
    assert outlying(failed) == [3, 10, 11, 23]
    assert outlying(1.0 - failed) == [3, 10, 11, 23]
    assert outlying(failed, noise=0.15**2) == []  # as much may be noise
    for usual in (
        climb,
        np.where(np.arange(24) < 12, 0.2, 0.8),  # a jump
        np.minimum(climb, 0.4),
        np.r_[0.0, np.full(23, 0.7)],  # only the untrained generation is weak
        np.resize([0.2, 0.8], 24),  # each second one: this is no failure
        np.random.default_rng(0).normal(0.5, 0.05, 24).cumsum() / 24,
        failed[:5],
    ):
        assert outlying(usual) == []


def test_a_trend_is_found_although_generations_fail():
    rng = np.random.default_rng(1)
    found = {True: 0, False: 0}
    for _ in range(20):
        climb = np.linspace(0.3, 0.7, 31) + rng.normal(0.0, 0.02, 31)
        climb[1 + rng.choice(30, 5, replace=False)] -= 0.3
        scores = np.repeat(climb[:, None], 3, axis=1)
        noise = np.full(31, 1e-4)
        for left_out in found:
            course = strength.without_outliers(scores, noise) if left_out else scores
            gain = strength.gain_of_runs(course.mean(axis=1)[None], noise[None])
            found[left_out] += gain.low > 0.0
    assert found[True] >= 15 >= 5 + found[False]
