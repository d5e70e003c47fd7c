"""Exercises of the notebook "Why did it bounce?"."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

import numpy as np

from matrixworld.explorer.gallery import drawn_world
from matrixworld.tutorial.boards import Cell, actions_to, pack, random_pack
from matrixworld.tutorial.chapter_1 import ABC, read_actions
from matrixworld.tutorial.exercises import NO_FUNCTION, Exercise, Prediction
from matrixworld.world.rules import Action
from matrixworld.world.world import World

JAM = ". . . . . b . / A B . C . . a / . . . . . . ."
JAM_ACTIONS = [Action.EAST, Action.EAST, Action.WEST, Action.EAST, Action.SOUTH]
"""The jam of the first exercise: pursuer 0 cannot move."""

MARKET = ". . . . . . . / A . B . . b # / . . . . . . . / . C a . . . ."
MARKET_ACTIONS = [Action.EAST, Action.WEST, Action.EAST, Action.STAY, Action.EAST]
"""The step of the second exercise, under the rules -O."""

SIDE = 4
"""Side of the squares on which a student's resolver is tried."""


# 2.1: one other action.


def _mistake_in_jam(answer: object) -> str | None:
    actions = read_actions(answer, len(JAM_ACTIONS))
    if isinstance(actions, str):
        return actions
    changed = [
        agent
        for agent, (new, old) in enumerate(zip(actions, JAM_ACTIONS, strict=True))
        if new != old
    ]
    if 0 in changed:
        return "Pursuer 0 shall still go east. Change the action of another agent."
    if len(changed) != 1:
        return f"Exactly one action shall be another one, and {len(changed)} are."
    world = drawn_world("SB", JAM)
    world.step(actions, explain=True)
    if world.positions[0].tolist() != [1, 1]:
        reason = next(each for each in world.conflicts if 0 in each.held)
        return f"Pursuer 0 still bounces: {reason}."
    return None


# 2.2: rewards of a step.


def market() -> World:
    """Return the world of the second exercise after its step."""
    world = drawn_world("O", MARKET)
    world.step(MARKET_ACTIONS, explain=True)
    return world


def _mistake_in_rewards(answer: object) -> str | None:
    if isinstance(answer, str) or not isinstance(answer, Iterable):
        return f"Expected a list of 5 numbers, got {type(answer).__name__}."
    given = list(answer)
    if len(given) != len(MARKET_ACTIONS):
        return f"Expected a list of 5 numbers, got {len(given)} of them."
    try:
        numbers = [float(each) for each in given]
    except (TypeError, ValueError):
        return "Expected a list of 5 numbers; one entry is no number."
    world = market()
    for agent, (number, reward) in enumerate(zip(numbers, world.rewards.tolist(), strict=True)):
        if not abs(number - reward) < 1e-3:
            return f"{_named(world, agent)}: {_reason(number - reward)}"
    return None


def _named(world: World, agent: int) -> str:
    return world.config.agent_name(agent).replace("_", " ").capitalize()


def _reason(difference: float) -> str:
    """Say what a wrong reward has too much or too little of."""
    parts = {
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
    for part, text in parts.items():
        if abs(difference - part) < 1e-3:
            return text
    return "not yet. Add up the four rows of the table for this agent alone."


# 2.3: caught at once, or surviving.


def _mistake_in_steps(answer: object) -> str | None:
    if isinstance(answer, bool) or not isinstance(answer, int | np.integer):
        return f"Expected a whole number of steps, got {type(answer).__name__}."
    if answer == 201:
        return "After 201 steps both totals are equal. It has to be worse."
    if answer in (200, 199):
        return "An evader that is caught in its first step pays for this step, too."
    if answer < 202:
        return f"After {answer} steps its total is {-0.05 * answer:.2f}. Compare that with -10.05."
    if answer > 202:
        return "There is a smaller number."
    return None


# 2.4: a resolver that judges all at once.

Resolver = Callable[[list[Cell], list[Cell]], object]


def true_cells(cells: list[Cell], targets: list[Cell], side: int) -> list[Cell]:
    """Return the cells of a pack after a step under -SB.

    Parameters
    ----------
    cells, targets : list of (int, int)
        Where the pursuers stand, and which cells they mean to enter; none leaves the square.
    side : int
        Rows and columns of the square.

    Returns
    -------
    list of (int, int)
        Where they stand then.
    """
    world = pack(cells, side)
    world.step([*actions_to(cells, targets), Action.STAY])
    return [(row, col) for row, col in world.positions[:-1].tolist()]


def _situations() -> list[tuple[list[Cell], list[Cell]]]:
    rng = np.random.default_rng(2)
    row = [(0, 0), (0, 1), (0, 2)]
    first: list[tuple[list[Cell], list[Cell]]] = [
        ([(0, 0), (0, 2)], [(0, 1), (0, 1)]),
        ([(0, 0), (0, 1)], [(0, 1), (0, 0)]),
        (row, [(0, 1), (0, 2), (0, 3)]),
        (row, [(0, 1), (0, 2), (0, 2)]),
        ([*row, (1, 3)], [(0, 1), (0, 2), (0, 3), (0, 3)]),
    ]
    return first + [random_pack(rng, SIDE, count) for count in range(2, 15) for _ in range(8)]


def _mistake_in_resolver(answer: object) -> str | None:
    if not callable(answer):
        return NO_FUNCTION
    for cells, targets in _situations():
        result = answer(list(cells), list(targets))
        if result is None:
            return "Your function returns None. Does it end with `return`?"
        found = _as_cells(result)
        if found is None or len(found) != len(cells):
            return f"Your function has to return a list of {len(cells)} cells, got {result!r}."
        expected = true_cells(cells, targets, SIDE)
        if found != expected:
            return _difference(cells, targets, found, expected)
    return None


def _as_cells(result: object) -> list[Cell] | None:
    """Return a result as cells, or None if it does not hold any."""
    try:
        return [(int(row), int(col)) for row, col in result]  # type: ignore[attr-defined]
    except (TypeError, ValueError):
        return None


def _difference(
    cells: list[Cell], targets: list[Cell], found: list[Cell], expected: list[Cell]
) -> str:
    """Say in which situation a resolver is wrong, and about which agent."""
    agent = next(a for a in range(len(cells)) if found[a] != expected[a])
    does = "stays" if expected[agent] == cells[agent] else "moves"
    return (
        f"For cells {cells} and targets {targets}, agent {agent} {does}; your function puts it on "
        f"{found[agent]}."
    )


EXERCISES: Mapping[str, Exercise | Prediction] = {
    "2.a": Prediction(
        ("a", "b"),
        "b",
        "Pursuer 1 meets pursuer 2 and bounces. Then it stands in the way of pursuer 0.",
    ),
    "2.b": Prediction(
        ABC,
        "c",
        "The first one stays, so the cell behind it does not become free, and so on to the last.",
    ),
    "2.1": Exercise(
        _mistake_in_jam,
        "Pursuer 0 follows as soon as pursuer 1 can leave its cell.",
        (
            "Pursuer 0 depends on pursuer 1 alone. On which agent does pursuer 1 depend?",
            "Either pursuer 2 gives way, or pursuer 1 leaves in another direction.",
        ),
    ),
    "2.c": Prediction(
        ABC,
        "b",
        "Teammates share the responsibility: the one that stood there could have given way.",
    ),
    "2.2": Exercise(
        _mistake_in_rewards,
        "Two penalties for teammates, one for the wall, and one capture, which costs nobody a "
        "penalty.",
        (
            "Begin with -0.05 for everyone, and then look at each conflict.",
            "Under -O two teammates may share a cell. They are at fault all the same.",
            "The captured evader is gone after the step, and no other two adversaries are beside "
            "each other.",
        ),
    ),
    "2.3": Exercise(
        _mistake_in_steps,
        "202 steps cost 10.10. An episode may last 500 steps, so an evader that only counts "
        "rewards had better be caught. `mw.Rewards.published()` pays evaders +0.05 per step "
        "instead, as the published code of the paper does.",
        (
            "Write both totals down: one is a single number, the other depends on the steps.",
            "For which whole n is -0.05 n smaller than -10.05?",
        ),
    ),
    "2.d": Prediction(
        ABC,
        "c",
        "Where the front one is moved first, each cell is free in time. Where the last one is "
        "moved first, it finds its next cell still occupied.",
    ),
    "2.e": Prediction(
        ABC,
        "c",
        "A single pair that depends on the order is enough to change the result of a step, and "
        "among 30 agents there is nearly always one.",
    ),
    "2.f": Prediction(
        ABC,
        "b",
        "A random order favours no agent in the long run, but each single step still depends on "
        "the order. The numbers were replaced by dice.",
    ),
    "2.4": Exercise(
        _mistake_in_resolver,
        "It agrees with the engine in all situations. Nowhere did you ask which agent comes first.",
        (
            "An agent that bounces is an agent whose target is its own cell. Then look at the "
            "situation anew.",
            "Repeat: find all agents in conflict, and set the targets of all of them to their own "
            "cells. When can you stop?",
            "Stop when nothing changes any more. Then the targets are the new cells.",
        ),
    ),
}
"""Exercises and predictions, in the order of the notebook."""
