"""Selection of parents by their fitness."""

from __future__ import annotations

import numpy as np

from matrixworld.coevolution.types import FloatArray, Indices, Rng


def select_tournament(fitness: FloatArray, k: int, rng: Rng, *, size: int) -> Indices:
    """Return the parents (k,): each the fittest of `size` random entrants; size 1 is random."""
    entrants = rng.integers(0, len(fitness), size=(k, size))
    # Rows are tournaments; of equal fitness the first entrant wins, and their order is random.
    winners = np.argmax(fitness[entrants], axis=1)
    selected: Indices = entrants[np.arange(k), winners]
    return selected


def fittest(fitness: FloatArray, k: int) -> Indices:
    """Return the k fittest individuals, the fittest first; of equals the first."""
    return np.argsort(-fitness, kind="stable")[:k]
