"""Solutions of notebook 9, "Fast and safe?"."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import matrixworld as mw
from matrixworld.tutorial.chapter_9 import WORLD, pack

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

free = replace(WORLD, rewards=mw.Rewards(pursuer_collide=0))
brisk, idle = [4, 10, -10, -8, -2, 0], [0, 0, 0, 0, 0, 20]
played = mw.rollout(free, pack([brisk, idle]), "random", mw.Matches.of([0, 1], 0, 2), episodes=400)
gain = played.pursuer_return.mean(axis=1)
collisions = played.faults[:, :, 0].sum(axis=2).mean(axis=1)

exercise_2 = (gain[0] - gain[1]) / (collisions[0] - collisions[1])

# 9.3  Episodes without a collision that show a share below 1 in 100 with 95% confidence.
#
# The smallest n with 0.99^n <= 0.05: n = log(0.05) / log(0.99) = 298.07, so 299.

exercise_3 = int(np.ceil(np.log(0.05) / np.log(0.99)))

# 9.4  A mask with right of way.
#
# A pursuer may enter a free cell if no teammate stands on a side of this cell that comes before its
# own side in the order north, east, south, west. Two pursuers beside the same free cell are on two
# of its sides, and one side comes first: only that pursuer may go. They cannot swap cells either,
# since neither cell is free.

STEPS = [(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1)]  # stay, north, east, south, west
MIDDLE = 5


def exercise_4(views):
    """Return which actions are allowed, (n, 5), from n views, (n, 3, 11, 11)."""
    allowed = np.ones((len(views), 5), bool)
    for action in range(1, 5):
        row, col = STEPS[action]
        target = views[:, :, MIDDLE + row, MIDDLE + col]
        allowed[:, action] = ~target.any(axis=1)
        for down, right in STEPS[1:]:
            if (down, right) == (-row, -col):  # this side of the target is my own cell
                break
            teammate = views[:, 1, MIDDLE + row + down, MIDDLE + col + right]
            allowed[:, action] &= teammate == 0
    return allowed
