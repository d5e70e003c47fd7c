"""Public functions and classes document every parameter, in numpydoc form."""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from numpydoc.docscrape import FunctionDoc

PUBLIC = (
    "matrixworld",
    "matrixworld.analysis",
    "matrixworld.coevolution",
    "matrixworld.coevolution.opponents",
    "matrixworld.envs",
    "matrixworld.plots",
    "matrixworld.episodes.replay",
    "matrixworld.toys",
)
SECTIONS = ("Parameters", "Other Parameters", "Attributes")


def public_objects() -> Iterator[Any]:
    """Yield each public function and class once, with its name as the id of a test."""
    seen: set[int] = set()
    for module_name in PUBLIC:
        module = importlib.import_module(module_name)
        names = getattr(module, "__all__", [n for n in vars(module) if not n.startswith("_")])
        for name in names:
            found = getattr(module, name)
            ours = getattr(found, "__module__", "").startswith("matrixworld")
            if callable(found) and ours and id(found) not in seen and not is_enum(found):
                seen.add(id(found))
                yield pytest.param(found, id=f"{module_name.removeprefix('matrixworld.')}.{name}")


def is_enum(found: object) -> bool:
    """Whether something is an enumeration, whose members document themselves."""
    return hasattr(found, "__members__")


def parameters_of(found: Callable[..., Any]) -> set[str]:
    """Return the names of the parameters that a caller gives."""
    if inspect.isclass(found) and issubclass(found, Exception):
        return set()
    if getattr(found, "_is_protocol", False):
        return set()
    return set(inspect.signature(found).parameters) - {"self", "args", "kwargs"}


def documented_by(found: Callable[..., Any]) -> set[str]:
    """Return the parameters and attributes that one docstring describes."""
    doc = FunctionDoc(found, doc=inspect.getdoc(found))
    return {
        name.strip().lstrip("*")
        for section in SECTIONS
        for entry in doc[section]
        for name in entry.name.split(",")
    }


@pytest.mark.parametrize("found", list(public_objects()))
def test_all_parameters_are_documented(found: Callable[..., Any]) -> None:
    # A class may leave the parameters that it inherits to its base class.
    classes = inspect.getmro(found) if inspect.isclass(found) else (found,)
    ours = [each for each in classes if each.__module__.startswith(("matrixworld", __name__))]
    documented = set().union(*map(documented_by, ours))
    assert parameters_of(found) <= documented


def test_a_missing_parameter_is_found() -> None:
    def half(number: int, other: int) -> int:
        """Return half a number.

        Parameters
        ----------
        number : int
            The number.
        """
        return number // 2 + other

    with pytest.raises(AssertionError):
        test_all_parameters_are_documented(half)
