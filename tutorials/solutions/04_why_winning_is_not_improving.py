"""Solutions of notebook 4, Why does winning not mean improving?"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

# 4.1  Two payoff matrices with the same diagonal: both teams get better, both teams get worse.
#
# If both teams become stronger by the same amount in each generation, a cell depends on the lag
# only: pursuers that are g - h generations ahead of the evaders capture more. On the diagonal the
# lag is 0, whatever the steps are. If both become weaker, the sign changes; that is the transpose.

generation = np.arange(4)
better = 0.5 + 0.1 * (generation[:, None] - generation[None, :])
worse = better.T
exercise_1 = better, worse


# 4.2  The pursuers of generation g against all earlier evaders.
#
# Row g holds these pursuers; the earlier evaders are the columns before g.


def exercise_2(payoff: np.ndarray, g: int) -> float:
    return payoff[g, :g].mean()


# 4.3  The best generations of a master tournament.
#
# The matrix holds capture rates. Pursuers want a high mean of their row, evaders a low mean of
# their column.


def exercise_3(payoff: np.ndarray) -> tuple[int, int]:
    return int(payoff.mean(axis=1).argmax()), int(payoff.mean(axis=0).argmin())


# 4.4  The share of all pairs that individuals win against held-out opponents.
#
# `beats` compares arrays row by row. So each individual is repeated m times, and the list of
# opponents is repeated n times as a whole: every individual is beside every opponent once.


def exercise_4(
    beats: Callable[[np.ndarray, np.ndarray], np.ndarray],
    individuals: np.ndarray,
    opponents: np.ndarray,
) -> float:
    n, m = len(individuals), len(opponents)
    first = np.repeat(individuals, m, axis=0)
    second = np.tile(opponents, (n, 1))
    return beats(first, second).mean()
