"""The payoff matrix: checked on the way in, halved, seen from the other team."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Rates = NDArray[np.float64]


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
