"""Checks of answers: what is right, and what to say to typical mistakes.

A check is a function `exercise_<n>` of its chapter. It takes the answer, returns nothing if it is
right, and else raises `Mistake` with one or two sentences, which do not give the answer away. What
a student's own function raises is told with its line and its arguments: a traceback would show more
of the package than of the function.
"""

from __future__ import annotations

import linecache
import traceback
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from copy import deepcopy
from inspect import getargvalues, signature
from numbers import Real
from pathlib import Path
from sysconfig import get_path
from types import FrameType
from typing import Any

import numpy as np
from numpy.typing import NDArray

import matrixworld
from matrixworld import Action


class Mistake(Exception):  # noqa: N818  # no error: the answer is judged
    """What is wrong with an answer."""


@contextmanager
def about(part: str) -> Iterator[None]:
    """Name the part of an answer that a mistake is in."""
    try:
        yield
    except Mistake as mistake:
        told = str(mistake)
        raise Mistake(f"{part}: {told[0].lower()}{told[1:]}") from None


# ---- What an answer has to be --------------------------------------------------------------------


def number(value: Any, name: str = "a number") -> Any:
    """Return an answer that is a number; `name` is what is expected, in words."""
    if isinstance(value, bool | np.bool_) or not isinstance(value, Real):
        raise Mistake(f"Expected {name}, got {described(value)}.")
    return value


def whole(value: Any, name: str = "a whole number") -> int:
    """Return an answer that is a whole number; 202.0 and numpy.ceil are, too."""
    if number(value, name) != value // 1:
        raise Mistake(f"Expected {name}, got {described(value)}.")
    return int(value)


def one_of(value: Any, words: Sequence[str]) -> str:
    """Return an answer that is one of some words."""
    if not isinstance(value, str) or value not in words:
        raise Mistake(f"Expected one of {', '.join(map(repr, words))}, got {described(value)}.")
    return value


def choices(answer: Any, right: Mapping[str, str], words: Sequence[str]) -> list[str]:
    """Return the keys for which a dict has the wrong one of some words."""
    if not isinstance(answer, Mapping) or set(answer) != set(right):
        raise Mistake(f"Expected a dict with the keys {', '.join(map(repr, right))}.")
    return [key for key, word in right.items() if one_of(answer[key], words) != word]


def array(value: Any, name: str, *shape: Any, finite: bool = True) -> NDArray[np.float64]:
    """Return an answer that is an array of numbers; ``...`` in a shape stands for any length."""
    try:
        found = np.asarray([*value], np.float64)
    except (TypeError, ValueError):
        found = None
    if found is None or not (
        len(found.shape) == len(shape)
        and all(each in (..., length) for each, length in zip(shape, found.shape, strict=True))
    ):
        raise Mistake(f"Expected {name}, got {described(value)}.")
    if finite and not np.isfinite(found).all():
        raise Mistake(f"Expected {name}, got NaN or infinity among them.")
    return found


def actions(value: Any, count: int) -> list[Action]:
    """Return an answer of so many actions without diagonal ones."""
    name = f"a list of {count} actions such as Action.EAST"
    found = array(value, name, count)
    if not np.isin(found, range(Action.WEST + 1)).all():
        raise Mistake(f"Expected {name}, got one that is not 0 (stay) to 4 (west).")
    return [Action(int(each)) for each in found]


def function(value: Any) -> Callable[..., Any]:
    """Return an answer that is a function; a call with too few or too many arguments is told."""
    if not callable(value):
        raise Mistake(
            "Expected a function: the answer is your function itself. Write `def answer(...):` in "
            "the cell, or give the name of your function, without parentheses."
        )
    try:
        parameters = signature(value)
    except ValueError:  # some functions that are written in C
        return value

    def called(*given: Any) -> Any:
        try:
            parameters.bind(*given)
        except TypeError:
            name = getattr(value, "__name__", "answer")
            count = "1 argument" if len(given) == 1 else f"{len(given)} arguments"
            raise Mistake(f"Expected a function of {count}, got {name}{parameters}.") from None
        return value(*given)

    return called


def described(value: Any) -> str:
    """Return a value as Python writes it, shortened; an array by its shape."""
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape}"
    text = repr(value.item() if isinstance(value, np.generic) else value)
    return text if len(text) <= 100 else f"{text[:97]}..."


# ---- Comparisons ---------------------------------------------------------------------------------

Check = Callable[[Any], None]
Words = str | Callable[..., str]
"""A reply, or a function that returns it."""


def near(
    found: float,
    right: float,
    within: float,
    *,
    low: Words,
    high: Words = "",
    clues: Mapping[float, str] | None = None,
) -> None:
    """Compare a number with the right one.

    `clues` has what to say to other numbers, `low` and `high` to all below and above the right one;
    without `high`, `low` is for all.
    """
    if abs(found - right) <= within:
        return
    for wrong, text in (clues or {}).items():
        if abs(found - wrong) <= within:
            raise Mistake(text)
    raise Mistake(_said(low if found < right or not high else high, found))


def comparison(
    reference: Callable[..., Any],
    cases: Collection[tuple[Any, ...]],
    read: Callable[[Any], Any] = number,
    *,
    otherwise: Words,
    case: str = "",
    clues: Mapping[str, Callable[..., Any]] | None = None,
    within: float = 1e-9,
) -> Check:
    """Return the check of a function: its results on `cases` are those of a reference.

    A result is read by `read` first. `case` names a case with the parameters of the reference as
    fields, such as ``"For generation {g}"``. `clues` has what to say if the result is that of a
    typical wrong function; `otherwise` is for all other results, and may be a function of the
    result, the right one, and the arguments.
    """
    names = list(signature(reference).parameters)

    def check(answer: Any) -> None:
        for given in cases:
            result = function(answer)(*deepcopy(given))  # it may change its arguments
            try:
                found = read(result)
            except Mistake as mistake:
                more = " Does your function end with `return`?" if result is None else ""
                raise Mistake(f"{mistake}{more}") from None
            expected = reference(*given)
            if _same(found, expected, within):
                continue
            typical = (
                text for text, wrong in (clues or {}).items() if _same(found, wrong(*given), within)
            )
            told = next(typical, "") or _said(otherwise, found, expected, *given)
            if not case:
                raise Mistake(told)
            where = case.format(**dict(zip(names, given, strict=True)))
            short = f"{found:g}" if isinstance(found, float | np.floating) else described(found)
            raise Mistake(f"{where} your function returns {short}. {told}")

    return check


def _said(words: Words, *about: Any) -> str:
    return words if isinstance(words, str) else words(*about)


def _same(found: Any, expected: Any, within: float) -> bool:
    if isinstance(expected, float | np.floating | np.ndarray):
        return bool(np.allclose(found, expected, rtol=0.0, atol=within))
    return bool(found == expected)


# ---- Errors of a student's function --------------------------------------------------------------

LIBRARIES = (
    str(Path(__file__).parent),
    str(Path(matrixworld.__file__).parent),
    *map(get_path, ("purelib", "platlib", "stdlib")),
)
"""Where code lies that no student wrote."""


def mistake_in(answer: Any, check: Check) -> str | None:
    """Return what a check says of an answer, or what the student's own function raised."""
    try:
        check(answer)
    except Mistake as mistake:
        return str(mistake)
    except Exception as error:
        # The outermost frame of the student's code: what it calls may be a library.
        for frame, line in traceback.walk_tb(error.__traceback__):
            if not frame.f_code.co_filename.startswith(LIBRARIES):
                return _told(error, frame, line)
        raise
    return None


def _told(error: Exception, frame: FrameType, line: int) -> str:
    message = " ".join(traceback.format_exception_only(error)[-1].split())
    code = linecache.getline(frame.f_code.co_filename, line).strip()
    place = f" in its line `{code}`" if code else ""
    names, _, _, values = getargvalues(frame)  # the function may have changed them since
    given = [f"{name} = {described(values[name])}" for name in names if name in values]
    case = f", for {', '.join(given)}" if given else ""
    return f"Your function raises {message}{place}{case}."
