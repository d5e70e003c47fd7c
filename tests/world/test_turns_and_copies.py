"""Rounds played turn by turn, copies of a world in the middle of a round, and snapshots of it."""

import copy
import pickle

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.world.arrays import array_specs, new_arrays
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


def test_a_round_is_finished_as_it_was_begun() -> None:
    world = mw.World(config_of("TO"))
    stay = np.zeros(world.config.n_agents, int)
    world.play_turn([0, *[99] * (len(stay) - 1)])  # only actions of those that act are read
    with pytest.raises(RuntimeError, match="turn 1 of 7 is next"):
        world.step(stay)
    assert world.steps == 0
    world.reset(1)
    assert world.turn == 0


@pytest.mark.parametrize("name", NAMES)
def test_a_batch_by_turns_writes_what_its_worlds_would(name: str) -> None:
    """After each turn, also of rounds in whose middle some worlds end, and of none."""
    config, n = config_of(name, obstacles=0.1, max_steps=6), 20
    buffers = new_arrays(array_specs(config), n)
    batch, order = mw.Batch(n, config, threads=2, buffers=buffers), mw.World(config)
    batch.reset(5)
    worlds = [batch.world(w) for w in range(n)]
    for actions in random_actions(3, config.n_actions, 6, n, config.n_agents):
        going = [w for w, world in enumerate(worlds) if not (world.terminated or world.truncated)]
        for turn in range(batch.n_turns):
            assert (batch.turn, batch.actors) == (turn, order.actors)
            unread = np.full_like(actions, 99)
            unread[:, order.actors] = actions[:, order.actors]
            batch.play_turn(unread)
            order.play_turn(actions[0])
            for w in going:
                worlds[w].play_turn(actions[w])
                for each, array in worlds[w].read(*buffers).items():
                    np.testing.assert_array_equal(buffers[each][w], array, err_msg=each)
        order.reset(0)


def test_a_batch_finishes_its_round() -> None:
    batch = mw.Batch(3, config_of("TO"))
    stay = np.zeros((3, batch.config.n_agents), int)
    batch.play_turn(stay)
    with pytest.raises(RuntimeError, match="turn 1 of 7 is next"):
        batch.step(stay)
    with pytest.raises(RuntimeError, match="turn 1 of 7 is next"):
        batch.reset(1, mask=[True, False, False])
    batch.reset(1)
    assert batch.turn == 0
    with pytest.raises(ValueError, match="expected DISABLED"):
        mw.Batch(3, autoreset=mw.Autoreset.SAME_STEP).play_turn(np.zeros((3, 38), int))


@pytest.mark.parametrize("name", NAMES)
def test_copies_continue_independently_and_identically(name: str) -> None:
    config = config_of(name, obstacles=0.15, max_steps=40)
    world = mw.World(config)
    world.reset(11, episode=4)
    turns = random_actions(6, config.n_actions, 60, config.n_agents)
    for actions in turns[:5]:
        if world.turn or not (world.terminated or world.truncated):
            world.play_turn(actions)
    twins = copy.deepcopy(world), pickle.loads(pickle.dumps(world))  # noqa: S301
    left_behind = copy.deepcopy(world)
    for actions in turns[5:]:
        if not world.turn and (world.terminated or world.truncated):
            for each in (world, *twins):
                each.reset()
        world.play_turn(actions)
        for twin in twins:
            twin.play_turn(actions)
            assert_same_worlds(world, twin)
    assert left_behind.turn == 5 % world.n_turns or left_behind.terminated
