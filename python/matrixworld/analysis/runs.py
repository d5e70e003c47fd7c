"""Several runs: mean curves, and scores against the same opponents."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_integer
from matrixworld.analysis import intervals
from matrixworld.analysis.intervals import LEVEL, UNIT, Band, Estimate
from matrixworld.analysis.payoffs import Rates, check_finite, check_rates
from matrixworld.analysis.progress import generalization, lag_profile
from matrixworld.analysis.ratings import ELO_POINTS, elo

RESAMPLES = 2000
"""Bootstrap samples of an interquartile mean; the ends of the interval then vary by some percent of
its width."""
TRIMMED = 0.25  # share of the scores that an interquartile mean leaves out at each end


def fewest_runs(level: float = LEVEL) -> int:
    """Return the fewest runs with which intervals of scores are given: 6 at a level of 95 %."""
    intervals.check_level(level)
    # All n runs lie on the same side of the median with probability ``2 ** (1 - n)``, so a
    # bootstrap interval of fewer runs cannot reach the level, whatever its method.
    return max(2, math.ceil(1.0 - math.log2(1.0 - level)))


def interquartile_mean(scores: ArrayLike, *, level: float = LEVEL, seed: int = 0) -> Estimate:
    """Return the mean of the middle half of all scores, with a bootstrap interval over runs.

    Single runs that fail and single opponents that are easy count less than in the mean. There is
    no interval below 6 runs (at 95 %), and if all runs are equal.

    Parameters
    ----------
    scores : array_like of float, shape (runs, opponents)
        One finite score of each run against each opponent, such as the held-out ones.
    level : float, optional
        Confidence level, in (0, 1).
    seed : int, optional
        Seed of the bootstrap samples.

    Notes
    -----
    Whole runs are resampled, because scores of one run against several opponents depend on each
    other. The interval is an expanded percentile interval (Hesterberg), since plain percentiles are
    too narrow for few runs.

    References
    ----------
    Agarwal et al. (2021), "Deep reinforcement learning at the edge of the statistical precipice",
    NeurIPS. Hesterberg (2015), "What teachers should know about the bootstrap", The American
    Statistician 69(4).
    """
    array = check_finite(scores, "scores (runs, opponents)", ndim=2)
    value, runs, fewest = _middle_mean(array), len(array), fewest_runs(level)
    if runs < fewest:
        return Estimate(value, samples=runs, note=f"no interval below {fewest} runs")
    if np.ptp(array, axis=0).max() == 0.0:
        return Estimate(value, samples=runs, note=f"no interval: all {runs} runs are equal")
    rng = np.random.default_rng(check_integer("seed", seed, 0))
    drawn = [_middle_mean(array[rng.integers(runs, size=runs)]) for _ in range(RESAMPLES)]
    tail = expanded_tail(runs, level)
    low, high = np.quantile(drawn, [tail, 1.0 - tail])
    return Estimate(value, float(low), float(high), "runs", runs)


def expanded_tail(runs: int, level: float) -> float:
    """Return the probability below the lower end of an expanded percentile interval."""
    from scipy.special import ndtr

    return float(ndtr(-math.sqrt(runs / (runs - 1)) * float(intervals.t_quantile(level, runs - 1))))


def _middle_mean(scores: Rates) -> float:
    ordered = np.sort(scores, axis=None)
    cut = int(TRIMMED * len(ordered))
    return float(ordered[cut : len(ordered) - cut].mean())


def race_bands(payoffs: ArrayLike) -> dict[str, Band]:
    """Return mean generalization, Elo points and lag profile of runs (runs, n, m), with intervals.

    By name: ``pursuer_generalization``, ``evader_ratings`` and so on, and ``lag_profile``.
    """
    matrices = check_rates(payoffs, ndim=3, what="payoff matrices (runs, n, m)")
    found: dict[str, Band] = {}
    for team in ("pursuers", "evaders"):
        scores = [getattr(generalization(matrix), team) for matrix in matrices]
        ratings = [ELO_POINTS * getattr(elo(matrix), team) for matrix in matrices]
        found[f"{team[:-1]}_generalization"] = intervals.band_over_runs(scores, bounds=UNIT)
        found[f"{team[:-1]}_ratings"] = intervals.band_over_runs(ratings)
    profiles = [lag_profile(matrix) for matrix in matrices]
    lags, means = profiles[0].lags, [profile.means for profile in profiles]
    found["lag_profile"] = intervals.band_over_runs(means, places=lags, bounds=UNIT)
    return found
