"""States: all that changes in a learner or a sampler, as arrays by name.

A state is a named tuple of arrays, of None, and of further named tuples; or, of code of the user,
a dict of arrays. Files hold it flat, by paths such as ``noise.key``.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

NOTHING = np.empty(0, np.bool_)
"""What stands for None in a file."""

State: TypeAlias = Any
"""A named tuple or a dict of arrays."""
Arrays = Mapping[str, NDArray[Any]]


def is_tuple(state: State) -> bool:
    """Return whether a state, or a part of one, is a named tuple."""
    return isinstance(state, tuple) and hasattr(state, "_fields")


def flat(state: State) -> dict[str, NDArray[Any]]:
    """Return the arrays of a state by their paths."""
    parts = state._asdict() if is_tuple(state) else state
    arrays: dict[str, NDArray[Any]] = {}
    for name, part in parts.items():
        if is_tuple(part):
            arrays |= {f"{name}.{path}": array for path, array in flat(part).items()}
        else:
            arrays[name] = NOTHING if part is None else part
    return arrays


def restored(like: State, arrays: Arrays, path: str = "") -> State:
    """Return the state whose arrays are below a path; its named tuples are those of `like`.

    KeyError, or the error of the mapping, if an array is missing.
    """
    if not is_tuple(like):
        return below(arrays, path)
    parts: dict[str, Any] = {}
    for name, part in like._asdict().items():
        here = f"{path}.{name}" if path else name
        if is_tuple(part):
            parts[name] = restored(part, arrays, here)
        else:
            array = arrays[here]
            is_nothing = array.dtype == NOTHING.dtype and array.shape == NOTHING.shape
            parts[name] = None if is_nothing else array
    return type(like)(**parts)


def below(arrays: Arrays, path: str) -> dict[str, NDArray[Any]]:
    """Return the arrays below a path, by the rest of their paths; of no path all of them."""
    begin = f"{path}." if path else ""
    return {name[len(begin) :]: array for name, array in arrays.items() if name.startswith(begin)}
