"""Make the kept numbers of notebook 8 on the paper's baselines.

    python tutorials/make/chapter_8_paper.py

Reads ``evolution/results/paper_claims/numbers.npz``, which ``evolution/paper_claims.py`` makes, and
writes ``tutorials/course/data/chapter_8_paper.npz`` in a second. Run it again when these
results change, and then the notebook (``python tutorials/run.py 08``).
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from matrixworld._util.files import save_arrays

DATA = Path(__file__).parents[1] / "course" / "data"
ROOT = Path(__file__).parents[2]
NUMBERS = ROOT / "evolution" / "results" / "paper_claims" / "numbers.npz"


def derived() -> dict[str, np.ndarray]:
    """Return the mean payoff (kinds, seeds) of each team against each sort of opponents."""
    # Scripts of one directory import each other by their plain names.
    sys.path.insert(0, str(ROOT / "evolution"))
    from paper_claims import OPPONENTS, standings
    from paper_runs import CANDIDATES

    with np.load(NUMBERS) as file:
        numbers = {name: file[name] for name in file.files}
    arrays: dict[str, np.ndarray] = {}
    for team, kinds in CANDIDATES.items():
        arrays[f"{team}s: kinds"] = np.array(kinds)
        for opponents, scores in standings(numbers, team).items():
            assert opponents in OPPONENTS
            arrays[f"{team}s: {opponents}"] = np.array([scores[kind] for kind in kinds])
    return arrays


if __name__ == "__main__":
    save_arrays(DATA / "chapter_8_paper.npz", derived())
