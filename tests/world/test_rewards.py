"""Presets of rewards, penalties by kind of collision, and the agents that pay them."""

from __future__ import annotations

import numpy as np
import pytest

import matrixworld as mw
from rows import config_of, random_actions


def step_rewards(world: mw.World, actions: list[int]) -> list[float]:
    return [round(float(value), 4) for value in world.step(actions)]


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


def test_penalties_by_kind() -> None:
    rewards = penalties_only(pursuer_collide=(-1, -20, -300), evader_collide=[-4, -50, -600])
    config = mw.WorldConfig("SB", rows=2, cols=6, n_pursuers=3, n_evaders=1, rewards=rewards)
    world = mw.World(config)
    # The first pursuer runs into the border, the second and third head for the same cell.
    world.reset(0, pursuers=[[0, 0], [1, 0], [1, 2]], evaders=[[0, 4]])
    assert step_rewards(world, [1, 2, 4, 0]) == [-1.0, -20.0, -20.0, 0.0]
    world.reset(0, pursuers=[[0, 3], [1, 0], [1, 2]], evaders=[[0, 4]])
    assert step_rewards(world, [2, 0, 0, 2]) == [0.0] * 4  # the pursuer follows the evader
    assert step_rewards(world, [2, 0, 0, 2]) == [-300.0, 0.0, 0.0, -4.0]  # at the border both wait


def test_involved_agents_pay_if_the_rewards_say_so() -> None:
    rewards = penalties_only(pursuer_collide=-7, evader_collide=-7)
    shared = penalties_only(pursuer_collide=-7, evader_collide=-7, blame=mw.Blame.INVOLVED)
    paid = []
    for each in (rewards, shared):
        world = mw.World("S", rows=1, cols=4, n_pursuers=1, n_evaders=1, rewards=each)
        world.reset(0, pursuers=[[0, 0]], evaders=[[0, 1]])
        paid.append(step_rewards(world, [mw.Action.EAST, mw.Action.STAY]))
    assert paid == [[-7.0, 0.0], [-7.0, -7.0]]


@pytest.mark.parametrize("name", ["D", "SDB", "swarm-S", "agents-R"])
@pytest.mark.parametrize("blame", list(mw.Blame))
def test_penalties_agree_with_the_reported_fault_and_involvement(
    name: str, blame: mw.Blame
) -> None:
    by_kind = {"pursuer_collide": (-1, -20, -300), "evader_collide": (-2, -40, -600)}
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


@pytest.mark.parametrize(
    ("changes", "error", "says"),
    [
        ({"pursuer_collide": (1, 2)}, ValueError, r"pursuer_collide: expected 1 or 3 numbers"),
        ({"evader_collide": (1, 2, "x")}, TypeError, r"evader_collide: expected a number, got 'x'"),
        ({"evader_collide": (1, 2, np.inf)}, ValueError, r"expected a finite number, got inf"),
        ({"pursuer_step": (1, 2, 3)}, TypeError, r"pursuer_step: expected a number"),
        ({"blame": "fault"}, TypeError, r"blame: expected a matrixworld.Blame, got 'fault'"),
    ],
)
def test_rewards_refuse(changes: dict[str, object], error: type[Exception], says: str) -> None:
    with pytest.raises(error, match=says):
        mw.Rewards(**changes)
