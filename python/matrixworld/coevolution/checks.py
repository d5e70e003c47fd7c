"""Checks of settings: each says what was expected and what came."""

from __future__ import annotations

from collections.abc import Iterable
from numbers import Integral, Real
from typing import Any


def check_integer(name: str, value: Any, *, least: int) -> None:
    """TypeError unless `value` is an integer, ValueError if it is below `least`."""
    if isinstance(value, bool) or not isinstance(value, Integral):
        raise TypeError(f"{name}: expected an integer, got {value!r}")
    if value < least:
        raise ValueError(f"{name}: expected at least {least}, got {value}")


def check_number(
    name: str, value: Any, *, least: float, most: float = float("inf"), positive: bool = False
) -> None:
    """TypeError unless `value` is a number, ValueError outside [least, most] or not finite."""
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name}: expected a number, got {value!r}")
    number = float(value)
    if not least <= number <= most or number == float("inf") or (positive and number == 0.0):
        above = "above" if positive else "at least"
        upper = "" if most == float("inf") else f" and at most {most:g}"
        raise ValueError(f"{name}: expected a number {above} {least:g}{upper}, got {value}")


def check_flag(name: str, value: Any) -> None:
    """TypeError unless `value` is True or False."""
    if not isinstance(value, bool):
        raise TypeError(f"{name}: expected True or False, got {value!r}")


def check_choice(name: str, value: Any, choices: Iterable[str]) -> None:
    """ValueError unless `value` is one of `choices`."""
    known = list(choices)
    if value not in known:
        raise ValueError(f"{name}: expected one of {', '.join(known)}, got {value!r}")
