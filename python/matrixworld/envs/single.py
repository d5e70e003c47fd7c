"""One world as an environment: of PettingZoo for all agents, or of Gymnasium for one of them."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from copy import copy
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import DTypeLike, NDArray
from pettingzoo import AECEnv, ParallelEnv
from pettingzoo.utils.wrappers import AssertOutOfBoundsWrapper, OrderEnforcingWrapper
from typing_extensions import Unpack

from matrixworld._util import checks
from matrixworld.envs.opponents import (
    BuiltInTeam,
    Observation,
    Opponents,
    PlaysTeam,
    one_team,
    with_opponent,
)
from matrixworld.episodes.episode import Episode
from matrixworld.episodes.record import Drawing
from matrixworld.world.arrays import LARGE, WORLD_FIELDS, WorldArrays, python_value
from matrixworld.world.config import WorldConfig, WorldSettings
from matrixworld.world.policy import Team
from matrixworld.world.rules import COLLISION_KINDS, Rules, variant_name
from matrixworld.world.world import World

Seen = NDArray[Any]
Info = dict[str, Any]

RENDER_MODES = ("human", "rgb_array", "ansi")

OPTIONS = ("episode", "pursuers", "evaders", "obstacles")
"""The keys that ``options`` of a reset may hold; each is an argument of `World.reset`."""


class Status(WorldArrays):
    """Results of the last step for all agents, as fresh arrays: see `array_specs`."""

    def __init__(self, world: World) -> None:
        arrays = world.read(*(WORLD_FIELDS.keys() - {*LARGE}))
        vars(self).update({name: python_value(array) for name, array in arrays.items()})

    def add_collisions(self, earlier: Status) -> None:
        """Add the collisions and captors of an earlier round."""
        np.logical_or(self.involved, earlier.involved, out=self.involved)
        np.logical_or(self.fault, earlier.fault, out=self.fault)
        np.maximum(self.captors, earlier.captors, out=self.captors)
        self.cost[:] = self.fault.sum(axis=1)

    def infos(self) -> list[Info]:
        """Return the info of each agent, with plain values."""
        n_pursuers = len(self.alive) - len(self.captured)
        by_kind = {"involved": self.involved, "fault": self.fault, "cost": self.fault.astype(float)}
        of_agents = {
            "captured": [False] * n_pursuers + self.captured.tolist(),
            "captors": [0] * n_pursuers + self.captors.tolist(),
            "cost": self.cost.tolist(),
            **{
                f"{name}_{kind}": column
                for name, array in by_kind.items()
                for kind, column in zip(COLLISION_KINDS, array.T.tolist(), strict=True)
            },
        }
        pursuers, evaders = self.survival_rate.tolist()
        of_all = {
            "step": self.steps,
            "capture_rate": self.capture_rate,
            "ever_capture_rate": self.ever_capture_rate,
            "pursuer_survival_rate": pursuers,
            "evader_survival_rate": evaders,
        }
        rows = zip(*of_agents.values(), strict=True)
        return [dict(zip(of_agents, row, strict=True)) | of_all for row in rows]


class MatrixWorldBase(PlaysTeam):
    """What both environments share; `MatrixWorldParallel` tells its arguments and attributes."""

    _actions: NDArray[np.int64]
    _mates: BuiltInTeam | None = None  # which plays for the others of the caller's team

    def __init__(
        self,
        config: WorldConfig | Rules | str = "O",
        *,
        render_mode: str | None = None,
        record: bool = False,
        action_mask: bool | str = False,
        observation: Observation = "views",
        dtype: DTypeLike | None = None,
        flatten: bool = False,
        pursuers: Opponents | None = None,
        evaders: Opponents | None = None,
        **changes: Unpack[WorldSettings],
    ) -> None:
        checks.check_keywords(changes, WorldSettings.__annotations__, MatrixWorldBase)
        self._set_up(config, changes, action_mask, render_mode, *RENDER_MODES)
        self._space = self._space_of(observation, dtype, flatten)
        self._read = {self._observed}
        if self._masks.given:
            self._read.add("views")
        self.world = World(self.config)
        variant = variant_name(self.config.rules).lower() or "custom"
        self.metadata |= {"name": f"pursuit_evasion_{variant}_v0", "is_parallelizable": True}
        built_in = one_team(pursuers, evaders)
        self._team = None if built_in is None else BuiltInTeam(*built_in, self.config)
        played = range(self.config.n_agents) if self._team is None else self._team.learners
        self._names = {agent: self.config.agent_name(agent) for agent in played}
        self._index = {name: agent for agent, name in self._names.items()}
        self.possible_agents: list[str] = list(self._index)
        self.agents: list[str] = []
        is_kept = checks.check_bool("record", record) or render_mode is not None
        self._drawing = Drawing(self.world, render_mode) if is_kept else None
        self.observation_spaces: dict[str, spaces.Box] = {
            name: copy(self._space)  # not shared: each has a generator of its own
            for name in self.possible_agents
        }
        self.action_spaces: dict[str, spaces.Discrete] = {
            name: spaces.Discrete(self.config.n_actions) for name in self.possible_agents
        }
        whole = (3, self.config.rows, self.config.cols)
        self.state_space: spaces.Box = spaces.Box(0, 1, whole, np.uint8)
        self._seeded = False
        self.np_random = np.random.default_rng(0)  # for wrappers that draw; the world never does

    def observation_space(self, agent: str) -> spaces.Box:
        """Return ``Box(0, 1, (3, fov, fov), uint8)``: evaders, pursuers, obstacles in view.

        `observation`, `flatten` and `dtype` change bounds, shape and dtype.
        """
        checks.check_choice("agent", agent, self._index)
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> spaces.Discrete:
        """Return ``Discrete(5)``, or 9 with diagonal moves; see `matrixworld.Action`."""
        checks.check_choice("agent", agent, self._index)
        return self.action_spaces[agent]

    def state(self) -> NDArray[np.uint8]:
        """Return the whole world, uint8 of shape (3, rows, cols): evaders, pursuers, obstacles."""
        return self.world.state()

    @property
    def status(self) -> Status:
        """The last step for all agents at once, in arrays in which an agent keeps its index."""
        return Status(self.world)

    def _observe(self, status: Status) -> tuple[Seen, list[Info]]:
        """Return what all agents observe now, in the form of the spaces, and their infos."""
        arrays = self.world.read(*self._read)
        infos = status.infos()
        if self._masks.given:
            for info, mask in zip(infos, self._allowed(arrays["views"]), strict=True):
                info["action_mask"] = mask
        observations = arrays[self._observed].reshape(len(infos), *self._space.shape)
        return observations.astype(self._space.dtype, copy=False), infos

    def _allowed(self, views: NDArray[np.uint8]) -> NDArray[np.int8]:
        """Return the masks of all agents, in one order with the teammates that are played."""
        in_turn = self._mates is not None and self._mates.yields_in_turn
        return self._masks.of(views, step=self.world.steps if in_turn else None)

    def _by_agent(self, agents: list[str], values: Any) -> dict[str, Any]:
        return {agent: values[self._index[agent]] for agent in agents}

    def _reset_world(self, seed: int | None, options: Mapping[str, Any] | None) -> None:
        arguments = dict(options or {})
        for unknown in set(arguments) - set(OPTIONS):
            warnings.warn(f"options: expected some of {OPTIONS}, ignored {unknown!r}", stacklevel=3)
            del arguments[unknown]
        if seed is None and not self._seeded:
            # The first episode without a seed is a random one; later ones continue its seed.
            seed = int(np.random.SeedSequence().generate_state(1, np.uint64)[0])
        self.world.reset(seed, **arguments)
        if seed is not None:
            self.np_random = np.random.default_rng(self.world.seed)
        for team in filter(None, (self._team, self._mates)):
            team.draw(0, self.world.seed, self.world.episode)
        self._seeded = True
        self.agents = self.possible_agents[:]
        if self._drawing is not None:
            self._drawing.begin()
            self._drawing.show()

    def _note_round(self) -> None:
        if self._drawing is not None:
            self._drawing.note(self._actions)
            self._drawing.show()

    def _choose(self, agent: str, action: Any) -> None:
        most = self.config.n_actions - 1
        chosen = checks.check_integer(f"action of {agent}", action, 0, most)
        self._actions[self._index[agent]] = chosen

    def _decide(self, actions: NDArray[np.int64], agents: range) -> None:
        if self._team is not None:
            self._team.decide(self.world, agents, actions)

    @property
    def opponent(self) -> int | None:
        """The place in `opponents` of this episode's opponent; None without one."""
        return None if self._team is None else int(self._team.chosen[0])

    def render(self) -> NDArray[np.uint8] | str | None:
        """Draw the present moment: pixels (height, width, 3) uint8 or a text; None for "human"."""
        if self.render_mode is None or self._drawing is None:
            raise ValueError(f"render_mode: expected one of {RENDER_MODES}, got None")
        if not self._seeded:
            raise RuntimeError("call reset() first")
        return self._drawing.render()

    @property
    def recorded(self) -> Episode:
        """The episode so far, to `replay` or save; RuntimeError if steps are not kept."""
        if self._drawing is None:
            raise RuntimeError("no episode was kept: make the environment with record=True")
        if not self._seeded:
            raise RuntimeError("call reset() first")
        return self._drawing.episode()


class MatrixWorldParallel(MatrixWorldBase, ParallelEnv[str, Seen, int]):  # type: ignore[misc]
    """Environment of PettingZoo's parallel API: all agents act at once.

    Where the rules take turns, a step plays a round with actions that were chosen before it.

    Parameters
    ----------
    config : WorldConfig, Rules or str, optional
        The settings, the rules, or the name of a variant such as ``"O"`` (the default) or
        ``"pursuit-evasion-o"``.
    render_mode : {None, "human", "rgb_array", "ansi"}, optional
        "human" shows every step in a notebook's output or the terminal. "rgb_array" returns
        pictures, uint8 (height, width, 3); "ansi" returns text.
    record : bool, optional
        Whether to keep every step for `recorded`, as with a render mode.
    action_mask : bool or str, optional
        Whether infos have an ``action_mask``, int8 of shape (n_actions,): 1 for allowed actions.
        True or "obstacles" allows moves that run into neither an obstacle nor the border (`fov` at
        least 3); "right-of-way" those that cannot put the agent at fault if its teammates keep to
        their masks, too (`fov` at least 5). The default is False.
    observation : {"views", "named"}, optional
        What agents observe: views (the default), or the named inputs of each move, ``(moves,
        inputs)`` in the order of `INPUTS`.
    dtype : dtype, optional
        Dtype of the observations: of views uint8 (the default) or float32, of named inputs float32.
    flatten : bool, optional
        Whether each observation has one axis, such as ``(3 * fov * fov,)``.
    pursuers, evaders : Opponents, optional
        What plays for one of the teams, see `matrixworld.envs.opponents`: one of several is drawn
        for each episode. Its agents are not in `possible_agents`. By default the caller plays both.
    **changes
        Fields of `WorldConfig` to change.

    Attributes
    ----------
    world : World
        The world that is played.
    possible_agents : list of str
        Names of the caller's agents: ``pursuer_0`` and so on, then ``evader_0`` and so on.
    agents : list of str
        Names of the agents that still play; empty before the first reset and after the end.
    """

    def reset(
        self, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[dict[str, Seen], dict[str, Info]]:
        """Start an episode. If arguments are refused, the environment stays as it was.

        Parameters
        ----------
        seed : int, optional
            By default the next episode of the present seed starts; the first one is drawn from the
            operating system.
        options : mapping, optional
            Arguments of `World.reset`, named in `OPTIONS`; others are ignored with a warning.

        Returns
        -------
        observations, infos : dict
            By the name of the agent.
        """
        self._reset_world(seed, options)
        observations, infos = self._observe(self.status)
        return self._by_agent(self.agents, observations), self._by_agent(self.agents, infos)

    def step(
        self, actions: Mapping[str, Any]
    ) -> tuple[
        dict[str, Seen], dict[str, float], dict[str, bool], dict[str, bool], dict[str, Info]
    ]:
        """Play a round.

        Parameters
        ----------
        actions : mapping of str to int
            Actions of `agents`, by name.

        Returns
        -------
        observations, rewards, terminations, truncations, infos : dict
            By the name of the agent, for all that acted. An agent that disappears in this step
            observes zeros, terminates, and leaves `agents`.

        Raises
        ------
        RuntimeError
            If the episode has ended.
        ValueError, TypeError
            For a bad or missing action or an unknown agent; nothing has changed.
        """
        if not self.agents:
            if actions or not self._seeded:
                raise RuntimeError("the episode has ended, or never began: call reset()")
            return {}, {}, {}, {}, {}  # on which wrappers of PettingZoo rely
        acting = self.agents
        self._choose_all(actions)
        self._decide(self._actions, range(self.config.n_agents))
        self.world.step(self._actions)
        self._note_round()
        status = Status(self.world)
        observations, infos = self._observe(status)
        terminations = self._by_agent(acting, status.terminations.tolist())
        truncations = self._by_agent(acting, status.truncations.tolist())
        # All that acted get their last results; agents that ended leave only now.
        self.agents: list[str] = [a for a in acting if not (terminations[a] or truncations[a])]
        return (
            self._by_agent(acting, observations),
            self._by_agent(acting, status.rewards.tolist()),
            terminations,
            truncations,
            self._by_agent(acting, infos),
        )

    def _choose_all(self, actions: Mapping[str, Any]) -> None:
        checks.check_instance("actions", actions, Mapping)
        missing = [agent for agent in self.agents if agent not in actions]
        if missing:
            raise ValueError(f"actions: expected one for each of agents, none came for {missing}")
        unknown = [agent for agent in actions if agent not in self._index]
        if unknown:
            raise ValueError(f"actions: expected names of agents, got {unknown}")
        self._actions = np.zeros(self.config.n_agents, np.int64)
        for agent in self.agents:
            self._choose(agent, actions[agent])


class MatrixWorldAEC(MatrixWorldBase, AECEnv[str, Seen, int]):  # type: ignore[misc]
    """An environment in which one agent acts after the other, with arguments of `parallel_env`.

    Actions are collected until all agents of a turn have chosen; then the turn is played.
    """

    agent_selection: str
    _to_commit: list[str]  # agents of this turn that have not chosen yet

    def __init__(self, config: WorldConfig | Rules | str = "O", **settings: Any) -> None:
        super().__init__(config, **settings)
        # Where teams or agents take turns, they see what earlier ones did: that game is not the one
        # in which all choose at once.
        self.metadata["is_parallelizable"] = self.world.n_turns == 1

    def reset(self, seed: int | None = None, options: Mapping[str, Any] | None = None) -> None:
        """Start an episode; see `MatrixWorldParallel.reset`."""
        self._reset_world(seed, options)
        self._actions = np.zeros(self.config.n_agents, np.int64)
        self.agent_selection = self.agents[0]
        self._to_commit = []
        self.rewards: dict[str, float] = dict.fromkeys(self.agents, 0.0)
        self._cumulative_rewards = dict.fromkeys(self.agents, 0.0)
        self.terminations: dict[str, bool] = dict.fromkeys(self.agents, False)
        self.truncations: dict[str, bool] = dict.fromkeys(self.agents, False)
        self.infos: dict[str, Info] = {}
        self._skip_agent_selection: str | None = None
        self._play_until_actors()

    def observe(self, agent: str) -> Seen:
        """Return what an agent sees after the last played turn, as in its observation space."""
        checks.check_choice("agent", agent, self._index)
        return np.array(self._seen[self._index[agent]])

    def step(self, action: Any) -> None:
        """Choose the action of `agent_selection`; the last choice of a turn plays the turn.

        The action of an agent that has ended is None. If one is refused, nothing has changed.
        """
        if not self.agents:
            raise RuntimeError("the episode has ended, or never began: call reset()")
        agent = self.agent_selection
        if self.terminations[agent] or self.truncations[agent]:
            self._was_dead_step(action)
            return
        self._choose(agent, action)
        self._cumulative_rewards[agent] = 0.0
        self._clear_rewards()
        if self._to_commit:
            self.agent_selection = self._to_commit.pop(0)
            return
        self._play_turn()
        self._play_until_actors()

    def _play_turn(self) -> None:
        # Rewards accumulate over a round in the world; an AEC step pays the difference of its turn.
        before = self.world.rewards.astype(float) if self.world.turn else 0.0
        self._decide(self._actions, self.world.actors)
        self.world.play_turn(self._actions)
        paid = (self.world.rewards.astype(float) - before).tolist()
        for agent in self.agents:
            self.rewards[agent] += paid[self._index[agent]]
        if self.world.turn == 0:
            self._note_round()

    def _play_until_actors(self) -> None:
        """Play turns of agents that are gone or built in, select who acts next, and pay rewards."""
        ended: list[Status] = []
        while not (actors := self._living_actors()):
            if self.world.turn == 0 and (self.world.terminated or self.world.truncated):
                break
            if self.world.turn == 0:  # the next turn forgets the collisions of this round
                ended.append(self.status)
            self._play_turn()
        self._report(ended)
        if actors:
            self.agent_selection, *self._to_commit = actors
        self._accumulate_rewards()
        self._deads_step_first()

    def _report(self, ended: list[Status]) -> None:
        """Tell all agents the results of this round and of those that ended before it."""
        status = self.status
        for earlier in ended:
            status.add_collisions(earlier)
        self._seen, infos = self._observe(status)
        self.terminations |= self._by_agent(self.agents, status.terminations.tolist())
        self.truncations |= self._by_agent(self.agents, status.truncations.tolist())
        self.infos |= self._by_agent(self.agents, infos)

    def _living_actors(self) -> list[str]:
        if self.world.terminated:
            return []
        alive = self.world.alive
        return [self._names[i] for i in self.world.actors if i in self._names and alive[i]]


parallel_env = MatrixWorldParallel


def aec_env(config: WorldConfig | Rules | str = "O", **settings: Any) -> MatrixWorldAEC:
    """Make an environment of PettingZoo's AEC API: one agent acts after the other.

    Where the rules take turns, this is the game itself: an agent observes what earlier agents did.
    Where they do not, agents only choose one after the other, and the last choice plays the round.

    Parameters
    ----------
    config, **settings
        As for `parallel_env`.

    Returns
    -------
    MatrixWorldAEC
        In PettingZoo's wrappers, which refuse actions out of range and calls out of order.
    """
    env: MatrixWorldAEC = OrderEnforcingWrapper(
        AssertOutOfBoundsWrapper(MatrixWorldAEC(config, **settings))
    )
    return env


class AgentEnv(gymnasium.Env[Any, Any]):
    """One agent of a world as an environment of Gymnasium; all other agents are played.

    ``gymnasium.make("matrixworld/pursuit_evasion_o_v0")`` makes one, with these arguments.

    Parameters
    ----------
    config, **settings
        As for `parallel_env`.
    agent : str, optional
        The agent that the caller plays, such as ``"evader_2"``. The default is ``"pursuer_0"``.
    pursuers, evaders : Opponents, optional
        What plays the other agents of each team, as for `parallel_env`. The defaults are
        ``"clumsy-chaser"`` and ``"clumsy-fleer"``, against which first attempts learn. With the
        `action_mask` of right of way only teammates that keep it, too, leave the agent without
        fault: ``careful-`` scripts, and policies with this mask. It has their order.

    Attributes
    ----------
    env : MatrixWorldParallel
        The environment of the agent's team. Its ``status``, ``recorded`` and ``world`` tell more.

    Notes
    -----
    An episode terminates when the agent disappears or its world terminates, and is truncated with
    its world. All agents choose before a round is played.
    """

    def __init__(
        self,
        config: WorldConfig | Rules | str = "O",
        *,
        agent: str = "pursuer_0",
        pursuers: Opponents = "clumsy-chaser",
        evaders: Opponents = "clumsy-fleer",
        **settings: Any,
    ) -> None:
        team: Team = "evader" if str(agent).startswith("evader") else "pursuer"
        if team == "pursuer":
            mates = pursuers
            settings["evaders"] = evaders
        else:
            mates = evaders
            settings["pursuers"] = pursuers
        self.env = MatrixWorldParallel(config, **settings)
        self._mates = self.env._mates = BuiltInTeam(team, mates, self.env.config)
        checks.check_choice("agent", agent, self.env.possible_agents)
        self.agent: str = agent
        self.observation_space: spaces.Box = self.env.observation_space(agent)
        self.action_space: spaces.Discrete = self.env.action_space(agent)
        self.metadata: dict[str, Any] = self.env.metadata
        self.render_mode: str | None = self.env.render_mode

    def reset(
        self, *, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[Seen, dict[str, Any]]:
        """Start an episode and return observation and info; see `MatrixWorldParallel.reset`."""
        observations, infos = self.env.reset(seed, options)
        super().reset(seed=None if seed is None else int(seed))
        return observations[self.agent], infos[self.agent]

    def step(self, action: int) -> tuple[Seen, float, bool, bool, dict[str, Any]]:
        """Play a round; return observation, reward, terminated, truncated and info of the agent."""
        env = self.env
        if self.agent not in env.agents:
            raise RuntimeError("the episode has ended, or never began: call reset()")
        # The policy decides for all agents of the team; the caller's agent then chooses itself.
        actions = np.zeros(env.config.n_agents, np.int64)
        self._mates.decide(env.world, range(len(actions)), actions)
        chosen = env._by_agent(env.agents, actions.tolist()) | {self.agent: action}
        observations, rewards, terminations, truncations, infos = env.step(chosen)
        return (
            observations[self.agent],
            rewards[self.agent],
            terminations[self.agent],
            truncations[self.agent],
            infos[self.agent],
        )

    def action_masks(self) -> NDArray[np.bool_]:
        """Return which actions are allowed now, bool (n_actions,): all without an `action_mask`."""
        env = self.env
        masks: NDArray[np.bool_] = env._allowed(env.world.views())[env._index[self.agent]] > 0
        return masks

    def render(self) -> Any:
        """See `MatrixWorldParallel.render`."""
        return self.env.render()


def make(
    config: WorldConfig | Rules | str = "O",
    *,
    team: Team | None = None,
    opponent: Opponents | None = None,
    **settings: Any,
) -> MatrixWorldParallel:
    """Make a `parallel_env` of which the caller plays both teams, or one against an opponent.

    Parameters
    ----------
    config, **settings
        As for `parallel_env`, such as ``size=10``.
    team : {"pursuer", "evader"}, optional
        The team that the caller plays. The default is both.
    opponent : Opponents, optional
        What plays the other team, see `matrixworld.envs.opponents`. The default is
        ``"clumsy-fleer"`` or ``"clumsy-chaser"``.

    Returns
    -------
    MatrixWorldParallel
        The environment.
    """
    return MatrixWorldParallel(config, **with_opponent(team, opponent, settings))
