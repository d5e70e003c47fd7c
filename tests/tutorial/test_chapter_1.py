"""Exercises of "Who may stand where?": wrong answers are told apart, and numbers are true."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import Action
from matrixworld.explorer.scenes import drawn_world
from matrixworld.tutorial import check, hint
from matrixworld.tutorial.boards import pack, random_pack
from matrixworld.tutorial.chapter_1 import BUMPER_CARS, MAZE, SHORTEST, true_conflicts

STAY, NORTH, EAST, SOUTH, WEST = list(Action)[:5]


def reply(name: str, answer: Any) -> str:
    """Return the reply to an answer that is wrong."""
    feedback = check(name, answer)
    assert feedback.right is False
    return feedback.text


# 1.1


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        ([SOUTH, SOUTH, SOUTH, EAST, EAST, EAST, EAST], "Move 5 (EAST) runs into an obstacle"),
        ([NORTH, EAST, EAST, SOUTH, SOUTH, EAST, EAST], "Move 1 (NORTH) runs into an obstacle"),
        ([EAST, EAST, SOUTH, SOUTH, EAST, EAST, STAY], "the pursuer stands on (2, 4)"),
        ([EAST] * 8, "Expected a list of 7 actions such as Action.EAST, got 8 of them"),
        ("EESSEES", "got str"),
        (7, "got int"),
        ([EAST, EAST, SOUTH, SOUTH, EAST, EAST, 5], "actions are 0 (stay) to 4 (west)"),
        (["EAST"] * 7, "one entry is no action"),
    ],
)
def test_wrong_ways(answer: Any, expected: str) -> None:
    assert expected in reply("1.1", answer)


def test_there_is_one_shortest_way() -> None:
    """All ways of at most 7 moves are walked."""
    walls = np.pad(drawn_world("O", MAZE).map, 1, constant_values=True)
    ways = np.zeros(walls.shape, int)
    ways[1, 1] = 1
    for moves in range(1, SHORTEST + 1):
        ways = sum(np.roll(ways, by, axis) for by in (1, -1) for axis in (0, 1)) * ~walls
        assert bool(ways[4, 5]) is (moves == SHORTEST)
    assert ways[4, 5] == 1


def test_arrays_of_actions_are_answers_too() -> None:
    assert check("1.1", np.array([2, 2, 3, 3, 2, 2, 3])).right is True


# 1.2


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        ([EAST, WEST, EAST, WEST], "meant to swap"),
        ([EAST, STAY, NORTH, STAY], "both headed for (0, 1)"),
        ([WEST, EAST, WEST, EAST], "ran into the obstacle or border"),
        ([STAY] * 4, "pursuer 0 did not move"),
        ([EAST, SOUTH, NORTH, WEST, STAY], "a list of 4 actions such as Action.EAST, got 5"),
        (None, "got NoneType"),
    ],
)
def test_wrong_moves_in_the_room(answer: Any, expected: str) -> None:
    text = reply("1.2", answer)
    assert expected in text
    assert "circle" not in text


def test_both_directions_of_the_circle_are_right() -> None:
    assert check("1.2", [EAST, SOUTH, NORTH, WEST]).right is True
    assert check("1.2", [SOUTH, WEST, EAST, NORTH]).right is True


# 1.3


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({"interaction": mw.Interaction.SIMULTANEOUS}, "described: interaction."),
        ({"interaction": mw.Interaction.AGENT_TURNS}, "described: interaction."),
        ({"pursuer": mw.Outcome.REACH, "captured_disappear": True}, "pursuer, captured_disappear."),
        ({"capture": mw.Capture.OCCUPATION}, "described: capture."),
    ],
)
def test_wrong_rules(changes: dict[str, Any], expected: str) -> None:
    text = reply("1.3", dataclasses.replace(BUMPER_CARS, **changes))
    assert expected in text
    assert "BOUNCE" not in text
    assert "SURROUND" not in text


@pytest.mark.parametrize("answer", ["SB", mw.VARIANTS, mw.Rules, None])
def test_rules_of_another_type(answer: Any) -> None:
    assert "Expected mw.Rules(...), got" in reply("1.3", answer)


# 1.4


def pairs(cells: list, targets: list, *, vertex: bool = True, edge: bool = True) -> set[int]:
    """Return agents in conflict, as an independent function finds them."""
    return {
        a
        for a, (here, there) in enumerate(zip(cells, targets, strict=True))
        if (vertex and targets.count(there) > 1)
        or (edge and here != there and (there, here) in zip(cells, targets, strict=True))
    }


def without_stayers(cells: list, targets: list) -> set[int]:
    return {a for a in pairs(cells, targets) if cells[a] != targets[a]}


def occupied(cells: list, targets: list) -> set[int]:
    """Take every target that is occupied for a conflict, also if its agent leaves."""
    return {a for a, there in enumerate(targets) if there in cells and there != cells[a]}


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        (lambda cells, targets: pairs(cells, targets, edge=False), "does not find it"),
        (lambda cells, targets: pairs(cells, targets, vertex=False), "does not find it"),
        (without_stayers, "agent 1 is in a conflict"),
        (lambda cells, targets: pairs(cells, targets) | occupied(cells, targets), "no conflict"),
        (lambda cells, targets: set(), "agent 0 is in a conflict"),
        (lambda cells, targets: None, "end with `return`?"),
        (lambda cells, targets: [(0, 1)], "a set of agents' numbers, got [(0, 1)]"),
        (lambda cells, targets: True, "a set of agents' numbers, got True"),
        ({0, 1}, "the answer is your function itself"),
    ],
)
def test_wrong_functions(answer: Any, expected: str) -> None:
    assert expected in reply("1.4", answer)


def test_functions_may_return_lists_and_change_their_arguments() -> None:
    def careless(cells: list, targets: list) -> list[int]:
        found = sorted(pairs(cells, targets))
        cells.clear()
        return found

    assert check("1.4", careless).right is True


def test_the_errors_of_a_student_s_function_are_shown() -> None:
    with pytest.raises(ZeroDivisionError):
        check("1.4", lambda cells, targets: 1 / 0)


def test_the_engine_and_an_independent_function_find_the_same_conflicts() -> None:
    rng = np.random.default_rng(1)
    for _ in range(200):
        cells, targets = random_pack(rng, 5, 9)
        assert true_conflicts(cells, targets, 5) == pairs(cells, targets)


# Predictions: what the notebook shows.


def test_outcomes_of_the_predictions() -> None:
    world = drawn_world("SB", ". . . . . / . A . B . / . . . . . / . . a . .")
    world.step([EAST, WEST, STAY])
    assert world.positions[:2].tolist() == [[1, 1], [1, 3]]  # 1.a
    world = drawn_world("SB", ". . . . . . / A B C . . . / . . . . . a")
    world.step([EAST, EAST, EAST, STAY])
    assert world.positions[:3].tolist() == [[1, 1], [1, 2], [1, 3]]  # 1.b
    world = drawn_world("S", ". . . . . / . A a . . / . . . . .")
    world.step([EAST, STAY])
    assert world.positions.tolist() == [[1, 1], [1, 2]]  # 1.c
    for name, captured in (("O", False), ("TO", True)):
        world = drawn_world(name, "# # # # # # / A a . . . . / # # # # # #")
        world.step([EAST, EAST])
        assert bool(world.captured[0]) is captured  # 1.d


@pytest.mark.parametrize("first", [0, 1000, 2000])
def test_fragile_chasers_catch_less_in_other_worlds_too(first: int) -> None:
    """1.e, with the number of worlds of a quick run."""
    rules = mw.VARIANTS["O"], dataclasses.replace(mw.VARIANTS["O"], teammate=mw.Outcome.DISAPPEAR)
    matches = mw.Matches.of(0, 0, np.arange(first, first + 100))
    usual, fragile = (
        mw.rollout(
            mw.WorldConfig(each, rows=16, cols=16, n_pursuers=4, n_evaders=8, max_steps=100),
            "chaser", "fleer", matches,
        )
        for each in rules
    )  # fmt: skip
    assert fragile.capture_rate.mean() < 0.5 * usual.capture_rate.mean()
    assert fragile.pursuer_survivors.mean() < 2 < usual.pursuer_survivors.mean()


@pytest.mark.parametrize("agents", [1, 16])
def test_packs_have_no_room_outside_their_square(agents: int) -> None:
    world = pack([divmod(place, 4) for place in range(agents)], 4)
    for _ in range(20):
        world.step([*np.random.default_rng(0).integers(5, size=agents), WEST])
    assert (world.positions[:-1] < 4).all()
    assert world.positions[-1].tolist() == [0, 5]


def test_hints_go_from_small_to_large() -> None:
    first = hint("1.4").text
    assert first.startswith("Hint 1 of 3: ")
    assert hint("1.4").text != first
