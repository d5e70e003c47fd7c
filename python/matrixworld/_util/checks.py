"""Checks of arguments. Every message states what was expected and what was passed."""

from __future__ import annotations

import inspect
import operator
import os
import re
from collections.abc import Callable, Iterable, Mapping, Set
from difflib import get_close_matches
from numbers import Real
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

INT_MAX = 2**31 - 1
"""The largest size or index of the engine."""

SEED_MAX = 2**64 - 1
"""The largest seed, and the largest number of an episode."""

MOST_THREADS = 1024
"""The most threads that anything may use."""

_LONGEST = 100  # characters of a value in a message
_GROUP = Path("/sys/fs/cgroup")  # of a container (Linux, version 2)


class OutOfMemoryError(ValueError):
    """Something needs more memory than this machine has available."""


def shown(value: object) -> str:
    """Return a value as a message names it: as Python writes it, unless that is very long."""
    try:
        text = repr(value.item() if isinstance(value, np.generic) else value)
    except ValueError:  # Python does not write integers of thousands of digits
        return f"a very large {type(value).__name__}"
    text = re.sub(r"\n\s*", " ", text)  # arrays are written in several lines
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."


def check_integer(name: str, value: Any, low: int = -INT_MAX, high: int = INT_MAX) -> int:
    """Return an argument that Python takes for an index, but no bool, as an int within limits."""
    if isinstance(value, bool | np.bool_):
        raise TypeError(f"{name}: expected an integer, got {shown(value)}")
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: expected an integer, got {shown(value)}") from None
    if not low <= number <= high:
        # A caller below the lower limit does not need to read the upper limit of an integer.
        expected = f"at least {low}" if number < low and high >= INT_MAX else f"{low} to {high}"
        raise ValueError(f"{name}: expected {expected}, got {shown(number)}")
    return number


def check_real(name: str, value: Any) -> float:
    """Return a real argument, but no bool, as a float."""
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name}: expected a number, got {shown(value)}")
    try:
        return float(value)
    except OverflowError:
        raise ValueError(f"{name}: expected a finite number, got {shown(value)}") from None


def check_number(
    name: str, value: Any, *, least: float, most: float = np.inf, positive: bool = False
) -> float:
    """Return a real argument within limits as a float; infinity and NaN are never legal."""
    number = check_real(name, value)
    # NaN compares as False with everything.
    if not least <= number <= most or number == np.inf or (positive and number == 0.0):
        above = "above" if positive else "at least"
        upper = "" if most == np.inf else f" and at most {most:g}"
        raise ValueError(f"{name}: expected a number {above} {least:g}{upper}, got {shown(value)}")
    return number


def check_floats(
    name: str, given: ArrayLike, dtype: type[np.floating[Any]] = np.float64
) -> NDArray[Any]:
    """Return real numbers as a new array of a float dtype; no text and no masked cells."""
    expected = f"{name}: expected an array of numbers, got"
    try:
        array: Any = np.ma.asarray(given)
        kept = np.array(array.data, dtype) if array.dtype.kind in "biufO" else None
    except OverflowError:
        raise ValueError(f"{name}: expected numbers that {dtype.__name__} holds") from None
    except (TypeError, ValueError) as error:
        raise type(error)(f"{expected} {shown(given)}") from None
    if kept is None:
        raise TypeError(f"{expected} {shown(given)}")
    if np.any(array.mask):
        where = ", ".join(map(str, np.argwhere(array.mask)[0]))
        raise ValueError(f"{expected} a masked cell at ({where})")
    return kept


def unmasked(name: str, given: Any) -> NDArray[Any]:
    """Return an argument as an array; TypeError where a mask hides values of it."""
    rows = given if isinstance(given, list | tuple) else (given,)
    if any(isinstance(row, np.ma.MaskedArray) for row in rows):
        raise TypeError(f"{name}: expected an array that hides no values, got a masked array")
    return np.asarray(given)


def check_shape(name: str, array: NDArray[Any], *expected: int) -> None:
    """Raise TypeError unless an argument is an array, or ValueError if it has another shape."""
    check_instance(name, array, np.ndarray)
    if unmasked(name, array).shape != expected:
        raise ValueError(f"{name}: expected shape {expected}, got {array.shape}")


def check_finite(name: str, array: NDArray[Any]) -> None:
    """Raise ValueError with the first of some numbers that is NaN or infinite."""
    bad = array[~np.isfinite(array)]
    if bad.size:
        raise ValueError(f"{name}: expected finite numbers, got {bad[0]}")


def check_bool(name: str, value: Any) -> bool:
    """Return an argument that must be True or False."""
    if not isinstance(value, bool):
        raise TypeError(f"{name}: expected True or False, got {shown(value)}")
    return value


def check_instance(name: str, value: Any, kind: type) -> None:
    """Raise TypeError unless an argument is an instance of a type."""
    if not isinstance(value, kind):
        # numpy.random.Generator is of numpy.random._generator, such as others.
        inner = r"^builtins\.|(?<=^matrixworld\.)[\w.]+\.|(?<=\.)_[\w.]+\."
        expected = re.sub(inner, "", f"{kind.__module__}.{kind.__name__}")
        raise TypeError(f"{name}: expected a {expected}, got {shown(value)}")


def check_sequence(name: str, value: Any, of: str) -> tuple[Any, ...]:
    """Return the items of an argument in their order; TypeError for a text, a mapping or a set."""
    if not isinstance(value, Iterable) or isinstance(value, str | bytes | Mapping | Set):
        raise TypeError(f"{name}: expected a sequence of {of}, got {shown(value)}")
    return tuple(value)


def check_sizes(name: str, value: Any, most: int = INT_MAX) -> tuple[int, ...]:
    """Return an argument that is a sequence of integers from 1 on."""
    return tuple(check_integer(name, size, 1, most) for size in check_sequence(name, value, "ints"))


def check_choice(name: str, value: Any, choices: Iterable[str]) -> None:
    """Raise ValueError, listing the choices, unless `value` is one of them."""
    known = list(choices)
    # The type first: an array would compare element by element.
    if not isinstance(value, str) or value not in known:
        raise ValueError(f"{name}: expected one of {', '.join(known)}, got {shown(value)}")


ELSEWHERE = {
    "num_envs": ("n_worlds",),
    "n_envs": ("num_envs", "n_worlds"),
    "n_worlds": ("num_envs",),
    "max_cycles": ("max_steps",),
    "max_episode_steps": ("max_steps",),
    "opponent": ("evaders",),
}
"""What other libraries call keyword arguments, and what they are called here."""


def check_keywords(given: Iterable[str], known: Iterable[str], of: Callable[..., Any]) -> None:
    """Raise TypeError for an unknown keyword argument of a call, and name the nearest one."""
    legal = set(known)
    unknown = [name for name in given if name not in legal]
    if unknown:
        parameters = inspect.signature(of).parameters.values()
        legal |= {each.name for each in parameters if each.kind is not each.VAR_KEYWORD}
        nearest = get_close_matches(unknown[0], sorted(legal), 1)
        nearest = [name for name in ELSEWHERE.get(unknown[0], ()) if name in legal] or nearest
        meant = f"; did you mean {nearest[0]}?" if nearest else ""
        # In Python's words, by which libraries know that they may try again without it.
        got = f"got an unexpected keyword argument {unknown[0]!r}{meant}"
        raise TypeError(f"{got}; expected some of {', '.join(sorted(legal))}")


def check_threads(threads: int | None) -> int:
    """Return the number of threads for the engine; None becomes `usable_cores`."""
    return usable_cores() if threads is None else check_integer("threads", threads, 1, MOST_THREADS)


def check_integers(
    name: str, given: ArrayLike, dtype: type[np.integer[Any]], low: int | None = 0
) -> NDArray[Any]:
    """Return integers from `low` (None: the smallest) to the largest of a dtype as a new array."""
    limits = np.iinfo(dtype)
    least, most = int(limits.min) if low is None else low, int(limits.max)
    try:
        array = unmasked(name, given)
    except ValueError:  # rows of different lengths
        array = np.asarray(given, object)
    if array.dtype.kind not in "iu":
        # Large integers, and signed ones beside unsigned ones, become floats or objects in NumPy.
        numbers = np.asarray(given, object)
        checked = [check_integer(name, number, least, most) for number in numbers.flat]
        return np.array(checked, dtype).reshape(numbers.shape)
    if array.size and (array.dtype != dtype or least > limits.min):
        for number in (array.min(), array.max()):
            check_integer(name, number, least, most)
    return array.astype(dtype)


def usable_cores() -> int:
    """Return the number of cores that this process may use, the default number of threads."""
    has_affinity = hasattr(os, "sched_getaffinity")
    cores = len(os.sched_getaffinity(0)) if has_affinity else os.cpu_count() or 1
    return min(cores, MOST_THREADS)


def check_memory(what: str, **parts: float) -> None:
    """Raise OutOfMemoryError if `what` needs more bytes than are available, in all its parts."""
    needed, available = sum(parts.values()), available_memory()
    if available is not None and needed > available:
        largest = max(parts, key=parts.__getitem__)
        wanted, has, most = (size / 10**9 for size in (needed, available, parts[largest]))
        raise OutOfMemoryError(
            f"{what}: expected to need at most {has:,.1f} GB of memory, which are available, got "
            f"an estimate of {wanted:,.1f} GB, of which {largest}: {most:,.1f} GB"
        )


def available_memory() -> int | None:
    """Return the bytes that this process can get without swapping; None where that is unknown."""
    limits = []
    if free := re.search(r"^MemAvailable: *(\d+) kB", _text(Path("/proc/meminfo")), re.MULTILINE):
        limits.append(1024 * int(free[1]))
    # What is left to a container. Not memory.current, which counts files in the cache.
    limit = re.match(r"\d+", _text(_GROUP / "memory.max"))  # or the word "max"
    held = re.search(r"^anon (\d+)$", _text(_GROUP / "memory.stat"), re.MULTILINE)
    if limit and held:
        limits.append(int(limit[0]) - int(held[1]))
    return max(0, min(limits)) if limits else None


def _text(file: Path) -> str:
    """Return a text of the system, or an empty one where there is none to read."""
    try:
        return file.read_text("utf-8")
    except OSError:
        return ""
