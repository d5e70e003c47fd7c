"""Nim of 13 stones: players take 1 to 3 in turn, and who takes the last one wins.

A genome is a preference for each number of stones that are left and each move. Perfect play leaves
a multiple of four. Since 13 is none, the first player always wins against all, if it plays so.
"""

from __future__ import annotations

import numpy as np

from matrixworld.coevolution import Game
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, IntArray, Rng

STONES, MOST = 13, 3


def moves(genomes: Genomes, left: IntArray) -> IntArray:
    """Return how many stones genomes (M, genes) take of those that are left (M,)."""
    preferences = genomes.reshape(-1, STONES, MOST)[np.arange(len(genomes)), left - 1]
    allowed = np.arange(1, MOST + 1) <= left[:, np.newaxis]
    return np.asarray(1 + np.argmax(np.where(allowed, preferences, -np.inf), axis=1))


def play(a: Genomes, b: Genomes, rng: Rng) -> FloatArray:
    """Return 1 where a, which begins, takes the last stone."""
    left, scores = np.full(len(a), STONES), np.empty(len(a))
    for turn in range(STONES):
        going = np.flatnonzero(left)
        left[going] -= moves((a, b)[turn % 2][going], left[going])
        scores[going] = (turn + 1) % 2  # the last who moves wins
    return scores


def show(a: Genome, b: Genome) -> str:
    """Return the stones that are left after each move."""
    left, lines = np.array([STONES]), []
    while left[0]:
        name = nim.teams[len(lines) % 2]
        left = left - moves((a, b)[len(lines) % 2][np.newaxis], left)
        lines.append(f"{name:6} leaves {left[0]:2}")
    return "\n".join(lines)


nim = Game(play, STONES * MOST, teams=("first", "second"), deterministic=True, show=show)
