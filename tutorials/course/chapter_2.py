"""Exercises of the notebook "Why did it bounce?"."""

from __future__ import annotations

from collections.abc import Callable
from itertools import permutations
from typing import Any

import numpy as np

from course.boards import SITUATIONS, Cell, after_step, random_pack
from course.checks import Mistake, about, actions, array, comparison, near, whole
from matrixworld import Action
from matrixworld.explorer.playground import drawn_world

JAM = ". . . . . b . / A B . C . . a / . . . . . . ."
JAM_ACTIONS = [Action.EAST, Action.EAST, Action.WEST, Action.EAST, Action.SOUTH]
"""Pursuer 0 cannot move."""


def exercise_1(answer: Any) -> None:
    """Free pursuer 0 by one other action."""
    moves = actions(answer, len(JAM_ACTIONS))
    changed = [agent for agent, move in enumerate(moves) if move != JAM_ACTIONS[agent]]
    if 0 in changed:
        raise Mistake("Pursuer 0 shall still go east. Change the action of another agent.")
    if len(changed) != 1:
        raise Mistake(f"Exactly one action shall be another one, and {len(changed)} are.")
    world = drawn_world("SB", JAM)
    world.step(moves, explain=True)
    if world.positions[0].tolist() != [1, 1]:
        reason = next(each for each in world.conflicts if 0 in each.held)
        raise Mistake(f"Pursuer 0 still bounces: {reason}.")


MARKET = ". . . . . . . / A . B . . b # / . . . . . . . / . C a . . . ."
MARKET_ACTIONS = [Action.EAST, Action.WEST, Action.EAST, Action.STAY, Action.EAST]
REWARD_CLUES = {
    0.05: "is the reward of the step itself in it?",
    -0.05: "the reward of the step itself is paid once.",
    12.0: "is there a penalty?",
    -12.0: "who is at fault in this kind of meeting, under occupation?",
    10.0: "what is the other side of a capture?",
    -10.0: "who took part in the capture?",
    20.0: "a capture is good for one side only.",
    -20.0: "a capture is good for one side only.",
    0.1: "is an adversary beside it after the step?",
    -0.1: "is an adversary beside it after the step?",
}
"""What to say to a reward that is so much too large."""
NOT_YET = "not yet. Add up the four rows of the table for this agent alone."


def exercise_2(answer: Any) -> None:
    """Compute the rewards of a step under the rules O."""
    world = drawn_world("O", MARKET)
    world.step(MARKET_ACTIONS)
    given = array(answer, "a list of 5 numbers", 5)
    for agent, reward in enumerate(world.rewards.tolist()):
        clues = {reward + part: text for part, text in REWARD_CLUES.items()}
        with about(world.config.agent_name(agent).replace("_", " ").capitalize()):
            near(given[agent], reward, 1e-3, clues=clues, low=NOT_YET)


def exercise_3(answer: Any) -> None:
    """Say after how many steps it is worse to survive than to be caught at once."""
    near(
        whole(answer, "a whole number of steps"),
        202,
        0,
        clues={
            201: "After 201 steps both totals are equal. It has to be worse.",
            200: "An evader that is caught in its first step pays for this step, too.",
            199: "An evader that is caught in its first step pays for this step, too.",
        },
        low=lambda n: f"After {n} steps its total is {-0.05 * n:.2f}. Compare that with -10.05.",
        high="There is a smaller number.",
    )


def true_cells(cells: list[Cell], targets: list[Cell], side: int = 4) -> list[Cell]:
    """Return the cells of a pack on a square after a step under SB; no target is outside."""
    world = after_step((cells, targets), side)
    return [(row, col) for row, col in world.positions[:-1].tolist()]


def all_at_once(cells: list[Cell], targets: list[Cell]) -> list[Cell]:
    """Return the cells of pursuers on 10 x 10 cells after a step of the world, under SB."""
    return true_cells(cells, targets, side=10)


def share_of_changes(
    rule: Callable[..., Any], crowd: int, seed: int, *, steps: int = 25, renumber: bool = True
) -> float:
    """Return the share of steps that have another result when they are played again.

    A rule takes cells and targets, and returns cells. Agents get other numbers before the second
    time, unless they are not renumbered.
    """
    rng, changes = np.random.default_rng([seed, crowd]), 0
    for _ in range(steps):
        cells, targets = random_pack(rng, 10, crowd)
        order = rng.permutation(crowd) if renumber else np.arange(crowd)
        first = rule(cells, targets)
        again = rule([cells[agent] for agent in order], [targets[agent] for agent in order])
        changes += again != [first[agent] for agent in order]
    return changes / steps


def in_conflict(cells: list[Cell], targets: list[Cell]) -> set[int]:
    """Return the numbers of all agents in a vertex or an edge conflict: exercise 1.4."""
    found = set()
    for a, b in permutations(range(len(cells)), 2):
        swap = targets[a] == cells[b] and targets[b] == cells[a]
        if targets[a] == targets[b] or swap:
            found.add(a)
    return found


def _cells(value: Any) -> list[Cell]:
    return [(whole(row), whole(col)) for row, col in array(value, "a list of cells", ..., 2)]


def _difference(
    found: list[Cell], expected: list[Cell], cells: list[Cell], targets: list[Cell]
) -> str:
    if len(found) != len(cells):
        return f"Expected a list of {len(cells)} cells, got {found}."
    agent = next(a for a in range(len(cells)) if found[a] != expected[a])
    does = "stays" if expected[agent] == cells[agent] else "moves"
    return (
        f"For cells {cells} and targets {targets}, agent {agent} {does}; your function puts it on "
        f"{found[agent]}."
    )


exercise_4 = comparison(true_cells, SITUATIONS, _cells, otherwise=_difference)
"""Resolve a step, with all agents judged at once."""
