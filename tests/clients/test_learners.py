"""Environments of Tianshou and TorchRL; docs/clients trains with them."""

import importlib
from typing import Any

import numpy as np
import pytest

import matrixworld as mw

WORLD: dict[str, Any] = {"rows": 6, "cols": 6, "n_pursuers": 2, "n_evaders": 1, "max_steps": 12}
FLEER = {"evaders": "clumsy-fleer", **WORLD}


def test_tianshou_gets_the_agents_of_a_vector_environment() -> None:
    pytest.importorskip("tianshou", exc_type=ImportError)
    envs = importlib.import_module("tianshou_envs").AgentEnvs("O", 3, **FLEER)
    settings = {"autoreset_mode": "Disabled", "dtype": "float32", "flatten": True, **FLEER}
    twin = mw.AgentVectorEnv(mw.VectorEnv("O", 3, **settings))
    np.testing.assert_array_equal(envs.reset(seed=5)[0], twin.reset(seed=5)[0])
    rng = np.random.default_rng(0)
    for _ in range(12):
        actions = rng.integers(5, size=6)
        for found, expected in zip(envs.step(actions)[:4], twin.step(actions), strict=False):
            np.testing.assert_array_equal(found, expected)
    again, _ = envs.reset([2, 3])  # both agents of a world, whose next episode begins
    assert again.shape == twin.reset()[0][2:4].shape


def test_torchrl_gets_flat_observations_of_a_team() -> None:
    pytest.importorskip("torchrl", exc_type=ImportError)
    env = importlib.import_module("torchrl_envs").env("O", seed=0, **FLEER)
    importlib.import_module("torchrl.envs.utils").check_env_specs(env)
    assert env.observation_spec["pursuer", "observation"].shape[-2:] == (2, 363)
