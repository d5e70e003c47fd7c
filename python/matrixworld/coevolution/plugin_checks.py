"""Errors of learners and samplers from outside the package, and checks of what they return."""

from __future__ import annotations

import inspect
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import DTypeLike

from matrixworld.coevolution.types import State


class PluginError(RuntimeError):
    """Code from outside the package failed or returned what its interface does not allow.

    The message names the learner or sampler and its method; the cause is the original error.
    """


def described(error: Exception) -> str:
    """Return the kind and the message of an error."""
    return f"{type(error).__name__}: {error}"


@contextmanager
def errors_of(title: str, method: str) -> Iterator[None]:
    """Turn errors of a plugin's method into `PluginError`, which names both."""
    try:
        yield
    except PluginError:
        raise
    except Exception as error:
        raise PluginError(f"{title}: {method}: {described(error)}") from error


def check_methods(title: str, found: Any, names: Collection[str]) -> None:
    """Raise PluginError unless an object has the attributes of its interface."""
    for name in names:
        # Not by hasattr, which would compute a property.
        if inspect.getattr_static(found, name, None) is None and not hasattr(found, name):
            raise PluginError(f"{title}: expected {', '.join(names)}, got no {name}")


def check_array(
    title: str, what: str, found: Any, shape: tuple[int, ...], dtype: DTypeLike
) -> None:
    """Raise PluginError unless a plugin returned an array of this shape and dtype, all finite."""
    wanted = np.dtype(dtype)
    if not isinstance(found, np.ndarray) or (found.shape, found.dtype) != (shape, wanted):
        got = (
            f"{found.dtype} {found.shape}"
            if isinstance(found, np.ndarray)
            else type(found).__name__
        )
        raise PluginError(f"{title}: {what}: expected an array of {wanted} {shape}, got {got}")
    if not np.isfinite(found).all():
        raise PluginError(f"{title}: {what}: expected finite numbers, got NaN or infinity")


def checked_state(title: str, state: Any) -> State:
    """Return copies of the arrays of a state; PluginError unless these can be saved by name."""
    if not isinstance(state, dict):
        raise PluginError(f"{title}: state: expected arrays by name, got {type(state).__name__}")
    for name, value in state.items():
        # A checkpoint holds the arrays of all parts of a run, as part.name.
        if not isinstance(name, str) or not name.isidentifier():
            raise PluginError(f"{title}: state: expected names such as sigma, got {name!r}")
        if not isinstance(value, np.ndarray) or value.dtype.hasobject:
            raise PluginError(
                f"{title}: state: expected an array of numbers or text as {name}, got {value!r}"
            )
    # Copies: a run may restore a state of before a generation, which must not have changed since.
    return {name: value.copy() for name, value in state.items()}
