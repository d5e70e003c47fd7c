"""Runs whose evaders lose another share of their fitness where they share cells than usual."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import matrixworld as mw
from matrixworld.coevolution import RaceSettings, Run, SavedRun, Team, create


class Penalised(Run):
    """A run with such a penalty."""

    def __init__(self, directory: Path, penalty: float, **options: Any) -> None:
        self.penalty = penalty
        super().__init__(directory, **options)

    def fitness(self, team: Team, scores: mw.EpisodeStatistics, table: Any) -> np.ndarray:
        """Return the fitness (n,) of the candidates."""
        return self.settings.fitness.fitness(scores, team, table, self.penalty)


def finish(
    settings: RaceSettings, directory: Path, penalty: float = 0.5, *, threads: int | None = 1
) -> SavedRun:
    """Return the finished run of these settings, with a penalty on evaders that share cells."""
    create(settings, directory)
    return Penalised(directory, penalty, threads=threads).run()
