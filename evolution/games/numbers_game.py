"""The larger number wins: progress is possible, and seen in the genomes.

After Watson & Pollack 2001, "Coevolutionary dynamics in a minimal substrate", GECCO. A genome is
some numbers; their sum is the objective, which selection does not see. In `numbers` the larger sum
wins, so the game is transitive. In `focusing` the number decides in which two genomes differ most:
others drift away. In `relativism` it is that in which they differ least: a beats b, b beats c and c
beats a is possible, so winning says little about the objective.
"""

import numpy as np
from scipy.special import expit

from matrixworld.coevolution import Game


def larger_sum(a, b, rng):
    """Return scores by the sums: a larger one wins more often than not."""
    return expit(a.sum(axis=1) - b.sum(axis=1))


def farthest(a, b, rng):
    """Return scores by the number in which genomes differ most."""
    return _by(np.argmax(np.abs(a - b), axis=1), a, b)


def nearest(a, b, rng):
    """Return scores by the number in which genomes differ least."""
    return _by(np.argmin(np.abs(a - b), axis=1), a, b)


def _by(deciding, a, b):
    difference = (a - b)[np.arange(len(a)), deciding]
    return (1.0 + np.sign(difference)) / 2.0


TEAMS = ("hosts", "parasites")
numbers = Game(larger_sum, genes=5, teams=TEAMS, deterministic=True)
focusing = Game(farthest, genes=5, teams=TEAMS, deterministic=True)
relativism = Game(nearest, genes=5, teams=TEAMS, deterministic=True)
