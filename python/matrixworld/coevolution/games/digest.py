"""A digest of what a game is made of: a run goes on with the game that it began with, and no other.

It is of the game's fields, of the source of its functions, and of all that these name in their own
module or hold in closures and defaults: functions, classes, numbers, text, arrays, collections of
these, the fields of objects of the module's classes, of dataclasses and of what plays, and what a
DEAP toolbox or set of primitives has registered. Of a function from another module it is of the
source and what it holds, of one of this package of what it holds, and of other objects, such as the
settings of another library, of their type alone. It is the same in every process, as the game is
before it plays: what `play` keeps to be faster changes nothing.
"""

from __future__ import annotations

import inspect
from collections import deque
from collections.abc import Iterator, Mapping, Set
from dataclasses import is_dataclass
from datetime import date, timedelta
from decimal import Decimal
from enum import Enum
from fractions import Fraction
from functools import partial
from hashlib import sha256
from re import Pattern
from types import (
    BuiltinFunctionType,
    CodeType,
    FunctionType,
    MethodDescriptorType,
    MethodType,
    ModuleType,
    SimpleNamespace,
    WrapperDescriptorType,
)
from typing import TYPE_CHECKING, Any

import numpy as np
from deap import base, gp

from matrixworld.coevolution.games.operators import PAIRED

if TYPE_CHECKING:
    from matrixworld.coevolution.games.game import Game

PLAIN = (
    bool, float, complex, str, bytes, bytearray, range, Fraction, Decimal, Pattern, timedelta, date,
)  # fmt: skip
"""Types whose text says all of a value."""
LONGEST = 200  # characters of a text that is not replaced by its digest
OF_C = (BuiltinFunctionType, MethodDescriptorType, WrapperDescriptorType, np.ufunc)
"""Functions that have no source, but a name."""
PACKAGE = __name__.partition(".")[0]

FIELDS = (
    "genes", "teams", "bounds", "deterministic", "many", "scores", "symmetric", "extras", "play",
    "show", *PAIRED,
)  # fmt: skip
"""What a game is made of."""


def digest_of(game: Game) -> str:
    """Return a digest of a game's fields and functions, the same in every process."""
    parts = _Parts()
    lines = [f"{name}\n{parts.text_of(getattr(game, name), '')}" for name in FIELDS]
    return sha256("\n".join([*lines, *parts.texts]).encode()).hexdigest()[:16]


class _Parts:
    """The functions and classes that a game is made of, each numbered when it is first met.

    Names do not tell them apart: all lambdas have one, and a function that a function returns has
    the name of its sisters, which hold other values.
    """

    def __init__(self) -> None:
        self.texts: list[str] = []
        self._numbers: dict[tuple[int, int], int] = {}  # by address, and that of a method's object
        self._known: dict[int, str] = {}  # texts of collections, by address
        self._met: list[Any] = []  # kept, so that no other object gets the address of one
        self._around: list[int] = []  # addresses of the collections around a value

    def text_of(self, value: Any, module: str) -> str:
        """Return a text of a value that code in a module names, and add what it is made of."""
        if isinstance(value, Enum):
            return f"{type(value).__qualname__}.{value.name}"
        if isinstance(value, int) and not isinstance(value, bool):
            return hex(value)  # Python writes no decimals of very large ones
        if value is None or isinstance(value, PLAIN):
            return _short(repr(value))
        if isinstance(value, np.ndarray | np.generic) and not value.dtype.hasobject:
            array = np.ascontiguousarray(value)
            return f"{array.dtype} {np.shape(value)} {sha256(array.tobytes()).hexdigest()}"
        if isinstance(value, ModuleType):
            return value.__name__
        if isinstance(value, OF_C):
            name = getattr(value, "__qualname__", value.__name__)
            return f"{getattr(value, '__module__', '')} {name}"
        function = value if isinstance(value, type) else _function_of(value)
        if function is not None:
            return f"part {self._number_of(value, function, module)}"
        if id(value) in self._around:
            return "itself"
        if id(value) not in self._known:
            self._around.append(id(value))
            parts = [self.text_of(part, module) for part in self._parts_of(value, module)]
            self._around.pop()
            if isinstance(value, Set):  # its order differs from process to process
                parts.sort()
            self._known[id(value)] = _short(f"{type(value).__qualname__}({', '.join(parts)})")
            self._met.append(value)
        return self._known[id(value)]

    def _parts_of(self, value: Any, module: str) -> list[Any]:
        """Return what a collection, a partial, a toolbox or another object is made of."""
        if isinstance(value, Mapping):
            return list(value.items())
        if isinstance(value, tuple | list | Set | deque | np.ndarray):
            return list(value)
        if isinstance(value, partial):
            return [value.func, value.args, value.keywords]
        if isinstance(value, base.Toolbox):
            registered = {k: part for k, part in vars(value).items() if isinstance(part, partial)}
            return [registered]
        if isinstance(value, gp.PrimitiveSetTyped):
            names = {name: getattr(part, "arity", None) for name, part in value.mapping.items()}
            functions = {k: part for k, part in value.context.items() if k != "__builtins__"}
            return [value.arguments, names, functions]
        kind = type(value)
        if kind.__module__ == module or kind is SimpleNamespace or is_dataclass(value):
            return [kind, getattr(value, "__dict__", {})]
        call = getattr(kind, "__call__", None)  # noqa: B004, of its class
        return [call, getattr(value, "__dict__", {})] if isinstance(call, FunctionType) else []

    def _number_of(self, value: Any, function: FunctionType | type, module: str) -> int:
        """Return the number of a function, method or class, with what it is made of among parts."""
        key = id(function), id(getattr(value, "__self__", None))
        if key not in self._numbers:
            number = self._numbers[key] = len(self.texts)
            self._met.append(value)
            self.texts.append("")  # before the rest: a function may name itself
            lines = self._lines_of(value, function, module or function.__module__)
            self.texts[number] = "\n".join(lines)
        return self._numbers[key]

    def _lines_of(self, value: Any, function: FunctionType | type, module: str) -> Iterator[str]:
        """Yield the source of a function or class, and the texts of what it holds and names."""
        yield function.__qualname__
        in_package = function.__module__.partition(".")[0] == PACKAGE
        if isinstance(function, type):
            if function.__module__ == module and not in_package:
                yield _source_of(function)
                for part in (*function.__bases__, *vars(function).values()):
                    if isinstance(part, type | FunctionType):
                        yield self.text_of(part, module)
            return
        if not in_package:
            yield _source_of(function.__code__)
        holds = [function.__defaults__, function.__kwdefaults__, *_closure_of(function)]
        if isinstance(value, MethodType) and not isinstance(value.__self__, type):
            holds.append(getattr(value.__self__, "__dict__", None))
        for held in holds:
            yield self.text_of(held, module)
        if function.__module__ == module and not in_package:
            for name in sorted({*_names(function.__code__)} & function.__globals__.keys()):
                yield f"{name} {self.text_of(function.__globals__[name], module)}"


def _function_of(value: Any) -> FunctionType | None:
    """Return the function of a method, or of a cache of one; None of other values."""
    if isinstance(value, partial):  # that of a toolbox may have the attributes of its function
        return None
    function = getattr(value, "__func__", value)
    while not isinstance(function, FunctionType | type) and hasattr(function, "__wrapped__"):
        function = function.__wrapped__
    return function if isinstance(function, FunctionType) else None


def _closure_of(function: FunctionType) -> Iterator[Any]:
    """Yield the values of the variables outside a function that it holds."""
    held = inspect.getclosurevars(function).nonlocals  # those that are set
    for name in sorted(held):
        yield held[name]


def _source_of(code: CodeType | type) -> str:
    """Return a source; of a lambda it is that of its whole line."""
    try:
        return inspect.getsource(code)
    except (OSError, TypeError):  # typed at a prompt that keeps no source
        if isinstance(code, type):
            return code.__qualname__
        return f"{code.co_code.hex()} {code.co_consts} {code.co_names}"


def _short(text: str) -> str:
    """Return a text, or a digest of a long one: collections that others hold may be in many."""
    return text if len(text) <= LONGEST else sha256(text.encode()).hexdigest()


def _names(code: CodeType) -> Iterator[str]:
    """Yield the names that a function uses, with those of the functions inside it."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)
