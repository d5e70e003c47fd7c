"""What the notebooks ask for: predictions, exercises and hints, kept results, sizes of experiments.

``exercises.toml`` has the texts of all exercises, ``chapter_<number>`` the checks of a notebook.
"""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime, timezone
from functools import cache
from importlib import import_module
from pathlib import Path
from textwrap import fill
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from course.checks import described, mistake_in

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

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

HERE = Path(__file__).parent


def texts_of(path: Path) -> dict[str, Any]:
    """Return the values of a TOML file without the comments in its texts, which name claims."""
    return tomllib.loads(re.sub(r"<!--.*?-->", "", path.read_text("utf-8")))


TEXTS = texts_of(HERE / "exercises.toml")
EDITION = TEXTS["edition"]
"""Options of predictions have the same letters within one."""
DATA = HERE / "data"
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


# ---- Exercises -----------------------------------------------------------------------------------


def check(name: str, answer: object) -> Feedback:
    """Reply to the answer of an exercise, such as ``"3.2"``; ``...`` stands for no answer yet.

    An error that the student's own function raises is told with the line and the arguments.
    """
    exercise = _find(name)
    if isinstance(exercise, Prediction):
        raise ValueError(f"name: {name!r} is a prediction; predict({name!r}, ...) takes it")
    if answer is ...:
        return Feedback(None, NO_ANSWER)
    chapter, number = name.split(".")
    module = import_module(f"course.chapter_{chapter}")
    if mistake := mistake_in(answer, getattr(module, f"exercise_{number}")):
        return Feedback(False, f"✗ Not yet. {mistake}  (hint({name!r}) gives a hint.)")
    return Feedback(True, f"✓ Right. {exercise.explanation}")


_given: dict[str, int] = {}
"""How many hints of each exercise were given."""


def hint(name: str) -> Feedback:
    """Give the next hint of an exercise; after the last one, the last one again."""
    exercise = _find(name)
    if isinstance(exercise, Prediction):
        return Feedback(None, "There is no hint: any prediction is a good one.")
    _given[name] = number = min(_given.get(name, 0) + 1, len(exercise.hints))
    return Feedback(None, f"Hint {number} of {len(exercise.hints)}: {exercise.hints[number - 1]}")


# ---- Predictions ---------------------------------------------------------------------------------


def predict(name: str, choice: object) -> None:
    """Write the choice of a prediction, such as ``"3.b"``, down with its time.

    It is the first line of the cell with the experiment: without a choice, `UnansweredError` stops
    the cell. `PREDICTIONS` in the working directory gets a line, unless the last choice was the
    same. ValueError if the file is damaged, or of another edition of the course.
    """
    prediction = _prediction(name)
    if choice is ...:
        raise UnansweredError(NO_PREDICTION)
    if not isinstance(choice, str) or choice not in prediction.options:
        expected = ", ".join(repr(option) for option in prediction.options)
        raise UnansweredError(f"Expected one of {expected}, got {described(choice)}.")
    if _predicted(name) != choice:
        time = datetime.now(timezone.utc).isoformat(timespec="seconds")
        line = {"prediction": name, "choice": choice, "time": time, "edition": EDITION}
        with PREDICTIONS.open("a", encoding="utf-8") as file:
            file.write(json.dumps(line) + "\n")


def outcome(name: str) -> Feedback:
    """Compare the last choice of a prediction with what the experiment showed, and say why."""
    prediction, choice = _prediction(name), _predicted(name)
    if choice is None:
        raise UnansweredError(NO_PREDICTION)
    right = choice == prediction.outcome
    told = f"You predicted: {choice}. The outcome: {prediction.outcome}."
    told = f"✓ As you predicted: {choice}." if right else told
    return Feedback(right, f"{told} {prediction.explanation}")


def _prediction(name: str) -> Prediction:
    found = _find(name)
    if isinstance(found, Prediction):
        return found
    raise ValueError(f"name: expected a prediction such as '3.b', got the exercise {name!r}")


def _predicted(name: str) -> str | None:
    """Return the last choice that was written down."""
    lines = PREDICTIONS.read_text("utf-8").splitlines() if PREDICTIONS.exists() else []
    try:
        entries = [json.loads(line) for line in lines]
        choices = {each["prediction"]: each["choice"] for each in entries}
    except (ValueError, TypeError, KeyError) as error:
        raise ValueError(f"{PREDICTIONS}: expected lines that predict has written") from error
    for edition in {each.get("edition", "none") for each in entries} - {EDITION}:
        raise ValueError(
            f"{PREDICTIONS}: expected edition {EDITION} of the course, got {edition}, in which "
            f"other letters stand for the options. Move the file away, and predict again"
        )
    return choices.get(name)


# ---- Texts and numbers ---------------------------------------------------------------------------


@cache
def exercises(chapter: int) -> Mapping[str, Exercise | Prediction]:
    """Return the exercises and predictions of a notebook, from 1, by name, in their order."""
    found: dict[str, Exercise | Prediction] = {}
    for name, fields in TEXTS.items():
        if name.startswith(f"{chapter}."):
            joined = {field: _joined(text) for field, text in fields.items()}
            found[name] = Prediction(**joined) if "outcome" in joined else Exercise(**joined)
    return found


def _joined(text: str | list[str]) -> Any:
    """Return a text, or several, in one line each; those of the file are of any length."""
    return " ".join(text.split()) if isinstance(text, str) else tuple(map(_joined, text))


def _find(name: str) -> Exercise | Prediction:
    for table in map(exercises, CHAPTERS):
        if name in table:
            return table[name]
    raise ValueError(f"name: expected text such as '3.2', got {described(name)}")


def kept(name: str) -> dict[str, NDArray[Any]]:
    """Return arrays that were computed before, by name; `name` is that of a file in `DATA`."""
    names = sorted(path.stem for path in DATA.glob("*.npz"))
    if name not in names:
        raise ValueError(f"name: expected one of {', '.join(names)}, got {described(name)}")
    with np.load(DATA / f"{name}.npz") as arrays:
        return dict(arrays)


def size(full: T, quick: T) -> T:
    """Return `full`, or `quick` where notebooks only have to prove that they run (`QUICK`)."""
    return quick if os.environ.get(QUICK) == "1" else full
