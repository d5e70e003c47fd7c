"""The lesson that needs no installation: the texts of ``lesson.toml``, and three real races.

``make_pages.py`` writes the page. It keeps its races: a page of the present texts and scripts takes
them from the one that it replaces.
"""

from __future__ import annotations

import base64
import json
import re
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from course.figures import CROSSINGS, may_go
from course.questions import TEXTS as COURSE
from course.questions import texts_of
from matrixworld.coevolution.saved_run import open_runs
from matrixworld.coevolution.types import Payoff
from matrixworld.explorer.evolve_page import evolve_data
from matrixworld.explorer.page import render_page, write_page
from matrixworld.explorer.playground import page_data
from matrixworld.explorer.runs_page import findings, runs_data
from matrixworld.version import __version__
from matrixworld.world.arrays import MOVES

PAGE = Path(__file__).with_name("lesson.html")
LESSON = texts_of(Path(__file__).with_name("lesson.toml"))
MOST_BYTES = 2 * 2**20
"""Genomes of the page, in bytes, which holds every fifth generation of default races."""
VERDICTS = {"present": "a", "absent": "b", "cannot tell": "c"}
"""Options of prediction 0.g: the verdict on the arms race in the last half of the first race."""


class Races(NamedTuple):
    """Races as plain values, in the order of the lesson, and the genomes that they name."""

    runs: list[dict[str, Any]]
    genomes: dict[str, bytes]


def races_of_job(job: Path) -> Races:
    """Return the races of a finished job; ValueError if one that the lesson shows is missing."""
    found = {run.settings.schedule.name: run for run in open_runs(job)}
    if missing := set(LESSON["races"]) - set(found):
        raise ValueError(f"{job}: expected a finished race of {', '.join(sorted(missing))}")
    names = zip("ABC", LESSON["races"], strict=True)
    runs = [(f"Race {letter}", found[name]) for letter, name in names]
    return Races(*runs_data(runs, most=MOST_BYTES))


def races_of_page(page: str) -> Races:
    """Return the races that a page holds, judged by the rules of today."""
    scripts = dict(re.findall(r'<script type="[^"]+" id="([\w-]+)">(.*?)</script>', page))
    runs = json.loads(scripts.pop("data"))["runs"]
    for run in runs:
        scores = np.array(run["payoff"]["capture_rates"], np.float32)
        run["findings"] = findings(Payoff(scores))
    return Races(runs, {name: base64.b64decode(each) for name, each in scripts.items()})


def write_lesson(job: Path | None) -> None:
    """Write the page with the races of a job, or those that it has."""
    races = races_of_job(job) if job else races_of_page(PAGE.read_text(encoding="utf-8"))
    write_page(PAGE, lesson_page(races))


def lesson_page(races: Races) -> str:
    """Return the page as HTML."""
    sections = [
        {**section, "parts": [_filled(part, races) for part in section["parts"]]}
        for section in LESSON["sections"]
    ]
    data = {
        "version": __version__,
        "edition": COURSE["edition"],
        **{name: " ".join(LESSON[name].split()) for name in ("title", "lead")},
        "sections": sections,
        "runs": races.runs,
        "playground": page_data(),
        "evolve": evolve_data(),
    }
    title = f"{LESSON['title']} - matrixworld"
    return render_page("lesson", title, data, races.genomes, works=True)


def _filled(part: dict[str, Any], races: Races) -> dict[str, Any]:
    """Return a part with what course, races and engine say of it."""
    if part.get("widget") == "right-of-way":
        return {**part, "crossings": crossings()}
    name = part.get("predict") or part.get("exercise")
    if name is None:
        return part
    if name == "0.g":
        (verdict,) = (
            row[1] for row in races.runs[0]["findings"]["table"] if row[0::3] == _ARMS_RACE
        )
        return {**part, "outcome": VERDICTS[verdict]}
    if name.startswith("0."):
        return part
    known = {
        field: " ".join(COURSE[name][field].split())
        for field in ("explanation", "outcome")
        if field in COURSE[name]
    }
    return {**known, **part}


def crossings() -> list[dict[str, Any]]:
    """Return the panels of the figure `right_of_way`: pursuers' moves, and whether each may go."""
    return [
        {
            "title": title,
            "text": text,
            "ways": [
                [*MOVES[move].tolist(), goes]
                for move, goes in zip(moves, may_go(moves), strict=True)
            ],
        }
        for title, text, moves in CROSSINGS
    ]


_ARMS_RACE = ["arms race", "whole race"]
"""Condition and window of the row of the judgement that prediction 0.g asks for."""
