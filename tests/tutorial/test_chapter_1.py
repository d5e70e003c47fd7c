"""Notebook 1: what its text says is true."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import Action
from matrixworld.explorer.scenes import drawn_world
from matrixworld.tutorial.boards import pack, random_pack
from matrixworld.tutorial.chapter_1 import MAZE, SHORTEST, true_conflicts
from student_functions import conflicts

STAY, NORTH, EAST, SOUTH, WEST = list(Action)[:5]


def test_there_is_one_shortest_way() -> None:
    """All ways of at most 7 moves are walked."""
    walls = np.pad(drawn_world("O", MAZE).map, 1, constant_values=True)
    ways = np.zeros(walls.shape, int)
    ways[1, 1] = 1
    for moves in range(1, SHORTEST + 1):
        ways = sum(np.roll(ways, by, axis) for by in (1, -1) for axis in (0, 1)) * ~walls
        assert bool(ways[4, 5]) is (moves == SHORTEST)
    assert ways[4, 5] == 1


def test_the_engine_and_an_independent_function_find_the_same_conflicts() -> None:
    rng = np.random.default_rng(1)
    for _ in range(200):
        cells, targets = random_pack(rng, 5, 9)
        assert true_conflicts(cells, targets, 5) == conflicts(cells, targets)


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
