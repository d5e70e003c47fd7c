"""Notebooks 1 and 2: what their texts say is true, and their small worlds do what they say."""

import dataclasses
from functools import partial
from itertools import product

import numpy as np

import matrixworld as mw
from course import check
from course.boards import random_pack
from course.chapter_1 import MAZE, SHORTEST
from course.chapter_2 import JAM, JAM_ACTIONS, true_cells
from matrixworld import Action
from matrixworld.explorer.playground import drawn_world
from student_functions import by_index

STAY, NORTH, EAST, SOUTH, WEST = list(Action)[:5]


# ---- Notebook 1 ----------------------------------------------------------------------------------


def test_there_is_one_shortest_way() -> None:
    # So that `np.roll` leads nobody round the border.
    walls = np.pad(drawn_world("O", MAZE).map, 1, constant_values=True)
    ways = np.zeros(walls.shape, int)
    ways[1, 1] = 1
    for moves in range(1, SHORTEST + 1):
        # Each way goes on in four directions.
        ways = sum(np.roll(ways, by, axis) for by in (1, -1) for axis in (0, 1)) * ~walls
        assert bool(ways[4, 5]) is (moves == SHORTEST)
    assert ways[4, 5] == 1


def test_outcomes_of_the_predictions_of_notebook_1() -> None:
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


def test_fragile_chasers_catch_less_in_other_worlds_too() -> None:
    """1.e, with the number of worlds of a quick run."""
    rules = mw.VARIANTS["O"], dataclasses.replace(mw.VARIANTS["O"], teammate=mw.Outcome.DISAPPEAR)
    matches = mw.Matches.of(0, 0, np.arange(1000, 1100))
    usual, fragile = (
        mw.rollout(
            mw.WorldConfig(each, rows=16, cols=16, n_pursuers=4, n_evaders=8, max_steps=100),
            "chaser", "fleer", matches,
        )
        for each in rules
    )  # fmt: skip
    assert fragile.capture_rate.mean() < 0.5 * usual.capture_rate.mean()
    assert fragile.pursuer_survivors.mean() < 2 < usual.pursuer_survivors.mean()


# ---- Notebook 2 ----------------------------------------------------------------------------------


def test_every_single_change_that_frees_pursuer_0_is_right() -> None:
    """The engine decides; the answers are those that the solution sheet names."""
    free = []
    for agent, action in product(range(1, 5), list(Action)[:5]):
        actions = list(JAM_ACTIONS)
        if actions[agent] == action:
            continue
        actions[agent] = action
        world = drawn_world("SB", JAM)
        world.step(actions)
        right = world.positions[0].tolist() == [1, 1]
        assert check("2.1", actions).right is right
        if right:
            free.append((agent, action))
    assert free == [(1, NORTH), (1, SOUTH), (2, STAY), (2, NORTH), (2, EAST), (2, SOUTH)]


def test_outcomes_of_the_first_predictions_of_notebook_2() -> None:
    world = drawn_world("SB", JAM)
    world.step(JAM_ACTIONS, explain=True)
    assert world.positions[0].tolist() == [1, 0]  # 2.a
    assert [c.form for c in world.conflicts if 0 in c.agents] == ["chain"]
    world = drawn_world("SB", "a . . . . . . . . . / . A B C D E F G H # / . . . . . . . . . .")
    world.step([*[EAST] * 8, STAY])
    assert world.fault[:8].any(axis=1).all()  # 2.b
    world = drawn_world("SB", ". . . . / A B . . / . . . a")
    world.step([EAST, STAY, STAY])
    assert world.fault.any(axis=1).tolist() == [True, True, False]  # 2.c


def test_renumbering_changes_most_steps_by_index_and_none_of_the_world() -> None:
    """2.e and 2.f, in crowds that the notebook does not draw."""
    rng = np.random.default_rng(7)
    at_once = partial(true_cells, side=10)
    changed = {by_index: 0, at_once: 0}
    for _ in range(60):
        here, there = random_pack(rng, 10, 30)  # dense: most agents have a neighbour to depend on
        order = rng.permutation(30)
        for resolver in changed:
            result = resolver(here, there)
            again = resolver([here[a] for a in order], [there[a] for a in order])
            changed[resolver] += again != [result[a] for a in order]
    assert changed[by_index] > 40  # of 60
    assert changed[at_once] == 0
