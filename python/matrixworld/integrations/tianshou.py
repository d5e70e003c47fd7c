"""Tianshou: a vector environment of agents."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.envs.vector import AgentVectorEnv
from matrixworld.integrations import agents
from matrixworld.version import imported
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import Rules

__all__ = ["vector_env"]


def vector_env(config: WorldConfig | Rules | str = "O", n_worlds: int = 8, **settings: Any) -> Any:
    """Make a vector environment in which the agents of one team share the policy that learns.

    Parameters
    ----------
    config, n_worlds, **settings
        As for `matrixworld.integrations.stable_baselines3.vec_env`.

    Returns
    -------
    tianshou.env.BaseVectorEnv
        With n_worlds times the agents of the team. Its attribute ``agents`` is the
        `AgentVectorEnv`, which has the spaces of one agent.
    """
    library = imported("tianshou.env", "tianshou")

    class AgentVectorEnv(_Adapter, library.BaseVectorEnv):  # type: ignore[misc, name-defined]
        """Collectors of the library accept subclasses of its class only."""

    # Collectors reset environments that have ended, so the worlds do not.
    return AgentVectorEnv(agents(config, n_worlds, "Disabled", settings))


class _Adapter:
    """The methods of the library's `BaseVectorEnv`, for the agents of an `AgentVectorEnv`."""

    def __init__(self, agents: AgentVectorEnv) -> None:
        self.agents, self.env_num = agents, agents.num_envs
        self.is_async = self.is_closed = False

    def get_env_attr(self, key: str, id: Any = None) -> list[Any]:
        return [getattr(self.agents, f"single_{key}")] * self.env_num

    def seed(self, seed: Any = None) -> None:
        self.agents.reset(seed=seed)

    def reset(self, env_id: Any = None, **kwargs: Any) -> tuple[NDArray[Any], NDArray[Any]]:
        chosen = np.arange(self.env_num) if env_id is None else np.asarray(env_id)
        mask = np.zeros(self.env_num, np.bool_)
        mask[chosen] = True  # the agents of a world end together
        observations, _ = self.agents.reset(options={"reset_mask": mask}, **kwargs)
        return observations[chosen], np.array([{} for _ in chosen])

    def step(self, action: Any, id: Any = None) -> tuple[Any, ...]:
        *results, _ = self.agents.step(action)
        return (*results, np.array([{} for _ in action]))

    def close(self) -> None:
        self.agents.close()
