"""The AEC environment: a turn is played when all its agents have chosen an action."""

from typing import Any

import numpy as np
import pytest
from pettingzoo.utils.conversions import aec_to_parallel

import matrixworld as mw
from matrixworld.envs.single import MatrixWorldAEC
from rows import NAMES, by_name, config_of, play_turns, random_actions


def play(env: Any, rows: np.ndarray) -> tuple[dict[str, float], list[str]]:
    """Play an episode; row t holds the t-th action of each agent. Return returns and order."""
    order: list[str] = []

    def choose(agent: str, _: Any) -> int:
        order.append(agent)
        return int(rows[order.count(agent) - 1, env.possible_agents.index(agent)])

    return play_turns(env, choose), order


@pytest.mark.parametrize("name", NAMES)
def test_an_episode_agrees_with_the_world(name: str) -> None:
    config = config_of(name, obstacles=0.1)
    env, world = mw.aec_env(config), mw.World(config)
    rows = random_actions(5, config.n_actions, config.max_steps, config.n_agents)
    env.reset(seed=6)
    returns, _ = play(env, rows)
    world.reset(6)
    expected = np.zeros(config.n_agents)
    for row in rows:
        expected += world.step(row)
        if world.terminated or world.truncated:
            break
    np.testing.assert_allclose(list(returns.values()), expected, atol=1e-3)
    np.testing.assert_array_equal(env.state(), world.state())
    assert env.unwrapped.status.steps == world.steps
    assert env.agents == []


def test_agents_see_what_was_done_before_their_turn() -> None:
    """Cops and robbers: every action is a turn."""
    config = config_of("TO", obstacles=0.1, max_steps=30)
    env, world = MatrixWorldAEC(config), mw.World(config)
    env.reset(seed=2)
    world.reset(2)
    rng = np.random.default_rng(0)
    seen_in_midround = 0
    while env.agents:
        agent = env.agent_selection
        number = env.possible_agents.index(agent)
        np.testing.assert_array_equal(env.observe(agent), world.views()[number])
        if env.terminations[agent] or env.truncations[agent]:
            env.step(None)
            continue
        while world.actors[0] != number:  # agents that are gone
            world.play_turn(np.zeros(config.n_agents, int))
        action = int(rng.integers(5))
        env.step(action)
        world.play_turn(np.full(config.n_agents, action))
        while world.turn and world.terminated:
            world.play_turn(np.zeros(config.n_agents, int))
        np.testing.assert_array_equal(env.state(), world.state())
        seen_in_midround += world.turn > 0
    assert seen_in_midround > 5


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
