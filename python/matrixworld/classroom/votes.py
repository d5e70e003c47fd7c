"""How a class voted: the predictions of the course that students hand in.

Lines are those that `predict` of the course writes. Files come from strangers: names and
choices are checked, and lines of any other form refuse the file.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from typing import Any, TypeAlias

from matrixworld._util.files import one_line
from matrixworld.classroom.submissions import LONGEST_NAME, Refusal, Submission

Votes: TypeAlias = dict[str, dict[str, int]]
"""How many students made each choice, by prediction and choice, such as ``votes["4.a"]["b"]``."""

NAME = re.compile(r"(0|[1-9][0-9]?)\.([a-z])")
"""The notebook and its prediction; 0 is the lesson that needs no notebook, ``docs/lesson.html``."""


def count_votes(files: Iterable[Submission]) -> tuple[Votes, list[Refusal]]:
    """Count the first choice of each student for each prediction; what is damaged is refused."""
    votes: Votes = {}
    refusals: list[Refusal] = []
    voted: set[tuple[str, str]] = set()  # a student may hand in several files
    for file in files:
        choices, refused = _choices_of(file)
        refusals += refused
        for name, choice in choices.items():
            counts = votes.setdefault(name, {})
            if (file.name, name) not in voted:
                counts[choice] = counts.get(choice, 0) + 1
                voted.add((file.name, name))
    return {name: dict(sorted(votes[name].items())) for name in sorted(votes, key=_place)}, refusals


def _choices_of(file: Submission) -> tuple[dict[str, str], list[Refusal]]:
    try:
        return first_choices(file.content), []
    except ValueError as error:
        return {}, [Refusal(file.name, file.file, one_line(error))]


def first_choices(content: bytes) -> dict[str, str]:
    """Return what was chosen before the experiment, by prediction; ValueError if damaged."""
    found: dict[str, str] = {}
    for number, line in enumerate(content.decode("utf-8", "replace").splitlines(), 1):
        entry = _parsed(line)
        name, choice = (entry.get(key) for key in ("prediction", "choice"))
        if not (isinstance(name, str) and NAME.fullmatch(name) and _is_choice(choice)):
            raise ValueError(f"line {number}: expected a prediction and its choice")
        found.setdefault(name, str(choice))
    return found


def _parsed(line: str) -> dict[str, Any]:
    """Return an object of JSON; an empty one where a line is something else."""
    try:
        entry = json.loads(line)
    except (ValueError, RecursionError):
        return {}
    return entry if isinstance(entry, dict) else {}


def _is_choice(value: Any) -> bool:
    return isinstance(value, str) and one_line(value) == value and 0 < len(value) <= LONGEST_NAME


def _place(name: str) -> tuple[int, str]:
    chapter, _, letter = name.partition(".")
    return int(chapter), letter
