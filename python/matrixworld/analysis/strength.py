"""Strength of a team over a window: its change, its trend, and forgetting, with intervals.

Two questions about strength have two intervals. `strength_change`: how much did it change, given
the noise of the episodes? `strength_gain`: is there a trend, given that strength also fluctuates
from generation to generation? A random walk ends somewhere: it has a change, and no trend.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.analysis import intervals
from matrixworld.analysis.intervals import LEVEL, Estimate, t_ends, t_quantile
from matrixworld.analysis.payoffs import (
    GENERATIONS_TO_JUDGE,
    ByTeam,
    Rates,
    check_payoff,
    swap_teams,
)

GRID = 40  # values of each standard deviation over which the posterior is summed
WIDEST = (4.0, 3.0)
"""Largest standard deviations of steps and of fluctuation on the grid, in units of that of the
observed steps."""
PARTS = 5  # parts of a course, none of which may fall back, and of the opponents
SETBACK, OF_GAIN = 0.25, 0.05
"""Share of its change by which a sustained course goes back at most, and the course of a gain."""
OUTLYING, LEAST_OUTLYING = 4.0, 0.15
"""An outlying generation is so many standard deviations, and so much, from its neighbours."""
NEIGHBOURS, NEARBY = 3, 15  # generations on either side; all whose deviations are compared
PER_MEDIAN = 1.4826  # standard deviation of normal numbers by their median distance from 0
_NEGLIGIBLE = 1e-8  # weight of a point of the grid that is left out
_LEAST = 1e-9  # a team that never changes has steps of 0; the grid needs a width


def without_outliers(scores: Rates, noise: Rates) -> Rates:
    """Return scores (k, m) of a team; outlying generations lie on lines between the others."""
    is_outlying = outlying(scores.mean(axis=1), noise)
    if not is_outlying.any():
        return scores
    places, kept = np.arange(len(scores)), np.flatnonzero(~is_outlying)
    return np.stack([np.interp(places, kept, column[kept]) for column in scores.T], axis=1)


def outlying(course: Rates, noise: Rates) -> NDArray[np.bool_]:
    """Return which generations of a course (k,) of means are outlying.

    A generation is outlying if its mean is far from the median of seven generations, itself in the
    middle: as seen beside those of all generations, of those nearby, and beside the noise (k,), the
    variance of the means. A jump of strength is none, because it stays. The last generation is
    compared with the three before. If more than a third are outlying, none is.

    The filter is Hampel's: Davies and Gather (1993), "The identification of multiple outliers",
    Journal of the American Statistical Association 88.
    """
    size = len(course)
    found = np.zeros(size, bool)
    if size < GENERATIONS_TO_JUDGE:
        return found
    off = np.abs(course - _running_median(course))[1:-1]  # the ends have no neighbours
    first = np.clip(np.arange(size) - 1 - NEARBY // 2, 0, max(0, size - 2 - NEARBY))
    nearby = np.array([np.median(off[start : start + NEARBY]) for start in first])
    deviation = PER_MEDIAN * np.maximum(np.median(off), nearby)
    far = OUTLYING * np.maximum(deviation, np.sqrt(noise.mean()))
    far = np.maximum(far, LEAST_OUTLYING)
    found[1:-1] = off > far[1:-1]
    usual = course[1:-1][~found[1:-1]]
    if len(usual) >= NEIGHBOURS:
        step = float(np.median(np.abs(np.diff(usual))))
        last = abs(course[-1] - np.median(usual[-NEIGHBOURS:]))
        found[-1] = last > max(far[-1], OUTLYING * step)
    return found if found.sum() <= size / 3.0 else np.zeros(size, bool)


def fails_at_last(course: Rates, noise: Rates) -> bool:
    """Return whether the last generation is outlying, and weaker than those before."""
    before = np.median(course[-1 - NEIGHBOURS : -1])
    return bool(outlying(course, noise)[-1] and course[-1] < before)


def _running_median(course: Rates) -> Rates:
    """Return medians of each number and its neighbours, as many before as after it."""
    last = len(course) - 1
    reach = [min(NEIGHBOURS, at, last - at) for at in range(len(course))]
    return np.array([np.median(course[at - r : at + r + 1]) for at, r in enumerate(reach)])


def strength_gain(scores: Rates, noise: Rates, *, level: float = LEVEL) -> Estimate:
    """Return how much the strength of a team changes by its trend: ``k - 1`` times the drift.

    The scores (k,), of at least 4 generations, are mean payoffs against the same opponents, the
    noise (k,) is the variance of their errors, 0 if unknown. The model is a random walk with drift
    that is observed with fluctuation and noise (the local level model with drift, Harvey 1989)::

        score[g]        = strength[g] + fluctuation[g] + error[g]
        strength[g + 1] = strength[g] + drift + step[g]
        step ~ N(0, s^2)    fluctuation ~ N(0, t^2)    error ~ N(0, mean noise)

    A team that improves steadily has small steps, so its drift is known, also if single generations
    fluctuate about it; that of a team that jumps once, or drifts at random, cannot be told from 0.
    The credible interval is equal-tailed. The prior is flat on the drift and on t, and half-normal
    on s at the scale of the observed steps (Gelman 2006); s and t are summed out on a grid.
    """
    steps = len(scores) - 1
    drifts, deviations, weights = _posterior(np.diff(scores), float(noise.mean()))
    tail = (1.0 - level) / 2.0
    low, middle, high = (
        steps * _quantile(p, drifts, deviations, weights) for p in (tail, 0.5, 1.0 - tail)
    )
    # A mean score lies in [0, 1], so it cannot change by more than 1.
    low, middle, high = np.clip([low, middle, high], -1.0, 1.0).tolist()
    return Estimate(middle, low, high, "episodes")


def gain_of_runs(scores: Rates, noise: Rates, *, level: float = LEVEL) -> Estimate:
    """Return the gain of a team over several runs; scores and noise have the shape (runs, k).

    Runs that are too few for a mean have the interval that contains those of all of them.
    """
    # It is that of their mean course if this never falls back (a smooth curve may rise by chance,
    # and then falls), and if runs also gain without the tenth in which each would have jumped: of
    # runs that jump once, each at its own time, the mean rises evenly. Otherwise the interval
    # reaches to 0, or to what is left.
    if 1 < len(scores) < intervals.RUNS_FOR_T:
        courses = zip(scores[:, np.newaxis], noise[:, np.newaxis], strict=True)
        return intervals.around([gain_of_runs(*each, level=level) for each in courses])
    gain = _gain_of_mean_course(scores, noise, level)
    sign = 1.0 if gain.value > 0.0 else -1.0
    least = 1.0 if setback(scores.mean(axis=0)) < OF_GAIN else 0.0
    if len(scores) > 1:
        left = _without_jumps(sign * scores) @ _slope_weights(scores.shape[1])
        # One end of this interval has the error of both of the other.
        least = min(least, t_ends(left, 2.0 * level - 1.0, (-1.0, 1.0))[0])
    if least > 0.0:
        return gain
    low, high = gain.ends
    if sign > 0.0:
        return replace(gain, low=min(low, least))
    return replace(gain, high=max(high, -least))


def _without_jumps(scores: Rates) -> Rates:
    """Return courses (runs, k) without the tenth around the time that best divides each in two."""
    # It divides where the means, weighted by the generations before and after, differ most: unlike
    # the steepest tenth this is not chosen by the noise of single generations.
    steps = np.diff(scores, axis=1)
    k = scores.shape[1]
    before = np.arange(1, k)
    sums = np.cumsum(scores, axis=1)
    means = sums[:, :-1] / before, (sums[:, -1:] - sums[:, :-1]) / (k - before)
    places = ((means[1] - means[0]) * np.sqrt(before * (k - before))).argmax(axis=1)
    first = np.clip(places - _tenth(k) // 2, 0, k - 1 - _tenth(k))
    at = np.arange(k - 1) - first[:, np.newaxis]
    steps[(at >= 0) & (at < _tenth(k))] = 0.0
    return np.concatenate([scores[:, :1], scores[:, :1] + steps.cumsum(axis=1)], axis=1)


def _gain_of_mean_course(scores: Rates, noise: Rates, level: float) -> Estimate:
    """Return the `strength_gain` of the mean course of several runs."""
    # Several runs have a second interval, Student's t over the runs' linear changes, which becomes
    # narrower with each run; it counts if the mean course is sustained, because a jump in the same
    # generation of all runs is no trend. Both have half of the error; what both contain remains.
    runs = len(scores)
    course = scores.mean(axis=0)
    errors = noise.mean(axis=0) / runs
    changes = scores @ _slope_weights(scores.shape[1])
    if runs == 1 or not is_sustained(course):
        return strength_gain(course, errors, level=level)
    both = (1.0 + level) / 2.0
    one_low, one_high = strength_gain(course, errors, level=both).ends
    other_low, other_high = t_ends(changes, both, (-1.0, 1.0))
    low = max(one_low, other_low)
    high = min(one_high, other_high)
    if low > high:  # the two models disagree
        low, high = high, low
    return Estimate(float(np.clip(changes.mean(), low, high)), low, high, "runs")


def is_sustained(course: Rates) -> bool:
    """Return whether a course keeps its direction: that of its linear change. It may rest."""
    # No tenth of it, and no two steps, make half of the change; it goes back by a quarter at most.
    change = float(_slope_weights(len(course)) @ course)
    if abs(change) <= _LEAST:  # of a course that rests, rounding alone has a direction
        return False
    forward = course * np.sign(change)
    tenth = _tenth(len(course))
    jump = (forward[tenth:] - forward[:-tenth]).max()
    return bool(jump < abs(change) / 2.0) and setback(course) < SETBACK


def setback(course: Rates) -> float:
    """Return the most by which a course goes back from part to part, as a share of its change."""
    change = float(_slope_weights(len(course)) @ course)
    parts = np.array([part.mean() for part in np.array_split(course * np.sign(change), PARTS)])
    return -float(np.diff(parts).min()) / max(abs(change), _LEAST)


def falls_back(scores: Rates) -> bool:
    """Return whether a team of scores (k, m) loses again, against some, what it had gained."""
    # Its mean against a part of the opponents falls by more than a quarter of its change and noise.
    change = float(_slope_weights(len(scores)) @ scores.mean(axis=1))
    rows = (part.mean(axis=0) for part in np.array_split(scores, PARTS))
    parts = np.array([[c.mean() for c in np.array_split(row, PARTS)] for row in rows])
    drops = np.maximum.accumulate(parts, axis=0) - parts
    # Neighbours differ by noise, but for their strengths, which these contrasts do not hold.
    contrasts = np.diff(np.diff(scores, axis=0), axis=1)
    noise = float((contrasts**2).mean()) / 4.0 * parts.size / scores.size
    return bool(drops.max() > abs(change) / 4.0 + 2.0 * np.sqrt(2.0 * noise))


def _tenth(generations: int) -> int:
    # Two steps at least: a jump that some runs make a generation later is a jump.
    return max(2, generations // 10)


def _slope_weights(generations: int) -> Rates:
    """Return the weights (k,) with which scores add up to ``k - 1`` times their slope."""
    places = np.arange(generations) - (generations - 1) / 2.0
    weights: Rates = (generations - 1) * places / (places**2).sum()
    return weights


def strength_change(scores: Rates, noise: Rates, *, level: float = LEVEL) -> Estimate:
    """Return the linear change of strength: ``k - 1`` times the slope of a regression line.

    The interval is normal with the known noise, or Student's t with the scatter if all noise is 0.
    """
    weights = _slope_weights(len(scores))
    value = float(weights @ scores)
    variances = noise
    freedom = np.inf
    if not variances.any():
        freedom = len(scores) - 2
        residuals = scores - scores.mean() - weights * value / (weights**2).sum()
        variances = np.full(len(scores), (residuals**2).sum() / freedom)
    reach = float(t_quantile(level, freedom) * np.sqrt(weights**2 @ variances))
    return Estimate(value, value - reach, value + reach, "episodes")


def _posterior(steps: Rates, noise: float) -> tuple[Rates, Rates, Rates]:
    """Return mean and standard deviation of the drift for each s and t, and their weights."""
    spread = max(float(steps.std()), _LEAST)
    middles = (np.arange(GRID) + 0.5) / GRID * spread
    s, t = (grid.reshape(-1, 1) for grid in np.meshgrid(*(most * middles for most in WIDEST)))
    # Neighbouring differences share a score: covariance 2, -1 on the diagonals, whose eigenvectors
    # are sines.
    k = np.arange(1, len(steps) + 1)
    angles = np.pi * k / (len(steps) + 1)
    vectors = np.sin(np.outer(k, angles)) * np.sqrt(2.0 / (len(steps) + 1))
    ones, values = vectors.sum(axis=0), vectors.T @ steps
    precision = 1.0 / ((noise + t**2) * (2.0 - 2.0 * np.cos(angles)) + s**2)
    total = (precision * ones**2).sum(axis=1)
    drifts = (precision * ones * values).sum(axis=1) / total
    misfit = (precision * (values - drifts[:, np.newaxis] * ones) ** 2).sum(axis=1)
    # The likelihood of s and t with the drift integrated out.
    log_weights = 0.5 * (np.log(precision).sum(axis=1) - np.log(total) - misfit)
    log_weights -= 0.5 * (s[:, 0] / spread) ** 2
    weights = np.exp(log_weights - log_weights.max())
    kept = weights > _NEGLIGIBLE * weights.sum()
    return drifts[kept], total[kept] ** -0.5, weights[kept] / weights[kept].sum()


def _quantile(probability: float, means: Rates, deviations: Rates, weights: Rates) -> float:
    """Return a quantile of a mixture of normal distributions."""
    from scipy.optimize import brentq
    from scipy.special import ndtr

    reach = 12.0 * float(deviations.max())
    ends = float(means.min()) - reach, float(means.max()) + reach
    return float(brentq(lambda x: weights @ ndtr((x - means) / deviations) - probability, *ends))


# ---- Forgetting ----------------------------------------------------------------------------------


def forgetting(payoff: ArrayLike) -> ByTeam[Rates]:
    """Return how far each generation falls below the best of its ancestors, over all opponents.

    For pursuers of generation g in `payoff` (n, m): mean over h of ``max(M[:g + 1, h]) - M[g, h]``;
    for evaders the same on ``1 - M``. The maximum of many noisy cells is too high by chance, so a
    few hundredths mean nothing; ``MEASURES["pursuer_forgetting"]`` allows for it.

    Chaudhry et al. (2018), "Riemannian walk for incremental learning", where forgetting is measured
    at the end of training only.
    """
    matrix = check_payoff(payoff)
    swapped = swap_teams(matrix)
    return ByTeam(_drops(matrix, matrix), _drops(swapped, swapped))


def late_forgetting(payoff: Rates, generations: slice) -> float:
    """Return the mean `forgetting` of the row team over the later half of some generations."""
    return float(_drops(payoff, payoff)[_later_half(generations)].mean())


def late_forgetting_over_episodes(
    halves: tuple[Rates, Rates], noise: Rates, generations: slice, level: float
) -> Estimate:
    """Return `late_forgetting` without selection bias, with an interval over episodes.

    The halves (n, m) are payoffs in two sets of equally many episodes, the noise (n, m) the
    variance of the mean of both. `biased_high` is `late_forgetting`, which is not too low.
    """
    # One set chooses the best ancestors and the other one measures, then they change roles: the
    # number is not too high on average. The interval reaches from below the first to above the
    # second.
    (first, second), late = halves, _later_half(generations)
    value = float(((_drops(first, second) + _drops(second, first)) / 2.0)[late].mean())
    both = (first + second) / 2.0
    naive = late_forgetting(both, generations)
    reach = intervals.normal_quantile(level)
    # The two directions share episodes; the mean of their errors holds for any correlation.
    errors = [_error(chooses, 2.0 * noise, late) for chooses in (first, second)]
    low = value - reach * float(np.mean(errors))
    high = naive + reach * _error(both, noise, late)
    # No generation can fall below ancestors by less than 0; noise can make the estimate negative.
    return Estimate(
        max(0.0, value), low, max(high, value), "episodes", biased_low=value, biased_high=naive
    )


def _later_half(generations: slice) -> slice:
    return slice((generations.start + generations.stop) // 2, generations.stop)


def _drops(chooses: Rates, measures: Rates) -> Rates:
    """Return the drop of each row below the best row so far, mean over columns; shape (n,)."""
    heights = np.take_along_axis(measures, _best_so_far(chooses), axis=0)
    drops: Rates = (heights - measures).mean(axis=1)
    return drops


def _best_so_far(scores: Rates) -> NDArray[np.intp]:
    """Return for each cell the row of the best cell of its column so far; of equals the first."""
    rows = np.arange(len(scores))[:, np.newaxis]
    best = np.maximum.accumulate(scores, axis=0)
    # A new best is above all before it; the row number of the last new best is carried on.
    before = np.vstack([np.full((1, scores.shape[1]), -np.inf), best[:-1]])
    best_row: NDArray[np.intp] = np.maximum.accumulate(np.where(scores > before, rows, 0), axis=0)
    return best_row


def _error(chooses: Rates, variance: Rates, generations: slice) -> float:
    """Return the standard error of the mean drop, given which ancestors were chosen."""
    # The mean drop is a sum of cells with these weights: + for the best ancestor, - for the row.
    weights = np.zeros_like(chooses)
    chosen = _best_so_far(chooses)[generations]
    columns = np.broadcast_to(np.arange(chooses.shape[1]), chosen.shape)
    np.add.at(weights, (chosen, columns), 1.0)
    weights[generations] -= 1.0
    return float(np.sqrt((weights**2 * variance).sum()) / chosen.size)
