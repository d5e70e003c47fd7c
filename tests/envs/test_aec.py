"""The AEC environment: a turn is played when all its agents have chosen an action."""

from typing import Any

import numpy as np
import pytest
from pettingzoo.utils.conversions import aec_to_parallel

import matrixworld as mw
from matrixworld.envs.single import MatrixWorldAEC
from rows import NAMES, by_name, config_of, play_turns, random_actions


@pytest.mark.parametrize("name", NAMES)
def test_an_episode_agrees_with_the_world_turn_by_turn(name: str) -> None:
    """Agents see what was done before their turn."""
    config = config_of(name, obstacles=0.1, max_steps=30)
    env, world, expected = MatrixWorldAEC(config), mw.World(config), np.zeros(config.n_agents)
    rows = random_actions(5, config.n_actions, config.max_steps, config.n_agents)
    env.reset(seed=6)
    world.reset(6)

    def play_turn() -> None:
        world.play_turn(rows[world.steps])
        if world.turn == 0:
            expected[:] += world.rewards

    def choose(agent: str, _: Any) -> int:
        number = env.possible_agents.index(agent)
        while world.steps < env.status.steps or number not in world.actors:
            play_turn()
        np.testing.assert_array_equal(env.observe(agent), world.views()[number])
        np.testing.assert_array_equal(env.state(), world.state())
        return int(rows[world.steps, number])

    paid = play_turns(env, choose)
    while world.steps < env.status.steps:
        play_turn()
    assert world.terminated or world.truncated
    np.testing.assert_allclose(list(paid.values()), expected, atol=1e-3)
    np.testing.assert_array_equal(env.state(), world.state())
    assert env.agents == []


@pytest.mark.parametrize("name", NAMES)
def test_only_simultaneous_rules_are_parallelizable(name: str) -> None:
    env = mw.aec_env(config_of(name))
    at_once = env.unwrapped.config.rules.interaction is mw.Interaction.SIMULTANEOUS
    assert env.metadata["is_parallelizable"] == at_once
    assert mw.parallel_env(config_of(name)).metadata["is_parallelizable"]
    if not at_once:
        with pytest.raises(AssertionError, match="not generally safe"):
            aec_to_parallel(env)
        return
    converted, parallel = aec_to_parallel(env), mw.parallel_env(config_of(name))
    converted.reset(seed=1)
    parallel.reset(seed=1)
    for row in random_actions(3, 5, 20, len(parallel.possible_agents)):
        assert converted.agents == parallel.agents
        if not (played := by_name(parallel, row)):
            break
        results = converted.step(played), parallel.step(played)
        for agent in played:
            for part in (0, 2, 3, 4):  # rewards are sums of float32 in another order
                np.testing.assert_equal(*(result[part][agent] for result in results))
    assert not parallel.agents


def test_refused() -> None:
    env = MatrixWorldAEC(config_of("O"))
    with pytest.raises(RuntimeError, match="call reset"):
        env.step(0)
    env.reset(seed=1)
    for action, error in ((5, ValueError), (None, TypeError)):
        with pytest.raises(error, match="^action of pursuer_0:"):
            env.step(action)
    assert env.agent_selection == "pursuer_0"
    seen = env.observe("pursuer_0")
    seen[:] = 9  # the caller's own
    assert env.observation_space("pursuer_0").contains(env.last()[0])
