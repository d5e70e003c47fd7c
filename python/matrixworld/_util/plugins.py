"""Code of the user, by its name ``module:object``: how it is found, and how it fails."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from operator import attrgetter
from typing import Any

from matrixworld._util.checks import shown

PATH = re.compile(r"[^\W\d]\w*(\.[^\W\d]\w*)*:[^\W\d]\w*(\.[^\W\d]\w*)*")
"""``module:object``, both with dots or without."""


class PluginError(RuntimeError):
    """Code of your own cannot be imported or made, or does not keep a promise of its base.

    The message names it; the cause is the original error, if there is one.
    """


@contextmanager
def no_exit(where: str) -> Iterator[None]:
    """Raise PluginError where code of your own exits: the program would end as if all was well."""
    try:
        yield
    except SystemExit as error:
        raise PluginError(f"{where}: code of your own called exit") from error


def imported(code: str) -> Any:
    """Return the object of a name; ValueError if there is none, PluginError if its module fails.

    Modules are also looked for in the working directory, which is appended to `sys.path`.
    """
    name, _, attribute = code.partition(":")
    # An installed command looks for modules where it lies itself, not where the user is.
    if os.getcwd() not in sys.path:
        sys.path.append(os.getcwd())
    try:
        module = import_module(name)
    except (Exception, SystemExit) as error:
        # A module that exists may fail to import another one: then the error names that one.
        missing = isinstance(error, ModuleNotFoundError) and error.name
        if missing and f"{name}.".startswith(f"{missing}."):
            raise ValueError(
                f"{code}: expected a module that can be imported ({error}); install the package "
                f"that has it, or put its folder on PYTHONPATH"
            ) from error
        raise PluginError(f"{code}: import: {type(error).__name__}: {error}") from error
    try:
        return attrgetter(attribute)(module)
    except AttributeError as error:
        raise ValueError(f"{code}: expected the name of an object in {name}") from error


def name_of(code: Any) -> str:
    """Return ``module:object`` of a class; ValueError if this is no name, as inside a function."""
    name = f"{getattr(code, '__module__', '')}:{getattr(code, '__qualname__', '')}"
    if not PATH.fullmatch(name):
        raise ValueError(f"code: expected a class of a module, got {shown(code)}")
    return name
