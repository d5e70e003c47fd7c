"""Matches in lockstep against the same matches with one world after the other, bit by bit.

``cpp/tests/random_rollouts.cpp`` does so with any numbers of worlds, agents and units.
"""

from dataclasses import fields
from functools import partial
from unittest import mock

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import _core
from rows import NAMES, config_of, random_team

WIDTHS = [(20,), (32,), (33,), (48, 24), (64, 64), (400, 300), ()]
MAP = ["......", ".#..#.", "......", "..##..", "......", ".#....", "......"]


def assert_same_one_by_one(*args, **kwargs):
    """Play a rollout in both ways, and compare every bit."""
    fast = mw.rollout(*args, **kwargs)
    with mock.patch.object(_core, "rollout", partial(_core.rollout, one_by_one=True)):
        plain = mw.rollout(*args, **kwargs)
    for item in fields(fast):
        found, expected = getattr(fast, item.name), getattr(plain, item.name)
        assert found.dtype == expected.dtype
        assert found.tobytes() == expected.tobytes(), (item.name, np.nonzero(found != expected))


def assert_same(config, hidden, *, episodes, memory="none"):
    activation = "tanh" if len(hidden) > 1 else "relu"
    team = random_team(config, 0, 1, hidden=hidden, activation=activation, memory=memory)
    matches = mw.Matches.of([0, 1, 1], [0, 0, 1], [3, 4, 5])
    assert_same_one_by_one(config, team, team, matches, episodes=episodes, threads=2)


@pytest.mark.parametrize("name", NAMES)
def test_every_game(name):
    """All interactions, outcomes and captures, without obstacles or with one kind of them."""
    number = NAMES.index(name)
    for memory, shift in (("none", 0), ("gru", 1)):
        obstacles = (0.0, 0.15, MAP)[(number + shift) % 3]
        config = config_of(name, obstacles=obstacles, diagonal=number % 2 == 1)
        hidden = WIDTHS[number % (7 - shift)]
        assert_same(config, hidden, episodes=1 + number % 8, memory=memory)


def test_extreme_weights():
    """Outputs that are infinite or not numbers."""
    config = mw.WorldConfig("O", rows=9, cols=9, n_pursuers=9, max_steps=10)
    for memory in ("none", "gru"):
        team = random_team(config, 0, 1, hidden=(32,), memory=memory)
        huge = mw.Population(team.genomes * np.float32(1e30), team.policy)
        assert_same_one_by_one(config, huge, team, mw.Matches.of(0, 1, [1, 2]), episodes=3)


def test_rewards_of_many_magnitudes():
    """Sums of rewards are those of all agents one by one, whatever a step pays."""
    rewards = mw.Rewards(
        pursuer_step=1e-7, evader_step=3e8, pursuer_capture=1e5, evader_neighbor=-7e-4
    )
    config = mw.WorldConfig("SD", rows=9, cols=9, max_steps=60, rewards=rewards)
    assert_same(config, (32,), episodes=9)
