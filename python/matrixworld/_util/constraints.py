"""What a single value may be: constraints that say in words what they expected.

A constraint makes its words when a value does not meet it, and not before.
"""

from __future__ import annotations

import math
import sys
from abc import ABC, abstractmethod
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from numbers import Integral, Real
from typing import Any

from typing_extensions import override

from matrixworld._util.checks import INT_MAX

FLOAT_MAX = sys.float_info.max


class Constraint(ABC):
    """Base of the constraints."""

    @abstractmethod
    def expected(self, value: Any) -> str:
        """Return in words what was expected in place of a value; empty if the value fits."""


@dataclass(frozen=True)
class Range(Constraint):
    """Finite numbers from `least` to `most`; with `open` the least itself is not legal."""

    least: float = 0.0
    most: float = math.inf
    open: bool = False

    @override
    def expected(self, value: Any) -> str:
        if isinstance(value, bool) or not isinstance(value, Real):
            return "a number"
        # An integer may be larger than any float.
        if not -FLOAT_MAX <= value <= FLOAT_MAX:  # type: ignore[operator]  # numbers are compared
            return "a finite number"
        if self.least <= float(value) <= self.most and not (self.open and value == self.least):
            return ""
        lower = f"{'above' if self.open else 'at least'} {self.least:g}"
        upper = "" if self.most == math.inf else f" and at most {self.most:g}"
        return f"a number {lower}{upper}"


@dataclass(frozen=True)
class Whole(Constraint):
    """Integers from `least` to `most`."""

    least: int = 0
    most: int = INT_MAX

    @override
    def expected(self, value: Any) -> str:
        if isinstance(value, bool) or not isinstance(value, Integral):
            return "an integer"
        if int(value) < self.least:
            return f"an integer of at least {self.least}"
        if int(value) > self.most:
            return f"an integer of at most {self.most}"
        return ""


@dataclass(frozen=True)
class OneOf(Constraint):
    """Some texts."""

    choices: Collection[str]

    @override
    def expected(self, value: Any) -> str:
        if isinstance(value, str) and value in self.choices:
            return ""
        return f"one of {', '.join(self.choices)}"


@dataclass(frozen=True)
class Instance(Constraint):
    """Values of a type, which `words` name."""

    kind: type
    words: str

    @override
    def expected(self, value: Any) -> str:
        return "" if isinstance(value, self.kind) else self.words


@dataclass(frozen=True)
class Items(Constraint):
    """Tuples whose items meet a constraint, and which `words` name."""

    item: Constraint
    words: str

    @override
    def expected(self, value: Any) -> str:
        if isinstance(value, tuple) and not any(self.item.expected(part) for part in value):
            return ""
        return self.words


class Plain(Constraint):
    """Settings of code of your own: values by name that files can hold."""

    @override
    def expected(self, value: Any) -> str:
        if not isinstance(value, Mapping):
            return "values by name, such as {'sigma': 0.1}"
        for name, setting in value.items():
            if not isinstance(name, str) or not name.isidentifier():
                return "names such as sigma"
            is_plain = isinstance(setting, bool | int | str)
            if not is_plain and not (isinstance(setting, float) and math.isfinite(setting)):
                return f"a finite number, text, True or False as {name}"
        return ""


BOOL = Instance(bool, "True or False")
TEXT = Instance(str, "a text")
TEXTS = Items(TEXT, "a sequence of texts")
SIZES = Items(Whole(1), "a sequence of integers from 1 on")
