"""Exercises of the notebook "Who may stand where?"."""

from __future__ import annotations

from dataclasses import fields
from operator import index
from typing import Any

from course.boards import Cell, Situation, after_step, pack, situations
from course.checks import Check, FormError, Kind, actions, function, value
from matrixworld.explorer.playground import drawn_world
from matrixworld.world.rules import Action, Capture, Interaction, Outcome, Rules

# 1.1: a way through a maze.

MAZE = "A . . # . / . # . # . / . # . . . / . . # # a"
SHORTEST = 7
"""Moves from the pursuer to the evader there."""


def _mistake_in_way(way: list[Action]) -> str | None:
    world = drawn_world("O", MAZE)
    for number, action in enumerate(way, 1):
        world.step([action, Action.STAY], explain=True)
        if world.terminated:
            return None
        if world.conflicts:
            return f"Move {number} ({action.name}) runs into an obstacle or the border."
    row, col = world.positions[0].tolist()
    return f"After {SHORTEST} moves the pursuer stands on ({row}, {col}), the evader on (3, 4)."


# 1.2: four pursuers in a room of four cells.

ROOM = ((0, 0), (0, 1), (1, 0), (1, 1))


def _mistake_in_room(moves: list[Action]) -> str | None:
    world = pack(ROOM, 2)
    world.step([*moves, Action.STAY], explain=True)
    if world.conflicts:
        return f"This happens: {world.conflicts[0]}."
    stayed = [i for i, cell in enumerate(ROOM) if tuple(world.positions[i]) == cell]
    if stayed:
        return f"Nobody collides, and pursuer {stayed[0]} did not move. All four shall move."
    return None


# 1.3: rules of one's own.

BUMPER_CARS = Rules(
    Interaction.SWARM_TURNS,
    obstacle=Outcome.BOUNCE,
    teammate=Outcome.BOUNCE,
    evader=Outcome.BOUNCE,
    pursuer=Outcome.BOUNCE,
    capture=Capture.SURROUND,
)


def _mistake_in_rules(answer: Any) -> str | None:
    if not isinstance(answer, Rules):
        return f"Expected mw.Rules(...), got {type(answer).__name__}."
    names = [field.name for field in fields(Rules)]
    wrong = [name for name in names if getattr(answer, name) != getattr(BUMPER_CARS, name)]
    return f"Not as described: {', '.join(wrong)}." if wrong else None


# 1.4: conflicts found by the student's own function.


def _conflicts(cells: list[Cell], targets: list[Cell]) -> set[int]:
    """Return the pursuers in a vertex or an edge conflict, as the engine finds them.

    They stand on 4 x 4 cells and mean to enter targets, none of which is outside.
    """
    # Teammates that share cells hold each other nowhere, so there are no chains.
    world = after_step((cells, targets), 4, "S")
    return {agent for conflict in world.conflicts for agent in conflict.agents}


DRAWN: list[Situation] = [
    ([(0, 0), (0, 2)], [(0, 1), (0, 1)]),
    ([(0, 0), (0, 1)], [(0, 1), (0, 1)]),
    ([(0, 0), (0, 1)], [(0, 1), (0, 0)]),
    ([(0, 0), (0, 1)], [(0, 1), (0, 2)]),
    ([(0, 0), (0, 2), (1, 1), (3, 3)], [(0, 1), (0, 1), (0, 1), (3, 2)]),
]


def _agents(value: Any) -> set[int]:
    try:
        return {index(each) for each in value}
    except TypeError:
        raise FormError(f"got {value!r}") from None


def _difference(found: set[int], expected: set[int], cells: list[Cell], targets: list[Cell]) -> str:
    missed, wrong = sorted(expected - found), sorted(found - expected)
    told = (
        f"agent {missed[0]} is in a conflict, and your function does not find it"
        if missed
        else f"agent {wrong[0]} is in no conflict, and your function returns it"
    )
    return f"For cells {cells} and targets {targets}, {told}."


in_conflict = function(
    Kind("a set of agents' numbers", _agents),
    _conflicts,
    lambda: situations(DRAWN, seed=20, most=10),
    otherwise=_difference,
)


CHECKS: dict[str, Check] = {
    "1.1": value(actions(SHORTEST), _mistake_in_way),
    "1.2": value(actions(len(ROOM)), _mistake_in_room),
    "1.3": _mistake_in_rules,
    "1.4": in_conflict,
}
