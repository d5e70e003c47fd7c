"""Elo ratings: one number for each generation."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.readable import Readable
from matrixworld.analysis.intervals import LEVEL, Band, check_cells, t_quantile
from matrixworld.analysis.payoffs import ByTeam, Rates, check_payoff

ELO_POINTS = 400.0 / math.log(10.0)
"""Points of the chess scale for one unit of these ratings, a natural logit."""
SHRINKAGE = 0.01  # shrinkage of rates towards 1/2: 0 and 1 become .01 and .99, logits -4.6 and 4.6
RIDGE = 1e-3  # weight of the squared ratings in the fit

_MOST_STEPS = 100
_TOLERANCE = 1e-9  # of the gradient, a sum of differences of rates


@dataclass(frozen=True, eq=False, repr=False)
class Elo(Readable):
    """Ratings: ``logit P(capture) = pursuers[g] - evaders[h] + offset``.

    `pursuers` (n,) and `evaders` (m,) are in natural logits, sum 0; higher captures, and escapes,
    more. The `offset` is the advantage of the pursuers in the game itself.
    """

    pursuers: Rates
    evaders: Rates
    offset: float


def elo(payoff: ArrayLike) -> Elo:
    """Fit Elo ratings of both teams: all matches at once, in no order.

    Parameters
    ----------
    payoff : array_like, shape (n, m)
        Capture rates in [0, 1].

    Returns
    -------
    Elo
        Ratings `pursuers` (n,) and `evaders` (m,) in natural logits with sum 0, and the `offset`.

    Notes
    -----
    The fit minimises the cross entropy of P with ``x = s + (1 - 2 s) M``, summed over cells, plus
    ``r / 2`` times the sum of the squared ratings. The shrinkage s = .01 keeps the ratings of
    generations finite that win or lose all matches, and the ridge r = .001 those of others unique.

    Elo (1978), "The rating of chessplayers, past and present". Balduzzi et al. (2018),
    "Re-evaluating evaluation": the batch form.
    """
    matrix = check_payoff(payoff)
    return _centred(_fit(_shrunken(matrix)), len(matrix))


def elo_over_episodes(scores: ArrayLike, *, level: float = LEVEL) -> ByTeam[Band]:
    """Return the Elo ratings of `scores` (n, m, episodes) in points, with intervals of a `level`.

    Of each cell there are at least two independent episodes. The ends are NaN where all are equal.

    Notes
    -----
    Episode e of all cells is one measurement of the matrix; ratings follow it by their gradient
    (delta method), and have Student's t interval over these measurements.
    """
    array = check_cells(scores, level)
    rows, columns, episodes = array.shape
    matrix = array.mean(axis=2)
    rates = _shrunken(matrix)
    parameters = _fit(rates)
    ratings = _centred(parameters, rows)
    _, _, curvature = _loss(parameters, rates)
    changes = (1.0 - 2.0 * SHRINKAGE) * (array - matrix[:, :, None])
    by_row, by_column = changes.sum(axis=1), changes.sum(axis=0)
    gradients = np.concatenate([by_row, -by_column, by_row.sum(axis=0)[None]])
    moved = np.linalg.lstsq(curvature, gradients, rcond=None)[0][:-1]
    moved -= np.repeat([moved[:rows].mean(axis=0), moved[rows:].mean(axis=0)], (rows, columns), 0)
    variances = ELO_POINTS**2 * moved.var(axis=1, ddof=1) / episodes
    errors = np.sqrt(np.where(variances > 0.0, variances, np.nan))
    reach = float(t_quantile(level, episodes - 1)) * errors
    means = ELO_POINTS * ratings.pursuers, ELO_POINTS * ratings.evaders
    both = zip(means, np.split(reach, [rows]), strict=True)
    return ByTeam(*(Band(np.arange(len(m)), m, m - r, m + r) for m, r in both))


def _shrunken(matrix: Rates) -> Rates:
    return SHRINKAGE + (1.0 - 2.0 * SHRINKAGE) * matrix


def _centred(parameters: Rates, rows: int) -> Elo:
    """Return parameters as ratings, which are defined up to a constant: the offset absorbs it."""
    a, b, [offset] = np.split(parameters, [rows, len(parameters) - 1])
    return Elo(a - a.mean(), b - b.mean(), float(offset) + float(a.mean()) - float(b.mean()))


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
    p: Rates = np.exp(-np.logaddexp(0.0, -x))  # a sigmoid that does not overflow for large |x|
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
