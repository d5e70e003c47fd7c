"""Small worlds of the first notebooks."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image

from matrixworld import Action, World
from matrixworld.explorer.scenes import drawn_world
from matrixworld.tutorial.boards import (
    Picture,
    actions_to,
    before_and_after,
    pack,
    plan,
    random_pack,
    target,
)

STAY, NORTH, EAST, SOUTH, WEST = list(Action)[:5]
DRAWING = ". . . . / . A . B / . . . ."


def world_of_three() -> World:
    return drawn_world("SB", DRAWING + " / . . . a")


def test_a_plan_leaves_the_world_as_it_is_and_shows_the_moves() -> None:
    world = world_of_three()
    before = world.positions.tolist()
    pictures = [plan(world, [action, STAY, STAY]).pixels.tobytes() for action in list(Action)[:5]]
    assert len(set(pictures)) == 5, "every move looks different"
    assert world.positions.tolist() == before
    assert world.steps == 0


def test_a_step_is_played_and_can_be_explained() -> None:
    world = world_of_three()
    picture = before_and_after(world, [EAST, WEST, STAY])
    assert world.steps == 1
    assert [str(each) for each in world.conflicts] == [
        "pursuer_0 and pursuer_1 both headed for (1, 2): both bounce"
    ]
    before = plan(world_of_three(), [EAST, WEST, STAY]).pixels
    assert np.array_equal(picture.pixels[:, : before.shape[1]], before)
    assert picture.pixels.shape[1] == 2 * before.shape[1]


def test_agents_that_are_gone_have_no_arrow() -> None:
    world = drawn_world("D", ". A . B / . . . . / C . . a")
    before_and_after(world, [EAST, WEST, STAY, STAY])
    assert world.alive.tolist() == [False, False, True, True]
    one, other = (plan(world, [move, move, STAY, STAY]).pixels for move in (NORTH, STAY))
    assert np.array_equal(one, other)


@pytest.mark.parametrize(
    ("actions", "message"),
    [
        ([EAST, WEST], r"actions: expected 3 \(agents\), got shape \(2,\)"),
        ([EAST, WEST, 5], "actions: expected 0 to 4, got 5"),
        ([EAST, WEST, -1], "actions: expected 0 to 4, got -1"),
    ],
)
def test_wrong_actions_play_no_step(actions: list[int], message: str) -> None:
    world = world_of_three()
    with pytest.raises(ValueError, match=message):
        before_and_after(world, actions)
    assert world.steps == 0


def test_notebooks_show_a_picture_as_png() -> None:
    pixels = np.zeros((3, 5, 3), np.uint8)
    with Image.open(io.BytesIO(Picture(pixels)._repr_png_())) as image:
        assert (image.format, image.size) == ("PNG", (5, 3))
    assert repr(Picture(pixels)) == "<Picture: 5 x 3 pixels>"


@pytest.mark.parametrize("count", [1, 7, 25])
def test_random_packs(count: int) -> None:
    cells, targets = random_pack(np.random.default_rng(count), 5, count)
    assert len(set(cells)) == count
    assert all(0 <= part < 5 for cell in [*cells, *targets] for part in cell)
    actions = actions_to(cells, targets)
    assert [target(cell, action) for cell, action in zip(cells, actions, strict=True)] == targets


def test_a_pack_stands_where_it_was_put() -> None:
    world = pack([(0, 0), (2, 1)], 3)
    assert world.positions.tolist() == [[0, 0], [2, 1], [0, 4]]
    assert world.map[:, 3].all()
    assert not world.map[:, :3].any()
