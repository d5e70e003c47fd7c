"""Solutions of notebook 6, "Running in circles"."""

from __future__ import annotations

from itertools import combinations

import numpy as np


# 6.1  Count the checkerboards of a matrix of capture rates.
#
# Go through all pairs of rows and all pairs of columns. The square is a checkerboard if wins lie on
# one diagonal and losses on the other: opposite corners agree, neighbours do not.
def exercise_1(matrix: np.ndarray) -> int:
    """Return the number of checkerboards."""
    wins = np.asarray(matrix) > 0.5
    rows, columns = (range(size) for size in wins.shape)
    return sum(
        bool(wins[a, x] == wins[b, y] and wins[a, y] == wins[b, x] and wins[a, x] != wins[a, y])
        for a, b in combinations(rows, 2)
        for x, y in combinations(columns, 2)
    )


# 6.2  The transitive share with NumPy only.
#
# Row means and column means both contain the mean of the matrix, so it is added once. All rows and
# columns of the rest then have the sum 0.
def exercise_2(matrix: np.ndarray) -> float:
    """Return the transitive share."""
    mean = matrix.mean()
    rest = matrix - matrix.mean(axis=1, keepdims=True) - matrix.mean(axis=0) + mean
    return float(1 - (rest**2).sum() / ((matrix - mean) ** 2).sum())


# 6.3  A hall of fame: the newest opponent, and up to four different older ones.
#
# The older ones are 0 to available - 2, which are available - 1 of them.
def exercise_3(available: int, rng: np.random.Generator) -> list[int]:
    """Return the numbers of the opponents to meet."""
    older = rng.choice(available - 1, size=min(4, available - 1), replace=False)
    return [available - 1, *older]
