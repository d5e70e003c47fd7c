"""Exercises of the notebook "Who may stand where?"."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

from course.boards import SITUATIONS, Cell, after_step, pack
from course.checks import Mistake, actions, array, comparison, whole
from matrixworld import Action, Capture, Interaction, Outcome, Rules
from matrixworld.explorer.playground import drawn_world

MAZE = "A . . # . / . # . # . / . # . . . / . . # # a"
SHORTEST = 7
"""Moves from the pursuer to the evader there."""


def exercise_1(answer: Any) -> None:
    """Find a way through a maze."""
    world = drawn_world("O", MAZE)
    for number, action in enumerate(actions(answer, SHORTEST), 1):
        world.step([action, Action.STAY], explain=True)
        if world.terminated:
            return
        if world.conflicts:
            raise Mistake(f"Move {number} ({action.name}) runs into an obstacle or the border.")
    row, col = world.positions[0].tolist()
    raise Mistake(
        f"After {SHORTEST} moves the pursuer stands on ({row}, {col}), the evader on (3, 4)."
    )


ROOM = ((0, 0), (0, 1), (1, 0), (1, 1))


def exercise_2(answer: Any) -> None:
    """Let four pursuers in a room of four cells all move."""
    world = pack(ROOM, 2)
    world.step([*actions(answer, len(ROOM)), Action.STAY], explain=True)
    if world.conflicts:
        raise Mistake(f"This happens: {world.conflicts[0]}.")
    for pursuer, cell in enumerate(ROOM):
        if tuple(world.positions[pursuer]) == cell:
            raise Mistake(
                f"Nobody collides, and pursuer {pursuer} did not move. All four shall move."
            )


BUMPER_CARS = Rules(
    Interaction.AGENT_TURNS,
    obstacle=Outcome.BOUNCE,
    teammate=Outcome.BOUNCE,
    evader=Outcome.BOUNCE,
    pursuer=Outcome.BOUNCE,
    capture=Capture.SURROUND,
)


def exercise_3(answer: Any) -> None:
    """Write down rules that are described in words."""
    if not isinstance(answer, Rules):
        raise Mistake(f"Expected mw.Rules(...), got {type(answer).__name__}.")
    names = [field.name for field in fields(Rules)]
    wrong = [name for name in names if getattr(answer, name) != getattr(BUMPER_CARS, name)]
    if wrong:
        raise Mistake(f"Not as described: {', '.join(wrong)}.")


def _conflicts(cells: list[Cell], targets: list[Cell]) -> set[int]:
    """Return the pursuers in a vertex or an edge conflict, as the engine finds them."""
    # Teammates that share cells hold each other nowhere, so there are no chains.
    world = after_step((cells, targets), 4, "S")
    return {agent for conflict in world.conflicts for agent in conflict.agents}


def _agents(value: Any) -> set[int]:
    return {whole(each) for each in array(value, "a set of agents' numbers", ...)}


def _difference(found: set[int], expected: set[int], cells: list[Cell], targets: list[Cell]) -> str:
    agent = min(expected - found or found - expected)
    told = "a conflict, and your function does not find it"
    if agent in found:
        told = "no conflict, and your function returns it"
    return f"For cells {cells} and targets {targets}, agent {agent} is in {told}."


exercise_4 = comparison(_conflicts, SITUATIONS, _agents, otherwise=_difference)
"""Find conflicts."""
