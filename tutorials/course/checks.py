"""Checks of answers: what is right, and what to say to typical mistakes.

A check takes an answer and returns what is wrong with it in one or two sentences, or None if it is
right. It does not give the answer away. What a student's own function raises is told with its line
and its arguments: a traceback would show more of the package than of the function.
"""

from __future__ import annotations

import linecache
import traceback
from collections.abc import Callable, Iterable, Mapping, Sequence
from copy import copy
from inspect import getargvalues, signature
from numbers import Real
from operator import index
from pathlib import Path
from sysconfig import get_path
from types import FrameType
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import shown
from matrixworld.world.rules import Action

Check: TypeAlias = Callable[[Any], str | None]
Words: TypeAlias = str | Callable[..., str]
"""A reply, or a function that returns it."""

NO_FUNCTION = (
    "Expected a function: the answer is your function itself. Write `def answer(...):` in the "
    "cell, or give the name of your function, without parentheses."
)


# ---- Kinds of answers ----------------------------------------------------------------------------


class FormError(ValueError):
    """An answer is not of the expected kind; the text says what came, as in "got 3 of them"."""


class Kind(NamedTuple):
    """What an answer has to be: in words, and as a function that reads it or raises FormError."""

    name: str
    read: Callable[[Any], Any]


def _number(value: Any) -> Any:
    if isinstance(value, bool | np.bool_) or not isinstance(value, Real):
        raise FormError(f"got {_described(value)}")
    return value


def _whole(value: Any) -> int:
    if _number(value) != value // 1:  # 202.0 and numpy.ceil are whole, too
        raise FormError(f"got {_described(value)}")
    return int(value)


NUMBER = Kind("a number", _number)
WHOLE = Kind("a whole number", _whole)


def one_of(words: Sequence[str]) -> Kind:
    """Return the kind of one of some words."""

    def read(value: Any) -> str:
        if not isinstance(value, str) or value not in words:
            raise FormError(f"got {_described(value)}")
        return value

    return Kind(f"one of {', '.join(map(repr, words))}", read)


def numbers(name: str, count: int) -> Kind:
    """Return the kind of so many finite numbers."""
    return _several(name, count, _finite, "got an entry that is no number")


def actions(count: int) -> Kind:
    """Return the kind of so many actions without diagonal ones."""

    def read(value: Any) -> Action:
        if not Action.STAY <= index(value) <= Action.WEST:
            raise FormError("got one that is not 0 (stay) to 4 (west)")
        return Action(index(value))

    name = f"a list of {count} actions such as Action.EAST"
    return _several(name, count, read, "got an entry that is no action")


def _finite(value: Any) -> float:
    number = float(value)
    if not np.isfinite(number):
        raise ValueError
    return number


def _several(name: str, count: int, read: Callable[[Any], Any], wrong_entry: str) -> Kind:
    def read_all(value: Any) -> list[Any]:
        if isinstance(value, str) or not isinstance(value, Iterable):
            raise FormError(f"got {type(value).__name__}")
        given = list(value)
        if len(given) != count:
            raise FormError(f"got {len(given)} of them")
        try:
            return [read(each) for each in given]
        except FormError:
            raise
        except (TypeError, ValueError):
            raise FormError(wrong_entry) from None

    return Kind(name, read_all)


def array(name: str, *shape: int) -> Kind:
    """Return the kind of an array of numbers."""

    def read(value: Any) -> NDArray[np.float64]:
        try:
            found = np.asarray(value, np.float64)
        except (TypeError, ValueError):
            raise FormError(f"got {_described(value)}") from None
        if found.shape != shape:
            raise FormError(f"got the shape {found.shape}")
        return found

    return Kind(name, read)


def _described(value: Any) -> str:
    return f"an array of shape {value.shape}" if isinstance(value, np.ndarray) else shown(value)


# ---- Checks --------------------------------------------------------------------------------------


def value(kind: Kind, judge: Check) -> Check:
    """Return the check of a value of a kind, which `judge` gets as it was read."""

    def mistake(answer: Any) -> str | None:
        try:
            found = kind.read(answer)
        except FormError as error:
            return f"Expected {kind.name}, {error}."
        return judge(found)

    return mistake


def number(
    right: float,
    within: float,
    *,
    low: Words,
    high: Words,
    clues: Mapping[float, str] | None = None,
    kind: Kind = NUMBER,
) -> Check:
    """Return the check of a number near another one.

    `clues` has what to say to other numbers, `low` and `high` to all below and above the right one.
    """

    def judge(found: float) -> str | None:
        if abs(found - right) <= within:
            return None
        near = (text for wrong, text in (clues or {}).items() if abs(found - wrong) <= within)
        return next(near, "") or _said(low if found < right else high, found)

    return value(kind, judge)


def choices(
    right: Mapping[str, str], words: Sequence[str], clue: Callable[[list[str]], str]
) -> Check:
    """Return the check of a dict with one of the words for each key.

    `clue` gets the keys whose words are wrong.
    """
    each = one_of(words)

    def mistake(answer: Any) -> str | None:
        if not isinstance(answer, Mapping) or set(answer) != set(right):
            return f"Expected a dict with the keys {', '.join(map(repr, right))}."
        for word in answer.values():
            unknown = value(each, lambda known: None)(word)
            if unknown:
                return unknown
        wrong = [key for key, word in right.items() if answer[key] != word]
        return clue(wrong) if wrong else None

    return mistake


def tried(judge: Check) -> Check:
    """Return the check of a function that `judge` tries."""
    return lambda answer: judge(answer) if callable(answer) else NO_FUNCTION


def function(
    kind: Kind,
    reference: Callable[..., Any],
    cases: Callable[[], Iterable[tuple[Any, ...]]],
    *,
    otherwise: Words,
    case: str = "",
    clues: Mapping[str, Callable[..., Any]] | None = None,
    within: float = 1e-9,
) -> Check:
    """Return the check of a function that gives what `reference` gives in all cases.

    `case` begins the reply, and ``{name}`` in it stands for an argument of `reference`. `clues` has
    what to say where the result is that of a typical wrong function; `otherwise` is for all other
    results, and may be a function of the result, the right one, and the arguments.
    """
    names, wrongs = list(signature(reference).parameters), list((clues or {}).items())

    def mistake_in(given: tuple[Any, ...], answer: Callable[..., Any]) -> str | None:
        result = answer(*(copy(each) for each in given))  # it may change its arguments
        try:
            found = kind.read(result)
        except FormError as error:
            more = " Does your function end with `return`?" if result is None else ""
            return f"Expected {kind.name}, {error}.{more}"
        expected = reference(*given)
        if _same(found, expected, within):
            return None
        near = (text for text, wrong in wrongs if _same(found, wrong(*given), within))
        told = next(near, "") or _said(otherwise, found, expected, *given)
        where = case.format(**dict(zip(names, given, strict=True)))
        short = f"{found:.6g}" if isinstance(found, float | np.floating) else shown(found)
        return f"{where} your function returns {short}. {told}" if case else told

    def judge(answer: Callable[..., Any]) -> str | None:
        mistakes = (mistake_in(given, answer) for given in cases())
        return next(filter(None, mistakes), None)

    return tried(judge)


def _said(words: Words, *about: Any) -> str:
    return words if isinstance(words, str) else words(*about)


def _same(found: Any, expected: Any, within: float) -> bool:
    if isinstance(expected, float | np.floating | np.ndarray):
        return bool(np.allclose(found, expected, rtol=0.0, atol=within))
    return bool(found == expected)


# ---- Errors of a student's function --------------------------------------------------------------

LIBRARIES = (str(Path(__file__).parents[1]), *map(get_path, ("purelib", "platlib", "stdlib")))
"""Where code lies that no student wrote."""


def mistake_of(check: Check, answer: Any) -> str | None:
    """Return what a check says, or what the student's own function raised, and where."""
    try:
        return check(answer)
    except Exception as error:
        # The outermost frame of the student's code: what it calls may be a library.
        walked = traceback.walk_tb(error.__traceback__)
        found = next((each for each in walked if _is_students(each[0])), None)
        if found is None:
            raise
        frame, line = found
        code = linecache.getline(frame.f_code.co_filename, line).strip()
        place = f" in its line `{code}`" if code else ""
        return f"Your function raises {_message(error)}{place}{_arguments(frame)}."


def _is_students(frame: FrameType) -> bool:
    return not frame.f_code.co_filename.startswith(LIBRARIES)


def _message(error: Exception) -> str:
    return " ".join(traceback.format_exception_only(error)[-1].split())


def _arguments(frame: FrameType) -> str:
    """Return the arguments of a function, which it may have changed since."""
    names, _, _, values = getargvalues(frame)
    told = [f"{name} = {_described(values[name])}" for name in names if name in values]
    return f", for {', '.join(told)}" if told else ""
