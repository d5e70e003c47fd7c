"""Rock-paper-scissors over mixed strategies: nobody can progress, because no hand is better.

A genome is three numbers; their softmax is the probabilities of the hands. The score is the chance
to win, a draw counting one half. The equilibrium is one third of each hand, with a value of 1/2.
"""

from __future__ import annotations

import numpy as np

from matrixworld.coevolution import Game
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Rng

HANDS = ("rock", "paper", "scissors")
WINS = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]])
"""Score of each hand (rows) against each other one."""


def strategies(genomes: Genomes) -> FloatArray:
    """Return the probabilities of the hands, (..., 3)."""
    weights = np.exp(genomes - genomes.max(axis=-1, keepdims=True), dtype=np.float64)
    return np.asarray(weights / weights.sum(axis=-1, keepdims=True))


def play(a: Genomes, b: Genomes, rng: Rng) -> FloatArray:
    """Return the expected scores of a."""
    return np.asarray(np.einsum("mi,ij,mj->m", strategies(a), WINS, strategies(b)))


def show(a: Genome, b: Genome) -> str:
    """Return the probabilities of both players' hands."""
    rows = zip(HANDS, strategies(a), strategies(b), strict=True)
    return "\n".join(f"{hand:8} {first:4.0%} {second:4.0%}" for hand, first, second in rows)


rock_paper_scissors = Game(play, genes=3, teams=("left", "right"), deterministic=True, show=show)
