"""Solutions of notebook 10, "How far from perfect?"."""

import numpy as np

from course import kept
from course.chapter_10 import STAKES


# 10.1  Who leaves a multiple of most + 1 wins. Of such a number every move loses.
def exercise_1(stones, most):
    return stones % (most + 1)


# 10.2  The opponent that knows the mixture chooses the column in which it scores least.
def exercise_2(payoff, mixture):
    return (mixture @ payoff).min()


# 10.3  In the safe mixture no hand of the opponent is better than another. Two equations say so,
# the sum is the third. By hand: each hand is played as often as the *other* two are worth against
# each other, in margins above 0.5: rock .25, paper .5, scissors .25.
_equations = np.vstack([STAKES[:, 0] - STAKES[:, 1], STAKES[:, 1] - STAKES[:, 2], np.ones(3)])
exercise_3 = np.linalg.solve(_equations, [0, 0, 1])

# 10.4  Perfect teams guarantee value and 1 - value, together 1. NashConv is what is missing.
_stored = kept("chapter_10")
_schedule = list(_stored["schedules"]).index("hall-of-fame")
_last = [_stored[f"{team}: truth"][_schedule, :, -1] for team in ("pursuer", "evader")]
exercise_4 = (1 - _last[0] - _last[1]).mean()
