"""Symmetric games: one population plays both sides; and games with a score of each team."""

import numpy as np
from scipy.special import expit

from matrixworld.coevolution import Game

# Iterated dilemma by a text of 5 letters: the first move, and those after CC, CD, DC and DD.

PAYS = {"CC": (3, 3), "CD": (0, 5), "DC": (5, 0), "DD": (1, 1)}
STATES = (*PAYS,)
ROUNDS = 10


def rule(rng):
    return "".join(rng.choice(["C", "D"], 5))


def flipped(text, rng):
    at = rng.integers(5)
    return text[:at] + "CD"[text[at] == "C"] + text[at + 1 :]


def crossed(one, other, rng):
    at = rng.integers(1, 5)
    return one[:at] + other[at:]


def dilemma(one, other, rng):
    """Return the mean payoffs of both, from 0 to 1; a move in 50 is a mistake."""
    a, b = one[0], other[0]
    sums = np.zeros(2)
    for mistakes in rng.random((ROUNDS, 2)) < 0.02:
        a, b = (
            "CD"[move == "C"] if wrong else move
            for move, wrong in zip((a, b), mistakes, strict=True)
        )
        sums += PAYS[a + b]
        a, b = one[1 + STATES.index(a + b)], other[1 + STATES.index(b + a)]
    return tuple(sums / (5 * ROUNDS))


prisoners = Game(
    dilemma, teams=("prisoners",), initial=rule, mutate=flipped, mate=crossed, symmetric=True,
    scores="both",
)  # fmt: skip


# Vectors of one population: the larger sum wins, exactly or by a coin; rock, paper and scissors.


def larger(a, b, rng):
    return expit(a.sum(axis=1) - b.sum(axis=1))


def coin(a, b, rng):
    return 1.0 * (rng.random(len(a)) < larger(a, b, rng))


def hands(a, b, rng):
    """Return scores of the hands that the three preferences of each genome are largest for."""
    difference = (np.argmax(a, axis=1) - np.argmax(b, axis=1)) % 3
    return np.choose(difference, [0.5, 1.0, 0.0])


ladder = Game(larger, 4, ("climbers",), deterministic=True, symmetric=True)
coins = Game(coin, 4, ("climbers",), symmetric=True)
fists = Game(hands, 3, ("players",), deterministic=True, symmetric=True)


# Two teams, both of which want the same: sums that are close.


def close(a, b, rng):
    score = np.exp(-abs(a.sum(axis=1) - b.sum(axis=1)))
    return np.stack([score, 0.5 * score], axis=1), {"distance": abs(a - b).sum(axis=1)}


meeting = Game(
    close, (3, 3), ("guests", "hosts"), deterministic=True, scores="both", extras=("distance",)
)
