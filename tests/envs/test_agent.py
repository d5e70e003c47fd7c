"""One agent as an environment of Gymnasium: conformance, and whose choices are played."""

import warnings
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import matrixworld as mw

SMALL: dict[str, Any] = {"rows": 8, "cols": 8, "n_pursuers": 3, "n_evaders": 2, "max_steps": 30}


@pytest.mark.parametrize("variant", mw.VARIANTS)
@pytest.mark.parametrize("agent", ["pursuer_1", "evader_0"])
def test_gymnasium_makes_and_checks_it(variant: str, agent: str) -> None:
    name = f"matrixworld/pursuit_evasion_{variant.lower()}_v0"
    env = gymnasium.make(name, agent=agent, action_mask=True, **SMALL)
    assert env.unwrapped.env.config.rules == mw.VARIANTS[variant]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped, skip_render_check=True)


@pytest.mark.parametrize("agent", ["pursuer_0", "pursuer_2", "evader_1"])
def test_an_agent_that_plays_the_script_of_its_team_plays_the_episode_of_a_rollout(
    agent: str,
) -> None:
    config = mw.WorldConfig("O", **SMALL)
    team, number = agent.split("_")
    index = int(number) + (config.n_pursuers if team == "evader" else 0)
    script = {"pursuer": "chaser", "evader": "dodger"}
    env = mw.AgentEnv(config, agent=agent, pursuers="chaser", evaders="dodger", record=True)
    lengths = set()
    for seed in range(8):
        env.reset(seed=seed)
        ended, total = False, 0.0
        while not ended:
            actions = np.zeros(config.n_agents, np.int64)
            env.env.world.decide(script[team], range(index, index + 1), actions)
            _, reward, terminated, truncated, _ = env.step(int(actions[index]))
            ended, total = terminated or truncated, total + reward
        expected = mw.record(config, "chaser", "dodger", seed=seed)
        played = env.env.recorded
        steps = played.length  # the agent may be gone before the end
        np.testing.assert_array_equal(played.positions, expected.positions[: steps + 1])
        assert total == pytest.approx(expected.rewards[:steps, index].sum(), abs=1e-4)
        lengths.add(steps)
    assert len(lengths) > 2


def test_mates_and_opponents_are_drawn_independently() -> None:
    env = mw.AgentEnv("O", pursuers=["chaser", "random"], evaders=["fleer", "random"], **SMALL)
    env.reset(seed=0)
    pairs = set()
    for _ in range(40):
        pairs.add((int(env._mates.chosen[0]), env.env.opponent))
        env.reset()
    assert len(pairs) == 4


def test_it_refuses() -> None:
    with pytest.raises(ValueError, match=r"^agent: expected one of pursuer_0, .*, got 'prey'"):
        mw.AgentEnv("O", agent="prey")
    env = mw.AgentEnv("O", **SMALL)
    with pytest.raises(RuntimeError, match=r"call reset\(\)"):
        env.step(0)
    env.reset(seed=0)
    with pytest.raises(TypeError, match="^actions: expected an int"):
        env.step(0.5)  # type: ignore[arg-type]
