"""Stable-Baselines3: a vector environment of agents, and trained models as policies."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.envs.vector import AgentVectorEnv, VectorEnv
from matrixworld.version import imported
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import Rules

__all__ = ["policy", "vec_env"]


def vec_env(config: WorldConfig | Rules | str = "O", n_worlds: int = 8, **settings: Any) -> Any:
    """Make a vector environment in which the agents of one team share the policy that learns.

    `config`, `n_worlds` and `settings` are as for `matrixworld.VectorEnv`, with 8 worlds by
    default. ``pursuers`` or ``evaders`` says what plays that team, by default
    ``evaders="clumsy-fleer"``. Returns a ``VecMonitor``, with ``num_envs`` of n_worlds times the
    agents of the team. Observations are float32, flat unless ``flatten=False``. An agent's episode
    ends with its world, see `AgentVectorEnv`.
    """
    library = imported("stable_baselines3.common.vec_env", "stable-baselines3")

    class AgentVecEnv(library.VecEnv):  # type: ignore[misc, name-defined]
        """Learners of the library accept subclasses of its class only."""

        def __init__(self, agents: AgentVectorEnv) -> None:
            self.agents = agents
            spaces: Any = agents.single_observation_space, agents.single_action_space
            super().__init__(agents.num_envs, *spaces)

        def reset(self) -> NDArray[Any]:
            observations, _ = self.agents.reset(seed=self._seeds[0])
            self._reset_seeds()
            return observations

        def step_async(self, actions: NDArray[Any]) -> None:
            self._actions = actions

        def step_wait(self) -> tuple[Any, ...]:
            seen, rewards, terminations, truncations, infos = self.agents.step(self._actions)
            ended = terminations | truncations
            by_agent: list[dict[str, Any]] = [{} for _ in ended]
            for agent in ended.nonzero()[0]:
                by_agent[agent] = {
                    "terminal_observation": infos["final_obs"][agent],
                    "TimeLimit.truncated": bool(truncations[agent]),
                }
            return seen, rewards, ended, by_agent

        def close(self) -> None:
            self.agents.close()

        def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
            return [getattr(self.agents, attr_name) for _ in self._get_indices(indices)]

        def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
            setattr(self.agents, attr_name, value)

        def env_method(self, name: str, *args: Any, indices: Any = None, **more: Any) -> Any:
            # The agents are one object, so that a method is called once.
            return [getattr(self.agents, name)(*args, **more)]

        def env_is_wrapped(self, wrapper_class: type, indices: Any = None) -> list[bool]:
            return [False for _ in self._get_indices(indices)]

    if not settings.keys() & {"pursuers", "evaders"}:
        settings["evaders"] = "clumsy-fleer"  # against which first attempts learn
    own = {"autoreset_mode": "SameStep", "dtype": "float32", "flatten": True, **settings}
    return library.VecMonitor(AgentVecEnv(AgentVectorEnv(VectorEnv(config, n_worlds, **own))))


def policy(model: Any, deterministic: bool = False) -> Callable[[NDArray[Any]], NDArray[Any]]:
    """Return a trained `model` as a function of observations (n, 3, fov, fov), which gives (n,).

    It is a model that learned on views, not on named inputs.
    `matrixworld.score_policy` scores it, and environments take it as an opponent. `deterministic`
    takes the most probable action instead of a drawn one.
    """
    shape = model.observation_space.shape

    def act(observations: NDArray[Any]) -> NDArray[Any]:
        seen = observations.reshape(len(observations), *shape).astype(np.float32)
        actions: NDArray[Any] = model.predict(seen, deterministic=deterministic)[0]
        return actions

    return act
