"""One agent as an environment of Gymnasium: conformance, and whose choices are played."""

import warnings
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.wrappers import TimeAwareObservation

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


@pytest.mark.parametrize("limit", [{"max_steps": 7}, {"max_episode_steps": 7}])
def test_the_specification_tells_the_time_limit(limit: dict[str, int]) -> None:
    name = "matrixworld/pursuit-evasion-o"  # as everywhere; with _ and _v0 it is the same
    env = TimeAwareObservation(gymnasium.make(name, **{**SMALL, "max_steps": 30, **limit}))
    assert env.max_timesteps == env.spec.max_episode_steps == 7
    worlds = gymnasium.make_vec(name, num_envs=2, max_episode_steps=7)
    assert worlds.unwrapped.config.max_steps == 7
    with pytest.raises(ValueError, match="^max_episode_steps, max_steps: expected one of them"):
        gymnasium.make_vec(name, max_steps=3, max_episode_steps=7)


def test_it_tells_the_allowed_actions() -> None:
    env = gymnasium.make("matrixworld/pursuit-evasion-o", action_mask="right-of-way", **SMALL)
    _, info = env.reset(seed=0)
    for _ in range(5):
        masks = env.get_wrapper_attr("action_masks")()
        assert masks.dtype == bool
        np.testing.assert_array_equal(masks, info["action_mask"])
        info = env.step(0)[4]
    assert mw.AgentEnv("O", **SMALL).action_masks().all()  # without a mask


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
    with pytest.raises(TypeError, match="^action of pursuer_0: expected an int"):
        env.step(0.5)  # type: ignore[arg-type]
