"""Payoff matrices: validation, last half, swapped teams, logits."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Rates = NDArray[np.float64]
"""Capture rates, or other float64 numbers of the analysis."""
Mask = NDArray[np.bool_]

SHRINKAGE = 0.01
"""Default shrinkage towards 1/2 before a logit: 0 and 1 become .01 and .99, logits -4.6 and 4.6."""


def check_payoff(payoff: ArrayLike) -> Rates:
    """Return the payoff matrix as a float64 array, or raise an error that says what is wrong.

    Parameters
    ----------
    payoff : array_like of real numbers, shape (n, m)
        Capture rates in [0, 1]. Row g holds the pursuers of generation g, column h the evaders of
        generation h; n and m are at least 1.

    Returns
    -------
    ndarray of float64, shape (n, m)
        The same values; not a copy if they are float64 already.

    Raises
    ------
    ValueError
        If the array does not have two dimensions, is empty, or has values that are not finite or
        outside [0, 1].
    TypeError
        If the values are not real numbers.
    """
    return check_rates(payoff, ndim=2, what="a payoff matrix")


def check_rates(values: ArrayLike, *, ndim: int, what: str = "an array of rates") -> Rates:
    """Return rates in [0, 1] as a float64 array.

    Parameters
    ----------
    values : array_like of real numbers
        The rates.
    ndim : int
        Expected number of dimensions; none of them may be empty.
    what : str, optional
        What error messages call the array.

    Returns
    -------
    ndarray of float64
        The same values in the same shape.

    Raises
    ------
    ValueError
        If the array has another number of dimensions, is empty, or has values that are not finite
        or outside [0, 1].
    TypeError
        If the values are not real numbers.
    """
    array = _as_array(values, what)
    # Booleans count as rates of 0 and 1: single matches are stored this way.
    if array.dtype.kind not in "biuf":
        raise TypeError(f"expected {what} of real numbers, got dtype {array.dtype}")
    if array.ndim != ndim or array.size == 0:
        raise ValueError(
            f"expected {what} with {ndim} dimension(s), none of them empty, got shape {array.shape}"
        )
    # float32 rates are widened: sums over many cells would lose digits.
    rates = array.astype(np.float64, copy=False)
    _require_unit_interval(rates, what)
    return rates


def check_runs(payoffs: ArrayLike) -> Rates:
    """Return the payoff matrices of several runs as a float64 array.

    Parameters
    ----------
    payoffs : array_like of real numbers, shape (runs, n, m) or (n, m)
        Capture rates in [0, 1]. One matrix of shape (n, m) is a single run.

    Returns
    -------
    ndarray of float64, shape (runs, n, m)
        The matrices.

    Raises
    ------
    ValueError, TypeError
        As `check_payoff` does.
    """
    # A single matrix is a stack of one run, so callers need no second case.
    if np.ndim(_as_array(payoffs, "payoff matrices")) == 2:
        return check_payoff(payoffs)[None]
    return check_rates(payoffs, ndim=3, what="payoff matrices (runs, n, m)")


def last_half(payoff: ArrayLike) -> Rates:
    """Return rows from ``n // 2`` on and columns from ``m // 2`` on.

    Early generations mix untrained and trained teams, so measures of the whole matrix mislead.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.

    Returns
    -------
    ndarray of float64, shape (n - n // 2, m - m // 2)
        For 31 generations: generations 15 to 30.
    """
    matrix = check_payoff(payoff)
    # Of an odd number of generations the middle one belongs to the last half.
    rows, columns = matrix.shape
    return matrix[rows // 2 :, columns // 2 :]


def swap_teams(payoff: ArrayLike) -> Rates:
    """Return the payoff matrix of the same matches from the evaders' side: ``1 - M.T``.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix of the pursuers.

    Returns
    -------
    ndarray of float64, shape (m, n)
        Escape rates, evaders in rows.
    """
    swapped: Rates = 1.0 - check_payoff(payoff).T
    return swapped


def logits(payoff: ArrayLike, *, shrinkage: float = SHRINKAGE) -> Rates:
    """Return the logits of the capture rates, shrunk towards 1/2.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.
    shrinkage : float, optional
        Shrinkage s, in (0, 1/2).

    Returns
    -------
    ndarray of float64, shape (n, m)
        ``log(x / (1 - x))`` with ``x = s + (1 - 2 s) M``.

    Raises
    ------
    ValueError
        If the shrinkage is outside (0, 1/2).

    Notes
    -----
    Shrinking keeps the order of all cells; clipping would make cells near 0 or 1 equal.
    """
    x = shrink(check_payoff(payoff), shrinkage)
    # log1p keeps its digits for rates close to 0.
    odds: Rates = np.log(x) - np.log1p(-x)
    return odds


def shrink(rates: Rates, shrinkage: float) -> Rates:
    """Return rates moved towards 1/2, away from 0 and 1."""
    require(0.0 < shrinkage < 0.5, "a shrinkage in (0, 0.5)", shrinkage)
    return shrinkage + (1.0 - 2.0 * shrinkage) * rates


def require(condition: bool, expected: str, received: object) -> None:
    """Raise ValueError with the expected and the received value unless the condition holds."""
    if not condition:
        raise ValueError(f"expected {expected}, got {received}")


def _as_array(values: ArrayLike, what: str) -> NDArray[np.generic]:
    # NumPy refuses ragged lists with a message about "inhomogeneous shape"; ours says what to
    # change.
    try:
        return np.asarray(values)
    except ValueError as error:
        raise ValueError(f"expected {what} with rows of equal length, got: {error}") from error


def _require_unit_interval(rates: Rates, what: str) -> None:
    with np.errstate(invalid="ignore"):
        # The negated test also finds NaN, which compares as false with everything.
        bad = np.argwhere(~((rates >= 0.0) & (rates <= 1.0)))
    if len(bad):
        where = tuple(int(i) for i in bad[0])
        raise ValueError(
            f"expected {what} with finite values in [0, 1], got {rates[where]} at index {where}"
        )
