"""How a generation of a game of your own stands: its genome, and whom it wins and loses against."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from matrixworld._util import readable
from matrixworld.coevolution.runs.stored import StoredRun
from matrixworld.coevolution.types import BOTH, FloatArray, Genome

FEW = 3  # opponents of which the best and the worst are named


@dataclass(frozen=True, repr=False)
class Standing(readable.Readable):
    """What is known of a generation from the evaluation of its race.

    `scores` (k,) are its means against each generation of its opponents, by its own scores.
    """

    team: str
    opponents: str
    generation: int
    genome: str | Genome  # a text, as files hold an object, or a vector (genes,) float32
    scores: FloatArray

    def to_json(self) -> dict[str, Any]:
        """Return plain values that JSON can represent."""
        plain: dict[str, Any] = readable.plain_values(self)
        return plain

    def _parts(self) -> readable.Parts:
        order = np.argsort(-self.scores, kind="stable")
        best, worst = order[:FEW], order[::-1][:FEW]
        return [
            f"{self.team.capitalize()} of generation {self.generation}: {self.genome}",
            f"Score against all {len(order)} generations of {self.opponents}: "
            f"{self.scores.mean():.3f}",
            f"Best against generation {self._named(best)}; worst against {self._named(worst)}",
        ]

    def _named(self, generations: Any) -> str:
        return ", ".join(f"{g} ({self.scores[g]:.2f})" for g in generations)


def standing(run: StoredRun, team: str, generation: int) -> Standing:
    """Return how a generation of a finished race stands, in a game of your own."""
    key = run.key_of(team)
    side = run.facts.keys.index(key)
    number = run.generation(team, generation, "generation")
    names = run.facts.teams
    genome = run.archive()[key][number]
    shown = str(genome[0]) if genome.dtype.kind == "U" else genome
    scores = run.payoff().payoffs().side(BOTH[side]).matrices[0][number]
    return Standing(names[side], names[1 - side], number, shown, scores)
