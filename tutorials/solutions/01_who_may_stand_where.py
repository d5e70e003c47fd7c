"""Solutions of the exercises in "Who may stand where?"."""

import matrixworld as mw
from matrixworld import Action

STAY, NORTH, EAST, SOUTH, WEST = list(Action)[:5]

# 1.1  The shortest way through the maze, in 7 moves.
#
# The evader is 3 rows to the south and 4 columns to the east, so 7 moves are only enough if each of
# them goes south or east. Obstacles leave one such way.
exercise_1 = [EAST, EAST, SOUTH, SOUTH, EAST, EAST, SOUTH]

# 1.2  Four pursuers in a room of four cells, all of which move.
#
# Swaps are conflicts, but a cell that its agent leaves is free. So all walk in a circle, here
# clockwise. Pursuers 0 and 1 are in the upper row, 2 and 3 in the lower row. The other direction is
# right, too.
exercise_2 = [EAST, SOUTH, NORTH, WEST]

# 1.3  Bumper cars.
#
# "The agents take turns" is the interaction. The four outcomes are all to bounce. "While it is
# surrounded" is the capture, and "it stays on the floor" is the default of the last field.
exercise_3 = mw.Rules(
    interaction=mw.Interaction.AGENT_TURNS,
    obstacle=mw.Outcome.BOUNCE,
    teammate=mw.Outcome.BOUNCE,
    evader=mw.Outcome.BOUNCE,
    pursuer=mw.Outcome.BOUNCE,
    capture=mw.Capture.SURROUND,
    captured_disappear=False,
)


# 1.4  The agents in a vertex or an edge conflict.
#
# Every pair of agents is looked at. A vertex conflict is one target for both; this includes a
# target on which the other agent stays. An edge conflict is a swap. Nothing else is a conflict, so
# cells that agents leave play no part.
def exercise_4(cells, targets):
    found = set()
    for a in range(len(cells)):
        for b in range(a):
            vertex = targets[a] == targets[b]
            edge = targets[a] == cells[b] and targets[b] == cells[a]
            if vertex or edge:
                found |= {a, b}
    return found
