"""Make the kept numbers of notebook 10 on races beside perfect play.

    python tutorials/make/chapter_10.py

Plays ten seeds of five schedules in the world of ``evolution/small_world.toml``, half an hour on
two cores, and writes ``tutorials/course/data/chapter_10.npz``. It can be interrupted and called
again. Run it when races change, and then the notebook (``python tutorials/run.py 10``).
"""

from __future__ import annotations

import sys
from functools import partial
from pathlib import Path

import numpy as np
from races import DATA

ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT / "evolution" / "validation"), str(ROOT / "evolution")]

from common import finish_all, kept, long_race
from ground_truth import numbers_of
from matrixworld._util.files import load_toml, save_arrays
from matrixworld.coevolution import RaceSettings, SavedRun

RUNS = Path("runs", "chapter_10")
SMALL = load_toml(ROOT / "evolution" / "small_world.toml")
SHORT = {"match_episodes": 4, "schedule.generations": 20}
"""Races shorter than those of the file, of which many are needed."""
SCHEDULES = (
    "specialist-specialist", "generalist-specialist", "generalist-generalist", "hall-of-fame",
    "psro",
)  # fmt: skip
SEEDS = 10
MEASURES = ("current", "ancestors", "all", "nash", "held_out")


def settings(schedule: str, seed: int) -> RaceSettings:
    """Return the settings of a race."""
    return RaceSettings.of(SMALL | long_race(schedule)).changed({**SHORT, "seed": seed})


def numbers(run: SavedRun) -> dict[str, np.ndarray]:
    """Return what each generation guarantees and scores (teams, generations)."""
    found = kept(run.path.with_suffix(".json"), partial(numbers_of, run))
    names = ("truth", *MEASURES, "value")
    return {name: np.round(found[name], 4) for name in names}


def made() -> dict[str, np.ndarray]:
    """Play the races; return what generations guarantee and score: (schedules, seeds, ...)."""
    wanted = {f"{each}/{seed}": settings(each, seed) for each in SCHEDULES for seed in range(SEEDS)}
    runs = finish_all(wanted, RUNS)
    found = [[numbers(runs[f"{each}/{seed}"]) for seed in range(SEEDS)] for each in SCHEDULES]
    arrays = {"schedules": np.array(SCHEDULES), "value": found[0][0]["value"]}
    for t, team in enumerate(("pursuer", "evader")):
        for name in ("truth", *MEASURES):
            arrays[f"{team}: {name}"] = np.array([[one[name][t] for one in of] for of in found])
    return arrays


if __name__ == "__main__":
    save_arrays(DATA / "chapter_10.npz", made())
