"""Small races of the notebooks, whose evaders lose another share where they share cells."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from matrixworld.coevolution import RaceSettings, Run, SavedRun, create

DATA = Path(__file__).parents[1] / "course" / "data"
SMALL = {
    "policy.hidden": (16,), "learner.relative_sigma": 0.0, "learner.learning_rate": 0.02,
    "schedule.pursuer_epochs": 20,
}  # fmt: skip
"""Settings of the races of notebooks 4, 6 and 7."""


class Penalised(Run):
    """A run with such a penalty."""

    def __init__(self, directory: Path, penalty: float, **options: Any) -> None:
        super().__init__(directory, **options)
        self.game = replace(self.game, penalty=penalty)


def finish(settings: RaceSettings, directory: Path, penalty: float = 0.5) -> SavedRun:
    """Return the finished run of these settings, with a penalty on evaders that share cells."""
    create(settings, directory)
    return Penalised(directory, penalty, threads=1).run()


def counts(rates: np.ndarray, evaders: int) -> np.ndarray:
    """Return shares of captured evaders as their numbers."""
    return np.rint(rates * evaders).astype(np.uint8)
