"""Bad calls of a world or a batch raise, state what was expected, and change nothing."""

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from refusals import CONFIG, assert_refuses, kind, table, value

HUGE = np.array([2**64 - 1, 0, 0], np.uint64)
WORLD_CALLS = [
    value(lambda w: w.step([0, 0]), "shape (3,) | got (2,)"),
    value(lambda w: w.step([[0, 0, 0]]), "shape (3,) | (1, 3)"),
    value(lambda w: w.step(0), "shape (3,) | got ()"),
    kind(lambda w: w.step([0.0, 1, 2]), "integers | got dtype float64"),
    kind(lambda w: w.step([True] * 3), "integers | got dtype bool"),
    kind(lambda w: w.step(None), "integers | got dtype object"),
    value(lambda w: w.step([0, -1, 0]), "0 to 4 | got -1 (world 0, agent 1)"),
    value(lambda w: w.step([0, 0, 5]), "0 to 4 | got 5 (world 0, agent 2)"),
    value(lambda w: w.step(HUGE), "0 to 4 | got 9223372036854775807"),
    value(lambda w: w.reset(-1), "0 to 18446744073709551615 | got -1"),
    value(lambda w: w.reset(2**64), "0 to 1844 | got 18446744073709551616"),
    value(lambda w: w.reset(0, episode=-1), "0 to 1844 | got -1"),
    value(lambda w: w.reset(episode=3), "a seed with it | got episode 3"),
    value(lambda w: w.reset(pursuers=[[0, 0]]), "shape (2, 2) | pursuers: expected shape"),
    value(lambda w: w.reset(evaders=[[0, 1, 2]]), "shape (1, 2) | (1, 3)"),
    kind(lambda w: w.reset(evaders=[[0.5, 1]]), "integers | float64"),
    kind(lambda w: w.reset(pursuers=[]), "integers | got dtype float64"),
    value(lambda w: w.reset(pursuers=[[1, 2], [1, 2]]), "distinct cells | two agents on (1, 2)"),
    value(
        lambda w: w.reset(pursuers=[[0, 0], [2, 3]], evaders=[[2, 3]]),
        "distinct cells | two agents on (2, 3)",
    ),
    value(lambda w: w.reset(evaders=[[3, 0]]), "a cell of the 3 x 4 grid | (3, 0)"),
    value(lambda w: w.reset(evaders=[[0, -1]]), "a cell of the 3 x 4 | (0, -1)"),
    value(lambda w: w.reset(evaders=[[2**40, 0]]), "a cell of the 3 x 4 | (2147483647, 0)"),
    value(
        lambda w: w.reset(evaders=[[1, 1]], obstacles=["....", ".#..", "...."]),
        "a free cell | position (1, 1)",
    ),
    value(lambda w: w.reset(obstacles=["...", "..."]), "shape (3, 4) | got (2, 3)"),
    value(lambda w: w.reset(obstacles=["####", "####", "##.."]), "at least 3 free cells | got 2"),
    kind(lambda w: w.reset(obstacles=np.zeros((3, 4), int)), "dtype bool | got int64"),
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


def test_diagonal_actions_need_a_diagonal_world() -> None:
    with pytest.raises(ValueError, match="expected 0 to 4, got 5"):
        mw.World(CONFIG).step([mw.Action.NORTHEAST, 0, 0])
    world = mw.World(CONFIG, diagonal=True)
    world.step([mw.Action.NORTHEAST, 0, 0])
    with pytest.raises(ValueError, match="expected 0 to 8, got 9"):
        world.step([9, 0, 0])


# ---- Batches ---------------------------------------------------------------------------------


ZEROS = np.zeros((2, 3), int)
BAD_ACTION = np.array([[0, 0, 0], [4, 5, 4]])
BATCH_CALLS = [
    value(lambda b: b.step(ZEROS[0]), "shape (2, 3) | got (3,)"),
    value(lambda b: b.step(np.zeros((2, 4), int)), "shape (2, 3) | (2, 4)"),
    kind(lambda b: b.step(ZEROS * 1.0), "integers | got dtype float64"),
    value(lambda b: b.step(BAD_ACTION), "0 to 4 | got 5 (world 1, agent 1)"),
    value(lambda b: b.reset([1]), "shape (2,) | got (1,)"),
    value(lambda b: b.reset([[1, 2]]), "shape (2,) | got (1, 2)"),
    value(lambda b: b.reset([5, -3]), "0 to 1844 | got -3"),
    kind(lambda b: b.reset([1.0, 2.0]), "an integer | got 1.0"),
    value(lambda b: b.reset(episode=3), "a seed with it | got episode 3"),
    kind(lambda b: b.reset(mask=[1, 0]), "dtype bool | got int64"),
    value(lambda b: b.reset(mask=[True] * 3), "shape (2,) | got (3,)"),
    value(lambda b: b.reset(pursuers=np.zeros((2, 0, 2), int)), "shape | got (2, 0, 2)"),
    value(
        lambda b: b.reset(pursuers=[[[0, 0], [0, 1]], [[0, 0], [0, 0]]]),
        "distinct cells | got two agents on (0, 0)",
    ),
    value(lambda b: b.reset(0, episode=-1), "0 to 1844 | got -1"),
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
