"""How a class voted: the predictions of students, as `predict` and the lesson have written them.

The files come from students: names and choices are checked, and lines of any other form refuse the
file.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from typing import NamedTuple, TypeAlias

from matrixworld._util.files import one_line

Votes: TypeAlias = dict[str, dict[str, int]]
"""How many students made each choice, by prediction and choice, such as ``votes["4.a"]["b"]``."""
PREDICTION = re.compile(r"(0|[1-9][0-9]?)\.([a-z])")
"""The notebook and its prediction; 0 is the lesson that needs no notebook, ``docs/lesson.html``."""
PUPIL = re.compile(r"[0-9a-f]{8}|")
LONGEST_CHOICE = 60
"""The most characters of a choice."""


class Predictions(NamedTuple):
    """What a file of predictions holds."""

    choices: dict[str, str]  # the first one of each prediction
    pupil: str  # the number by which the lesson tells browsers apart; empty in a notebook's file
    edition: int  # of the course; 0 if the file names none


def count_votes(files: Iterable[tuple[str, str, bytes]]) -> tuple[Votes, dict[str, str]]:
    """Count the first choice of each student for each prediction; return why files do not count.

    A file is the student, its name, by which a reason is found, and its content. A student is known
    by name, and by the pupil in files of the lesson. Files that add nothing are refused as doubles,
    as are copies, what is damaged, and all editions but the newest one, because their letters are
    others. The lesson's own page counts by the same rule.
    """
    read: list[tuple[str, str, bytes, Predictions]] = []
    refused: dict[str, str] = {}
    for student, file, content in files:
        try:
            found = read_predictions(content)
        except ValueError as error:
            refused[file] = one_line(error)
            continue
        read.append((student, file, content, found))
    newest = max((predictions.edition for *_, predictions in read), default=0)
    votes: Votes = {}
    counted: dict[tuple[str, str], str] = {}  # student and prediction -> file
    copies: dict[bytes, str] = {}
    # A student who saves again saves more: the longest file first.
    for student, file, content, found in sorted(read, key=lambda each: -len(each[3].choices)):
        owners = [student, *([f"pupil {found.pupil}"] if found.pupil else [])]
        known = {
            name: next((counted[o, name] for o in owners if (o, name) in counted), None)
            for name in found.choices
        }
        if found.edition != newest:
            expected = f"expected edition {newest} of the course, as in other files"
            refused[file] = f"{expected}, got {found.edition or 'none'}"
        elif content in copies:
            refused[file] = f"double: the same content as {copies[content]}"
        elif known and all(known.values()):
            refused[file] = f"double: the pupil of {next(iter(known.values()))}"
        else:
            copies[content] = file
            for name, choice in found.choices.items():
                if known[name] is None:
                    counts = votes.setdefault(name, {})
                    counts[choice] = counts.get(choice, 0) + 1
                counted.update({(owner, name): file for owner in owners})
    order = sorted(votes, key=lambda name: (int(name[:-2]), name))  # of the notebooks
    return {name: dict(sorted(votes[name].items())) for name in order}, refused


def read_predictions(content: bytes) -> Predictions:
    """Return what was chosen before the experiments; ValueError if damaged."""
    found: dict[str, str] = {}
    owners: set[tuple[str, int]] = set()
    for number, line in enumerate(content.decode("utf-8", "replace").splitlines(), 1):
        try:
            entry = json.loads(line)
            name, choice = entry["prediction"], entry["choice"]
            pupil, edition = entry.get("pupil", ""), entry.get("edition", 0)
            known = PREDICTION.fullmatch(name) and one_line(choice) == choice
            known = known and PUPIL.fullmatch(pupil) and type(edition) is int
        except (ValueError, RecursionError, LookupError, TypeError, AttributeError):
            known = False
        if not (known and 0 < len(choice) <= LONGEST_CHOICE):
            raise ValueError(f"line {number}: expected a prediction and its choice")
        found.setdefault(name, choice)
        owners.add((pupil, edition))
        if len(owners) > 1:
            raise ValueError(f"line {number}: expected lines of one pupil")
    return Predictions(found, *(owners.pop() if owners else ("", 0)))
