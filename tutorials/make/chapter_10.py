"""Make the kept numbers of notebook 10 on races beside perfect play.

    python tutorials/make/chapter_10.py

Reads ``evolution/results/ground_truth/races.json``, which
``evolution/validation/ground_truth.py`` makes, and writes ``tutorials/course/data/chapter_10.npz``
in a second. Run it again when these results change, and then the notebook (``python
tutorials/run.py 10``).
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from matrixworld._util.files import save_arrays

DATA = Path(__file__).parents[1] / "course" / "data"
RACES = Path(__file__).parents[2] / "evolution" / "results" / "ground_truth" / "races.json"
MEASURES = ("current", "ancestors", "all", "worst", "nash", "elo", "held_out")


def derived() -> dict[str, np.ndarray]:
    """Return what each generation guarantees and scores: (schedules, seeds, generations)."""
    races = json.loads(RACES.read_text("utf-8"))
    schedules = list(dict.fromkeys(race["schedule"] for race in races))
    arrays = {"schedules": np.array(schedules), "value": np.array(races[0]["value"])}
    for team in ("pursuer", "evader"):
        for name in ("truth", *MEASURES):
            arrays[f"{team}: {name}"] = np.array(
                [
                    [_numbers(race, team, name) for race in races if race["schedule"] == schedule]
                    for schedule in schedules
                ]
            )
    return arrays


def _numbers(race: dict, team: str, name: str) -> list[float]:
    return race["truth"][team] if name == "truth" else race["measures"][team][name]


if __name__ == "__main__":
    save_arrays(DATA / "chapter_10.npz", derived())
