"""One agent of a world as an environment of Gymnasium; all other agents are played."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.envs.registration import EnvSpec
from numpy.typing import NDArray

from matrixworld._util.checks import check_choice
from matrixworld.envs.opponents import BuiltInTeam, Opponents
from matrixworld.envs.single import MatrixWorldParallel, View
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import Rules


class AgentEnv(gymnasium.Env[Any, Any]):
    """One agent of a world as an environment of Gymnasium; all other agents are played.

    ``gymnasium.make("matrixworld/pursuit_evasion_o_v0")`` makes one, with these arguments.

    Parameters
    ----------
    config : WorldConfig, Rules or str, optional
        The world, its rules, or the name of a variant. The default is ``"O"``.
    agent : str, optional
        The agent that the caller plays, such as ``"evader_2"``. The default is ``"pursuer_0"``.
    pursuers, evaders : Opponents, optional
        What plays the other agents of each team, as for `parallel_env`: a script, a held-out
        opponent, a run directory, a policy, or several, of which each episode draws one. The
        defaults are ``"clumsy-chaser"`` and ``"clumsy-fleer"``, against which first attempts learn.
    **settings
        Other arguments of `parallel_env`: a render mode, and fields of `WorldConfig` to change.

    Attributes
    ----------
    env : MatrixWorldParallel
        The environment of the agent's team. Its ``status``, ``recorded`` and ``world`` tell more.
    observation_space : Box
        ``Box(0, 1, (3, fov, fov), uint8)``: evaders, pursuers and obstacles around the agent.
    action_space : Discrete
        5 actions, or 9 with diagonal moves; see `Action`.

    Notes
    -----
    An episode terminates when the agent disappears or its world terminates, and is truncated with
    its world. All agents choose before a round is played.

    Examples
    --------
    >>> import gymnasium, matrixworld
    >>> settings = {"rows": 10, "cols": 10, "n_pursuers": 2, "n_evaders": 1}
    >>> env = gymnasium.make("matrixworld/pursuit_evasion_o_v0", **settings)
    >>> observation, info = env.reset(seed=0)
    >>> observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
    >>> observation.shape
    (3, 11, 11)
    """

    _spec: EnvSpec | None = None

    def __init__(
        self,
        config: WorldConfig | Rules | str = "O",
        *,
        agent: str = "pursuer_0",
        pursuers: Opponents = "clumsy-chaser",
        evaders: Opponents = "clumsy-fleer",
        **settings: Any,
    ) -> None:
        if str(agent).startswith("evader"):
            self.env = MatrixWorldParallel(config, pursuers=pursuers, **settings)
            self._mates = BuiltInTeam("evader", evaders, self.env.config)
        else:
            self.env = MatrixWorldParallel(config, evaders=evaders, **settings)
            self._mates = BuiltInTeam("pursuer", pursuers, self.env.config)
        check_choice("agent", agent, self.env.possible_agents)
        self.agent: str = agent
        self.observation_space: spaces.Box = self.env.observation_space(agent)
        self.action_space: spaces.Discrete = self.env.action_space(agent)
        self.metadata: dict[str, Any] = self.env.metadata
        self.render_mode: str | None = self.env.render_mode

    @property
    def spec(self) -> EnvSpec | None:
        """Gymnasium's specification, in which wrappers look for `max_steps`."""
        return self._spec

    @spec.setter
    def spec(self, spec: EnvSpec | None) -> None:
        if spec is not None and spec.max_episode_steps is None:
            spec = replace(spec, max_episode_steps=self.env.config.max_steps)
        self._spec = spec

    def reset(
        self, *, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[View, dict[str, Any]]:
        """Start an episode and return observation and info; see `MatrixWorldParallel.reset`.

        Without a seed the next episode of the present seed starts.
        """
        observations, infos = self.env.reset(seed, options)
        super().reset(seed=None if seed is None else int(seed))
        self._mates.draw(0, self.env.world.seed, self.env.world.episode)
        return observations[self.agent], infos[self.agent]

    def step(self, action: int) -> tuple[View, float, bool, bool, dict[str, Any]]:
        """Play a round; return observation, reward, terminated, truncated and info of the agent.

        Raises RuntimeError if the episode has ended, ValueError or TypeError for a bad action.
        """
        env = self.env
        if self.agent not in env.agents:
            raise RuntimeError("the episode has ended, or never began: call reset()")
        everyone = range(env.config.n_agents)
        # The policy decides for all agents of the team; the caller's agent then chooses itself.
        actions = np.zeros(len(everyone), np.int64)
        self._mates.decide(env.world, everyone, actions)
        chosen = dict(zip(map(env.config.agent_name, everyone), actions.tolist(), strict=True))
        mine = self.agent
        seen, reward, terminated, truncated, info = env.step(
            {**{name: chosen[name] for name in env.agents}, mine: action}
        )
        return seen[mine], reward[mine], terminated[mine], truncated[mine], info[mine]

    def action_masks(self) -> NDArray[np.bool_]:
        """Return which actions are allowed now, bool (n_actions,), for learners that ask for it.

        All are, unless the environment was made with an ``action_mask``.
        """
        env = self.env
        masks: NDArray[np.bool_] = env._masks.of(env.world.views())[env._index[self.agent]] > 0
        return masks

    def render(self) -> Any:
        """See `MatrixWorldParallel.render`."""
        return self.env.render()
