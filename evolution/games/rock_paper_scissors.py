"""Rock-paper-scissors over mixed strategies: no hand is better, so there is no progress.

A genome is three numbers; their softmax is the probabilities of the hands. The score is the chance
to win, a draw counting one half. The equilibrium is one third of each hand, with a score of 1/2.
"""

import numpy as np

from matrixworld.coevolution import Game

HANDS = ("rock", "paper", "scissors")
WINS = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]])
"""Score of each hand (rows) against each other one."""


def strategies(genomes):
    """Return the probabilities of the hands, (..., 3)."""
    weights = np.exp(genomes - genomes.max(axis=-1, keepdims=True))
    return weights / weights.sum(axis=-1, keepdims=True)


def play(a, b, rng):
    """Return the expected scores of a."""
    return np.einsum("mi,ij,mj->m", strategies(a), WINS, strategies(b))


def show(a, b):
    """Return the probabilities of both players' hands."""
    rows = zip(HANDS, strategies(a), strategies(b), strict=True)
    return "\n".join(f"{hand:8} {first:4.0%} {second:4.0%}" for hand, first, second in rows)


rock_paper_scissors = Game(play, genes=3, teams=("left", "right"), deterministic=True, show=show)
