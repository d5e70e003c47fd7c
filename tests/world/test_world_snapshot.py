"""Snapshots of worlds: what `copy.deepcopy` and `pickle` write down and restore."""

import re
from typing import Any

import numpy as np
import pytest

import matrixworld as mw

CONFIG = mw.WorldConfig.of("TO", rows=4, cols=5, n_pursuers=2, n_evaders=3, max_steps=9)


def snapshot_of(world: mw.World) -> dict[str, Any]:
    return world.__getstate__()["moment"]


def restored(snapshot: dict[str, Any]) -> mw.World:
    return mw.World.at(CONFIG, snapshot)


def test_fields_and_types() -> None:
    world = mw.World(CONFIG)
    world.reset(2**64 - 1, episode=3)
    snapshot = snapshot_of(world)
    assert (snapshot["seed"], snapshot["episode"]) == (2**64 - 1, 3)
    arrays = {
        name: value.shape for name, value in snapshot.items() if isinstance(value, np.ndarray)
    }
    assert arrays == {
        "map": (20,),
        **dict.fromkeys(("cells", "last_cells", "rewards", "report"), (5,)),
        **dict.fromkeys(("captured", "ever_captured", "capture_paid", "captors"), (3,)),
        "participants": (0,),
    }
    plain = {name: type(value) for name, value in snapshot.items() if name not in arrays}
    assert plain == {
        **dict.fromkeys(("seed", "episode", "steps", "turn"), int),
        **dict.fromkeys(("first_turn", "terminated", "truncated"), bool),
    }


def test_a_restored_world_has_the_same_snapshot() -> None:
    world = mw.World(CONFIG)
    world.play_turn([mw.Action.EAST] * 5)
    world.play_turn([mw.Action.SOUTH] * 5)
    snapshot = snapshot_of(world)
    twin = snapshot_of(restored(snapshot))
    assert twin.keys() == snapshot.keys()
    assert snapshot["turn"] == 2
    for name, value in snapshot.items():
        np.testing.assert_array_equal(twin[name], value, err_msg=name)


@pytest.mark.parametrize(
    ("name", "value", "expected"),
    [
        ("map", np.zeros(19, np.uint8), "20 entries, got 19"),
        ("map", np.full(20, 2, np.uint8), "0 to 1, got 2"),
        ("cells", np.full(5, 20, np.int32), "-1 to 19, got 20"),
        ("cells", np.zeros(6, np.int32), "5 entries, got 6"),
        ("last_cells", np.full(5, -2, np.int32), "-1 to 19, got -2"),
        ("captured", np.full(3, 3, np.uint8), "0 to 1, got 3"),
        ("captors", np.full(3, 3, np.int32), "0 to 2, got 3"),
        ("rewards", np.zeros(4, np.float32), "5 entries, got 4"),
        ("report", np.full(5, 64, np.int32), "0 to 63, got 64"),
        ("participants", np.array([1, 5], np.int32), "0 to 4, got 5"),
        ("steps", 10, "0 to 9, got 10"),
        ("turn", 5, "0 to 4, got 5"),
    ],
)
def test_a_wrong_snapshot_is_refused(name: str, value: object, expected: str) -> None:
    snapshot = snapshot_of(mw.World(CONFIG))
    with pytest.raises(ValueError, match=re.escape(f"snapshot, {name}: expected {expected}")):
        restored(snapshot | {name: value})


@pytest.mark.parametrize("name", ["turn", "seed", "cells", "steps"])
def test_a_snapshot_without_a_field_is_refused(name: str) -> None:
    snapshot = snapshot_of(mw.World(CONFIG))
    del snapshot[name]
    with pytest.raises(ValueError, match=f"snapshot, {name}: expected an entry, got none"):
        restored(snapshot)


def test_an_array_of_another_type_is_refused() -> None:
    snapshot = snapshot_of(mw.World(CONFIG))
    with pytest.raises(TypeError):
        restored(snapshot | {"cells": np.zeros(5, np.float64)})
