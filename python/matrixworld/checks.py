"""Checks of plain arguments, with one wording for what was expected and what came."""

from __future__ import annotations

import operator
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

INT_MAX = 2**31 - 1
"""The largest number that the engine takes for a size or an index."""

SEED_MAX = 2**64 - 1
"""The largest seed, and the largest number of an episode."""

_MAX_THREADS = 1024


def check_integer(name: str, value: Any, low: int = -INT_MAX, high: int = INT_MAX) -> int:
    """``value`` as an int.

    Raises TypeError for what is not an integer, ValueError outside ``low`` to ``high``.
    """
    if isinstance(value, bool | np.bool_):
        raise TypeError(f"{name}: expected an int, got {value!r}")
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: expected an int, got {value!r}") from None
    if not low <= number <= high:
        raise ValueError(f"{name}: expected {low} to {high}, got {number}")
    return number


def check_bool(name: str, value: Any) -> bool:
    """``value``, a bool. Raises TypeError for anything else."""
    if not isinstance(value, bool):
        raise TypeError(f"{name}: expected a bool, got {value!r}")
    return value


def check_threads(threads: int | None) -> int:
    """The number of threads for the engine, where 0 stands for one a core.

    Raises ValueError outside 1 to 1024, TypeError for what is not an integer.
    """
    return 0 if threads is None else check_integer("threads", threads, 1, _MAX_THREADS)


def check_naturals(name: str, given: ArrayLike, dtype: type[np.integer[Any]]) -> NDArray[Any]:
    """Integers from 0 to the largest of ``dtype``, as an array of it.

    Raises TypeError for what is not an integer, ValueError for numbers out of range.
    """
    array = np.asarray(given)
    if array.dtype == dtype and array.dtype.kind == "u":
        return array.astype(dtype)
    high = int(np.iinfo(dtype).max)
    if array.dtype.kind not in "iu":  # NumPy makes floats of ints below and above 2**63
        numbers = np.asarray(given, object)
        checked = [check_integer(name, number, 0, high) for number in numbers.flat]
        return np.array(checked, dtype).reshape(numbers.shape)
    if array.size and (array.min() < 0 or array.max() > high):
        raise ValueError(f"{name}: expected 0 to {high}, got {array.min()} to {array.max()}")
    return array.astype(dtype)
