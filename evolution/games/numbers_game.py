"""Games of numbers: the larger number wins. Progress is possible, and seen in the genomes.

After Watson & Pollack 2001, "Coevolutionary dynamics in a minimal substrate", GECCO. A genome is
some numbers, whose sum is the objective that selection does not see.

- In `numbers` the larger sum wins: the game is transitive, and so there is no cycling.
- In `focusing` the number in which two genomes differ most decides: others drift away.
- In `relativism` the number in which they differ least decides: a beats b, b beats c and c beats a
  is possible, so winning says little about the objective.
"""

from __future__ import annotations

import numpy as np

from matrixworld.coevolution import Game
from matrixworld.coevolution.types import FloatArray, Genomes, Indices, Rng


def larger_sum(a: Genomes, b: Genomes, rng: Rng) -> FloatArray:
    """Return scores by the sums: a larger one wins more often than not."""
    return np.asarray(1.0 / (1.0 + np.exp(b.sum(axis=1) - a.sum(axis=1), dtype=np.float64)))


def farthest(a: Genomes, b: Genomes, rng: Rng) -> FloatArray:
    """Return scores by the number in which genomes differ most."""
    return _by(np.argmax(np.abs(a - b), axis=1), a, b)


def nearest(a: Genomes, b: Genomes, rng: Rng) -> FloatArray:
    """Return scores by the number in which genomes differ least."""
    return _by(np.argmin(np.abs(a - b), axis=1), a, b)


def _by(number: Indices, a: Genomes, b: Genomes) -> FloatArray:
    first, second = (each[np.arange(len(each)), number] for each in (a, b))
    return np.asarray((1.0 + np.sign(first - second)) / 2.0)


numbers = Game(larger_sum, genes=5, teams=("hosts", "parasites"), deterministic=True)
focusing = Game(farthest, genes=5, teams=("hosts", "parasites"), deterministic=True)
relativism = Game(nearest, genes=2, teams=("hosts", "parasites"), deterministic=True)
