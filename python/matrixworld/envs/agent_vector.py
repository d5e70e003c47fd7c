"""Vector environment of Gymnasium in which each agent is a sub-environment."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from gymnasium import spaces
from gymnasium.vector import VectorEnv as GymnasiumVectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_choice, check_instance
from matrixworld.envs.vector import AGENT_KEYS, VectorEnv
from matrixworld.episodes.render import rgb
from matrixworld.world.arrays import integers

TEAMS = ("pursuer", "evader")


class AgentVectorEnv(GymnasiumVectorEnv[NDArray[Any], NDArray[Any], NDArray[Any]]):
    """The agents of a `VectorEnv` as sub-environments, for learners and wrappers of single agents.

    Sub-environment ``w * n + i`` is agent i of the n agents in world w: ``num_envs`` is W * n,
    rewards, terminations and truncations are ``(W * n,)``, a single observation is a Box and a
    single action is Discrete.

    Parameters
    ----------
    worlds : VectorEnv
        The W worlds. Their settings hold here, too: ``copy``, the autoreset mode, dtype and so on.
    team : {None, "pursuer", "evader"}, optional
        The team whose agents are sub-environments; None (the default) for all agents that the
        caller plays. If that is both teams, the other one plays what ``worlds.actions`` holds for
        it at a step: fill ``worlds.evaders.actions[:]`` before it. At first that is staying.

    Attributes
    ----------
    worlds : VectorEnv
        The worlds, with arrays of whole worlds (``worlds.infos["capture_rate"]``).
    num_envs : int
        W * n.

    Raises
    ------
    TypeError
        If `worlds` is not a VectorEnv.
    ValueError
        For an unknown team, and for one that the worlds play themselves.

    Notes
    -----
    **The episode of a sub-environment is the episode of its world.** All agents of a world end and
    start again in the same step, as Gymnasium's autoreset modes prescribe: a sub-environment that
    has ended starts again at once, and an agent that is gone cannot return before its world starts
    its next episode. An agent that disappears earlier therefore does not terminate then. Until its
    world ends it observes zeros, its rewards are 0 and its actions are ignored. In the last step it
    terminates; an agent that is alive terminates or is truncated as its world does. Returns are
    those of the agent, and every agent ends once in each episode.

    A learner that knows nothing of this trains on the steps of gone agents, too. They pay nothing,
    so their value is 0, but agents that see nobody in the open observe the same zeros. A learner
    that can mask transitions does better with two arrays of infos:

    - It uses the transitions where ``infos["acted"]`` is True. This also leaves out the step in
      which `NextStep` only starts an episode.
    - It takes ``terminations | ~infos["alive"]`` for the ends of agents: the value after them is 0.

    ``infos`` has the arrays of `VectorEnv` with an axis of agents, as ``(W * n, ...)``: ``alive``,
    ``acted``, ``positions``, ``involved``, ``fault``, ``cost`` and its kinds, ``action_mask``,
    ``final_obs`` with ``_final_obs``. There is no ``episode``: `RecordEpisodeStatistics` adds it.

    With ``copy=False`` and both teams, arrays are overwritten by the next step as in `VectorEnv`.

    Examples
    --------
    >>> from gymnasium.wrappers.vector import RecordEpisodeStatistics
    >>> from matrixworld import AgentVectorEnv, VectorEnv
    >>> worlds = VectorEnv("O", 16, dtype="float32", flatten=True)
    >>> envs = RecordEpisodeStatistics(AgentVectorEnv(worlds, team="pursuer"))
    >>> observations, infos = envs.reset(seed=0)
    >>> observations.shape, envs.single_action_space
    ((128, 363), Discrete(5))
    """

    single_observation_space: spaces.Box
    single_action_space: spaces.Discrete
    observation_space: spaces.Space[NDArray[Any]]
    action_space: spaces.Space[NDArray[Any]]

    def __init__(self, worlds: VectorEnv, team: str | None = None) -> None:
        check_instance("worlds", worlds, VectorEnv)
        if team is not None:
            check_choice("team", team, TEAMS)
        self.worlds: VectorEnv = worlds
        self.team: str | None = team
        parts = {"pursuer": worlds.pursuers.agents, "evader": worlds.evaders.agents}
        self._slice = parts.get(team or "", slice(None))  # of the agents in the worlds' arrays
        self._agents = worlds.agents[self._slice]
        if not self._agents:
            raise ValueError(f"team: expected the one that the caller plays, got {team!r}")
        self.num_envs: int = worlds.n_worlds * len(self._agents)
        self.metadata: dict[str, Any] = worlds.metadata
        self.render_mode: str | None = worlds.render_mode
        seen = worlds.observations
        self.single_observation_space = spaces.Box(0, 1, seen.shape[2:], seen.dtype.type)
        self.single_action_space = spaces.Discrete(worlds.config.n_actions)
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self.action_space = batch_space(self.single_action_space, self.num_envs)

    @property
    def np_random_seed(self) -> tuple[int, ...]:  # type: ignore[override]
        """The seed of each sub-environment: that of its world."""
        return tuple(seed for seed in self.worlds.np_random_seed for _ in self._agents)

    @property  # type: ignore[misc]
    def np_random(self) -> tuple[np.random.Generator, ...]:  # type: ignore[override]
        """The generator of each sub-environment: that of its world."""
        return tuple(each for each in self.worlds.np_random for _ in self._agents)

    def reset(
        self,
        *,
        seed: int | ArrayLike | None = None,
        options: Mapping[str, Any] | None = None,
    ) -> tuple[NDArray[Any], dict[str, Any]]:
        """Start an episode in every world, or in some, and return observations and infos.

        As `VectorEnv.reset`, with seeds of the worlds, but ``reset_mask`` has the shape (W * n,),
        with the same value for all agents of a world.
        """
        given = dict(options or {})
        if given.get("reset_mask") is not None:
            given["reset_mask"] = self._worlds_of(given["reset_mask"])
        self.worlds._start(seed, given)
        return self._seen()

    def _worlds_of(self, mask: ArrayLike) -> NDArray[Any]:
        """Return the mask of the worlds whose agents are all in a mask of agents."""
        agents = np.asarray(mask)
        if agents.shape != (self.num_envs,):
            raise ValueError(f"reset_mask: expected shape {(self.num_envs,)}, got {agents.shape}")
        by_world = agents.reshape(self.worlds.n_worlds, -1)
        if (by_world != by_world[:, :1]).any():
            raise ValueError(
                "reset_mask: expected the same value for all agents of a world, got both in world "
                f"{int((by_world != by_world[:, :1]).any(axis=1).argmax())}"
            )
        return by_world[:, 0]

    def step(
        self, actions: ArrayLike
    ) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any], NDArray[Any], dict[str, Any]]:
        """Play one round in every world with an action of each sub-environment, (W * n,).

        Returns observations (W * n, ...), rewards, terminations, truncations, all (W * n,), and
        infos; see `AgentVectorEnv`. Raises as `VectorEnv.step` does.
        """
        worlds = self.worlds
        worlds._play(self._all_actions(actions))
        ended = worlds.infos["terminated"] | worlds.infos["truncated"]
        observations, infos = self._seen()
        rewards, truncations = self._flat(worlds.rewards), self._flat(worlds.truncations)
        terminations = self._flat(worlds.terminations & ended[:, None])
        return observations, rewards, terminations, truncations, infos

    def _all_actions(self, given: ArrayLike) -> NDArray[Any]:
        chosen = integers("actions", given)
        if chosen.shape != (self.num_envs,):
            raise ValueError(f"actions: expected shape {(self.num_envs,)}, got {chosen.shape}")
        actions: NDArray[np.int64] = self.worlds.actions.copy()
        actions[:, self._slice] = chosen.reshape(self.worlds.n_worlds, -1)
        return actions

    def _seen(self) -> tuple[NDArray[Any], dict[str, Any]]:
        worlds = self.worlds
        observations = self._flat(worlds.observations)
        infos: dict[str, Any] = {
            key: self._flat(worlds.infos[key]) for key in AGENT_KEYS if key in worlds.infos
        }
        if worlds.infos["final_obs"] is worlds.observations:
            infos["final_obs"] = observations
        infos["_final_obs"] = np.repeat(worlds.infos["_final_obs"], len(self._agents))
        return observations, infos

    def _flat(self, array: NDArray[Any]) -> NDArray[Any]:
        """Return the agents' part of an array (W, A, ...) as (W * n, ...)."""
        flat = array[:, self._slice].reshape(self.num_envs, *array.shape[2:])
        # The part of one team is a copy already, except where there is one world.
        shared = np.may_share_memory(flat, array)
        return flat.copy() if self.worlds.copy and shared else flat

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """Return a picture of its world for each agent, with its field of view outlined."""
        self.worlds._require_open("render")
        if self.render_mode is None:
            return None
        scenes = [self.worlds.world(number).scene() for number in range(self.worlds.n_worlds)]
        fov = self.worlds.config.fov
        return tuple(
            rgb(scene, fov=fov, viewers=[agent]) for scene in scenes for agent in self._agents
        )

    def close_extras(self, **kwargs: Any) -> None:
        """Close the worlds."""
        # Some versions of Gymnasium also close an environment whose constructor raised.
        if hasattr(self, "worlds"):
            self.worlds.close(**kwargs)
