"""Presets of rewards, penalties by kind of collision, and the agents that pay them."""

from __future__ import annotations

import numpy as np
import pytest

import matrixworld as mw
from rows import config_of, random_actions


def penalties_only(**changes: object) -> mw.Rewards:
    names = ("capture", "neighbor", "step")
    zero = {f"{team}_{name}": 0.0 for team in ("pursuer", "evader") for name in names}
    return mw.Rewards(**(zero | changes))


def test_presets() -> None:
    assert mw.Rewards.paper() == mw.Rewards()
    published = mw.Rewards.published()
    assert published.evader_step == 0.05
    assert published.capture_repeats
    assert mw.Rewards(evader_step=0.05, capture_repeats=True) == published


@pytest.mark.parametrize("name", ["D", "S", "SDB", "swarm-S", "agents-R"])
@pytest.mark.parametrize("blame", list(mw.Blame))
def test_penalties_agree_with_the_reported_fault_and_involvement(
    name: str, blame: mw.Blame
) -> None:
    by_kind = {"pursuer_collide": (-1, -20, -300), "evader_collide": [-2, -40, -600]}
    config = config_of(name, obstacles=0.1, rewards=penalties_only(**by_kind, blame=blame))
    world = mw.World(config)
    pursuers = np.arange(config.n_agents)[:, None] < config.n_pursuers
    tariff = np.where(pursuers, *by_kind.values())
    for actions in random_actions(9, config.n_actions, 30, config.n_agents):
        if world.terminated or world.truncated:
            world.reset()
        rewards = world.step(actions)
        to_blame = world.fault if blame is mw.Blame.FAULT else world.involved
        np.testing.assert_array_equal(rewards, (tariff * to_blame).sum(axis=1))
