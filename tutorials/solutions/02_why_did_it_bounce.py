"""Solutions of the exercises in "Why did it bounce?"."""

from matrixworld import Action

STAY, NORTH, EAST, SOUTH, WEST = list(Action)[:5]

# 2.1  One other action, so that pursuer 0 can go east.
#
# Pursuer 0 waits for the cell of pursuer 1, and pursuer 1 meets pursuer 2. If pursuer 2 stays, the
# cell between them belongs to pursuer 1 alone, and pursuer 0 follows. Pursuer 2 may also go north,
# east or south, or pursuer 1 north or south.
exercise_1 = [EAST, EAST, STAY, EAST, SOUTH]

# 2.2  The rewards of a step under O.
#
# Each agent gets -0.05 for the step. Pursuers 0 and 1 enter one cell: teammates are both at fault,
# -12 each. Pursuer 2 captures evader 0: +10 and -10, and nobody is at fault, because contact is the
# aim of this game. Evader 1 runs into an obstacle: -12. Nobody is beside an adversary afterwards.
exercise_2 = [-12.05, -12.05, 9.95, -10.05, -12.05]

# 2.3  Steps until surviving is worse than being caught at once.
#
# Caught in the first step: -10 - 0.05 = -10.05. Surviving n steps: -0.05 n. This is lower from
# n = 202 on; for 201 steps both are equal.
exercise_3 = 202


# 2.4  A resolver that judges all agents at once.
#
# Agents in conflict stay: their target becomes their own cell. This can bring others into conflict,
# namely those that meant to enter such a cell. So it is repeated until nothing changes. Targets
# only ever change to the agent's own cell, so the loop ends after at most as many rounds as there
# are agents.
def in_conflict(cells, targets):
    """Return the agents in a vertex or an edge conflict, as in exercise 1.4."""
    found = set()
    for a in range(len(cells)):
        for b in range(a):
            vertex = targets[a] == targets[b]
            edge = targets[a] == cells[b] and targets[b] == cells[a]
            if vertex or edge:
                found |= {a, b}
    return found


def exercise_4(cells, targets):
    while True:
        held = in_conflict(cells, targets)
        after = [cells[agent] if agent in held else target for agent, target in enumerate(targets)]
        if after == targets:
            return targets
        targets = after
