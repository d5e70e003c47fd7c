"""Vector environments of Gymnasium: many worlds, stepped together, or each agent of many worlds."""

from __future__ import annotations

from collections.abc import Mapping
from copy import copy as copy_of
from copy import deepcopy
from inspect import signature
from typing import Any, TypeVar

import numpy as np
from gymnasium import spaces
from gymnasium.vector import AutoresetMode
from gymnasium.vector import VectorEnv as GymnasiumVectorEnv
from numpy.typing import ArrayLike, DTypeLike, NDArray
from typing_extensions import Unpack

from matrixworld._core import Autoreset
from matrixworld._util import checks
from matrixworld.envs.opponents import (
    BuiltInWorlds,
    Observation,
    Opponents,
    PlaysTeam,
    one_team,
    resolved,
    with_opponent,
)
from matrixworld.play.functions import Function
from matrixworld.world import arrays
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig, WorldSettings
from matrixworld.world.policy import TEAMS, Team
from matrixworld.world.render import rgb
from matrixworld.world.rules import COLLISION_KINDS, Rules
from matrixworld.world.world import World

OPTIONS = ("reset_mask", "episode", "pursuers", "evaders", "obstacles")
"""Keys that ``options`` of a reset may have."""

Results = TypeVar("Results", bound="tuple[Any, ...]")
"""What `reset` or `step` of a vector environment returns."""

EPISODE_KEYS = {
    name.removeprefix("episode_"): name
    for name in arrays.BATCH_FIELDS
    if name.startswith("episode_")
}
"""The keys of ``infos["episode"]``, and the arrays of `episode_specs` that they are."""

AGENT_KEYS = (
    *(name for name, field in arrays.WORLD_FIELDS.items() if field.axes[:1] == ("agents",)),
    *("acted", "final_obs", "action_mask", *(f"cost_{kind}" for kind in COLLISION_KINDS)),
)
"""The keys of infos whose arrays have an axis of agents after that of worlds."""

# Arrays that infos leave out: `reset` and `step` return them, or infos have them in another form.
_NOT_IN_INFOS = {
    *("rewards", "terminations", "truncations", "views", "inputs", "last_positions"),
    *("ended", "final_views", "final_inputs", *EPISODE_KEYS.values()),
}
# Gymnasium has its own meaning for ``infos["episode"]``.
_RENAMED = {"steps": "step", "episode": "episode_number"}


class VectorEnv(PlaysTeam, GymnasiumVectorEnv[NDArray[Any], NDArray[Any], NDArray[Any]]):
    """Vector environment of W worlds with A agents each, pursuers first.

    Parameters
    ----------
    config, threads, **changes
        As for `Batch`.
    n_worlds : int, optional
        W. The default is 1.
    copy : bool, optional
        Whether `reset` and `step` return copies that belong to the caller (the default), or the
        arrays that every step overwrites, which is faster.
    autoreset_mode : gymnasium.vector.AutoresetMode or str, optional
        What happens after the end of an episode, as for `Batch`. With ``NextStep`` (the default)
        the next step starts another episode, with ``SameStep`` the last step does, whose last
        observations are in ``infos["final_obs"]``. ``Disabled`` waits for a reset of that world.
    observation, dtype, flatten : optional
        As for `parallel_env`: observations are ``(W, A, 3, fov, fov)``, ``(W, A, moves, inputs)``,
        or flat, ``(W, A, n)``.
    action_mask : bool or str, optional
        Whether and how ``infos["action_mask"]`` marks allowed actions, as for `parallel_env`.
    render_mode : {None, "rgb_array"}, optional
        What `render` returns. The default is None.
    pursuers, evaders : Opponents, optional
        What plays for one of the teams, as for `parallel_env`. All arrays of agents are then those
        of the other team, and A is its number of agents. By default the caller plays both.

    Attributes
    ----------
    observations, rewards, terminations, truncations, infos : ndarray and dict
        Results of the last step, see Notes. Every step overwrites these arrays.
    actions : ndarray of int64, shape (W, A)
        Actions for a `step` without arguments, to write into: ``envs.actions[:] = 0``.
    pursuers, evaders : slice
        The teams' parts of the axis of agents: ``envs.rewards[:, envs.evaders]``.
    agents : range
        The numbers of the A agents in their worlds.

    Notes
    -----
    Rewards, terminations and truncations are ``(W, A)``: float32, bool, bool. Gymnasium's wrappers
    for vector environments of single agents want ``(W,)``, as `AgentVectorEnv` has. An agent
    terminates when it disappears or its world terminates, and stays terminated. A learner uses the
    transitions of agents that acted in this step, which ``infos["acted"]`` marks.

    With ``copy=False``, and in the attributes always, arrays are the same at every step: copy what
    you keep. Only one thread of Python may use an environment at a time, see `Batch`.

    ``infos`` has the same keys at every step: all arrays of `array_specs` and `episode_specs` that
    are not results, each with a leading axis of W worlds, under their names, but:

    | key | shape | |
    |---|---|---|
    | ``step``, ``episode_number`` | (W,) | the arrays ``steps`` and ``episode`` |
    | ``cost_obstacle``, ``cost_teammate``, ``cost_adversary`` | (W, A) bool | at fault in a collision of this kind |
    | ``action_mask`` | (W, A, n_actions) int8 | 1 for allowed actions; only with an ``action_mask`` |
    | ``final_obs``, ``_final_obs`` | as observations; (W,) bool | last observations of an episode; whether it ended in this step |
    | ``opponent`` | (W,) int64 | place in `opponents`; only with a built-in team, whose last one is in ``episode``, too |
    | ``episode``, ``_episode`` | dict of `EPISODE_KEYS`; (W,) bool | statistics of the last ended episode, as in `EpisodeStatistics`; whether it ended in this step |
    """  # noqa: E501  (a row of a table is one line)

    _team: BuiltInWorlds | None

    def __init__(
        self,
        config: WorldConfig | Rules | str = "O",
        n_worlds: int = 1,
        *,
        copy: bool = True,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        observation: Observation = "views",
        dtype: DTypeLike | None = None,
        flatten: bool = False,
        action_mask: bool | str = False,
        threads: int | None = None,
        render_mode: str | None = None,
        pursuers: Opponents | None = None,
        evaders: Opponents | None = None,
        **changes: Unpack[WorldSettings],
    ) -> None:
        checks.check_keywords(changes, WorldSettings.__annotations__, VectorEnv)
        self._set_up(config, changes, action_mask, render_mode, "rgb_array")
        self._space = self._space_of(observation, dtype, flatten)
        self.num_envs: int = checks.check_integer("n_worlds", n_worlds, 1)
        mode_name = getattr(autoreset_mode, "value", autoreset_mode)
        checks.check_choice("autoreset_mode", mode_name, [mode.value for mode in AutoresetMode])
        mode = AutoresetMode(mode_name)
        self.metadata["autoreset_mode"] = mode
        self.copy: bool = checks.check_bool("copy", copy)
        built_in = one_team(pursuers, evaders)
        large = {self._observed}  # arrays that are left out unless they are asked for
        waits = mode is not AutoresetMode.SAME_STEP
        if not waits:  # else the observations stay those of the episode's end for one step
            large.add(f"final_{self._observed}")
        if self._masks.given or built_in is not None:  # functions that play see views
            large.add("views")
        if built_in is not None:
            team, given = built_in
            built_in = team, resolved(team, given, self.config)
            large |= {plays.reads for plays in built_in[1] if isinstance(plays, Function)}
        buffers = _make_buffers(
            self.config, self.num_envs, large, self._observed, self._space.dtype
        )
        self._batch = Batch(
            self.num_envs,
            self.config,
            threads=threads,
            autoreset=Autoreset[mode.name],
            buffers=buffers,
        )
        self._team = None if built_in is None else BuiltInWorlds(*built_in, self._batch, waits)
        everyone = range(self.config.n_agents)
        self.agents: range = everyone if self._team is None else self._team.learners
        of_agents = _of_agents(buffers, self.agents)
        # `reshape` that joins the last axes makes a view, so the batch writes into observations.
        shape = self.n_worlds, len(self.agents), *self._space.shape
        self.observations: NDArray[Any] = of_agents[self._observed].reshape(shape)
        self.rewards: NDArray[np.float32] = of_agents["rewards"]
        self.terminations: NDArray[np.bool_] = of_agents["terminations"]
        self.truncations: NDArray[np.bool_] = of_agents["truncations"]
        self.infos: dict[str, Any] = _make_infos(of_agents, self.observations, self._observed)
        if self._team is not None:
            self.infos["opponent"] = self._team.chosen
            self.infos["episode"]["opponent"] = self._team.last
        if self._masks.given:
            self._views: NDArray[Any] = of_agents["views"]
            self.infos["action_mask"] = self._masks.of(self._views, self.agents.start)
        n_actions = self.config.n_actions
        self.single_observation_space: spaces.Box = _widened(self._space, shape[1:])
        self.observation_space = _widened(self._space, shape)
        self.single_action_space = spaces.MultiDiscrete([n_actions] * len(self.agents))
        self.action_space = _widened(spaces.Box(0, n_actions - 1, (1,), np.int64), shape[:2])
        self._actions: NDArray[np.int64] = np.zeros(shape[:2], np.int64)
        first_evader = max(0, self.config.n_pursuers - self.agents.start)
        self.pursuers: slice = slice(0, first_evader)
        self.evaders: slice = slice(first_evader, None)
        self._seeded = False
        # A batch starts with fixed seeds, which would make every unseeded run the same.
        self._batch.reset(np.random.SeedSequence().generate_state(self.num_envs, np.uint64))

    @property
    def n_worlds(self) -> int:
        """The number of worlds, W; Gymnasium's name is ``num_envs``."""
        return self.num_envs

    @property
    def actions(self) -> NDArray[np.int64]:
        """Actions for a `step` without arguments, int64 (W, A)."""
        return self._actions

    def reset(
        self, *, seed: int | ArrayLike | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[NDArray[Any], dict[str, Any]]:
        """Start an episode in every world, or in some.

        Parameters
        ----------
        seed : int or array_like of int, shape (W,), optional
            As for `Batch.reset`. Worlds that never had a seed draw one from the operating system.
        options : mapping, optional
            Any of `OPTIONS`: arguments of `Batch.reset`, whose ``mask`` is ``reset_mask`` here.

        Returns
        -------
        observations : ndarray, shape (W, A, ...)
        infos : dict of str to ndarray
            See the notes of the class.
        """
        self._start(seed, options)
        return self._returned((self.observations, self.infos))

    def _start(self, seed: int | ArrayLike | None, options: Mapping[str, Any] | None) -> None:
        arguments = dict(options or {})
        unknown = set(arguments) - set(OPTIONS)
        if unknown:
            raise ValueError(f"options: expected some of {OPTIONS}, got {sorted(unknown)}")
        if seed is None and not self._seeded:
            seed = self.infos["seed"]
        mask = arguments.pop("reset_mask", None)
        self._batch.reset(seed, mask=mask, **arguments)
        if self._team is not None:
            everywhere = np.ones(self.num_envs, np.bool_)
            self._team.begin(everywhere if mask is None else np.asarray(mask))
        self._seeded = True
        self._write_masks()

    def step(
        self, actions: ArrayLike | None = None
    ) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any], NDArray[Any], dict[str, Any]]:
        """Play one round in every world.

        Parameters
        ----------
        actions : array_like of int, shape (W, A), optional
            By default those of the attribute. Of gone agents and in ended worlds they are ignored.

        Returns
        -------
        observations, rewards, terminations, truncations : ndarray, shape (W, A, ...)
        infos : dict of str to ndarray
            The attributes or copies of them.

        Raises
        ------
        RuntimeError
            Before the first reset.
        """
        self._play(actions)
        ends = self.terminations, self.truncations
        return self._returned((self.observations, self.rewards, *ends, self.infos))

    def _play(self, actions: ArrayLike | None) -> None:
        if not self._seeded:
            raise RuntimeError("call reset() before the first step")
        if actions is None:
            actions = self.actions
        if self._team is None:
            self._batch.step(actions)
        else:
            self._batch.step(self._team.actions(actions))
            self._team.note_step()
        self._write_masks()

    def _write_masks(self) -> None:
        if "action_mask" in self.infos:
            self.infos["action_mask"][:] = self._masks.of(self._views, self.agents.start)

    def _returned(self, results: Results) -> Results:
        return deepcopy(results) if self.copy else results

    def world(self, number: int) -> World:
        """Return an independent copy of one world, to draw it or to plan in it."""
        return self._batch.world(number)

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """Return a picture of each world, (height, width, 3) uint8; None without a render mode."""
        if self.render_mode is None:
            return None
        return tuple(rgb(self.world(number).scene()) for number in range(self.n_worlds))


def make_vec(
    config: WorldConfig | Rules | str = "O",
    num_envs: int = 1,
    *,
    team: Team | None = None,
    opponent: Opponents | None = None,
    **settings: Any,
) -> VectorEnv:
    """Make a `VectorEnv` with the names of arguments that ``gymnasium.make_vec`` uses.

    Parameters
    ----------
    config, **settings
        As for `VectorEnv`, such as ``size=10`` or ``flatten=True``.
    num_envs : int, optional
        Number of worlds. The default is 1.
    team, opponent : optional
        As for `make`.

    Returns
    -------
    VectorEnv
        The environment.
    """
    names = WorldSettings.__annotations__.keys() | signature(VectorEnv).parameters.keys()
    checks.check_keywords(settings, names - {"n_worlds", "changes"}, make_vec)
    return VectorEnv(config, num_envs, **with_opponent(team, opponent, settings))


class AgentVectorEnv(GymnasiumVectorEnv[NDArray[Any], NDArray[Any], NDArray[Any]]):
    """The agents of a `VectorEnv` as sub-environments, for learners and wrappers of single agents.

    Sub-environment ``w * n + i`` is agent i of the n agents in world w: ``num_envs`` is W * n. A
    single observation is a Box and a single action is Discrete.

    Parameters
    ----------
    worlds : VectorEnv
        An attribute, too: ``worlds.infos["capture_rate"]``. Its settings hold here: ``copy``, the
        autoreset mode, dtype and so on.
    team : {"pursuer", "evader"}, optional
        The agents that are sub-environments. The default is all that the caller plays. If that is
        both teams, the other one plays what ``worlds.actions`` holds for it at a step, such as
        ``worlds.actions[:, worlds.evaders]``; at first that is staying.

    Notes
    -----
    **The episode of a sub-environment is the episode of its world.** All agents of a world end and
    start again in the same step, as Gymnasium's autoreset modes prescribe. An agent that disappears
    earlier observes zeros until then, its rewards are 0 and its actions are ignored. A learner that
    can mask transitions does better with those where ``infos["acted"]`` is True, and with
    ``terminations | ~infos["alive"]`` as the ends of agents.

    ``infos`` has the arrays of `VectorEnv` with an axis of agents, as ``(W * n, ...)``, and
    ``_final_obs``. There is no ``episode``: `RecordEpisodeStatistics` adds it.
    """

    def __init__(self, worlds: VectorEnv, team: Team | None = None) -> None:
        checks.check_instance("worlds", worlds, VectorEnv)
        if team is not None:
            checks.check_choice("team", team, TEAMS)
        self.worlds: VectorEnv = worlds
        self.team: Team | None = team
        parts = {"pursuer": worlds.pursuers, "evader": worlds.evaders, None: slice(None)}
        self._slice = parts[team]  # of the agents in the worlds' arrays
        self._agents = worlds.agents[self._slice]
        if not self._agents:
            raise ValueError(f"team: expected the one that the caller plays, got {team!r}")
        self.num_envs: int = worlds.n_worlds * len(self._agents)
        self.metadata: dict[str, Any] = worlds.metadata
        self.render_mode: str | None = worlds.render_mode
        n_actions = worlds.config.n_actions
        space = worlds._space
        self.single_observation_space: spaces.Box = copy_of(space)
        self.observation_space = _widened(space, (self.num_envs, *space.shape))
        self.single_action_space: spaces.Discrete = spaces.Discrete(n_actions)
        self.action_space = _widened(spaces.MultiDiscrete([n_actions]), (self.num_envs,))

    def reset(
        self, *, seed: int | ArrayLike | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[NDArray[Any], dict[str, Any]]:
        """Start an episode in every world, or in some, and return observations and infos.

        As `VectorEnv.reset`, but ``reset_mask`` is (W * n,), the same for all agents of a world.
        """
        arguments = dict(options or {})
        if arguments.get("reset_mask") is not None:
            arguments["reset_mask"] = self._worlds_of(arguments["reset_mask"])
        self.worlds._start(seed, arguments)
        return self._seen()

    def _worlds_of(self, mask: ArrayLike) -> NDArray[Any]:
        agents = checks.unmasked("reset_mask", mask)
        checks.check_shape("reset_mask", agents, self.num_envs)
        by_world = agents.reshape(self.worlds.n_worlds, -1)
        differ = (by_world != by_world[:, :1]).any(axis=1)
        if differ.any():
            raise ValueError(
                "reset_mask: expected the same value for all agents of a world, "
                f"got both in world {int(differ.argmax())}"
            )
        return by_world[:, 0]

    def step(
        self, actions: ArrayLike
    ) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any], NDArray[Any], dict[str, Any]]:
        """Play one round in every world with an action of each sub-environment, (W * n,).

        Returns observations (W * n, ...), rewards, terminations, truncations, (W * n,), and infos.
        """
        chosen = arrays.integers("actions", actions)
        checks.check_shape("actions", chosen, self.num_envs)
        worlds = self.worlds
        everyone: NDArray[np.int64] = worlds.actions.copy()
        everyone[:, self._slice] = chosen.reshape(worlds.n_worlds, -1)
        worlds._play(everyone)
        ended = worlds.infos["terminated"] | worlds.infos["truncated"]
        observations, infos = self._seen()
        rewards, truncations = self._flat(worlds.rewards), self._flat(worlds.truncations)
        terminations = self._flat(worlds.terminations & ended[:, None])
        return observations, rewards, terminations, truncations, infos

    def _seen(self) -> tuple[NDArray[Any], dict[str, Any]]:
        worlds = self.worlds
        observations = self._flat(worlds.observations)
        infos: dict[str, Any] = {
            key: observations if part is worlds.observations else self._flat(part)
            for key, part in worlds.infos.items()
            if key in AGENT_KEYS
        }
        infos["_final_obs"] = np.repeat(worlds.infos["_final_obs"], len(self._agents))
        return observations, infos

    def _flat(self, array: NDArray[Any]) -> NDArray[Any]:
        """Return the agents' part of an array (W, A, ...) as (W * n, ...)."""
        flat = array[:, self._slice].reshape(self.num_envs, *array.shape[2:])
        # The part of one team is a copy already, except where there is one world.
        shared = np.may_share_memory(flat, array)
        return flat.copy() if self.worlds.copy and shared else flat

    def action_masks(self) -> NDArray[np.bool_]:
        """Return which actions are allowed now, bool (W * n, n_actions), as `AgentEnv` does."""
        masks = self.worlds.infos.get("action_mask")
        if masks is None:
            return np.ones((self.num_envs, self.worlds.config.n_actions), np.bool_)
        return self._flat(masks) > 0

    def call(self, name: str, *args: Any, **kwargs: Any) -> tuple[Any, ...]:
        """Return `spec`, `render_mode` or the result of `render` of each sub-environment."""
        if name == "render":
            pictures = self.render(*args, **kwargs)
            return (None,) * self.num_envs if pictures is None else pictures
        if name in ("spec", "render_mode"):
            return (getattr(self, name),) * self.num_envs
        raise AttributeError(f"call: expected render, render_mode or spec, got {name!r}")

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """Return a picture of its world for each agent; None without a render mode."""
        pictures = self.worlds.render()
        return pictures and tuple(picture for picture in pictures for _ in self._agents)


def _widened(space: spaces.Space[Any], shape: tuple[int, ...]) -> Any:
    """Return a space with more leading axes; its bounds are views of the given, no large arrays."""
    wide = copy_of(space)
    for name, part in vars(space).items():
        if isinstance(part, np.ndarray):
            setattr(wide, name, np.broadcast_to(part, shape))
    wide._shape = shape
    return wide


def _make_buffers(
    config: WorldConfig, n_worlds: int, asked: set[str], observed: str, dtype: DTypeLike
) -> dict[str, NDArray[Any]]:
    """Return an array of zeros for each output of a batch; of large ones, those asked for."""
    specs = arrays.array_specs(config) | arrays.episode_specs(config)
    left_out = {*arrays.LARGE, "final_views", "final_inputs"} - asked
    chosen: arrays.Specs = {
        name: (shape, dtype if name.endswith(observed) else usual)
        for name, (shape, usual) in specs.items()
        if name not in left_out
    }
    return arrays.new_arrays(chosen, n_worlds)


def _of_agents(buffers: dict[str, NDArray[Any]], agents: range) -> dict[str, NDArray[Any]]:
    """Return the same arrays with some agents only, without copies."""
    fields = arrays.WORLD_FIELDS | arrays.BATCH_FIELDS
    part = slice(agents.start, agents.stop)
    return {
        name: array[:, part] if fields[name].axes[:1] == ("agents",) else array
        for name, array in buffers.items()
    }


def _make_infos(
    buffers: dict[str, NDArray[Any]], observations: NDArray[Any], observed: str
) -> dict[str, Any]:
    """Return the infos of a vector environment: its buffers under the names of `VectorEnv`."""
    infos: dict[str, Any] = {
        _RENAMED.get(name, name): array
        for name, array in buffers.items()
        if name not in _NOT_IN_INFOS
    }
    infos |= {f"cost_{kind}": buffers["fault"][..., k] for k, kind in enumerate(COLLISION_KINDS)}
    # Without an array of its own, the end of an episode is what the observations show then.
    final = buffers.get(f"final_{observed}")
    infos["final_obs"] = observations if final is None else final.reshape(observations.shape)
    infos["episode"] = {key: buffers[name] for key, name in EPISODE_KEYS.items()}
    return infos | dict.fromkeys(("_final_obs", "_episode"), buffers["ended"])
