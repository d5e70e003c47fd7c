"""Payoff matrices with known properties."""

from itertools import combinations, permutations

import numpy as np
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

ROCK_PAPER_SCISSORS = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]])


def payoffs(*, least=1, most=6, parts=16):
    """Draw matrices of rates in equal parts, powers of 2: differences and complements are exact."""
    shapes = arrays.array_shapes(min_dims=2, max_dims=2, min_side=least, max_side=most)
    rates = st.integers(0, parts).map(lambda n: n / parts)
    return arrays.arrays(np.float64, shapes, elements=rates)


def circular(size, period=5.0):
    """Return a pure cycle: the rate depends on the difference of two positions on a circle."""
    generation = np.arange(size)
    turn = 2 * np.pi / period * (generation[:, None] - generation[None, :])
    return 0.5 + 0.45 * np.cos(turn - np.pi / 3)  # shifted, so that the diagonal is no crest


def logistic(size, slope=0.15):
    """Return a matrix where later generations of both teams are steadily stronger."""
    generation = np.arange(size)
    return 1 / (1 + np.exp(-slope * (generation[:, None] - generation[None, :])))


def quadruples(matrix):
    """Yield all that could be checkerboards: both winning and both losing cells, and their place.

    The place is two pursuers, ascending, and the evaders that the first and the second one beat.
    """
    for p, q in combinations(range(len(matrix)), 2):
        for a, b in permutations(range(matrix.shape[1]), 2):
            yield (matrix[p, a], matrix[q, b]), (matrix[p, b], matrix[q, a]), ((p, q), (a, b))
