"""What an agent sees, and the whole world as channels, drawn by hand."""

from __future__ import annotations

from typing import Any

import numpy as np

from drawing import Play, Start, begin, case, rules


def channels(*pictures: str) -> np.ndarray:
    """``(3, rows, cols)`` of the channels evaders, pursuers, obstacles, drawn with ``1``."""
    rows = [picture.replace("/", " ").split() for picture in pictures]
    return np.array([[[mark == "1" for mark in row] for row in drawn] for drawn in rows], np.uint8)


def played(start: Start, rules_: Any, before: str, *actions: list[int], fov: int = 3) -> Any:
    world, _ = begin(start, case("", rules_, before, Play("", ""), fov=fov))
    for chosen in actions:
        world.step(chosen)
    return world


def test_a_view_is_centred_and_leaves_the_agent_itself_out(start: Start) -> None:
    views = played(start, "S", "A . # / . a . / . . B").views()
    assert views.shape == (3, 3, 3, 3)
    assert views.dtype == np.uint8
    evader = channels(".../.../...", "1../.../..1", "..1/.../...")
    np.testing.assert_array_equal(views[2], evader)


def test_outside_the_grid_is_obstacle(start: Start) -> None:
    views = played(start, "S", "A . # / . a . / . . B").views()
    pursuer = channels(".../.../..1", ".../.../...", "111/1../1..")
    np.testing.assert_array_equal(views[0], pursuer)


def test_a_view_larger_than_the_world(start: Start) -> None:
    views = played(start, "S", "A a", fov=5).views()
    pursuer = channels(
        "...../...../...1./...../.....",
        "...../...../...../...../.....",
        "11111/11111/11..1/11111/11111",
    )
    evader = channels(
        "...../...../...../...../.....",
        "...../...../.1.../...../.....",
        "11111/11111/1..11/11111/11111",
    )
    np.testing.assert_array_equal(views, [pursuer, evader])


def test_a_view_of_one_cell(start: Start) -> None:
    views = played(start, "S", "A a", fov=1).views()
    np.testing.assert_array_equal(views, np.zeros((2, 3, 1, 1)))


def test_a_teammate_on_the_same_cell_is_drawn(start: Start) -> None:
    views = played(start, "S", ". . # / A B . / a . .", [2, 0, 0]).views()
    both = channels(".../.../1..", ".../.1./...", "..1/.../...")
    np.testing.assert_array_equal(views[:2], [both, both])


def test_an_adversary_on_the_same_cell_is_drawn(start: Start) -> None:
    views = played(start, "R", ". . # / A a . / b . .", [2, 0, 0]).views()
    np.testing.assert_array_equal(views[0], channels(".../.1./1..", ".../.../...", "..1/.../..."))
    np.testing.assert_array_equal(views[1], channels(".../.../1..", ".../.1./...", "..1/.../..."))


def test_agents_on_the_cell_of_an_obstacle(start: Start) -> None:
    views = played(start, rules(obstacle="R"), "A # . / . . . / . a .", [2, 0], fov=5).views()
    pursuer = channels(
        "...../...../...../...../..1..",
        "...../...../...../...../.....",
        "11111/11111/1.1.1/1...1/1...1",
    )
    np.testing.assert_array_equal(views[0], pursuer)


def test_the_gone_see_nothing_and_are_not_seen(start: Start) -> None:
    views = played(start, "O", "A a . b / . . . .", [2, 0, 0]).views()
    np.testing.assert_array_equal(views[1], np.zeros((3, 3, 3)))
    np.testing.assert_array_equal(views[0], channels(".../.../...", ".../.../...", "111/.../..."))


def test_the_whole_world(start: Start) -> None:
    world = played(start, "R", "A a # / b . B", [2, 0, 0, 0])
    expected = channels(".1./1..", ".1./..1", "..1/...")
    np.testing.assert_array_equal(world.state(), expected)
    assert world.state().dtype == np.uint8
