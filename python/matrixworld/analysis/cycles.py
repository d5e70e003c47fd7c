"""Cycles: what the strength of each generation does not explain, and checkerboards.

A race is *transitive* if its generations can be ordered by strength: sorted by it, capture rates
never fall along the pursuers and never rise along the evaders. Strength need not grow in the order
of time, and it may saturate. A checkerboard contradicts every such order.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_number, check_real
from matrixworld.analysis.intervals import LEVEL, Estimate, normal_quantile, t_quantile
from matrixworld.analysis.payoffs import EPISODES_TO_RECUR, Rates, check_payoff, require
from matrixworld.analysis.reasons import Reason, Why

EPISODES_TO_SUBTRACT_NOISE = 4
"""Fewest episodes for a transitive share without noise: the jackknife leaves out one of them."""
MARGIN = 0.15
"""Margin of a checkerboard: an additive matrix with the noise of ten episodes of a long race has
none above it. It does not tell cycles from noise in general; `judge` does."""
MOST_GENERATIONS = 40
"""More generations of a team are thinned out evenly, which keeps a fit below a second."""
SORTING = 1.5
"""Share of the noise that sorting hides, in units of (n + m) / (n m). Simulated: 1 to 1.3."""
BLOCKS = 8  # most blocks of episodes in each half from which recurrence is estimated
_ITERATIONS = 200  # the most of a fit; 20 to 100 suffice
_CONVERGED = 1e-4  # largest change of a cell in the last iteration
_ROUNDING = 1e-12  # differences of capture rates below this are floating-point noise


@dataclass(frozen=True)
class Checkerboards:
    """Number of checkerboards in a payoff matrix: `count` of all quadruples that are `possible`."""

    count: int
    possible: int

    @property
    def share(self) -> float:
        """``count / possible``; NaN where no quadruple is possible."""
        return self.count / self.possible if self.possible else math.nan


@dataclass(frozen=True)
class Checkerboard:
    """Two pursuer generations, each better by the margin against its own evaders."""

    pursuers: tuple[int, int]
    evaders: tuple[int, int]
    margin: float


def transitive_share(payoff: ArrayLike) -> float:
    """Return the share of the variance that generations' own strengths explain.

    Parameters
    ----------
    payoff : array_like, shape (n, m)
        Capture rates in [0, 1].

    Returns
    -------
    float
        1: the strengths of both generations add up to the capture rate. 0: only the pairing
        matters. NaN for a constant matrix.

    Notes
    -----
    Noise alone gives about ``(n + m - 2) / (n m - 1)``, so a low value is no proof of cycles: look
    at `checkerboards`, too; ``MEASURES["transitive_share"]`` subtracts the noise of episodes.

    Fisher (1925), "Statistical methods for research workers": two-way analysis of variance.
    Candogan et al. (2011), "Flows and decompositions of games: harmonic and potential games".
    """
    matrix = check_payoff(payoff)
    deviations, cyclic = _centred(matrix[:, :, np.newaxis])
    total = float(np.sum(deviations**2))
    if total <= matrix.size * _ROUNDING**2:  # constant but for rounding
        return math.nan
    return min(1.0, max(0.0, 1.0 - float(np.sum(cyclic**2)) / total))


def transitive_share_over_episodes(scores: Rates) -> Estimate:
    """Return the transitive share of what is behind episodes (n, m, episodes), without interval."""
    # Products of different episodes of a cell hold no noise (U statistics, Hoeffding 1948).
    measured = transitive_share(scores.mean(axis=2))
    episodes = scores.shape[2]
    if episodes < EPISODES_TO_SUBTRACT_NOISE:
        note = Reason(Why.BIASED_BY_FEW_EPISODES, EPISODES_TO_SUBTRACT_NOISE)
        return Estimate(measured, samples=episodes, note=note)
    total, cyclic = _centred(scores)
    parts = np.stack([cyclic, total]).reshape(2, episodes, -1)
    sums = _without_noise(parts @ parts.transpose(0, 2, 1))
    ends = _ratio(*sums, float(t_quantile(LEVEL, episodes - 1)))
    if ends is None:
        return Estimate(measured, samples=episodes, note=Reason(Why.BIASED_AND_EQUAL))
    share = min(1.0, max(0.0, 1.0 - ends[0]))
    return Estimate(share, samples=episodes, note=Reason(Why.NOISE_SUBTRACTED))


def _centred(scores: Rates) -> tuple[Rates, Rates]:
    """Return the matrix of each episode (episodes, n, m) less its mean, and its cyclic part."""
    matrices = np.moveaxis(scores, 2, 0)
    total = matrices - matrices.mean(axis=(1, 2), keepdims=True)
    return total, total - total.mean(axis=1, keepdims=True) - total.mean(axis=2, keepdims=True)


def checkerboards(
    payoff: ArrayLike, *, margin: float = 0.0, level: float | None = 0.5
) -> Checkerboards:
    """Count checkerboards: pursuers p1 beat e1 but not e2, and p2 beat e2 but not e1.

    Parameters
    ----------
    payoff : array_like, shape (n, m)
        Capture rates in [0, 1].
    margin : float, optional
        By more than this, in [0, 1), each of ``M[p1, e1]`` and ``M[p2, e2]`` exceeds each of
        ``M[p1, e2]`` and ``M[p2, e1]``. The default is 0.
    level : float or None, optional
        Capture rate in [0, 1] above which pursuers beat evaders: both winning cells lie above it,
        both losing cells do not. The default is 0.5. With None cells are compared with each other
        only, so a cycle between capture rates of .1 and .4 is found, too.

    Returns
    -------
    Checkerboards
        Their number, and that of all quadruples. A staircase and any matrix ``f(r_g + c_h)`` with
        increasing f have none. It takes time O(n^2 m^2) and memory O(m^2).
    """
    matrix = check_payoff(payoff)
    require(0.0 <= check_real("margin", margin) < 1.0, "a margin in [0, 1)", margin)
    if level is not None:
        check_number("level", level, least=0.0, most=1.0)
    count = 0
    for row, other in combinations(matrix, 2):
        won, lost = _sides(row, other)
        found = won - lost > margin
        if level is not None:
            found &= (won > level) & (lost <= level)
        count += int(found.sum())
    rows, columns = matrix.shape
    return Checkerboards(count, math.comb(rows, 2) * math.comb(columns, 2))


def _sides(row: Rates, other: Rates) -> tuple[Rates, Rates]:
    """Return the lower of the two wins and the higher of the two losses, by evaders, (m, m)."""
    return np.minimum(row[:, None], other), np.maximum(row, other[:, None])


def strongest_checkerboards(
    matrix: Rates, *, count: int = 12, margin: float = 0.0
) -> tuple[Checkerboard, ...]:
    """Return the largest checkerboards, of which no two have three generations in common.

    Of each two pursuers the best one, in a matrix that is `thinned`.
    """
    rows, columns = (_even(size).tolist() for size in matrix.shape)
    few, boards = thinned(matrix), list[Checkerboard]()
    for (p, row), (q, other) in combinations(enumerate(few), 2):
        won, lost = _sides(row, other)
        margins = won - lost
        a, b = divmod(int(margins.argmax()), len(columns))
        pairs = (rows[p], rows[q]), (columns[a], columns[b])
        boards.append(Checkerboard(*pairs, float(margins[a, b])))
    chosen: list[Checkerboard] = []
    for board in sorted(boards, key=lambda each: -each.margin):
        alike = any(_in_common(board, other) > 2 for other in chosen)
        if board.margin > margin and len(chosen) < count and not alike:
            chosen.append(board)
    return tuple(chosen)


def _in_common(one: Checkerboard, other: Checkerboard) -> int:
    return len({*one.pursuers} & {*other.pursuers}) + len({*one.evaders} & {*other.evaders})


def transitive_fit(matrix: Rates) -> Rates:
    """Return the nearest matrix that never falls along both teams, sorted by mean capture rate."""
    order = np.ix_(*(np.argsort(matrix.mean(axis=axis), kind="stable") for axis in (1, 0)))
    fit = np.empty_like(matrix)
    fit[order] = _monotone(matrix[order])
    return fit


def squared_intransitivity(matrix: Rates, noise: Rates, *, level: float = LEVEL) -> Estimate:
    """Return the mean squared residual of `transitive_fit` minus the mean noise (n, m).

    `biased_high` and `high` allow for what the fit hides (Robertson, Wright and Dykstra 1988).
    """
    matrix, noise = thinned(matrix), thinned(noise)
    fit = transitive_fit(matrix)
    share = 1.0 / matrix.size
    # A cell in a level set of b cells loses 1/b of its noise to the fit (Meyer and Woodroofe 2000).
    excess = (matrix - fit) ** 2 - noise * (1.0 - _leverages(fit))
    value = float((share * excess).sum())
    reach = normal_quantile(level) * float(np.sqrt((share**2 * excess**2).sum()))
    most = value + SORTING * sum(matrix.shape) / matrix.size * float((share * noise).sum())
    return Estimate(value, value - reach, most + reach, "episodes", biased_high=most)


def thinned(matrix: Rates) -> Rates:
    """Return all generations of each team, or `MOST_GENERATIONS` of them at even distances."""
    return matrix[np.ix_(*map(_even, matrix.shape))]


def _even(size: int) -> NDArray[np.intp]:
    even = np.linspace(0, size - 1, min(size, MOST_GENERATIONS))
    return np.asarray(even.round(), np.intp)


def _leverages(fit: Rates) -> Rates:
    """Return for each cell one over the number of cells that share its value."""
    # Converged values of one level set differ in the last digits only.
    _, member, counts = np.unique(
        np.round(fit / (10 * _CONVERGED)), return_inverse=True, return_counts=True
    )
    shares: Rates = 1.0 / counts[member.reshape(fit.shape)]
    return shares


def _monotone(matrix: Rates) -> Rates:
    """Return the least-squares fit that does not fall along rows and columns."""
    # Alternating projections (Dykstra and Robertson 1982): each starts from the last one plus its
    # own correction.
    fit = matrix
    along_rows = np.zeros_like(matrix)
    along_columns = np.zeros_like(matrix)
    for _ in range(_ITERATIONS):
        start = fit + along_rows
        half = _isotonic_rows(start)
        along_rows = start - half
        start = half + along_columns
        after = _isotonic_rows(start.T).T
        along_columns = start - after
        change = float(np.abs(after - fit).max())
        fit = after
        if change < _CONVERGED:
            break
    return fit


def _isotonic_rows(values: Rates) -> Rates:
    from scipy.optimize import isotonic_regression

    # One call for all rows: each lies above the one before, so none is pooled with another.
    steps = (np.ptp(values) + 1.0) * np.arange(len(values))[:, None]
    fit: Rates = isotonic_regression((values + steps).ravel()).x.reshape(values.shape) - steps
    return fit


def recurrence_over_episodes(
    scores: Rates, *, level: float = LEVEL, at_one_lag: bool = False
) -> Estimate:
    """Return how similar the row team becomes to its past again, of scores (n, m, episodes).

    With `at_one_lag` the interval is above 0 only if all generations return after about as many.
    """
    # c(d) is the mean product of the cyclic parts of generations that are d apart, divided by c(0).
    # Where c falls below 0, the team has left its old strategies; the largest c(d) after that is
    # the recurrence. One half of the episodes chooses d, the other one measures c(d).
    # The interval inverts a t test, as Fieller's theorem (1954) does for a ratio, with the standard
    # errors of the jackknife over episodes (Efron and Stein 1981).
    if scores.shape[2] < EPISODES_TO_RECUR:
        return Estimate(math.nan, note=Reason(Why.TOO_FEW_TO_RECUR))
    even = _similarities(scores[:, :, 0::2])
    odd = _similarities(scores[:, :, 1::2])
    first = _returned(even, odd, level)
    second = _returned(odd, even, level)
    if first is None or second is None:
        return Estimate(math.nan, note=Reason(Why.ONLY_NOISE))
    value, high, low = np.mean([first, second], axis=0).tolist()
    if (
        at_one_lag
        and low > 0.0
        and not all(_exceeds_chance(scores, half, level) for half in (even, odd))
    ):
        low = 0.0
    return Estimate(value, low, high, "episodes")


def _exceeds_chance(scores: Rates, chooses: Rates, level: float) -> bool:
    """Return whether generations that are the chosen lag apart are similar, each pair about alike.

    Without noise both halves of the episodes are equal: the lag is then the best of many for the
    very numbers that measure it, and styles that are all new are similar at some lag by chance.
    """
    found = _return_lag(chooses)
    if found is None:
        return False
    lag, tried = found
    _, [mean] = _centred(scores.mean(axis=2, keepdims=True))
    products = (mean[: len(mean) - lag] * mean[lag:]).sum(axis=1)
    free = len(products) - 1
    if free < 1:
        return False
    # Student's t of these products, of all lags that were tried (Bonferroni).
    reach = float(t_quantile(1.0 - (1.0 - level) / tried, free))
    return bool(products.mean() > reach * products.std(ddof=1) / math.sqrt(len(products)))


def _similarities(scores: Rates) -> Rates:
    """Return the similarity of two blocks of episodes at each lag, shape (lags, blocks, blocks)."""
    blocks = min(BLOCKS, scores.shape[2])
    kept = scores[:, :, : scores.shape[2] // blocks * blocks]
    _, residual = _centred(kept.reshape(*scores.shape[:2], -1, blocks).mean(axis=2))
    n = residual.shape[1]
    found = []
    for lag in range(n // 2 + 1):
        early, late = residual[:, : n - lag], residual[:, lag:]
        products = early.reshape(blocks, -1) @ late.reshape(blocks, -1).T / (n - lag)
        found.append((products + products.T) / 2.0)
    return np.array(found)


def _returned(chooses: Rates, measures: Rates, level: float) -> tuple[float, float, float] | None:
    """Return the recurrence with its largest and smallest value; None if the rates do not vary."""
    found = _return_lag(chooses)
    if found is None:
        return 0.0, 0.0, 0.0
    lag, _ = found
    t = float(t_quantile(level, measures.shape[1] - 1))
    return _ratio(*_without_noise(measures[[lag, 0]]), t)


def _return_lag(chooses: Rates) -> tuple[int, int] | None:
    """Return the lag at which a team is most similar to its past, and how many were tried.

    They are those after the team has first left its old strategies; None if it never has.
    """
    curve, _ = _without_noise(chooses)
    below = np.flatnonzero(curve < 0.0)
    tried = curve[below[0] + 1 :] if len(below) else curve[:0]
    if not len(tried):
        return None
    return int(below[0]) + 1 + int(tried.argmax()), len(tried)


def _without_noise(products: Rates) -> tuple[Rates, Rates]:
    """Return sums from products (k, episodes, episodes), and their jackknife covariance (k, k)."""
    # Products of an episode with itself hold the noise, so only those of two episodes count.
    episodes = products.shape[1]
    of_episode = products.sum(axis=2) - np.diagonal(products, axis1=1, axis2=2)
    everything = of_episode.sum(axis=1)
    left_out = everything[:, None] - 2.0 * of_episode
    jackknife = left_out / ((episodes - 1) * (episodes - 2))
    deviations = jackknife - jackknife.mean(axis=1, keepdims=True)
    covariance = (episodes - 1) / episodes * deviations @ deviations.T
    return everything / (episodes * (episodes - 1)), covariance


def _ratio(sums: Rates, covariance: Rates, t: float) -> tuple[float, float, float] | None:
    """Return the ratio q of two sums, its largest and smallest value; None if one may be 0."""
    # The ends solve ``(residual - q total)^2 = t^2 variance(residual - q total)``.
    residual, total = sums.tolist()
    a = total**2 - t**2 * covariance[1, 1]
    b = residual * total - t**2 * covariance[0, 1]
    c = residual**2 - t**2 * covariance[0, 0]
    if total <= 0.0 or a <= 0.0:
        return None
    half = math.sqrt(max(0.0, b**2 - a * c))
    return residual / total, (b + half) / a, (b - half) / a
