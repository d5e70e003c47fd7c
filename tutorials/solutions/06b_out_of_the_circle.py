"""Solutions of notebook 6b, "Out of the circle"."""

from __future__ import annotations

import numpy as np

# Exercise 6.3. Rock, paper, scissors, and the well.
#
# The well wins against rock and scissors and loses to paper: its row is 1, 0, 1, 0.5. Its column is
# one minus its row.
exercise_3 = [
    [0.5, 0.0, 1.0, 0.0],
    [1.0, 0.5, 0.0, 1.0],
    [0.0, 1.0, 0.5, 0.0],
    [1.0, 0.0, 1.0, 0.5],
]


# Exercise 6.4. A hall of fame: the newest opponent, and up to four different older ones.
#
# The older ones are 0 to available - 2, which are available - 1 of them.
def exercise_4(available: int, rng: np.random.Generator) -> list[int]:
    """Return the numbers of the opponents to meet."""
    older = rng.choice(available - 1, size=min(4, available - 1), replace=False)
    return [available - 1, *older]
