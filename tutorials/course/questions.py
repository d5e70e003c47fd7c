"""What the notebooks ask for: predictions, exercises and hints, kept results, sizes of experiments.

``exercises.toml`` has the texts of all exercises, ``chapter_<number>`` the checks of a notebook.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime, timezone
from functools import cache
from importlib import import_module
from pathlib import Path
from textwrap import fill
from typing import Any, TypeVar

from course.checks import Check, mistake_of
from matrixworld._util.checks import shown
from matrixworld._util.files import Arrays, DamagedFileError, load_arrays, load_toml

CHAPTERS = range(1, 11)
"""Numbers of the notebooks."""
WIDEST = 88
"""Characters in a line of a reply: exported notebooks break longer lines inside words."""
NO_ANSWER = "No answer yet. Replace the dots with your answer, run the cell, and check again."
NO_PREDICTION = (
    "No prediction yet: the experiment waits for yours. Write your choice in place of the dots, "
    "and run the cell again."
)
PREDICTIONS = Path("predictions.jsonl")
"""Choices of predictions with their times, a line each; it lies beside the notebook."""

TEXTS = Path(__file__).with_name("exercises.toml")
DATA = Path(__file__).parent / "data"
"""Results that take longer than a notebook should; scripts in ``tutorials/make`` make them anew."""
QUICK = "MATRIXWORLD_QUICK"
"""Environment variable: if it is 1, notebooks compute at the smaller size."""
BANNER = f"""\
################  {QUICK}=1: experiments are small.  ################
The text of this notebook does not apply to the numbers and figures that follow.
"""

T = TypeVar("T")


@dataclass(frozen=True)
class Exercise:
    """A question whose answer is a value or a function of the student's own."""

    mistake: Check
    explanation: str  # why the right answer is right
    hints: tuple[str, ...]  # from the smallest to the one that nearly tells it


@dataclass(frozen=True)
class Prediction:
    """A question that is answered before the experiment."""

    outcome: str  # the option that the experiment shows
    explanation: str  # why it happens
    options: tuple[str, ...] = ("a", "b", "c")


@dataclass(frozen=True, repr=False)
class Feedback:
    """The reply to an answer, or a hint; a notebook shows it as the last expression of a cell."""

    right: bool | None  # None if there is no answer
    text: str

    def __repr__(self) -> str:
        return fill(self.text, WIDEST)


class UnansweredError(Exception):
    """A question is still open; no cell below it is run, and a notebook shows the text alone."""

    def _render_traceback_(self) -> list[str]:
        return [fill(str(self), WIDEST)]


def check(name: str, answer: object) -> Feedback:
    """Reply to the answer of an exercise.

    Parameters
    ----------
    name : str
        Name of the exercise, for example ``"3.2"``.
    answer : object
        The student's answer; ``...`` stands for no answer yet. An error that the student's own
        function raises is told with the line and the arguments.

    Raises
    ------
    TypeError
        If the name is no text.
    ValueError
        If there is no exercise of this name.
    """
    exercise = _find(name)
    if isinstance(exercise, Prediction):
        raise ValueError(f"name: {name!r} is a prediction; predict({name!r}, ...) takes it")
    if answer is ...:
        return Feedback(None, NO_ANSWER)
    mistake = mistake_of(exercise.mistake, answer)
    if mistake is not None:
        return Feedback(False, f"✗ Not yet. {mistake}  (hint({name!r}) gives a hint.)")
    return Feedback(True, f"✓ Right. {exercise.explanation}")


def predict(name: str, choice: object) -> None:
    """Write a prediction down, with its time, before the experiment is run.

    It is the first line of the cell with the experiment, which is not run without a choice.
    `PREDICTIONS` in the working directory gets a line, unless the last choice was the same.

    Parameters
    ----------
    name : str
        Name of the prediction, for example ``"3.b"``.
    choice : object
        One of its options; ``...`` stands for no choice yet.

    Raises
    ------
    UnansweredError
        If the choice is none of the options.
    TypeError
        If the name is no text.
    ValueError
        If there is no prediction of this name, or the file is damaged.
    """
    prediction = _prediction(name)
    if choice is ...:
        raise UnansweredError(NO_PREDICTION)
    if not isinstance(choice, str) or choice not in prediction.options:
        expected = ", ".join(repr(option) for option in prediction.options)
        raise UnansweredError(f"Expected one of {expected}, got {shown(choice)}.")
    if _predicted(name) != choice:
        time = datetime.now(timezone.utc).isoformat(timespec="seconds")
        with PREDICTIONS.open("a", encoding="utf-8") as file:
            file.write(json.dumps({"prediction": name, "choice": choice, "time": time}) + "\n")


def outcome(name: str) -> Feedback:
    """Compare the last choice of a prediction with what the experiment showed, and say why.

    Parameters
    ----------
    name : str
        Name of the prediction, as in `predict`, which raises the same errors.
    """
    prediction, choice = _prediction(name), _predicted(name)
    if choice is None:
        raise UnansweredError(NO_PREDICTION)
    if choice == prediction.outcome:
        return Feedback(True, f"✓ As you predicted: {choice}. {prediction.explanation}")
    return Feedback(
        False,
        f"You predicted: {choice}. The outcome: {prediction.outcome}. {prediction.explanation}",
    )


def _prediction(name: str) -> Prediction:
    found = _find(name)
    if isinstance(found, Prediction):
        return found
    raise ValueError(f"name: expected a prediction such as '3.b', got the exercise {name!r}")


def _predicted(name: str) -> str | None:
    """Return the last choice that was written down; ValueError if the file is damaged."""
    lines = PREDICTIONS.read_text("utf-8").splitlines() if PREDICTIONS.exists() else []
    try:
        choices = {each["prediction"]: each["choice"] for each in map(json.loads, lines)}
    except (ValueError, TypeError, KeyError) as error:
        raise DamagedFileError(PREDICTIONS, "expected lines that predict has written") from error
    return choices.get(name)


_given: dict[str, int] = {}
"""How many hints of each exercise were given."""


def hint(name: str) -> Feedback:
    """Give the next hint of an exercise; after the last one, the last one again.

    Parameters
    ----------
    name : str
        Name of the exercise; errors are raised as in `check`.
    """
    exercise = _find(name)
    if isinstance(exercise, Prediction):
        return Feedback(None, "There is no hint: any prediction is a good one.")
    number = min(_given.get(name, 0), len(exercise.hints) - 1)
    _given[name] = number + 1
    return Feedback(None, f"Hint {number + 1} of {len(exercise.hints)}: {exercise.hints[number]}")


def exercises(chapter: int) -> Mapping[str, Exercise | Prediction]:
    """Return the exercises and predictions of a notebook, from 1, by name, in their order."""
    checks: Mapping[str, Check] = import_module(f"course.chapter_{chapter}").CHECKS
    return {
        name: Prediction(**text) if "outcome" in text else Exercise(checks[name], **text)
        for name, text in _texts().items()
        if name.startswith(f"{chapter}.")
    }


@cache
def _texts() -> dict[str, dict[str, Any]]:
    """Return the texts of all exercises, whose lines are of any length."""
    return {
        name: {field: _joined(text) for field, text in texts.items()}
        for name, texts in load_toml(TEXTS).items()
    }


def _joined(text: str | list[str]) -> str | tuple[str, ...]:
    if isinstance(text, list):
        return tuple(" ".join(each.split()) for each in text)
    return " ".join(text.split())


def _find(name: str) -> Exercise | Prediction:
    if not isinstance(name, str):
        raise TypeError(f'name: expected text in quotes such as "3.2", got {shown(name)}')
    chapter = name.partition(".")[0]
    if chapter not in map(str, CHAPTERS):
        raise ValueError(f"name: expected a name such as '3.2', got {name!r}")
    table = exercises(int(chapter))
    if name not in table:
        raise ValueError(f"name: expected one of {', '.join(table)}, got {name!r}")
    return table[name]


def kept(name: str) -> Arrays:
    """Return arrays that were computed before, by name.

    Parameters
    ----------
    name : str
        Name of the file without its ending; ValueError if nothing is kept under this name.
    """
    names = sorted(path.stem for path in DATA.glob("*.npz"))
    if name not in names:
        raise ValueError(f"name: expected one of {', '.join(names)}, got {shown(name)}")
    return load_arrays(DATA / f"{name}.npz")


def size(full: T, quick: T) -> T:
    """Return the size of an experiment: smaller where notebooks only have to prove that they run.

    Parameters
    ----------
    full : object
        The value for a reader.
    quick : object
        The value if the environment variable ``MATRIXWORLD_QUICK`` is 1.
    """
    return quick if os.environ.get(QUICK) == "1" else full
