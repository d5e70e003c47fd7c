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
        few = max(1, min(FEW, len(order) // 2))
        best, worst = order[:few], order[::-1][:few]
        return [
            f"{self.team.capitalize()} of generation {self.generation}: {self.genome}",
            f"Mean score against {self.opponents}, {len(order)} of them: {self.scores.mean():.3f}",
            f"Best against generation {self._named(best)}; worst against {self._named(worst)}",
        ]

    def _named(self, generations: Any) -> str:
        return ", ".join(f"{g} ({self.scores[g]:.2f})" for g in generations)


def standing(run: StoredRun, team: str, generation: int) -> Standing:
    """Return how a generation of a finished run stands, in a game of your own.

    ValueError for a generation of a team alone whose matches the run does not have.
    """
    key = run.key_of(team)
    side = run.facts.keys.index(key)
    number = run.generation(team, generation, "generation")
    names = run.facts.teams
    genome = run.archive()[key][number]
    shown = str(genome[0]) if genome.dtype.kind == "U" else genome
    rows = run.payoff().payoffs().side(BOTH[side]).matrices[0]
    first = run.generation(team, -1) + 1 - len(rows)  # a team alone has its last generation there
    if number < first:
        expected = f"a generation whose matches the run has, from {first} on"
        raise ValueError(f"generation: expected {expected}, got {number}")
    scores = rows[number - first]
    return Standing(names[side], names[1 - side], number, shown, scores)
