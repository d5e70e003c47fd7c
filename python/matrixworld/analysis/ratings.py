"""Ratings: Elo, one number for each generation, and cycles beside it (multidimensional Elo)."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_floats, check_integer
from matrixworld._util.readable import Readable
from matrixworld.analysis.intervals import LEVEL, check_level, t_quantile
from matrixworld.analysis.payoffs import (
    SHRINKAGE,
    ByTeam,
    Rates,
    check_payoff,
    check_rates,
    logits,
    require,
    shrink,
)

ELO_POINTS = 400.0 / math.log(10.0)
"""Points of the chess scale for one unit of these ratings, a natural logit."""
RIDGE = 1e-3
"""Weight of the squared ratings in the fit."""

_MOST_STEPS = 100
_TOLERANCE = 1e-9  # of the gradient, a sum of differences of rates


@dataclass(frozen=True, eq=False, repr=False)
class Elo(Readable):
    """Ratings: ``logit P(capture) = pursuers[g] - evaders[h] + offset + u[g] . v[h]``.

    `pursuers` (n,) and `evaders` (m,) are in natural logits, sum 0; higher captures, and escapes,
    more. The `offset` is the advantage of the pursuers in the game itself. `u` (n, 2 cycles): style
    of each pursuer generation, strongest dimension first; `v` (m, 2 cycles): weakness of each
    evader generation against these styles.
    """

    pursuers: Rates
    evaders: Rates
    offset: float
    u: Rates
    v: Rates

    @property
    def logits(self) -> Rates:
        """Logits of the shrunken rates; shape (n, m)."""
        ratings: Rates = self.pursuers[:, None] - self.evaders + self.offset
        return ratings + self.u @ self.v.T if self.u.size else ratings

    def predict(self) -> Rates:
        """Return predicted capture rates in [0, 1], shape (n, m)."""
        rates = (_sigmoid(self.logits) - SHRINKAGE) / (1.0 - 2.0 * SHRINKAGE)
        return np.clip(rates, 0.0, 1.0)


def elo(payoff: ArrayLike, *, cycles: int = 0) -> Elo:
    """Fit Elo ratings of both teams to a payoff matrix, and cycles beside them (mElo).

    All matches enter at once, so their order does not matter. The ratings are the same with cycles.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
    cycles : int, optional
        Number of cycles k, ``0 <= 2 k <= min(n, m)``. Rock-paper-scissors needs one; with
        ``2 k = min(n, m)`` every cell is reproduced.

    Notes
    -----
    The fit minimises the cross entropy of P with ``x = s + (1 - 2 s) M``, summed over cells, plus
    ``r / 2`` times the sum of the squared ratings. The shrinkage s = .01 keeps the ratings of
    generations finite that win or lose all matches, and the ridge r = .001 those of others unique.
    The residual of the ratings on the logits is approximated by its 2 k largest singular values,
    each divided evenly between u and v.

    References
    ----------
    Elo (1978), "The rating of chessplayers, past and present". Balduzzi et al. (2018),
    "Re-evaluating evaluation": the batch form, and mElo.
    """
    matrix = check_payoff(payoff)
    rows, columns = matrix.shape
    cycles = check_integer("cycles", cycles, 0, min(rows, columns) // 2)
    # a: pursuers, b: evaders, in natural logits.
    a, b, offset = np.split(_fit(shrink(matrix)), [rows, rows + columns])
    # Ratings are defined up to a constant, so they are centred and the offset absorbs the means.
    shift = float(offset[0]) + float(a.mean()) - float(b.mean())
    none = np.empty((rows, 0)), np.empty((columns, 0))
    ratings = Elo(a - a.mean(), b - b.mean(), shift, *none)
    if cycles == 0:
        return ratings
    left, sizes, right = np.linalg.svd(logits(matrix) - ratings.logits, full_matrices=False)
    kept = slice(0, 2 * cycles)
    # The sign of a singular pair is arbitrary: make the largest entry of each column of u positive.
    largest = np.take_along_axis(left, np.abs(left).argmax(axis=0)[None], axis=0)
    scale = np.where(largest < 0.0, -1.0, 1.0) * np.sqrt(sizes)
    return replace(ratings, u=(left * scale)[:, kept], v=(right.T * scale)[:, kept])


@dataclass(frozen=True, eq=False, repr=False)
class Ratings(Readable):
    """Elo ratings of one team in points, with intervals: arrays of shape (runs, k).

    `low` and `high` are NaN where all episodes are equal. `between`: standard deviation between
    runs, without noise; NaN for a single run. `within`: standard error of a rating of one run.
    """

    mean: Rates
    low: Rates
    high: Rates
    between: float
    within: float


def elo_over_episodes(scores: ArrayLike, *, level: float = LEVEL) -> ByTeam[Ratings]:
    """Return the Elo ratings of one run or several with intervals over episodes.

    Parameters
    ----------
    scores : array_like of float, shape (n, m, episodes) or (runs, n, m, episodes)
        Scores in [0, 1] of independent episodes, at least two of each cell.
    level : float, optional
        Confidence level of each interval, in (0, 1).

    Notes
    -----
    Episode e of all cells is one measurement of the matrix; ratings follow it by their gradient
    (delta method), and have Student's t interval over these measurements. Several runs are a
    hierarchy: the ratings of a generation are normal over runs, with a variance that all
    generations share, estimated by moments (DerSimonian and Laird 1986). So each is moved towards
    the mean over runs, the more the larger noise is beside that variance (Morris 1983, "Parametric
    empirical Bayes inference"). The interval is about this run.
    """
    array = check_floats("scores", scores)
    several = array[None] if array.ndim == 3 else array
    array = check_rates(several, ndim=4, what="scores ([runs,] n, m, episodes)")
    check_level(level)
    require(array.shape[3] >= 2, "at least 2 episodes a cell", array.shape[3])
    means, errors = np.array([_with_variances(each) for each in array]).swapaxes(0, 1)
    t = float(t_quantile(level, array.shape[3] - 1))
    rows = array.shape[1]
    return ByTeam(
        _pooled(means[:, :rows], errors[:, :rows], t), _pooled(means[:, rows:], errors[:, rows:], t)
    )


def _with_variances(scores: Rates) -> tuple[Rates, Rates]:
    """Return the ratings of pursuers, then evaders, in points, and their variances (n + m,)."""
    rows, columns, episodes = scores.shape
    matrix = scores.mean(axis=2)
    found, rates = elo(matrix), shrink(matrix)
    _, _, curvature = _loss(_fit(rates), rates)
    changes = (1.0 - 2.0 * SHRINKAGE) * (scores - matrix[:, :, None])
    by_row, by_column = changes.sum(axis=1), changes.sum(axis=0)
    gradients = np.concatenate([by_row, -by_column, by_row.sum(axis=0)[None]])
    moved = np.linalg.lstsq(curvature, gradients, rcond=None)[0][:-1]
    moved -= np.repeat([moved[:rows].mean(axis=0), moved[rows:].mean(axis=0)], (rows, columns), 0)
    variances = moved.var(axis=1, ddof=1) / episodes
    return ELO_POINTS * np.append(found.pursuers, found.evaders), ELO_POINTS**2 * variances


def _pooled(means: Rates, variances: Rates, t: float) -> Ratings:
    """Move the ratings of runs (runs, k) towards their mean over runs, as far as noise allows."""
    runs, within = len(means), float(variances.mean())
    if runs == 1:
        between, pooled = math.nan, variances
    else:
        middle = means.mean(axis=0)
        between = max(0.0, float(means.var(axis=0, ddof=1).mean()) - within)
        own = between / np.maximum(between + variances, np.finfo(float).tiny)
        pooled = own * variances + (1.0 - own) ** 2 * (between + variances.mean(axis=0)) / runs
        pooled += 2.0 / (runs - 1) * ((1.0 - own) * (means - middle)) ** 2
        means = middle + own * (means - middle)
    reach = t * np.sqrt(np.where(variances > 0.0, pooled, np.nan))
    return Ratings(means, means - reach, means + reach, between**0.5, within**0.5)


def log_loss(payoff: ArrayLike, predicted: ArrayLike) -> float:
    """Return the mean cross entropy of a prediction minus that of a perfect one, in nats.

    At least 0. Infinite if something happened whose predicted rate is 0.

    Parameters
    ----------
    payoff, predicted : array_like of float, shape (n, m)
        Capture rates in [0, 1].
    """
    from scipy.special import rel_entr

    matrix, guess = check_payoff(payoff), check_payoff(predicted)
    require(guess.shape == matrix.shape, f"predictions of shape {matrix.shape}", guess.shape)
    loss = float(np.mean(rel_entr(matrix, guess) + rel_entr(1.0 - matrix, 1.0 - guess)))
    return max(0.0, loss)  # rounding may leave a perfect prediction just below


def _fit(rates: Rates) -> Rates:
    """Return parameters (a, b, offset) by Newton's method, halving steps that do not descend."""
    rows, columns = rates.shape
    parameters: Rates = np.zeros(rows + columns + 1)
    for _ in range(_MOST_STEPS):
        loss, gradient, curvature = _loss(parameters, rates)
        if np.abs(gradient).max() < _TOLERANCE:
            break
        step = np.linalg.lstsq(curvature, -gradient, rcond=None)[0]
        # A full Newton step may overshoot where rates are close to 0 or 1 and the Hessian is flat.
        size = 1.0
        while size > 1e-9 and _loss(parameters + size * step, rates)[0] > loss:
            size /= 2.0
        parameters += size * step
    return parameters


def _loss(parameters: Rates, rates: Rates) -> tuple[float, Rates, Rates]:
    """Return the penalised cross entropy, its gradient and its Hessian."""
    rows, columns = rates.shape
    a, b, offset = np.split(parameters, [rows, rows + columns])
    x = a[:, None] - b + offset
    p = _sigmoid(x)
    penalty = np.append(np.full(rows + columns, RIDGE), 0.0)  # the offset is free
    # Cross entropy in terms of logits, which does not take the logarithm of a rate of 0.
    loss = float(np.sum(np.logaddexp(0.0, x) - rates * x) + penalty @ parameters**2 / 2)
    error, weight = p - rates, p * (1.0 - p)
    gradient = np.concatenate([error.sum(axis=1), -error.sum(axis=0), [error.sum()]])
    by_row, by_column = weight.sum(axis=1), weight.sum(axis=0)
    curvature = np.block(
        [
            [np.diag(by_row), -weight, by_row[:, None]],
            [-weight.T, np.diag(by_column), -by_column[:, None]],
            [by_row, -by_column, np.full(1, weight.sum())],
        ]
    )
    return loss, gradient + penalty * parameters, curvature + np.diag(penalty)


def _sigmoid(x: Rates) -> Rates:
    p: Rates = np.exp(-np.logaddexp(0.0, -x))  # does not overflow for large |x|
    return p
