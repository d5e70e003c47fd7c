"""Solutions of notebook 3, Can a chase evolve?"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

# 3.1  How many numbers has the genome of a network with one hidden layer?
#
# A layer with n inputs and m outputs has n * m weights and m biases, so (n + 1) * m numbers. The
# view has three layers of side * side cells. For a view of 5 x 5, 8 hidden units and 5 moves this
# gives 76 * 8 + 9 * 5 = 653.


def exercise_1(side: int, hidden: int, moves: int) -> int:
    inputs = 3 * side * side
    return (inputs + 1) * hidden + (hidden + 1) * moves


# 3.2  How many matches make the standard error of a mean small enough?
#
# The standard error is spread / sqrt(n). It is at most `error` if n is at least
# (spread / error)**2. Dividing two decimal numbers leaves rounding errors in the last digits, so
# the square is rounded before it is rounded up: (0.3 / 0.05)**2 should be 36, not 36.00000001.


def exercise_2(spread: float, error: float) -> int:
    return math.ceil(round((spread / error) ** 2, 6))


# 3.3  The share of a team that stands on a cell with a teammate, beyond the first on each cell.
#
# Each cell holds one agent that is not counted. So the number of different cells is subtracted.


def exercise_3(cells: Sequence[tuple[int, int]], team_size: int) -> float:
    return (len(cells) - len(set(cells))) / team_size


# 3.4  A learner: ask and tell.
#
# This one makes 30 mutants and moves to the mean of the best eight. A mean of several forgets the
# luck of a single one. The step becomes smaller with time.


class Climber:
    """A hill climber that moves to the mean of its best candidates."""

    def __init__(self, genome: np.ndarray, rng: np.random.Generator) -> None:
        self.genome, self.sigma = genome, 0.2

    def ask(self, rng: np.random.Generator) -> np.ndarray:
        noise = rng.standard_normal((30, len(self.genome)), dtype=np.float32)
        self.candidates = self.genome + np.float32(self.sigma) * noise
        return self.candidates

    def tell(self, fitness: np.ndarray) -> None:
        best = np.argsort(fitness)[-8:]
        self.genome = self.candidates[best].mean(axis=0)
        self.sigma *= 0.99


exercise_4 = Climber
