"""The payoff matrix: checked on the way in, halved, seen from the other team."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Rates = NDArray[np.float64]

SHRINKAGE = 0.01
"""Default pull towards 1/2 before a logit: 0 and 1 become .01 and .99, logits -4.6 and 4.6."""


def check_payoff(payoff: ArrayLike) -> Rates:
    """The payoff matrix as a float64 array, shape ``(n, m)`` as given, n and m at least 1.

    Row ``g`` belongs to the pursuers of generation ``g``, column ``h`` to the evaders of generation
    ``h``; values are capture rates in [0, 1].

    Raises ValueError unless the array has two dimensions, no empty one, and finite values in
    [0, 1]; TypeError unless its values are real numbers.
    """
    return check_rates(payoff, ndim=2, what="a payoff matrix")


def check_rates(values: ArrayLike, *, ndim: int, what: str = "an array of rates") -> Rates:
    """Rates in [0, 1] as a float64 array of ``ndim`` dimensions, none empty; errors name ``what``.

    Raises ValueError for another number of dimensions, an empty array, values that are not finite
    or outside [0, 1]; TypeError for values that are not real numbers.
    """
    array = _as_array(values, what)
    if array.dtype.kind not in "biuf":
        raise TypeError(f"expected {what} of real numbers, got dtype {array.dtype}")
    if array.ndim != ndim or array.size == 0:
        raise ValueError(
            f"expected {what} with {ndim} dimension(s), none of them empty, got shape {array.shape}"
        )
    rates = array.astype(np.float64, copy=False)
    _require_unit_interval(rates, what)
    return rates


def check_runs(payoffs: ArrayLike) -> Rates:
    """Payoff matrices of several runs as a float64 array, shape ``(runs, n, m)``.

    One matrix of shape ``(n, m)`` is a single run. Raises as :func:`check_payoff` does.
    """
    if np.ndim(_as_array(payoffs, "payoff matrices")) == 2:
        return check_payoff(payoffs)[None]
    return check_rates(payoffs, ndim=3, what="payoff matrices (runs, n, m)")


def last_half(payoff: ArrayLike) -> Rates:
    """Rows from ``n // 2`` on and columns from ``m // 2`` on: generations 15 to 30 of 0 to 30.

    Early generations mix naive and mature teams, so figures of the whole matrix mislead.
    """
    matrix = check_payoff(payoff)
    rows, columns = matrix.shape
    return matrix[rows // 2 :, columns // 2 :]


def swap_teams(payoff: ArrayLike) -> Rates:
    """The same matches seen by the evaders, shape ``(m, n)``: ``1 - M.T``."""
    swapped: Rates = 1.0 - check_payoff(payoff).T
    return swapped


def logits(payoff: ArrayLike, *, shrinkage: float = SHRINKAGE) -> Rates:
    """``log(x / (1 - x))`` of the shrunken rates ``x = shrinkage + (1 - 2 shrinkage) M``.

    Shape ``(n, m)``. Shrinking, unlike clipping, keeps the order of all cells. Raises ValueError
    unless ``0 < shrinkage < 1/2``.
    """
    x = shrink(check_payoff(payoff), shrinkage)
    odds: Rates = np.log(x) - np.log1p(-x)
    return odds


def shrink(rates: Rates, shrinkage: float) -> Rates:
    """Rates pulled towards 1/2, away from 0 and 1. Raises ValueError outside (0, 1/2)."""
    require(0.0 < shrinkage < 0.5, "a shrinkage in (0, 0.5)", shrinkage)
    return shrinkage + (1.0 - 2.0 * shrinkage) * rates


def require(condition: bool, expected: str, received: object) -> None:
    """Raise ValueError, saying what was expected and what came, unless the condition holds."""
    if not condition:
        raise ValueError(f"expected {expected}, got {received}")


def _as_array(values: ArrayLike, what: str) -> NDArray[np.generic]:
    try:
        return np.asarray(values)
    except ValueError as error:
        raise ValueError(f"expected {what} with rows of equal length, got: {error}") from error


def _require_unit_interval(rates: Rates, what: str) -> None:
    with np.errstate(invalid="ignore"):
        bad = np.argwhere(~((rates >= 0.0) & (rates <= 1.0)))  # a NaN is neither
    if len(bad):
        where = tuple(int(i) for i in bad[0])
        raise ValueError(
            f"expected {what} with finite values in [0, 1], got {rates[where]} at index {where}"
        )
