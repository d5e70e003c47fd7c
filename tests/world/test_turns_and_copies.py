"""Rounds played turn by turn, copies of a world in the middle of a round, and snapshots of it."""

import copy
import pickle

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


def test_a_round_is_finished_as_it_was_begun() -> None:
    world = mw.World(config_of("TO"))
    stay = np.zeros(world.config.n_agents, int)
    world.play_turn([0, *[99] * (len(stay) - 1)])  # only actions of those that act are read
    with pytest.raises(RuntimeError, match="turn 1 of 7 is next"):
        world.step(stay)
    assert world.steps == 0
    world.reset(1)
    assert world.turn == 0
    world.step(stay)
    assert world.steps == 1


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
