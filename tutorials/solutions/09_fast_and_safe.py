"""Solutions of notebook 9, "Fast and safe?"."""

from __future__ import annotations

import numpy as np

from course.chapter_9 import brisk_and_idle

# 9.1  Six weights: fewer than 10 of 1000 agent-steps at fault, at most 15 steps.
#
# [4, 10, -10, -8, -4, 0] of the figure is nearly there. A stronger `crowd` makes it safer and
# slower; a stronger `approach` makes it faster and less safe. With both, and a `teammate` that is
# never outvoted, it keeps both limits.

exercise_1 = [5, 10, -10, -10, -5, 0]

# 9.2  The penalty from which on it is better to be idle than brisk.
#
# The returns are equal where
#     gain[0] - penalty * collisions[0] = gain[1] - penalty * collisions[1].

gain, collisions = brisk_and_idle()
exercise_2 = (gain[0] - gain[1]) / (collisions[0] - collisions[1])

# 9.3  Episodes without a collision that show a share below 1 in 100 with 95% confidence.
#
# The smallest n with 0.99^n <= 0.05: n = log(0.05) / log(0.99) = 298.07, so 299.

exercise_3 = int(np.ceil(np.log(0.05) / np.log(0.99)))

# 9.4  A convention that never stops all pursuers around a cell.
#
# The moves are put in a row: north, east, south, west. Of any pursuers around a cell, the one whose
# move stands furthest to the left goes before all others. Each of the 24 rows is right. In all
# other conventions three pursuers can wait in a circle. Under the mask right-of-way these are the
# ones that move north, east and west, and those that move north, south and west.


def exercise_4(own, other):
    """Return whether a pursuer that enters a cell by `own` goes before one that does by `other`."""
    return own < other
