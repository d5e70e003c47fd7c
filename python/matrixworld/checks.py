"""Checks of arguments. Every message states what was expected and what was passed."""

from __future__ import annotations

import inspect
import operator
from collections.abc import Callable, Iterable
from difflib import get_close_matches
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

INT_MAX = 2**31 - 1
"""The largest number that the engine takes for a size or an index."""

SEED_MAX = 2**64 - 1
"""The largest seed, and the largest number of an episode."""

_MAX_THREADS = 1024


def check_integer(name: str, value: Any, low: int = -INT_MAX, high: int = INT_MAX) -> int:
    """Return an integer argument as an int.

    Parameters
    ----------
    name : str
        Name of the argument in messages.
    value : object
        The argument: an int or anything that Python takes for an index, but no bool.
    low, high : int, optional
        The smallest and the largest legal value. The default limits are those of the engine.

    Returns
    -------
    int
        The value.

    Raises
    ------
    TypeError
        If the value is not an integer.
    ValueError
        If it lies outside `low` to `high`.
    """
    if isinstance(value, bool | np.bool_):
        raise TypeError(f"{name}: expected an integer, got {value!r}")
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: expected an integer, got {value!r}") from None
    if not low <= number <= high:
        # A caller below the lower limit does not need to read the engine's upper limit.
        expected = f"at least {low}" if number < low and high == INT_MAX else f"{low} to {high}"
        raise ValueError(f"{name}: expected {expected}, got {number}")
    return number


def check_real(name: str, value: Any) -> float:
    """Return a real argument as a float; raise TypeError for anything else and for a bool."""
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name}: expected a number, got {value!r}")
    return float(value)


def check_number(
    name: str, value: Any, *, least: float, most: float = np.inf, positive: bool = False
) -> float:
    """Return a real argument as a float.

    Parameters
    ----------
    name : str
        Name of the argument in messages.
    value : object
        The argument: a real number, but no bool.
    least, most : float, optional
        The smallest and the largest legal value. Infinity is never legal.
    positive : bool, optional
        Whether 0 is refused.

    Returns
    -------
    float
        The value.

    Raises
    ------
    TypeError
        If the value is not a number.
    ValueError
        If it is not finite or lies outside the limits.
    """
    number = check_real(name, value)
    if not least <= number <= most or number == np.inf or (positive and number == 0.0):
        above = "above" if positive else "at least"
        upper = "" if most == np.inf else f" and at most {most:g}"
        raise ValueError(f"{name}: expected a number {above} {least:g}{upper}, got {value}")
    return number


def check_bool(name: str, value: Any) -> bool:
    """Return an argument that must be True or False; raise TypeError for anything else."""
    if not isinstance(value, bool):
        raise TypeError(f"{name}: expected True or False, got {value!r}")
    return value


def check_instance(name: str, value: Any, kind: type) -> None:
    """Raise TypeError unless an argument is an instance of a type that `matrixworld` exports."""
    if not isinstance(value, kind):
        raise TypeError(f"{name}: expected a matrixworld.{kind.__name__}, got {value!r}")


def check_choice(name: str, value: Any, choices: Iterable[str]) -> None:
    """Raise ValueError, listing the choices, unless `value` is one of them."""
    known = list(choices)
    if value not in known:
        raise ValueError(f"{name}: expected one of {', '.join(known)}, got {value!r}")


def check_keywords(given: Iterable[str], known: Iterable[str], of: Callable[..., Any]) -> None:
    """Raise TypeError for a keyword argument that is unknown, and name the nearest one.

    Parameters
    ----------
    given : iterable of str
        Keyword arguments beyond the parameters of `of`.
    known : iterable of str
        Those that are legal.
    of : callable
        The function or class that was called; messages name its own parameters, too.
    """
    legal = set(known)
    for name in given:
        if name in legal:
            continue
        parameters = inspect.signature(of).parameters.values()
        names = sorted(
            legal | {each.name for each in parameters if each.kind is not each.VAR_KEYWORD}
        )
        nearest = get_close_matches(name, names, 1)
        meant = f"; did you mean {nearest[0]}?" if nearest else ""
        raise TypeError(f"keywords: expected some of {', '.join(names)}, got {name}{meant}")


def check_threads(threads: int | None) -> int:
    """Return the number of threads for the engine; None becomes 0, its sign for one per core.

    Raises ValueError outside 1 to 1024 and TypeError for a value that is not an integer.
    """
    return 0 if threads is None else check_integer("threads", threads, 1, _MAX_THREADS)


def check_naturals(name: str, given: ArrayLike, dtype: type[np.integer[Any]]) -> NDArray[Any]:
    """Return integers from 0 to the largest of a dtype as an array of that dtype.

    Parameters
    ----------
    name : str
        Name of the argument in messages.
    given : array_like of int
        The argument.
    dtype : type
        A NumPy integer type.

    Returns
    -------
    ndarray of `dtype`
        A copy, of the same shape.

    Raises
    ------
    TypeError
        If an element is not an integer.
    ValueError
        If an element is negative or too large for `dtype`.
    """
    array = np.asarray(given)
    if array.dtype == dtype and array.dtype.kind == "u":
        return array.astype(dtype)
    high = int(np.iinfo(dtype).max)
    if array.dtype.kind not in "iu":
        # Integers beyond 2**63 beside smaller ones become floats in NumPy, so each is checked.
        numbers = np.asarray(given, object)
        checked = [check_integer(name, number, 0, high) for number in numbers.flat]
        return np.array(checked, dtype).reshape(numbers.shape)
    if array.size and (array.min() < 0 or array.max() > high):
        raise ValueError(f"{name}: expected 0 to {high}, got {array.min()} to {array.max()}")
    return array.astype(dtype)
