"""Solutions of notebook 7, "When one side gives up".

Try each exercise before you read on. There are other right answers, in particular to the last one.
"""

from __future__ import annotations

import numpy as np

# 7.1  Write the fitness of reduced virulence, f = 2 x / v - x^2 / v^2.
#
# x is relative to the best parasite of the population. If no parasite wins, the division is not
# possible; then all fitness is 0.


def exercise_1(wins, v):
    """Return the fitness of each parasite."""
    if wins.max() == 0:
        return np.zeros(len(wins))
    share = wins / wins.max() / v
    return 2 * share - share**2


# 7.2  Up to which v are 4 of 5 wins at least as good as 5 of 5?
#
# f(0.8) = 1.6 / v - 0.64 / v^2 and f(1) = 2 / v - 1 / v^2. They are equal where 0.4 v = 0.36.
# For a smaller v the parasite with 4 wins is fitter.

exercise_2 = 0.36 / 0.4

# 7.3  Write a fitness of your own that keeps hosts in the race.
#
# For example: the best parasite wins three quarters of the most wins, and each win more or less
# costs the same. (This is reduced virulence with straight lines in place of a parabola.)


def exercise_3(wins):
    """Return the fitness of each parasite: minus the distance to three quarters of the most."""
    return -np.abs(wins - 0.75 * wins.max())
