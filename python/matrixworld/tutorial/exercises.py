"""Exercises of the course: an answer is checked at once, and hints are given one after the other.

Each notebook has a module ``chapter_<number>`` with a table ``EXERCISES``. A key such as ``"3.2"``
names the second exercise of the third notebook, ``"3.b"`` its second prediction.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from textwrap import fill
from typing import Any

from matrixworld._util.checks import check_instance

CHAPTERS = range(1, 10)
"""Numbers of the notebooks."""

WIDEST = 88
"""Characters in a line of a reply: exported notebooks break longer lines inside words."""

NO_FUNCTION = "The answer is your function itself: give its name, without parentheses."
"""Reply where the answer has to be a function that was written in the cell."""
NO_DEFINITION = "Expected a function: remove the dots, and write `def answer(...):` in the cell."
"""Reply where the cell itself has to define it."""

NO_ANSWER = "No answer yet. Replace the dots with your answer, run the cell, and check again."
NO_PREDICTION = (
    "No prediction yet. Replace the dots in the cell above and run both cells again. Those who "
    "predict first see more."
)


@dataclass(frozen=True)
class Exercise:
    """A question whose answer is a value or a function of the student's own.

    Parameters
    ----------
    mistake : callable
        Takes the answer and returns what is wrong with it in one or two sentences, or None if it is
        right. It does not give the answer away. What a student's own function raises is not caught:
        the traceback tells more.
    explanation : str
        Why the right answer is right.
    hints : tuple of str
        Hints, from the smallest to the one that nearly tells it.
    """

    mistake: Callable[[Any], str | None]
    explanation: str
    hints: tuple[str, ...]


@dataclass(frozen=True)
class Prediction:
    """A question that is answered before the experiment.

    Parameters
    ----------
    options : tuple of str
        The answers to choose from.
    outcome : str
        The option that the experiment shows.
    explanation : str
        Why it happens.
    """

    options: tuple[str, ...]
    outcome: str
    explanation: str

    def __post_init__(self) -> None:
        if self.outcome not in self.options:
            raise ValueError(f"outcome: expected one of {self.options}, got {self.outcome!r}")


@dataclass(frozen=True, repr=False)
class Feedback:
    """The reply to an answer; a notebook shows it as the last expression of a cell.

    Parameters
    ----------
    right : bool or None
        Whether the answer is right; None if there is no answer yet.
    text : str
        The reply in words.
    """

    right: bool | None
    text: str

    def __repr__(self) -> str:
        return fill(self.text, WIDEST)


@dataclass(frozen=True, repr=False)
class Hint:
    """A hint; a notebook shows it as the last expression of a cell.

    Parameters
    ----------
    text : str
        The hint in words.
    """

    text: str

    def __repr__(self) -> str:
        return fill(self.text, WIDEST)


def check(name: str, answer: object) -> Feedback:
    """Reply to an answer.

    Parameters
    ----------
    name : str
        Name of the exercise or prediction, for example ``"3.2"`` or ``"3.b"``.
    answer : object
        The student's answer; ``...`` stands for no answer yet.

    Returns
    -------
    Feedback
        The reply.

    Raises
    ------
    ValueError
        If there is no exercise of this name.
    """
    exercise = _find(name)
    if isinstance(exercise, Prediction):
        return _compare(exercise, answer)
    if answer is ...:
        return Feedback(None, NO_ANSWER)
    mistake = exercise.mistake(answer)
    if mistake is not None:
        more = f"  (hint({name!r}) gives a hint.)" if exercise.hints else ""
        return Feedback(False, f"✗ Not yet. {mistake}{more}")
    return Feedback(True, f"✓ Right. {exercise.explanation}")


def _compare(prediction: Prediction, answer: object) -> Feedback:
    if answer is ...:
        return Feedback(None, NO_PREDICTION)
    if answer not in prediction.options:
        expected = ", ".join(repr(option) for option in prediction.options)
        return Feedback(None, f"Expected one of {expected}, got {answer!r}.")
    if answer == prediction.outcome:
        return Feedback(True, f"✓ As you predicted: {answer}. {prediction.explanation}")
    return Feedback(
        False,
        f"You predicted: {answer}. The outcome: {prediction.outcome}. {prediction.explanation}",
    )


_given: dict[str, int] = {}
"""How many hints of each exercise were given."""


def hint(name: str) -> Hint:
    """Give the next hint of an exercise; after the last one, the last one again.

    Parameters
    ----------
    name : str
        Name of the exercise, for example ``"3.2"``.

    Returns
    -------
    Hint
        The hint.

    Raises
    ------
    ValueError
        If there is no exercise of this name.
    """
    exercise = _find(name)
    hints = exercise.hints if isinstance(exercise, Exercise) else ()
    if not hints:
        return Hint("There is no hint: any prediction is a good one.")
    number = min(_given.get(name, 0), len(hints) - 1)
    _given[name] = number + 1
    return Hint(f"Hint {number + 1} of {len(hints)}: {hints[number]}")


def exercises(chapter: int) -> Mapping[str, Exercise | Prediction]:
    """Return the exercises and predictions of a notebook by name.

    Parameters
    ----------
    chapter : int
        Number of the notebook, from 1.

    Returns
    -------
    mapping of str to Exercise or Prediction
        In the order in which they appear.

    Raises
    ------
    ValueError
        If there is no notebook of this number.
    """
    if chapter not in CHAPTERS:
        raise ValueError(f"chapter: expected {CHAPTERS[0]} to {CHAPTERS[-1]}, got {chapter!r}")
    table: Mapping[str, Exercise | Prediction] = import_module(
        f"matrixworld.tutorial.chapter_{chapter}"
    ).EXERCISES
    return table


def _find(name: str) -> Exercise | Prediction:
    check_instance("name", name, str)
    chapter = name.partition(".")[0]
    if chapter not in map(str, CHAPTERS):
        raise ValueError(f"name: expected a name such as '3.2', got {name!r}")
    table = exercises(int(chapter))
    if name not in table:
        raise ValueError(f"name: expected one of {', '.join(table)}, got {name!r}")
    return table[name]
