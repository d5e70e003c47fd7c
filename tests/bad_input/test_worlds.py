"""Bad calls of a world or a batch raise, state what was expected, and change nothing."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from refusals import CONFIG, assert_refuses, kind, table, value

HUGE = np.array([2**64 - 1, 0, 0], np.uint64)
WORLD_CALLS = [
    value("too few actions", lambda w: w.step([0, 0]), "shape (3,) | got (2,)"),
    value("a table of actions", lambda w: w.step([[0, 0, 0]]), "shape (3,) | (1, 3)"),
    value("one action", lambda w: w.step(0), "shape (3,) | got ()"),
    kind("float actions", lambda w: w.step([0.0, 1, 2]), "integers | got dtype float64"),
    kind("bool actions", lambda w: w.step([True] * 3), "integers | got dtype bool"),
    kind("no actions", lambda w: w.step(None), "integers | got dtype object"),
    value("a negative action", lambda w: w.step([0, -1, 0]), "0 to 4 | got -1 (world 0, agent 1)"),
    value("too large an action", lambda w: w.step([0, 0, 5]), "0 to 4 | got 5 (world 0, agent 2)"),
    value("an action beyond bytes", lambda w: w.step([256, 0, 0]), "0 to 4 | got 256"),
    value("an action beyond 64 bits", lambda w: w.step(HUGE), "0 to 4 | got 9223372036854775807"),
    value("a negative seed", lambda w: w.reset(-1), "0 to 18446744073709551615 | got -1"),
    value("a huge seed", lambda w: w.reset(2**64), "0 to 1844 | got 18446744073709551616"),
    kind("a float seed", lambda w: w.reset(1.0), "an integer | got 1.0"),
    kind("a bool seed", lambda w: w.reset(True), "an integer | got True"),
    value("a negative episode", lambda w: w.reset(0, episode=-1), "0 to 1844 | got -1"),
    kind("a text as episode", lambda w: w.reset(0, episode="1"), "an integer | got '1'"),
    value("an episode alone", lambda w: w.reset(episode=3), "a seed with it | got episode 3"),
    value(
        "too few positions",
        lambda w: w.reset(pursuers=[[0, 0]]),
        "shape (2, 2) | pursuers: expected shape (2, 2), got (1, 2)",
    ),
    value(
        "too many positions",
        lambda w: w.reset(evaders=[[0, 0], [1, 1]]),
        "shape (1, 2) | evaders: expected shape (1, 2), got (2, 2)",
    ),
    value("flat positions", lambda w: w.reset(evaders=[0, 1]), "shape (1, 2) | got (2,)"),
    value("three numbers", lambda w: w.reset(evaders=[[0, 1, 2]]), "shape (1, 2) | (1, 3)"),
    kind("float positions", lambda w: w.reset(evaders=[[0.5, 1]]), "integers | float64"),
    kind("no positions", lambda w: w.reset(pursuers=[]), "integers | got dtype float64"),
    value(
        "overlapping teammates",
        lambda w: w.reset(pursuers=[[1, 2], [1, 2]]),
        "distinct cells | two agents on (1, 2)",
    ),
    value(
        "overlapping adversaries",
        lambda w: w.reset(pursuers=[[0, 0], [2, 3]], evaders=[[2, 3]]),
        "distinct cells | two agents on (2, 3)",
    ),
    value(
        "below the grid", lambda w: w.reset(evaders=[[3, 0]]), "a cell of the 3 x 4 grid | (3, 0)"
    ),
    value(
        "left of the grid", lambda w: w.reset(evaders=[[0, -1]]), "a cell of the 3 x 4 | (0, -1)"
    ),
    value(
        "far away", lambda w: w.reset(evaders=[[2**40, 0]]), "a cell of the 3 x 4 | (2147483647, 0)"
    ),
    value(
        "on an obstacle",
        lambda w: w.reset(evaders=[[1, 1]], obstacles=["....", ".#..", "...."]),
        "a free cell | position (1, 1)",
    ),
    value(
        "a map of another size",
        lambda w: w.reset(obstacles=["...", "..."]),
        "shape (3, 4) | got (2, 3)",
    ),
    value(
        "a map without room",
        lambda w: w.reset(obstacles=["####", "####", "##.."]),
        "at least 3 free cells | got 2",
    ),
    kind(
        "a map of numbers",
        lambda w: w.reset(obstacles=np.zeros((3, 4), int)),
        "dtype bool | got int64",
    ),
    kind("a number as a map", lambda w: w.reset(obstacles=0.5), "a bool array | got 0.5"),
]


def everything(world: mw.World) -> dict[str, Any]:
    return world.read(*mw.array_specs(world.config)) | {"conflicts": world.conflicts}


@table(WORLD_CALLS)
def test_a_world_refuses_and_stays_as_it_was(call: Any, error: type[Exception], says: str) -> None:
    world, twin = mw.World(CONFIG), mw.World(CONFIG)
    for each in (world, twin):
        each.reset(pursuers=[[0, 0], [0, 1]], evaders=[[2, 3]])
        each.step([mw.Action.EAST, mw.Action.WEST, mw.Action.EAST], explain=True)
    assert_refuses(lambda: call(world), error, says)
    for name, expected in everything(twin).items():
        np.testing.assert_array_equal(everything(world)[name], expected)
    for each in (world, twin):
        each.step([mw.Action.SOUTH, mw.Action.EAST, mw.Action.NORTH])
    np.testing.assert_array_equal(world.positions, twin.positions)
    world.reset()
    twin.reset()
    np.testing.assert_array_equal(world.positions, twin.positions)


def test_actions_of_gone_agents_are_ignored() -> None:
    world = mw.World("D", rows=3, cols=4, n_pursuers=2, n_evaders=2)
    world.reset(pursuers=[[0, 0], [2, 3]], evaders=[[0, 3], [2, 0]])
    world.step([mw.Action.NORTH, 0, mw.Action.NORTH, 0])
    assert world.alive.tolist() == [False, True, False, True]
    world.step([-1, 0, 10**9, 0])
    with pytest.raises(ValueError, match=r"got 9 \(world 0, agent 3\)"):
        world.step([-1, 0, -1, 9])


def test_diagonal_actions_need_a_diagonal_world() -> None:
    with pytest.raises(ValueError, match="expected 0 to 4, got 5"):
        mw.World(CONFIG).step([mw.Action.NORTHEAST, 0, 0])
    world = mw.World(CONFIG, diagonal=True)
    world.step([mw.Action.NORTHEAST, 0, 0])
    with pytest.raises(ValueError, match="expected 0 to 8, got 9"):
        world.step([9, 0, 0])


# ---- Batches ---------------------------------------------------------------------------------


def with_buffer(name: str, array: Any) -> mw.Batch:
    return mw.Batch(2, CONFIG, buffers={name: array})


def read_only() -> np.ndarray:
    array = np.zeros((2, 3), np.float32)
    array.flags.writeable = False
    return array


BATCHES = [
    value("no worlds", lambda: mw.Batch(0, CONFIG), "at least 1 | got 0"),
    value("fewer than no worlds", lambda: mw.Batch(-2, CONFIG), "at least 1 | got -2"),
    kind("float worlds", lambda: mw.Batch(2.5, CONFIG), "an integer | got 2.5"),
    value("no threads", lambda: mw.Batch(2, CONFIG, threads=0), "1 to 1024 | got 0"),
    value("negative threads", lambda: mw.Batch(2, threads=-1), "1 to 1024 | got -1"),
    value("many threads", lambda: mw.Batch(2, threads=10**6), "1 to 1024 | got 1000000"),
    kind("float threads", lambda: mw.Batch(2, threads=1.0), "an integer | got 1.0"),
    kind("autoreset", lambda: mw.Batch(2, autoreset="no"), "a matrixworld.Autoreset | got 'no'"),
    kind("buffers", lambda: mw.Batch(2, buffers=[]), "a dict of arrays | got []"),
    value(
        "another name",
        lambda: with_buffer("reward", np.zeros((2, 3), np.float32)),
        "some of positions, last_positions, alive | got ['reward']",
    ),
    kind(
        "another dtype",
        lambda: with_buffer("rewards", np.zeros((2, 3))),
        "dtype float32 | rewards: expected dtype float32, got float64",
    ),
    kind(
        "numbers for bools",
        lambda: with_buffer("alive", np.zeros((2, 3), np.int32)),
        "dtype | alive: expected",
    ),
    kind(
        "another byte order",
        lambda: with_buffer("rewards", np.zeros((2, 3), ">f4")),
        "dtype float32 | got >f4",
    ),
    value(
        "another shape",
        lambda: with_buffer("positions", np.zeros((2, 4, 2), np.int32)),
        "shape (2, 3, 2) | positions: expected shape (2, 3, 2), got (2, 4, 2)",
    ),
    value(
        "views of another size",
        lambda: with_buffer("views", np.zeros((2, 3, 3, 11, 11), np.uint8)),
        "shape (2, 3, 3, 5, 5) | got (2, 3, 3, 11, 11)",
    ),
    value(
        "another layout",
        lambda: with_buffer("positions", np.zeros((2, 3, 4), np.int32)[:, :, ::2]),
        "a writeable C-contiguous array | positions",
    ),
    value(
        "columns first",
        lambda: with_buffer("rewards", np.zeros((2, 3), np.float32, order="F")),
        "a writeable C-contiguous array | rewards",
    ),
    value(
        "read only",
        lambda: with_buffer("rewards", read_only()),
        "a writeable C-contiguous array | rewards",
    ),
    kind("a list", lambda: with_buffer("steps", [0, 0]), "a NumPy array | got list"),
]


@table(BATCHES)
def test_batches(call: Any, error: type[Exception], says: str) -> None:
    assert_refuses(call, error, says)


ZEROS = np.zeros((2, 3), int)
BAD_ACTION = np.array([[0, 0, 0], [4, 5, 4]])
BATCH_CALLS = [
    value("actions of one world", lambda b: b.step(ZEROS[0]), "shape (2, 3) | got (3,)"),
    value("a world too many", lambda b: b.step(np.zeros((3, 3), int)), "shape (2, 3) | (3, 3)"),
    value("an agent too many", lambda b: b.step(np.zeros((2, 4), int)), "shape (2, 3) | (2, 4)"),
    kind("float actions", lambda b: b.step(ZEROS * 1.0), "integers | got dtype float64"),
    value("too large an action", lambda b: b.step(BAD_ACTION), "0 to 4 | got 5 (world 1, agent 1)"),
    value("too few seeds", lambda b: b.reset([1]), "shape (2,) | got (1,)"),
    value("too many seeds", lambda b: b.reset([1, 2, 3]), "shape (2,) | got (3,)"),
    value("a table of seeds", lambda b: b.reset([[1, 2]]), "shape (2,) | got (1, 2)"),
    value("a negative seed", lambda b: b.reset(-1), "0 to 1844 | got -1"),
    value("a negative seed among others", lambda b: b.reset([5, -3]), "0 to 1844 | got -3"),
    value("a huge seed", lambda b: b.reset([2**64, 1]), "0 to 1844 | got 18446744073709551616"),
    kind("a float seed", lambda b: b.reset(1.5), "an integer | got 1.5"),
    kind("float seeds", lambda b: b.reset([1.0, 2.0]), "an integer | got 1.0"),
    value("an episode of no seed", lambda b: b.reset(episode=3), "a seed with it | got episode 3"),
    kind("a mask of ints", lambda b: b.reset(mask=[1, 0]), "dtype bool | got int64"),
    value("a long mask", lambda b: b.reset(mask=[True] * 3), "shape (2,) | got (3,)"),
    value(
        "too few pursuers",
        lambda b: b.reset(pursuers=np.zeros((2, 0, 2), int)),
        "shape | got (2, 0, 2)",
    ),
    value(
        "two on a cell in one world",
        lambda b: b.reset(pursuers=[[[0, 0], [0, 1]], [[0, 0], [0, 0]]]),
        "distinct cells | got two agents on (0, 0)",
    ),
    value("a negative episode", lambda b: b.reset(0, episode=-1), "0 to 1844 | got -1"),
]


@table(BATCH_CALLS)
def test_a_batch_refuses_and_stays_as_it_was(call: Any, error: type[Exception], says: str) -> None:
    batch, twin = mw.Batch(2, CONFIG), mw.Batch(2, CONFIG)
    for each in (batch, twin):
        each.step(ZEROS + mw.Action.WEST)
    assert_refuses(lambda: call(batch), error, says)
    for name, array in twin.buffers.items():
        np.testing.assert_array_equal(batch.buffers[name], array)
    for each in (batch, twin):
        each.step(ZEROS + mw.Action.NORTH)
    for name, array in twin.buffers.items():
        np.testing.assert_array_equal(batch.buffers[name], array)
