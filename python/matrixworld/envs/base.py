"""The part that the parallel and the AEC environments share."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray
from typing_extensions import Unpack

from matrixworld._util.checks import check_bool, check_keywords
from matrixworld.envs.opponents import HasOpponents, Opponents, built_in_team
from matrixworld.episodes.display import Drawing
from matrixworld.episodes.episode import Episode
from matrixworld.world.arrays import (
    WORLD_FIELDS,
    OutputField,
    WorldArrays,
    action_masks,
    check_maskable,
    python_value,
)
from matrixworld.world.config import WorldConfig, WorldSettings
from matrixworld.world.rules import COLLISION_KINDS, VARIANTS, Rules
from matrixworld.world.world import World


class EnvSettings(WorldSettings, total=False):
    """Keyword arguments of an environment, for type checkers; see `MatrixWorldBase`."""

    render_mode: str | None
    fields_of_view: bool | Iterable[str]
    record: bool
    action_mask: bool
    max_cycles: int | None
    pursuers: Opponents | None
    evaders: Opponents | None


RENDER_MODES = ("human", "rgb_array", "ansi")

OPTIONS = ("episode", "pursuers", "evaders", "obstacles")
"""The keys that ``options`` of a reset may hold; each is an argument of `World.reset`.

An environment that plays a team itself knows ``opponents``, too.
"""

# World arrays that infos leave out: `step` returns them, or they are attributes of `Status` only.
_NOT_IN_INFOS = {
    *("rewards", "terminations", "truncations", "terminated", "truncated", "views", "state"),
    *("positions", "last_positions", "alive", "ever_captured", "seed", "episode"),
}
_INFO_FIELDS = [output for name, output in WORLD_FIELDS.items() if name not in _NOT_IN_INFOS]


def _keys(output: OutputField) -> list[str]:
    if output.axes == ("agents", "kinds"):
        return [f"{output.name}_{kind}" for kind in COLLISION_KINDS]
    if output.axes == ("teams",):
        return [f"{team}_{output.name}" for team in ("pursuer", "evader")]
    return ["step" if output.name == "steps" else output.name]


INFO_KEYS = (
    *(key for output in _INFO_FIELDS for key in _keys(output)),
    *(f"cost_{kind}" for kind in COLLISION_KINDS),
)
"""The keys of every agent's info, at every step."""


class Status(WorldArrays):
    """Results of the last step for all agents at once, as fresh arrays: see `array_specs`.

    Pursuers come before evaders. An agent keeps its index when others are gone. `World.reset`
    accepts `seed` and `episode`.

    Parameters
    ----------
    world : World
        The world.
    """

    def __init__(self, world: World) -> None:
        arrays = world.read(*(WORLD_FIELDS.keys() - {"views", "state"}))
        vars(self).update({name: python_value(array) for name, array in arrays.items()})

    def add_collisions(self, earlier: Status) -> None:
        """Add the collisions and captors of an earlier round, for a report of several rounds."""
        np.logical_or(self.involved, earlier.involved, out=self.involved)
        np.logical_or(self.fault, earlier.fault, out=self.fault)
        np.maximum(self.captors, earlier.captors, out=self.captors)
        self.cost[:] = self.fault.sum(axis=1)

    def infos(self) -> list[dict[str, Any]]:
        """Return the info of each agent: a dict of `INFO_KEYS` with plain values."""
        n_agents = len(self.alive)
        columns = [
            column
            for output in _INFO_FIELDS
            for column in _columns(output, vars(self)[output.name], n_agents)
        ]
        columns += self.fault.T.astype(float).tolist()
        return [dict(zip(INFO_KEYS, row, strict=True)) for row in zip(*columns, strict=True)]


def _columns(output: OutputField, value: Any, n_agents: int) -> list[list[Any]]:
    """Return, for each info key of an output, the values of all agents."""
    if output.axes == ("agents", "kinds"):
        return list(value.T.tolist())
    if output.axes[:1] == ("agents",):
        return [value.tolist()]
    if output.axes[:1] == ("evaders",):  # a pursuer has the zero of the dtype
        return [[value.dtype.type(0).item()] * (n_agents - len(value)) + value.tolist()]
    return [[each] * n_agents for each in np.ravel(value).tolist()]


class MatrixWorldBase(HasOpponents):
    """A world with names of agents, spaces and pictures, as PettingZoo wants them.

    Parameters
    ----------
    config : WorldConfig, Rules or str, optional
        The settings, the rules, or the name of a variant. The default is ``"O"``.
    render_mode : {None, "human", "rgb_array", "ansi"}, optional
        "human" shows every step in a window, a notebook's output or the terminal. "rgb_array"
        returns pictures, uint8 of shape (height, width, 3); "ansi" returns text.
    fields_of_view : bool or iterable of str, optional
        The agents whose fields of view pictures outline: True for all, or their names.
    record : bool, optional
        Whether to keep every step for `recorded`. With a render mode steps are always kept.
    action_mask : bool, optional
        Whether infos have an ``action_mask``, int8 of shape (n_actions,): 1 for the moves that run
        into neither an obstacle nor the border. Needs a `fov` of at least 3. The default is False.
    max_cycles : int, optional
        Another name for ``max_steps`` of the config, as other PettingZoo environments call it.
    pursuers, evaders : Opponents, optional
        What plays for one of the teams, if the environment plays it itself; see
        `matrixworld.envs.opponents`. Each episode draws one of several. Agents of that team are not
        in `possible_agents`. By default the caller plays both teams.
    **changes
        Fields of `WorldConfig` to change.

    Attributes
    ----------
    world : World
        The world that is played.
    config : WorldConfig
        Its settings.
    possible_agents : list of str
        Names of the caller's agents: ``pursuer_0`` and so on, then ``evader_0`` and so on.
    agents : list of str
        Names of the agents that still play; empty before the first reset and after the end.

    Raises
    ------
    ValueError, TypeError
        As `WorldConfig` does, and for an unknown render mode or agent.

    Notes
    -----
    A copy (`copy.deepcopy`, `pickle`) is at the same moment of the same episode, and goes on
    independently. A window is not copied.
    """

    world: World
    possible_agents: list[str]
    render_mode: str | None

    def __init__(
        self,
        config: WorldConfig | Rules | str = "O",
        *,
        render_mode: str | None = None,
        fields_of_view: bool | Iterable[str] = False,
        record: bool = False,
        action_mask: bool = False,
        max_cycles: int | None = None,
        pursuers: Opponents | None = None,
        evaders: Opponents | None = None,
        **changes: Unpack[WorldSettings],
    ) -> None:
        check_keywords(changes, WorldSettings.__annotations__, MatrixWorldBase)
        if max_cycles is not None:
            changes["max_steps"] = max_cycles
        if render_mode not in (None, *RENDER_MODES):
            raise ValueError(
                f"render_mode: expected None or one of {RENDER_MODES}, got {render_mode!r}"
            )
        self.config: WorldConfig = WorldConfig.of(config, **changes)
        self._has_masks = check_bool("action_mask", action_mask)
        if self._has_masks:
            check_maskable(self.config)
        self.world = World(self.config)
        self.render_mode = render_mode
        self.metadata: dict[str, Any] = metadata_of(self.config)
        self._team = built_in_team(self.config, pursuers, evaders)
        played = range(self.config.n_agents) if self._team is None else self._team.learners
        self._names = {agent: self.config.agent_name(agent) for agent in played}
        self._index = {name: agent for agent, name in self._names.items()}
        self.possible_agents = list(self._index)
        self.agents: list[str] = []
        viewers = self._viewers(fields_of_view)
        kept = check_bool("record", record) or render_mode is not None
        self._drawing = Drawing(self.world, render_mode, viewers) if kept else None
        self._make_spaces()
        self._seeded = False

    def _viewers(self, fields_of_view: bool | Iterable[str]) -> list[int]:
        if isinstance(fields_of_view, bool):
            return list(self._index.values()) if fields_of_view else []
        named = list(fields_of_view)
        unknown = [name for name in named if name not in self._index]
        if unknown:
            raise ValueError(f"fields_of_view: expected names of agents, got {unknown}")
        return [self._index[name] for name in named]

    def _make_spaces(self) -> None:
        config = self.config
        view, whole = (3, config.fov, config.fov), (3, config.rows, config.cols)
        self.observation_spaces: dict[str, spaces.Box] = {
            name: spaces.Box(0, 1, view, np.uint8)  # not shared: each has a generator of its own
            for name in self.possible_agents
        }
        self.action_spaces: dict[str, spaces.Discrete] = {
            name: spaces.Discrete(config.n_actions) for name in self.possible_agents
        }
        self.state_space: spaces.Box = spaces.Box(0, 1, whole, np.uint8)

    def observation_space(self, agent: str) -> spaces.Box:
        """Return ``Box(0, 1, (3, fov, fov), uint8)``: evaders, pursuers, obstacles in view."""
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> spaces.Discrete:
        """Return ``Discrete(5)``, or 9 with diagonal moves; see `matrixworld.Action`."""
        return self.action_spaces[agent]

    def state(self) -> NDArray[np.uint8]:
        """Return the whole world, uint8 of shape (3, rows, cols): evaders, pursuers, obstacles."""
        return self.world.state()

    @property
    def status(self) -> Status:
        """The last step for all agents at once, in arrays in which an agent keeps its index."""
        return Status(self.world)

    def _infos(self, status: Status, views: NDArray[np.uint8]) -> list[dict[str, Any]]:
        """Return the info of each agent, in which `views` are what the agents see now."""
        infos = status.infos()
        if self._has_masks:
            masks = action_masks(views, self.config.n_actions)
            infos = [info | {"action_mask": mask} for info, mask in zip(infos, masks, strict=True)]
        return infos

    def _reset_world(self, seed: int | None, options: Mapping[str, Any] | None) -> None:
        given = dict(options or {})
        known = self._known_options(OPTIONS)
        for unknown in set(given) - set(known):
            warnings.warn(f"options: expected some of {known}, ignored {unknown!r}", stacklevel=3)
            del given[unknown]
        opponents = self._take_opponents(given)
        if seed is None and not self._seeded:
            # The first episode without a seed is a random one; later ones continue its seed.
            seed = int(np.random.SeedSequence().generate_state(1, np.uint64)[0])
        self.world.reset(seed, **given)
        if self._team is not None:
            self._team.opponents = opponents
            self._team.begin(self.world.seed, self.world.episode)
        self._seeded = True
        self.agents = self.possible_agents[:]
        if self._drawing is not None:
            self._drawing.begin()

    def _decide(self, actions: NDArray[np.int64], agents: range) -> None:
        """Write the actions of the team that the environment plays itself, if it plays one."""
        if self._team is not None:
            self._team.decide(self.world, agents, actions)

    @property
    def opponent(self) -> int | None:
        """The place in `opponents` of this episode's opponent, when it began; None without one."""
        return None if self._team is None else int(self._team.chosen[0])

    def render(self) -> NDArray[np.uint8] | str | None:
        """Draw the present moment: pixels (height, width, 3) uint8 or a text; None for "human".

        ValueError if the environment has no render mode, RuntimeError before the first reset.
        """
        if self.render_mode is None or self._drawing is None:
            raise ValueError(
                f"render: expected a render_mode of {RENDER_MODES} when the environment was made"
            )
        self._require_begun()
        return self._drawing.render()

    def _require_begun(self) -> None:
        if not self._seeded:
            raise RuntimeError("call reset() first")

    @property
    def recorded(self) -> Episode:
        """The episode so far, to `replay` or save.

        RuntimeError before the first reset, and if steps are not kept (see ``record``).
        """
        if self._drawing is None:
            raise RuntimeError("no episode was kept: make the environment with record=True")
        self._require_begun()
        return self._drawing.episode()

    def close(self) -> None:
        """Close the window, if there is one."""
        if self._drawing is not None:
            self._drawing.close()


def metadata_of(config: WorldConfig) -> dict[str, Any]:
    """Return PettingZoo's metadata of an environment."""
    names = [name.lower() for name, rules in VARIANTS.items() if rules == config.rules]
    return {
        "name": f"pursuit_evasion_{names[0] if names else 'custom'}_v0",
        "render_modes": list(RENDER_MODES),
        "render_fps": 10,
        "is_parallelizable": True,
    }
