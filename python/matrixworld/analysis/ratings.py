"""Ratings: one number a generation (Elo), and what it cannot say (multidimensional Elo)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.payoff import SHRINKAGE, Rates, check_payoff, logits, require, shrink

ELO_POINTS = 400.0 / math.log(10.0)
"""Points of the chess scale in one unit of these ratings, a natural logit."""
RIDGE = 1e-3
"""Default weight of the squared ratings beside the summed cross entropy of the cells."""

_MOST_STEPS = 100
_TOLERANCE = 1e-9  # of the gradient, whose terms are rates


@dataclass(frozen=True, eq=False)
class Elo:
    """``logit P(capture) = pursuers[g] - evaders[h] + offset``, in natural logits."""

    pursuers: Rates
    """Shape ``(n,)``, sum 0: higher captures more. Times `ELO_POINTS`: points as in chess."""
    evaders: Rates
    """Shape ``(m,)``, sum 0: higher escapes more."""
    offset: float
    """How much the game as such is in the pursuers' favour."""
    shrinkage: float
    """The shrinkage of the rates that were fitted."""

    @property
    def logits(self) -> Rates:
        """Shape ``(n, m)``: of the shrunken rates."""
        return self.pursuers[:, None] - self.evaders + self.offset

    def predict(self) -> Rates:
        """Predicted capture rates, shape ``(n, m)``, in [0, 1]."""
        return _rates(self.logits, self.shrinkage)


@dataclass(frozen=True, eq=False)
class MultiElo:
    """``logit P(capture) = pursuers[g] - evaders[h] + offset + u[g] . v[h]``."""

    elo: Elo
    """The part that one number a generation explains."""
    u: Rates
    """Shape ``(n, 2 k)``: what each pursuer generation plays like, strongest dimension first."""
    v: Rates
    """Shape ``(m, 2 k)``: against what each evader generation is weak."""

    @property
    def logits(self) -> Rates:
        """Shape ``(n, m)``: of the shrunken rates."""
        values: Rates = self.elo.logits + self.u @ self.v.T
        return values

    def predict(self) -> Rates:
        """Predicted capture rates, shape ``(n, m)``, in [0, 1]."""
        return _rates(self.logits, self.elo.shrinkage)


def elo(payoff: ArrayLike, *, ridge: float = RIDGE, shrinkage: float = SHRINKAGE) -> Elo:
    """Ratings of both teams by a batch fit (Elo, 1978; batch form after Balduzzi et al., 2018).

    Minimises the cross entropy of ``P`` with the shrunken rates ``x = shrinkage + (1 - 2
    shrinkage) M``, summed over cells, plus ``ridge / 2`` times the sum of the squared ratings.
    It depends on all matches at once, not on their order, and has one solution: shrinkage keeps
    ratings of those who win or lose everything finite.

    Raises ValueError unless ``ridge >= 0`` is finite and ``0 < shrinkage < 1/2``.
    """
    require(0.0 <= ridge < math.inf, "a finite ridge of at least 0", ridge)
    rates = shrink(check_payoff(payoff), shrinkage)
    rows, columns = rates.shape
    a, b, offset = np.split(_fit(rates, ridge), [rows, rows + columns])
    # Ratings are defined up to a constant that the offset takes up.
    shift = float(offset[0]) + float(a.mean()) - float(b.mean())
    return Elo(a - a.mean(), b - b.mean(), shift, shrinkage)


def multi_elo(
    payoff: ArrayLike, *, k: int = 1, ridge: float = RIDGE, shrinkage: float = SHRINKAGE
) -> MultiElo:
    """mElo of 2 k dimensions (Balduzzi et al., 2018), for two teams.

    What :func:`elo` leaves of the logits is approximated by its 2 k largest singular values
    (Eckart and Young, 1936), each divided evenly between ``u`` and ``v``. Rock-paper-scissors takes
    k = 1; with ``2 k = min(n, m)`` every cell is reproduced.

    Raises ValueError unless ``0 <= 2 k <= min(n, m)``, and as :func:`elo` does.
    """
    values = logits(payoff, shrinkage=shrinkage)
    most = min(values.shape) // 2
    require(0 <= k <= most, f"k from 0 to {most} for a matrix of {values.shape}", k)
    ratings = elo(payoff, ridge=ridge, shrinkage=shrinkage)
    left, sizes, right = np.linalg.svd(values - ratings.logits, full_matrices=False)
    kept = slice(0, 2 * k)
    # A singular pair may change sign; the largest entry of each column of u is made positive.
    largest = np.take_along_axis(left, np.abs(left).argmax(axis=0)[None], axis=0)
    scale = np.where(largest < 0.0, -1.0, 1.0) * np.sqrt(sizes)
    return MultiElo(ratings, (left * scale)[:, kept], (right.T * scale)[:, kept])


def log_loss(payoff: ArrayLike, predicted: ArrayLike) -> float:
    """Mean cross entropy of predicted capture rates, above that of a perfect prediction; in nats.

    At least 0, and infinite where a thing happened that was predicted never to happen. Both arrays
    have the shape ``(n, m)``. Raises ValueError for another shape and rates outside [0, 1].
    """
    from scipy.special import rel_entr

    matrix, guess = check_payoff(payoff), check_payoff(predicted)
    require(guess.shape == matrix.shape, f"predictions of shape {matrix.shape}", guess.shape)
    loss = float(np.mean(rel_entr(matrix, guess) + rel_entr(1.0 - matrix, 1.0 - guess)))
    return max(0.0, loss)  # rounding may leave a perfect prediction just below


def _fit(rates: Rates, ridge: float) -> Rates:
    """Newton's method, halving steps that do not descend; parameters (a, b, offset)."""
    rows, columns = rates.shape
    parameters: Rates = np.zeros(rows + columns + 1)
    for _ in range(_MOST_STEPS):
        loss, gradient, curvature = _loss(parameters, rates, ridge)
        if np.abs(gradient).max() < _TOLERANCE:
            break
        # Without a ridge the constant between ratings and offset is free: the shortest step.
        step = np.linalg.lstsq(curvature, -gradient, rcond=None)[0]
        size = 1.0
        while size > 1e-9 and _loss(parameters + size * step, rates, ridge)[0] > loss:
            size /= 2.0
        parameters += size * step
    return parameters


def _loss(parameters: Rates, rates: Rates, ridge: float) -> tuple[float, Rates, Rates]:
    """Penalised cross entropy, its gradient and its Hessian."""
    rows, columns = rates.shape
    a, b, offset = np.split(parameters, [rows, rows + columns])
    x = a[:, None] - b + offset
    p = _sigmoid(x)
    penalty = np.append(np.full(rows + columns, ridge), 0.0)
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
    p: Rates = np.exp(-np.logaddexp(0.0, -x))
    return p


def _rates(values: Rates, shrinkage: float) -> Rates:
    """Capture rates whose shrunken logits these are."""
    rates: Rates = np.clip((_sigmoid(values) - shrinkage) / (1.0 - 2.0 * shrinkage), 0.0, 1.0)
    return rates
