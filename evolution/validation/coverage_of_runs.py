"""Simulated numbers and scores of several runs whose truth is known, for `interval_coverage`."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np

from matrixworld import analysis
from matrixworld.analysis import Estimate

RUNS = (2, 3, 5, 10, 20)
SCORED_RUNS = (3, 5, 6, 10, 20)
"""Numbers of runs whose scores are simulated."""
OPPONENTS = np.array([0.9, 0.7, 0.55, 0.4, 0.3, 0.1])
"""Mean score of a run against each opponent."""
NOISE = 0.05
"""Standard deviation of the score of a run against an opponent."""
MANY = 200_000
"""Runs from which a truth is computed; its error is far below that of twenty runs."""

Case = tuple[str, str]
"""Interval and data."""
Matrix = np.ndarray


@dataclass(frozen=True)
class Simulation:
    """Data of one kind and amount, and the intervals that the package gives for them."""

    size: int
    """Generations of each team; 0 without a matrix."""
    samples: int
    """Runs, or episodes of each cell."""
    truths: Mapping[Case, float]
    """True value of each interval and kind of data."""
    estimates: Callable[[np.random.Generator], Mapping[Case, Estimate]]
    """Draws data, and returns the estimate of each interval."""


# ---- One number of each run ----------------------------------------------------------------------


def _two_outcomes(share: float) -> Callable[[np.random.Generator, int], Matrix]:
    return lambda rng, n: np.where(rng.random(n) < share, 0.8, 0.2) + rng.normal(0, 0.03, n)


VALUES: dict[str, tuple[float, Callable[[np.random.Generator, int], Matrix]]] = {
    "normal": (0.4, lambda rng, n: rng.normal(0.4, 0.1, n)),
    "skewed": (2.0, lambda rng, n: rng.gamma(2.0, 1.0, n)),
    "very skewed": (math.exp(0.5), lambda rng, n: rng.lognormal(0.0, 1.0, n)),
    "heavy-tailed": (0.0, lambda rng, n: rng.standard_t(3, n)),
    "shares": (0.6, lambda rng, n: rng.beta(6.0, 4.0, n)),
    "shares near 0": (0.1, lambda rng, n: rng.beta(1.0, 9.0, n)),
    "two outcomes, 1 : 1": (0.5, _two_outcomes(0.5)),
    "two outcomes, 4 : 1": (0.32, _two_outcomes(0.2)),
}
"""Mean and distribution of the numbers of runs."""


def of_runs(name: str, runs: int) -> Simulation:
    """Return the mean of runs, and their difference from as many normal runs."""
    mean, draw = VALUES[name]
    bounds = (0.0, 1.0) if name.startswith("shares") else (-math.inf, math.inf)

    def estimates(rng: np.random.Generator) -> dict[Case, Estimate]:
        one, other = draw(rng, runs), rng.normal(0.4, 0.1, runs)
        return {
            ("mean of runs", name): analysis.interval_over_runs(one, bounds=bounds),
            ("difference of runs", name): analysis.difference_of_runs(one, other),
        }

    truths = {("mean of runs", name): mean, ("difference of runs", name): mean - 0.4}
    return Simulation(0, runs, truths, estimates)


# ---- Scores of runs against several opponents ----------------------------------------------------

EFFECTS: dict[str, Callable[[np.random.Generator, int], Matrix]] = {
    "normal": lambda rng, n: rng.normal(0.0, 0.1, n),
    "skewed": lambda rng, n: rng.gamma(1.0, 0.1, n) - 0.1,
    "two outcomes, 1 : 1": lambda rng, n: _two_outcomes(0.5)(rng, n) / 2 - 0.25,
    "two outcomes, 4 : 1": lambda rng, n: _two_outcomes(0.2)(rng, n) / 1.5 - 0.2,
}
"""What a run adds to its scores against all opponents."""


def scores_of(name: str, runs: int, rng: np.random.Generator) -> Matrix:
    """Return scores (runs, opponents) in [0, 1]; those of one run depend on each other."""
    effect = EFFECTS[name](rng, runs)[:, None]
    return np.clip(OPPONENTS + effect + rng.normal(0.0, NOISE, (runs, len(OPPONENTS))), 0.0, 1.0)


@cache
def true_scores(name: str) -> Mapping[Case, float]:
    """Return the interquartile mean of infinitely many runs."""
    ordered = np.sort(scores_of(name, MANY, np.random.default_rng(0)), axis=None)
    middle = ordered[ordered.size // 4 : -(ordered.size // 4)].mean()
    return {("interquartile mean", name): float(middle)}


def of_scores(name: str, runs: int) -> Simulation:
    """Return the interquartile mean of the scores of runs against several opponents."""

    def estimates(rng: np.random.Generator) -> dict[Case, Estimate]:
        scores = scores_of(name, runs, rng)
        found = analysis.interquartile_mean(scores, seed=int(rng.integers(2**31)))
        return {("interquartile mean", name): found}

    return Simulation(0, runs, true_scores(name), estimates)
