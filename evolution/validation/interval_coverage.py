"""How often do the package's intervals contain the truth? Simulated data whose truth is known.

    python evolution/validation/interval_coverage.py           400 repetitions, some ten minutes
    python evolution/validation/interval_coverage.py --quick   20 repetitions, seconds

An interval of level 95 % should contain the true value in 95 of 100 repetitions. The data are runs
(normal, skewed, heavy-tailed, bounded shares, two outcomes), their scores against several
opponents, payoff matrices (four true matrices, win or loss and shares of 30 evaders whose captures
are correlated), ratings of these and of a matrix of steps, scores of one pair, and collision
counts. Intervals that the package withholds are counted as not given.

Method: the functions of ``matrixworld.analysis`` and `matrixworld.SafetyMonitor`, with their
sources. Look at the worst case of each interval, and at the exceptions below 90 %. ``--results``
receives the table and the counts behind it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits
from tqdm import tqdm

import _paths  # noqa: F401
import judgement_tables
import matrixworld as mw
from common import markdown, script_parser
from matrixworld import analysis
from matrixworld.analysis import MEASURES, Estimate
from matrixworld.analysis.intervals import difference_over_episodes, linear_over_episodes
from matrixworld.analysis.measures import Measure
from matrixworld.analysis.ratings import ELO_POINTS

RUNS = (2, 3, 5, 10, 20)
SCORED_RUNS = (3, 5, 6, 10, 20)
"""Numbers of runs whose scores are simulated."""
EPISODES = (4, 10, 50, 200)
SIZES = (8, 15, 31)
SAFETY_EPISODES = (20, 50, 100)
RATED = ((8, 4), (8, 10), (8, 50), (15, 10), (15, 50), (31, 10))
"""Sizes and episodes of the matrices whose ratings are measured."""
QUICK_LIMIT = 10
"""Most runs or episodes with ``--quick``; matrices then have the smallest size only."""
EVADERS = 30
CONCENTRATION = 4.0  # of the beta distribution of an episode's capture rate: correlated captures
FEWEST_GIVEN = 100
"""Fewest intervals of a case for its coverage to be quoted as the worst one."""
ENOUGH = 0.90
"""Coverage below this is an exception."""

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


@dataclass(frozen=True)
class Count:
    """Of one case: data sets, intervals that are given, and those that contain the truth."""

    interval: str
    data: str
    size: int
    samples: int
    repetitions: int
    given: int
    covered: int


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

OPPONENTS = np.array([0.9, 0.7, 0.55, 0.4, 0.3, 0.1])
"""Mean score of a run against each opponent."""
NOISE = 0.05
"""Standard deviation of the score of a run against an opponent."""
MANY = 200_000
"""Runs from which a truth is computed; its error is far below that of twenty runs."""

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


# ---- Episodes ------------------------------------------------------------------------------------


def _logistic(strength: Matrix) -> Matrix:
    return 1.0 / (1.0 + np.exp(-strength))


TRUE_MATRICES: dict[str, Callable[[Matrix, int], Matrix]] = {
    "pure race": lambda lag, n: _logistic(0.3 * lag),
    "slow race": lambda lag, n: _logistic(0.1 * lag),
    "cycle": lambda lag, n: _logistic(2.0 * np.sin(4.0 * np.pi * lag / n)),
    "flat": lambda lag, n: np.full((n, n), 0.5),
}
"""Capture rate of all pairs from the lag g - h and the number of generations."""


def lags(size: int) -> Matrix:
    """Return g - h of all pairs of generations."""
    return np.subtract.outer(np.arange(size), np.arange(size)).astype(float)


def win_or_loss(rates: Matrix, episodes: int, rng: np.random.Generator) -> Matrix:
    """Return scores (..., episodes) of 0 and 1."""
    return (rng.random((*rates.shape, episodes)) < rates[..., None]).astype(float)


def shares_of_evaders(rates: Matrix, episodes: int, rng: np.random.Generator) -> Matrix:
    """Return scores (..., episodes): shares of evaders that are captured with equal chances."""
    shape = (*rates.shape, episodes)
    a, b = (np.broadcast_to(CONCENTRATION * x[..., None], shape) for x in (rates, 1.0 - rates))
    return rng.binomial(EVADERS, rng.beta(a, b)) / EVADERS


SCORES = {"win or loss": win_or_loss, f"shares of {EVADERS}": shares_of_evaders}


def linear_weights(measure: Measure, size: int) -> Matrix:
    """Return the weights of the cells in a linear measure, which make it fast to compute."""
    weights = np.empty((size, size))
    for cell in np.ndindex(size, size):
        matrix = np.zeros((size, size))
        matrix[cell] = 1.0
        weights[cell] = measure.of(matrix, "whole").value
    return weights - measure.of(np.zeros((size, size)), "whole").value


LINEAR = {
    "capture_rate": (0.0, 1.0),
    "lag_rise": (-1.0, 1.0),
    "pursuer_generalization": (0.0, 1.0),
    "pursuer_fading": (-1.0, 1.0),
}
"""Linear measures and their bounds; those of the evaders are the same on the swapped matrix."""


def of_matrix(kind: str, scores: str, size: int, episodes: int, weights: Mapping) -> Simulation:
    """Return the linear measures of one run with known episodes."""
    rates = TRUE_MATRICES[kind](lags(size), size)
    data = f"{kind}, {scores}"

    def estimates(rng: np.random.Generator) -> dict[Case, Estimate]:
        drawn = SCORES[scores](rates, episodes, rng)
        return {
            (name, data): linear_over_episodes(
                drawn, lambda m, w=weights[name, size]: float(np.vdot(w, m)), bounds=LINEAR[name]
            )
            for name in LINEAR
        }

    truths = {(name, data): float(np.vdot(weights[name, size], rates)) for name in LINEAR}
    return Simulation(size, episodes, truths, estimates)


# ---- Ratings, and pairs --------------------------------------------------------------------------

RATED_MATRICES = {**TRUE_MATRICES, "steps": lambda lag, n: np.where(lag > 0, 0.9, 0.1)}


def of_rating(kind: str, scores: str, size: int, episodes: int) -> Simulation:
    """Return the rating of the last pursuers of one run."""
    rates = RATED_MATRICES[kind](lags(size), size)
    case = ("pursuer_rating", f"{kind}, {scores}")

    def estimates(rng: np.random.Generator) -> dict[Case, Estimate]:
        found = analysis.elo_over_episodes(SCORES[scores](rates, episodes, rng)).pursuers
        value, low, high = (float(each[-1]) for each in (found.mean, found.low, found.high))
        return {case: _estimate(value, low, high, episodes)}

    truth = ELO_POINTS * float(analysis.elo(rates).pursuers[-1])
    return Simulation(size, episodes, {case: truth}, estimates)


def of_pair(rate: float, scores: str, episodes: int) -> Simulation:
    """Return the mean score of one pair, and its difference from a pair that scores 1/2."""
    data = f"rate {rate}, {scores}"

    def estimates(rng: np.random.Generator) -> dict[Case, Estimate]:
        one, other = SCORES[scores](np.array([rate, 0.5]), episodes, rng)
        return {
            ("mean of episodes", data): analysis.mean_over_episodes(one),
            ("difference of episodes", data): difference_over_episodes(one, other),
        }

    truths = {("mean of episodes", data): rate, ("difference of episodes", data): rate - 0.5}
    return Simulation(0, episodes, truths, estimates)


# ---- Collisions ----------------------------------------------------------------------------------

COLLISIONS: dict[str, tuple[float, Callable[[np.random.Generator, int], Matrix]]] = {
    "often": (0.4, lambda rng, n: 0.8 * rng.beta(4.0, 4.0, n)),
    "some": (0.01, lambda rng, n: rng.gamma(1.0, 0.01, n)),
    "uneven": (0.01, lambda rng, n: rng.gamma(0.5, 0.02, n)),
    "very uneven": (0.01, lambda rng, n: rng.gamma(0.2, 0.05, n)),
    "in 1 of 10 episodes": (0.002, lambda rng, n: (rng.random(n) < 0.1) * rng.gamma(1, 0.02, n)),
    "often in 1 of 7": (0.0733, lambda rng, n: np.where(rng.random(n) < 1 / 7, 0.5, 0.00218)),
}
"""Mean collision rate, and its distribution over episodes: six, one for each team and kind."""


def of_collisions(episodes: int) -> Simulation:
    """Return the collision rates of a safety monitor; episodes have different lengths."""

    def estimates(rng: np.random.Generator) -> dict[Case, Estimate]:
        steps = rng.integers(200, 2001, (episodes, 2))
        rates = [draw(rng, episodes) for _, draw in COLLISIONS.values()]
        chances = np.clip(np.transpose(rates), 0.0, 1.0).reshape(-1, 2, 3)
        counts = rng.binomial(steps[:, :, None], chances)
        monitor = mw.SafetyMonitor()
        monitor.add(counts, counts, steps, np.zeros(episodes))
        summary = monitor.summary(seed=int(rng.integers(2**32)))
        values = zip(summary.fault_rate.ravel(), summary.fault_interval.reshape(6, 2), strict=True)
        return {
            ("collision rate", name): _estimate(rate, *ends, episodes)
            for name, (rate, ends) in zip(COLLISIONS, values, strict=True)
        }

    truths = {("collision rate", name): 1000 * mean for name, (mean, _) in COLLISIONS.items()}
    return Simulation(0, episodes, truths, estimates)


def _estimate(value: float, low: float, high: float, episodes: int) -> Estimate:
    ends = (None, None) if math.isnan(low) else (low, high)
    return Estimate(value, *ends, "episodes", episodes)


# ---- Counts --------------------------------------------------------------------------------------


def simulations(quick: bool) -> Iterator[Simulation]:
    """Return all simulations, or the small ones."""
    sizes = SIZES[:1] if quick else SIZES
    episodes = [e for e in EPISODES if not quick or e <= QUICK_LIMIT]
    weights = {(name, n): linear_weights(MEASURES[name], n) for name in LINEAR for n in sizes}
    for runs in (r for r in RUNS if not quick or r <= QUICK_LIMIT):
        yield from (of_runs(name, runs) for name in VALUES)
    for count in episodes:
        for scores in SCORES:
            yield from (of_pair(rate, scores, count) for rate in (0.5, 0.9, 0.99))
            for size in sizes:
                yield from (of_matrix(k, scores, size, count, weights) for k in TRUE_MATRICES)
    yield from (of_collisions(count) for count in SAFETY_EPISODES[: 1 if quick else None])
    # Last, because the seed of a simulation is its place: the counts of the others do not change.
    for runs in (r for r in SCORED_RUNS if not quick or r <= QUICK_LIMIT):
        yield from (of_scores(name, runs) for name in EFFECTS)
    for size, count in RATED[: 1 if quick else None]:
        for scores in SCORES if size == min(SIZES) else ("win or loss",):
            yield from (of_rating(kind, scores, size, count) for kind in RATED_MATRICES)


def count(simulation: Simulation, repetitions: int, rng: np.random.Generator) -> list[Count]:
    """Repeat a simulation, and count the intervals that contain the truth."""
    given = dict.fromkeys(simulation.truths, 0)
    covered = dict.fromkeys(simulation.truths, 0)
    for _ in range(repetitions):
        for case, estimate in simulation.estimates(rng).items():
            if estimate.low is not None and estimate.high is not None:
                given[case] += 1
                # A true rate of 1 is covered by an interval that ends at 1 after rounding.
                low, high = estimate.low - 1e-9, estimate.high + 1e-9
                covered[case] += low <= simulation.truths[case] <= high
    size, samples = simulation.size, simulation.samples
    return [Count(*case, size, samples, repetitions, given[case], covered[case]) for case in given]


# ---- Tables --------------------------------------------------------------------------------------


def table(counts: Iterable[Count]) -> str:
    """Return coverage by interval and number of samples, and the exceptions, as Markdown."""
    rows = list(counts)
    groups: dict[tuple[str, int], list[Count]] = {}
    for row in rows:
        groups.setdefault((row.interval, row.samples), []).append(row)
    order = list(dict.fromkeys(row.interval for row in rows))
    summaries = [groups[key] for key in sorted(groups, key=lambda key: order.index(key[0]))]
    heads = ["interval", "runs or episodes", "given", "coverage", "worst case |"]
    told = markdown(heads, map(_summary, summaries))
    return "\n".join([told, "", *_exceptions(rows)])


def _exceptions(rows: list[Count]) -> list[str]:
    """Return lines of the cases whose intervals cover too rarely, by runs or episodes."""
    low = [row for row in rows if _is_known(row) and _coverage([row]) < ENOUGH]
    cases: dict[str, list[str]] = {}
    for row in low:
        found = f"{_coverage([row]):.1%} at {row.samples}"
        cases.setdefault(f"{row.interval}, {_case(row)}", []).append(found)
    heading = f"Exceptions, with a coverage below {ENOUGH:.0%}:"
    return [heading, "", *(f"- {case}: {', '.join(each)}" for case, each in cases.items())]


def _is_known(row: Count) -> bool:
    return row.given >= min(FEWEST_GIVEN, row.repetitions)


def _summary(rows: list[Count]) -> list[str]:
    """Return a line of the table: mean coverage, and the case with the lowest one."""
    given = sum(row.given for row in rows) / sum(row.repetitions for row in rows)
    worst = min(filter(_is_known, rows), key=lambda row: _coverage([row]), default=None)
    cells = [rows[0].interval, str(rows[0].samples), f"{given:.0%}"]
    cells += [f"{_coverage(rows):.1%}" if given else ""]
    return [*cells, *(("", "") if worst is None else (f"{_coverage([worst]):.1%}", _case(worst)))]


def _coverage(rows: list[Count]) -> float:
    given = sum(row.given for row in rows)
    return sum(row.covered for row in rows) / given if given else math.nan


def _case(row: Count) -> str:
    return f"{row.data}, {row.size} x {row.size}" if row.size else row.data


def read_counts(path: Path) -> list[Count]:
    """Return the counts of a file that this script wrote."""
    rows = judgement_tables.read_counts(path)
    return [Count(r.pop("interval"), r.pop("data"), *map(int, r.values())) for r in rows]


def main() -> None:
    """Repeat all simulations, print and write the results."""
    parser = script_parser(__doc__, quick="20 repetitions of the small cases")
    parser.add_argument("--repetitions", type=int, help="data sets of each case")
    args = parser.parse_args()
    repetitions = args.repetitions or (20 if args.quick else 400)
    every = list(simulations(args.quick))
    # Threads would wait for each other longer than these small products take.
    with threadpool_limits(1):
        counts = [
            row
            for number, simulation in enumerate(tqdm(every, unit=" cases", disable=None))
            # A seed for each simulation: the number of repetitions of others changes no counts.
            for row in count(simulation, repetitions, np.random.default_rng(number))
        ]
    text = table(counts)
    args.results.mkdir(parents=True, exist_ok=True)
    judgement_tables.write_counts([vars(row) for row in counts], args.results / "coverage.csv")
    (args.results / "table.md").write_text(f"{text}\n", encoding="utf-8")
    print(text)
    print(f"\nWritten: {args.results}/table.md, {args.results}/coverage.csv")


if __name__ == "__main__":
    main()
