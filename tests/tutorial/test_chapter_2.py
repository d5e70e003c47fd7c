"""Notebook 2: what its text says is true."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import Action
from matrixworld.explorer.scenes import drawn_world
from matrixworld.tutorial import check
from matrixworld.tutorial.boards import random_pack
from matrixworld.tutorial.chapter_2 import JAM, JAM_ACTIONS, MARKET, true_cells
from notebooks import NOTEBOOKS, cells
from student_functions import by_index

STAY, NORTH, EAST, SOUTH, WEST = list(Action)[:5]


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


def test_rewards_of_the_market_are_sums_of_the_rows_of_the_table() -> None:
    world = drawn_world("O", MARKET)
    rewards = world.step([EAST, WEST, EAST, STAY, EAST])
    assert rewards.tolist() == pytest.approx([-12.05, -12.05, 9.95, -10.05, -12.05])


def test_rewards_of_a_captured_and_of_a_surviving_evader() -> None:
    world = mw.World("O", rows=1, cols=9, n_pursuers=1, n_evaders=2)
    world.reset(0, pursuers=[[0, 0]], evaders=[[0, 1], [0, 8]])
    captured, survivor = world.step([EAST, STAY, STAY])[1:]
    assert captured == pytest.approx(-10.05)
    assert 201 * survivor == pytest.approx(captured, abs=1e-4)
    assert check("2.3", np.int64(202)).right is True


def test_outcomes_of_the_first_predictions() -> None:
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


@pytest.mark.parametrize("seed", range(3))
def test_renumbering_changes_most_steps_by_index_and_none_of_the_world(seed: int) -> None:
    """2.e and 2.f, in crowds that the notebook does not draw."""
    rng = np.random.default_rng([7, seed])
    changed = {by_index: 0, at_once_on_ten: 0}
    for _ in range(60):
        here, there = random_pack(rng, 10, 30)
        order = rng.permutation(30)
        for resolver in changed:
            result = resolver(here, there)
            again = resolver([here[a] for a in order], [there[a] for a in order])
            changed[resolver] += again != [result[a] for a in order]
    assert changed[by_index] > 40
    assert changed[at_once_on_ten] == 0


def at_once_on_ten(cells: list, targets: list) -> list:
    return true_cells(cells, targets, 10)


def test_the_text_says_what_the_outputs_show() -> None:
    """Under index order low numbers win contests and high numbers queues; in the world, neither."""
    text = printed("share that enters")
    parts = text.split("all_at_once")
    rates = [
        {line[2:39].strip(): line[40:45] for line in part.splitlines()[1:] if line.strip()}
        for part in parts
    ]
    by_number, world = rates
    assert by_number["contest, higher number than the rival"] == "0.000"
    assert float(by_number["contest, lower number than the rival"]) > 0.9
    assert by_number["queue, lower number than the leader"] == "0.000"
    assert float(by_number["queue, higher number than the leader"]) > 0.5
    assert {value for name, value in world.items() if "contest" in name} == {"0.000"}
    assert "all at once: 0 of 3000 steps change" in printed("all at once: ")


def printed(part: str) -> str:
    """Return what the cell of the kept notebook printed that printed this text."""
    outputs = [
        "".join("".join(output.get("text", "")) for output in cell["outputs"])
        for cell in cells(NOTEBOOKS[1], "code")
    ]
    return next(text for text in outputs if part in text)
