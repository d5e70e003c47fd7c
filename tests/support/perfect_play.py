"""What a solution says of a moment of a world, found by the cells of its agents."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import matrixworld as mw
from matrixworld.coevolution import TEAMS
from matrixworld.solver import Solution


@dataclass(frozen=True)
class Moment:
    """Value, joint and single probabilities of the turn, and what actions lose, by team."""

    value: float
    play: list[list[float]]
    marginals: list[list[float] | None]
    lost: list[float]


def order_of(solution: Solution, world: mw.World) -> tuple[list[int], int]:
    """Return the agents in the order of a world's state, and the number of the state."""
    states, config, n = solution.states, world.config, world.config.n_pursuers
    cells = np.where(world.alive, world.positions @ [config.cols, 1], -1)
    by_cell = [*np.argsort(cells[:n], kind="stable"), *n + np.argsort(cells[n:], kind="stable")]
    one_by_one = config.rules.interaction is mw.Interaction.AGENT_TURNS
    order = list(range(config.n_agents)) if one_by_one else [int(agent) for agent in by_cell]
    same = (states.cells(world.turn) == cells[order]).all(axis=1)
    same &= (states.captured(world.turn) == world.captured[np.array(order[n:]) - n]).all(axis=1)
    return order, int(np.flatnonzero(same)[-1])


def solved_moment(solution: Solution, world: mw.World, row: NDArray[np.int64]) -> Moment:
    """Return perfect play of the next turn, and what the actions (A,) lose."""
    config, turn, left = world.config, world.turn, world.config.max_steps - world.steps
    order, state = order_of(solution, world)
    last = turn + 1 == solution.states.n_turns
    after = solution.values[0 if last else turn + 1]
    matrix = after[min(left - last, len(after) - 1)][solution.states.successors(turn)[state]]
    play = [solution.probabilities(team, left, turn)[state] for team in TEAMS]
    marginals: list[list[float] | None] = [None] * config.n_agents
    joint = []
    for side, shares in enumerate(play):
        team = [a for a in order if a in world.actors and (a >= config.n_pursuers) == side]
        shape = (config.n_actions,) * len(team)
        joint.append(int(np.ravel_multi_index(row[team], shape)) if team else 0)
        for axis, agent in enumerate(team):
            others = tuple(each for each in range(len(team)) if each != axis)
            marginals[agent] = shares.reshape(shape).sum(axis=others).tolist()
    # By time, the round that is played counts when it is over.
    now = solution.values[turn]
    counted = 1.0 if solution.payoff == "capture-time" and turn == 0 else 0.0
    value = float(now[min(left, len(now) - 1), state]) + counted
    lost = [value - matrix[joint[0]] @ play[1], play[0] @ matrix[:, joint[1]] - value]
    return Moment(value, [each.tolist() for each in play], marginals, [*map(float, lost)])
