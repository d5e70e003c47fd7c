"""Small races of the notebooks, whose evaders lose another share where they share cells."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from matrixworld.coevolution import RaceSettings, Run, SavedRun, create

DATA = Path(__file__).parents[1] / "course" / "data"
SMALL = {
    "policy.hidden": (16,), "learner.relative_sigma": 0.0, "learner.learning_rate": 0.02,
    "schedule.pursuer_epochs": 20,
}  # fmt: skip
"""Settings of the races of notebooks 4, 6 and 7."""


def penalised(settings: RaceSettings, directory: Path, penalty: float) -> Run:
    """Return the run of these settings, with a penalty on evaders that share cells."""
    create(settings, directory)
    run = Run(directory, threads=1)
    run.training.game = replace(run.training.game, penalty=penalty)
    return run


def finish(settings: RaceSettings, directory: Path, penalty: float = 0.5) -> SavedRun:
    """Return the finished run of these settings, with such a penalty."""
    penalised(settings, directory, penalty).run()
    return SavedRun(directory)


def counts(rates: np.ndarray, evaders: int) -> np.ndarray:
    """Return shares of captured evaders as their numbers."""
    return np.rint(rates * evaders).astype(np.uint8)
