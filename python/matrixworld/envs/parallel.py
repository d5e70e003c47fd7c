"""The parallel API: everybody acts at once."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pettingzoo import ParallelEnv

from matrixworld.envs.base import MatrixWorldBase, Status

View = NDArray[np.uint8]


class MatrixWorldParallel(MatrixWorldBase, ParallelEnv[str, View, int]):  # type: ignore[misc]
    """All agents act at once. Takes the arguments of `MatrixWorldBase`."""

    def reset(
        self, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[dict[str, View], dict[str, dict[str, Any]]]:
        """Start an episode; return observations and infos by agent.

        seed: an int in [0, 2**64). Without one, the next episode of the seed in use; an environment
            that never had one draws it from the operating system.
        options: any of `OPTIONS`: ``pursuers``, ``evaders``: positions ``(n, 2)``; ``obstacles``: a
            map as `read_map` takes it; ``episode``: which one of the seed. Others are warned of.

        Raises as `World.reset` does; the environment then stays as it was.
        """
        self._reset_world(seed, options)
        return self._by_agent(self.agents, self.world.views()), self._infos(self.agents)

    def step(
        self, actions: Mapping[str, Any]
    ) -> tuple[
        dict[str, View],
        dict[str, float],
        dict[str, bool],
        dict[str, bool],
        dict[str, dict[str, Any]],
    ]:
        """Play a round; return observations, rewards, terminations, truncations, infos by agent.

        actions: an int for each of `agents`; those of agents that are gone are not looked at

        An agent that goes in this step is told so, with an observation of zeros, and leaves
        `agents`. No actions in an ended episode, which has no agents, give five empty dicts:
        wrappers count on it. Raises RuntimeError for actions in an ended episode; ValueError for a
        missing action, an unknown agent or an action out of range, and TypeError for what is no
        integer, before anything is changed.
        """
        if not self.agents:
            if actions or not self._seeded:
                raise RuntimeError("the episode has ended, or never began: call reset()")
            return {}, {}, {}, {}, {}
        acting = self.agents
        self.world.step(self._committed(actions))
        if self._drawing is not None:
            self._drawing.note(self._actions)
        status = Status.of(self.world)
        observations = self._by_agent(acting, self.world.views())
        rewards = self._by_agent(acting, status.rewards.tolist())
        terminations = self._by_agent(acting, status.terminations.tolist())
        truncations = self._by_agent(acting, status.truncations.tolist())
        infos = self._by_agent(acting, status.infos())
        self.agents = [a for a in acting if not (terminations[a] or truncations[a])]
        return observations, rewards, terminations, truncations, infos

    def _committed(self, actions: Mapping[str, Any]) -> NDArray[np.int64]:
        missing = [agent for agent in self.agents if agent not in actions]
        if missing:
            raise ValueError(f"actions: expected one for each of agents, none came for {missing}")
        unknown = [agent for agent in actions if agent not in self._index]
        if unknown:
            raise ValueError(f"actions: expected names of agents, got {unknown}")
        given = np.array([actions[agent] for agent in self.agents])
        if given.dtype.kind not in "iu" or given.ndim != 1:
            kinds = sorted({type(actions[agent]).__name__ for agent in self.agents})
            raise TypeError(f"actions: expected an int for each agent, got {', '.join(kinds)}")
        self._actions = np.zeros(self.config.n_agents, np.int64)
        self._actions[[self._index[agent] for agent in self.agents]] = given
        return self._actions

    def _by_agent(self, agents: list[str], values: Any) -> dict[str, Any]:
        return {agent: values[self._index[agent]] for agent in agents}

    def _infos(self, agents: list[str]) -> dict[str, dict[str, Any]]:
        return self._by_agent(agents, self.status.infos())
