"""Rounds played turn by turn, copies of a world in the middle of a round, and snapshots of it."""

import copy
import pickle
import re
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from rows import NAMES, assert_same_worlds, config_of, random_actions

OF_TURNS = {"SIMULTANEOUS": 1, "SWARM_TURNS": 2}


@pytest.mark.parametrize("name", NAMES)
def test_a_round_by_turns_is_a_step(name: str) -> None:
    config = config_of(name, obstacles=0.1)
    whole, by_turns = mw.World(config), mw.World(config)
    assert whole.n_turns == OF_TURNS.get(config.rules.interaction.name, config.n_agents)
    for actions in random_actions(3, config.n_actions, 20, config.n_agents):
        if whole.terminated or whole.truncated:
            break
        whole.step(actions, explain=True)
        acted: list[int] = []
        for turn in range(by_turns.n_turns):
            assert by_turns.turn == turn
            acted += by_turns.actors
            by_turns.play_turn(actions, explain=True)
        assert acted == list(range(config.n_agents))
        assert_same_worlds(whole, by_turns)
        assert whole.conflicts == by_turns.conflicts


def test_only_the_actions_of_actors_are_read() -> None:
    world = mw.World(config_of("TO"))
    actions = np.full(world.config.n_agents, 99)
    actions[0] = 0
    world.play_turn(actions)
    assert world.turn == 1
    with pytest.raises(ValueError, match="expected 0 to 4, got 99 .*agent 1"):
        world.play_turn(actions)
    assert world.turn == 1


def test_a_round_is_finished_as_it_was_begun() -> None:
    world = mw.World(config_of("TO"))
    stay = np.zeros(world.config.n_agents, int)
    world.play_turn(stay)
    with pytest.raises(RuntimeError, match="turn 1 of 7 is next"):
        world.step(stay)
    assert world.steps == 0
    world.reset(1)
    assert world.turn == 0
    world.step(stay)
    assert world.steps == 1


def test_a_list_of_conflicts_is_kept_from_the_first_turn_on() -> None:
    world = mw.World(config_of("TO"))
    stay = np.zeros(world.config.n_agents, int)
    world.play_turn(stay)
    world.play_turn(stay, explain=True)
    with pytest.raises(RuntimeError, match="explain=True"):
        world.conflicts  # noqa: B018


@pytest.mark.parametrize("interaction", list(mw.Interaction))
def test_an_ended_world_takes_no_turn(interaction: mw.Interaction) -> None:
    world = mw.World(mw.Rules(interaction), rows=1, cols=2, n_pursuers=1, n_evaders=1)
    world.reset(0, pursuers=[[0, 0]], evaders=[[0, 1]])
    actions = [mw.Action.EAST, mw.Action.STAY]
    while not world.steps:  # terminated in the first turn: the round is still played to its end
        world.play_turn(actions)
    assert world.terminated
    with pytest.raises(RuntimeError, match="has ended"):
        world.play_turn(actions)


@pytest.mark.parametrize("copied", [copy.deepcopy, lambda w: pickle.loads(pickle.dumps(w))])  # noqa: S301
@pytest.mark.parametrize("name", NAMES)
def test_a_copy_continues_independently_and_identically(name: str, copied: object) -> None:
    config = config_of(name, obstacles=0.15, max_steps=40)
    world = mw.World(config)
    world.reset(11, episode=4)
    turns = random_actions(6, config.n_actions, 60, config.n_agents)
    for actions in turns[:5]:
        if world.turn or not (world.terminated or world.truncated):
            world.play_turn(actions)
    twin = copied(world)
    assert_same_worlds(world, twin)
    left_behind = copy.deepcopy(world)
    for actions in turns[5:]:
        if not world.turn and (world.terminated or world.truncated):
            world.reset()
            twin.reset()
        world.play_turn(actions)
        twin.play_turn(actions)
        assert_same_worlds(world, twin)
    assert left_behind.turn == 5 % world.n_turns or left_behind.terminated


# ---- Snapshots: what copies and pickles write down and restore -----------------------------------

CONFIG = mw.WorldConfig.of("TO", rows=4, cols=5, n_pursuers=2, n_evaders=3, max_steps=9)


def snapshot_of(world: mw.World) -> dict[str, Any]:
    return world._core.snapshot()


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
        *((missing, None, "an entry, got none") for missing in ("turn", "seed", "cells", "steps")),
    ],
)
def test_a_wrong_snapshot_is_refused(name: str, value: object, expected: str) -> None:
    snapshot = snapshot_of(mw.World(CONFIG)) | {name: value}
    if value is None:
        del snapshot[name]
    with pytest.raises(ValueError, match=re.escape(f"snapshot, {name}: expected {expected}")):
        mw.World.at(CONFIG, snapshot)


def test_an_array_of_another_type_is_refused() -> None:
    snapshot = snapshot_of(mw.World(CONFIG))
    with pytest.raises(TypeError):
        mw.World.at(CONFIG, snapshot | {"cells": np.zeros(5, np.float64)})


@pytest.mark.parametrize("name", sorted(mw.World(CONFIG)._core.snapshot()))
@pytest.mark.parametrize("value", ["x", None, 1.5, [1]])
def test_an_entry_of_another_type_is_refused(name: str, value: object) -> None:
    snapshot = snapshot_of(mw.World(CONFIG)) | {name: value}
    with pytest.raises(TypeError, match=rf"^snapshot, {name}: expected \w+, got "):
        mw.World.at(CONFIG, snapshot)


def test_something_else_than_a_snapshot_is_refused() -> None:
    with pytest.raises(TypeError, match="^config: expected a matrixworld.WorldConfig, got 'O'"):
        mw.World.at("O", snapshot_of(mw.World(CONFIG)))  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="^snapshot: expected a dict, got None"):
        mw.World.at(CONFIG, None)  # type: ignore[arg-type]
