"""Nim of 13 stones: players take 1 to 3 in turn, and who takes the last one wins.

A genome has a preference for each move, by the stones that are left. Perfect play leaves a multiple
of four. Since 13 is none, a first player who plays so wins against everybody.
"""

import numpy as np

from matrixworld.coevolution import Game

STONES, MOST = 13, 3


def taken(genomes, left):
    """Return how many stones genomes (M, genes) take of those that are left (M,)."""
    preferences = genomes.reshape(-1, STONES, MOST)[np.arange(len(genomes)), left - 1]
    allowed = np.arange(1, MOST + 1) <= left[:, np.newaxis]
    return 1 + np.argmax(np.where(allowed, preferences, -np.inf), axis=1)


def play(a, b, rng):
    """Return 1 where a, who begins, takes the last stone."""
    left, scores = np.full(len(a), STONES), np.empty(len(a))
    for turn in range(STONES):
        going = np.flatnonzero(left)
        left[going] -= taken((a, b)[turn % 2][going], left[going])
        scores[going] = 1 - turn % 2  # the last one who moves wins
    return scores


def show(a, b):
    """Return the stones that are left after each move."""
    left = [STONES]
    while left[-1]:
        mover = (b, a)[len(left) % 2]
        left.append(left[-1] - int(taken(mover[np.newaxis], np.array(left[-1:]))[0]))
    return " ".join(map(str, left))


nim = Game(play, genes=STONES * MOST, teams=("first", "second"), deterministic=True, show=show)
