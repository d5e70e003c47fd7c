"""Make the kept numbers of notebook 10 on races beside perfect play.

    python tutorials/make/chapter_10.py

Reads ``evolution/results/ground_truth/numbers.npz``, which
``evolution/validation/ground_truth.py`` makes, and writes ``tutorials/course/data/chapter_10.npz``
in a second. Run it again when these results change, and then the notebook (``python
tutorials/run.py 10``).
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from matrixworld._util.files import save_arrays

DATA = Path(__file__).parents[1] / "course" / "data"
RACES = Path(__file__).parents[2] / "evolution" / "results" / "ground_truth" / "numbers.npz"
MEASURES = ("current", "ancestors", "all", "worst", "nash", "elo", "held_out")


def derived() -> dict[str, np.ndarray]:
    """Return what each generation guarantees and scores: (schedules, seeds, generations)."""
    with np.load(RACES) as file:
        races = dict(file)
    schedules = [name.removesuffix(" / truth") for name in races if name.endswith(" / truth")]
    arrays = {"schedules": np.array(schedules), "value": races[f"{schedules[0]} / value"][0]}
    for t, team in enumerate(("pursuer", "evader")):
        for name in ("truth", *MEASURES):
            each = [races[f"{schedule} / {name}"][:, t] for schedule in schedules]
            arrays[f"{team}: {name}"] = np.stack(each)
    return arrays


if __name__ == "__main__":
    save_arrays(DATA / "chapter_10.npz", derived())
