"""PettingZoo's parallel API: all agents act at once."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pettingzoo import ParallelEnv

from matrixworld.envs.base import MatrixWorldBase, Status

View = NDArray[np.uint8]


class MatrixWorldParallel(MatrixWorldBase, ParallelEnv[str, View, int]):  # type: ignore[misc]
    """An environment in which all agents act at once.

    Takes the arguments of `matrixworld.envs.base.MatrixWorldBase`.

    Examples
    --------
    >>> from matrixworld import parallel_env
    >>> env = parallel_env("SB", rows=8, cols=8, n_pursuers=4, n_evaders=1)
    >>> observations, infos = env.reset(seed=0)
    >>> while env.agents:
    ...     actions = {agent: env.action_space(agent).sample() for agent in env.agents}
    ...     observations, rewards, terminations, truncations, infos = env.step(actions)
    """

    def reset(
        self, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[dict[str, View], dict[str, dict[str, Any]]]:
        """Start an episode, and return observations and infos by the name of the agent.

        Parameters
        ----------
        seed : int, optional
            Seed of the episode, 0 to 2**64 - 1. Without it the next episode of the present seed
            starts. The first seed is drawn from the operating system.
        options : mapping, optional
            Arguments of `World.reset` under the keys of `OPTIONS`: ``pursuers`` and ``evaders``
            (cells, shape (n, 2)), ``obstacles`` (a map), ``episode`` (a number). With a built-in
            team also ``opponents``: what plays for it from now on. Other keys are ignored with a
            warning.

        Raises
        ------
        ValueError, TypeError
            As `World.reset` does. The environment then stays as it was.
        """
        self._reset_world(seed, options)
        views = self.world.views()
        infos = self._infos(self.status, views)
        return self._by_agent(self.agents, views), self._by_agent(self.agents, infos)

    def step(
        self, actions: Mapping[str, Any]
    ) -> tuple[
        dict[str, View],
        dict[str, float],
        dict[str, bool],
        dict[str, bool],
        dict[str, dict[str, Any]],
    ]:
        """Play a round.

        Parameters
        ----------
        actions : mapping of str to int
            An action for each of `agents`. Those of agents that are gone are ignored.

        Returns
        -------
        observations, rewards, terminations, truncations, infos : dict
            By the name of the agent, for all that acted. An agent that disappears in this step
            observes zeros, terminates, and leaves `agents`.

        Raises
        ------
        RuntimeError
            If there are actions although the episode has ended. A step without actions then returns
            five empty dicts, because wrappers of PettingZoo rely on it.
        ValueError, TypeError
            If an action is missing, out of range or no integer, or an agent is unknown. Nothing has
            changed then.
        """
        if not self.agents:
            if actions or not self._seeded:
                raise RuntimeError("the episode has ended, or never began: call reset()")
            return {}, {}, {}, {}, {}
        acting = self.agents
        committed = self._committed(actions)
        self._decide(committed, range(self.config.n_agents))
        self.world.step(committed)
        if self._drawing is not None:
            self._drawing.note(self._actions)
        status, views = Status(self.world), self.world.views()
        observations = self._by_agent(acting, views)
        rewards = self._by_agent(acting, status.rewards.tolist())
        terminations = self._by_agent(acting, status.terminations.tolist())
        truncations = self._by_agent(acting, status.truncations.tolist())
        infos = self._by_agent(acting, self._infos(status, views))
        # All that acted get their last results; agents that ended leave only now.
        self.agents: list[str] = [a for a in acting if not (terminations[a] or truncations[a])]
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
