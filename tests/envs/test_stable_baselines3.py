"""The adapter for Stable-Baselines3; docs/clients trains with it."""

import sys

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.envs.stable_baselines3 import policy, vec_env
from matrixworld.version import MissingExtraError

WORLD = {"rows": 6, "cols": 6, "n_pursuers": 2, "n_evaders": 1, "max_steps": 12}


def test_a_missing_library_is_named_with_its_extra(monkeypatch):
    monkeypatch.setitem(sys.modules, "stable_baselines3", None)  # as if it were not installed
    expected = r"^expected the module stable_baselines3.*matrixworld-pursuit\[stable-baselines3\]"
    with pytest.raises(MissingExtraError, match=expected):
        vec_env("O", **WORLD)


@pytest.mark.parametrize("observation", ["views", "named"])
def test_stable_baselines3_gets_the_agents_of_a_vector_environment(observation):
    pytest.importorskip("stable_baselines3")
    world = {"observation": observation, **WORLD}
    envs = vec_env("O", n_worlds=3, **world)
    settings = {"autoreset_mode": "SameStep", "dtype": "float32", "flatten": True, **world}
    twin = mw.AgentVectorEnv(mw.VectorEnv("O", 3, evaders="clumsy-fleer", **settings))
    envs.seed(5)
    np.testing.assert_array_equal(envs.reset(), twin.reset(seed=5)[0])
    rng, ends = np.random.default_rng(0), 0
    for _ in range(30):
        actions = rng.integers(5, size=6)
        seen, rewards, ended, infos = envs.step(actions)
        expected = twin.step(actions)
        for found, other in zip((seen, rewards), expected, strict=False):
            np.testing.assert_array_equal(found, other)
        np.testing.assert_array_equal(ended, expected[2] | expected[3])
        for agent in np.flatnonzero(ended):
            ends += 1
            last = expected[4]["final_obs"][agent]
            np.testing.assert_array_equal(infos[agent]["terminal_observation"], last)
            assert infos[agent]["TimeLimit.truncated"] == expected[3][agent]
    assert ends > 6


def test_a_model_of_stable_baselines3_is_a_policy_and_an_opponent():
    pytest.importorskip("stable_baselines3")
    from stable_baselines3 import PPO

    model = PPO("MlpPolicy", vec_env("O", **WORLD), n_steps=8, batch_size=32).learn(100)
    config = mw.WorldConfig("O", **WORLD)
    assert 0 <= mw.score_policy(policy(model), "pursuer", config, episodes=2).mean().value <= 1
    model = PPO("MlpPolicy", vec_env(config, pursuers=policy(model)), n_steps=8, batch_size=8)
    assert model.env.num_envs == 8  # one evader in each world
