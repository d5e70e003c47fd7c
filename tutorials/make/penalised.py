"""Runs whose evaders lose another share of their fitness where they share cells than usual."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from matrixworld.coevolution import RaceSettings, Run, SavedRun, create


class Penalised(Run):
    """A run with such a penalty."""

    def __init__(self, directory: Path, penalty: float, **options: Any) -> None:
        super().__init__(directory, **options)
        self.game = replace(self.game, penalty=penalty)


def finish(settings: RaceSettings, directory: Path, penalty: float = 0.5) -> SavedRun:
    """Return the finished run of these settings, with a penalty on evaders that share cells."""
    create(settings, directory)
    return Penalised(directory, penalty, threads=1).run()
