"""The settings of a world, fixed before its first episode, and obstacle maps in several forms."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, fields, replace
from functools import cached_property
from numbers import Real
from os import PathLike, fspath
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeAlias, TypedDict

import numpy as np
from numpy.typing import NDArray
from typing_extensions import Unpack

from matrixworld import _core
from matrixworld._core import Capture
from matrixworld._util import checks
from matrixworld._util.files import load_toml, read_text
from matrixworld.world.conflicts import agent_name
from matrixworld.world.rules import Rewards, Rules, rules_of

MapLike: TypeAlias = "NDArray[np.bool_] | Sequence[str] | str | PathLike[str]"
"""An obstacle map in any form that `read_map` takes."""

FREE = ".GS"
"""Characters of passable terrain (ground, swamp) in a map."""
BLOCKED = "#@OTW"
"""Characters of impassable terrain: walls, out of bounds, trees, water."""

Obstacles: TypeAlias = "float | MapLike | None"
"""A share of the cells, a map, or no obstacles."""

_SIDE = 40
# The paper's team sizes: surrounding one evader takes up to four pursuers.
_TEAM_SIZES = {Capture.OCCUPATION: (8, 30), Capture.SURROUND: (20, 5)}

WORLDS: Mapping[str, Mapping[str, Any]] = MappingProxyType(
    load_toml(Path(__file__).with_name("worlds.toml"))
)
"""Worlds that have names, as keyword arguments of a `WorldConfig`.

In them neither of two good teams wins nearly all matches.
"""


class WorldSettings(TypedDict, total=False):
    """Keyword arguments that set or change fields of a `WorldConfig`, for type checkers."""

    size: int | None
    rows: int | None
    cols: int | None
    n_pursuers: int | None
    n_evaders: int | None
    fov: int
    diagonal: bool
    max_steps: int
    obstacles: Obstacles
    rewards: Rewards | None


def _sides(rows: int | None, cols: int | None, size: int | None) -> tuple[int | None, int | None]:
    """Return rows and columns, those of a square grid where its size is given instead."""
    if size is None:
        return rows, cols
    if rows is not None or cols is not None:
        raise ValueError("size, rows, cols: expected size alone or rows and cols, got both")
    return (checks.check_integer("size", size),) * 2


def _obstacles(given: Obstacles) -> float | NDArray[np.bool_]:
    if given is None:
        return 0.0
    if isinstance(given, bool):  # Python takes it for a number, and True for a share of 1
        raise TypeError(f"obstacles: expected a number in [0, 1) or a map, got {given!r}")
    if isinstance(given, float | Real):  # for the type checker, a float is no Real
        return checks.check_real("obstacles", given)
    return read_map(given)


def _plain(value: Any) -> Any:
    """Return a setting as JSON holds it: rules and rewards as mappings, a map as rows of text."""
    if isinstance(value, Rules | Rewards):
        return {name: _plain(part) for name, part in vars(value).items()}
    if isinstance(value, np.ndarray):
        return ["".join(".#"[int(cell)] for cell in row) for row in value]
    if isinstance(value, tuple):
        return list(value)
    return getattr(value, "name", value)  # of a member of an enumeration its name


def _all_fields(what: str, kind: type[Any], plain: Any) -> dict[str, Any]:
    """Return a copy of the values of all fields of a dataclass; refuse a missing or unknown one."""
    checks.check_instance(what, plain, Mapping)
    names = {item.name for item in fields(kind)}
    if plain.keys() != names:
        raise ValueError(f"{what}: expected {sorted(names)}, got {sorted(map(str, plain))}")
    return dict(plain)


@dataclass(frozen=True, eq=False, init=False)
class WorldConfig:
    """The settings of a world: its rules, its size and its rewards.

    Settings never change; `dataclasses.replace` makes a changed copy.

    Parameters
    ----------
    rules : Rules or str, optional
        The rules, or the name of a variant such as ``"SB"``. The default is ``"O"``.
    rows, cols : int, optional
        Size of the grid in cells, 1 to 4096 a side. The default is the size of the obstacle map,
        or 40 without one.
    size : int, optional
        In place of both: the side of a square grid.
    n_pursuers, n_evaders : int, optional
        Agents of each team, 1 to 4,194,303. The default is 8 pursuers and 30 evaders, or 20 and 5
        where capture is by surrounding, as in the paper.
    fov : int, optional
        Side, in cells, of the square that an agent sees around itself; odd, at most 255.
    diagonal : bool, optional
        Whether agents move in 8 directions instead of 4. The default is False.
    max_steps : int, optional
        Rounds after which an episode is truncated. The default is 500.
    obstacles : float or map, optional
        A number in [0, 1) is the share of the cells that become obstacles at every reset. They are
        drawn uniformly, so free cells need not be connected. Anything else is a fixed map as
        `read_map` takes it. By default there are no obstacles.
    rewards : Rewards, optional
        The rewards. The default is `Rewards()`, those of the paper.

    Warns
    -----
    UserWarning
        If the rules can never capture an evader.

    Examples
    --------
    >>> import dataclasses
    >>> from matrixworld import WorldConfig
    >>> config = WorldConfig("SB", rows=12, cols=16, n_pursuers=6, n_evaders=2, obstacles=0.1)
    >>> config.n_agents, config.n_actions
    (8, 5)
    >>> dataclasses.replace(config, diagonal=True).n_actions
    9
    """

    rules: Rules
    rows: int
    cols: int
    n_pursuers: int
    n_evaders: int
    fov: int
    diagonal: bool
    max_steps: int
    obstacles: float | NDArray[np.bool_]
    rewards: Rewards

    def __init__(
        self,
        rules: Rules | str = "O",
        *,
        rows: int | None = None,
        cols: int | None = None,
        size: int | None = None,
        n_pursuers: int | None = None,
        n_evaders: int | None = None,
        fov: int = 11,
        diagonal: bool = False,
        max_steps: int = 500,
        obstacles: Obstacles = None,
        rewards: Rewards | None = None,
    ) -> None:
        rows, cols = _sides(rows, cols, size)
        # Written out, not generated: defaults follow from the rules and the map.
        row = rules_of(rules)
        terrain = _obstacles(obstacles)
        height, width = terrain.shape if isinstance(terrain, np.ndarray) else (_SIDE, _SIDE)
        pursuers, evaders = _TEAM_SIZES[row.capture]
        rewards = Rewards() if rewards is None else rewards
        checks.check_instance("rewards", rewards, Rewards)
        numbers = {
            "rows": height if rows is None else rows,
            "cols": width if cols is None else cols,
            "n_pursuers": pursuers if n_pursuers is None else n_pursuers,
            "n_evaders": evaders if n_evaders is None else n_evaders,
            "fov": fov,
            "max_steps": max_steps,
        }
        # A frozen dataclass lets its fields be set in this way only.
        vars(self).update(
            {name: checks.check_integer(name, number) for name, number in numbers.items()},
            rules=row,
            diagonal=checks.check_bool("diagonal", diagonal),
            obstacles=terrain,
            rewards=rewards,
        )
        self.check_map(self.map)
        # Of sizes below 1 the engine says below what is wrong.
        are_positive = min(self.rows, self.cols, self.n_pursuers, self.n_evaders) > 0
        if are_positive and self.n_agents > self.rows * self.cols:
            raise ValueError(
                f"rows: expected at least {self.n_agents} cells (rows x cols) for "
                f"{self.n_pursuers} pursuers and {self.n_evaders} evaders, "
                f"got {self.rows} x {self.cols}"
            )
        # Building the engine's form checks the ranges, so a bad config fails here and not later.
        self.setup  # noqa: B018
        if not row.captures:
            warnings.warn("these rules can never capture an evader", stacklevel=2)

    @classmethod
    def of(
        cls, config: WorldConfig | Rules | str = "O", **changes: Unpack[WorldSettings]
    ) -> WorldConfig:
        """Return a config, or the one of some rules, with fields other than `rules` changed.

        A text is the name of a variant, or one of `WORLDS`.
        """
        checks.check_keywords(changes, WorldSettings.__annotations__, cls.of)
        if isinstance(config, str) and config in WORLDS:
            config = cls(**WORLDS[config])
        if isinstance(config, WorldConfig):
            values: dict[str, Any] = {**changes}  # fields are narrower than what `__init__` takes
            if values.pop("size", None) is not None:
                rows, cols = _sides(values.get("rows"), values.get("cols"), changes["size"])
                values |= {"rows": rows, "cols": cols}
            return replace(config, **values) if values else config
        return cls(config, **changes)

    @property
    def n_agents(self) -> int:
        """Number of agents of both teams."""
        return self.n_pursuers + self.n_evaders

    @property
    def n_actions(self) -> int:
        """Number of actions: 5, or 9 with diagonal moves."""
        return 9 if self.diagonal else 5

    @property
    def map(self) -> NDArray[np.bool_] | None:
        """The fixed obstacle map, bool of shape (rows, cols), or None without one."""
        return self.obstacles if isinstance(self.obstacles, np.ndarray) else None

    @property
    def density(self) -> float:
        """Share of the cells that become obstacles at a reset; 0 with a fixed map."""
        return 0.0 if isinstance(self.obstacles, np.ndarray) else self.obstacles

    def agent_name(self, agent: int) -> str:
        """Return the name of an agent: ``pursuer_0`` and so on, then ``evader_0`` and so on."""
        return agent_name(
            checks.check_integer("agent", agent, 0, self.n_agents - 1), self.n_pursuers
        )

    def check_map(self, obstacles: NDArray[np.bool_] | None) -> None:
        """Raise ValueError unless a map has the size of the world; None passes."""
        if obstacles is not None and np.shape(obstacles) != (self.rows, self.cols):
            expected = f"shape {(self.rows, self.cols)}, the rows and cols"
            raise ValueError(f"obstacle map: expected {expected}, got {np.shape(obstacles)}")

    def to_json(self) -> dict[str, Any]:
        """Return the settings as values that JSON can hold; a map becomes rows of text."""
        return {item.name: _plain(getattr(self, item.name)) for item in fields(self)}

    @classmethod
    def from_json(cls, plain: Mapping[str, Any]) -> WorldConfig:
        """Return the settings from plain values, such as ``episode.config`` of a recording."""
        values = _all_fields("config", cls, plain)
        # A text would be the path of a map: plain values must not choose a file to read.
        if not isinstance(values["obstacles"], float | int | list):
            raise TypeError(f"obstacles: expected a number or a list, got {values['obstacles']!r}")
        for name, kind in (("rules", Rules), ("rewards", Rewards)):
            values[name] = kind(**_all_fields(name, kind, values[name]))
        return cls(**values)

    # Not by the dataclass, which would compare a map element by element.
    def __eq__(self, other: object) -> bool:
        return isinstance(other, WorldConfig) and self.to_json() == other.to_json()

    def __hash__(self) -> int:
        return hash(repr(self.to_json()))

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields; the engine's form of them is built again on demand."""
        return {item.name: getattr(self, item.name) for item in fields(self)}

    # Kept, because worlds, batches and rollouts of this config all start from it.
    @cached_property
    def setup(self) -> _core.Setup:
        """The engine's form of the settings."""
        rewards, numbers = self.rewards, self.__getstate__()
        for name in ("rules", "rewards", "obstacles"):
            del numbers[name]
        paid = {name: rewards.by_team(name) for name in ("capture", "neighbor", "collide", "step")}
        return _core.Setup(
            rules=_core.Rules(**vars(self.rules)),
            rewards=_core.Rewards(
                **paid, blame=rewards.blame, capture_repeats=rewards.capture_repeats
            ),
            density=self.density,
            map=None if self.map is None else self.map.astype(np.uint8),
            **numbers,
        )


def world_name(config: WorldConfig) -> str:
    """Return the name of one of `WORLDS`; empty for other worlds."""
    return next((name for name in WORLDS if WorldConfig.of(name) == config), "")


def read_map(source: MapLike) -> NDArray[np.bool_]:
    """Return an obstacle map as a new bool array (rows, cols), True where an obstacle is.

    Parameters
    ----------
    source : array_like of bool, str, sequence of str, or path
        An array of shape (rows, cols) of bools, or of 0 and 1; rows of text with the characters of
        `FREE` and `BLOCKED`, or all rows as one text; or the path of a MovingAI ``.map`` file
        (Sturtevant 2012, "Benchmarks for grid-based pathfinding").

    Examples
    --------
    >>> from matrixworld import read_map
    >>> read_map(["..#", "#.."])
    array([[False, False,  True],
           [ True, False, False]])
    """
    if isinstance(source, str) and "\n" in source:
        return _from_rows(source.strip().splitlines(), "map")
    if isinstance(source, str | PathLike):
        return _from_file(Path(fspath(source)))
    if isinstance(source, Sequence) and all(isinstance(row, str) for row in source):
        return _from_rows(list(source), "map")
    array = np.array(None)
    with suppress(ValueError):  # of rows of different lengths
        array = checks.unmasked("map", source)
    if array.ndim == 0 or array.dtype.kind in "OUS":
        expected = "a path, rows of text or an array"
        raise TypeError(f"map: expected {expected}, got {checks.shown(source)}")
    return _from_array(array)


def _from_array(array: NDArray[Any]) -> NDArray[np.bool_]:
    if array.dtype.kind not in "biu":
        raise TypeError(f"map: expected dtype bool, or 0 and 1, got {array.dtype}")
    if array.ndim != 2 or not array.size:
        raise ValueError(f"map: expected shape (rows, cols), got {array.shape}")
    unknown = array[(array != 0) & (array != 1)]
    if unknown.size:
        raise ValueError(f"map: expected 0 (free) or 1 (obstacle), got {unknown[0]}")
    return array.astype(np.bool_)  # a copy: the caller may change its array later


def _from_rows(rows: list[str], name: str) -> NDArray[np.bool_]:
    rows = [row.strip() for row in rows]  # programs leave blanks at the ends of lines
    if not rows or not rows[0]:
        raise ValueError(f"{name}: expected at least one row of at least one cell, got {rows!r}")
    cells = len(rows[0])
    for number, row in enumerate(rows):
        where = f"{name}, row {number}"
        if len(row) != cells:
            raise ValueError(f"{where}: expected {cells} cells as in row 0, got {len(row)}")
        unknown = sorted(set(row) - set(FREE + BLOCKED))
        if unknown:
            expected = f"{FREE!r} (free) or {BLOCKED!r} (obstacle)"
            raise ValueError(f"{where}: expected {expected}, got {unknown}")
    return np.array([[cell in BLOCKED for cell in row] for row in rows])


def _from_file(path: Path) -> NDArray[np.bool_]:
    lines = [line.strip() for line in read_text(path, "map").splitlines()]
    lines = [line for line in lines if line]
    header = dict(line.split(maxsplit=1) for line in lines[:3] if len(line.split()) > 1)
    if lines[3:4] != ["map"] or set(header) != {"type", "height", "width"}:
        expected = "a MovingAI map (lines type, height, width and map)"
        raise ValueError(f"{path}: expected {expected}, got {lines[:4]}")
    array = _from_rows(lines[4:], str(path))
    sizes = header["height"], header["width"]
    if [int(size) if size.isdecimal() else size for size in sizes] != list(array.shape):
        expected = ", ".join(sizes)
        raise ValueError(f"{path}: expected ({expected}) cells as in its header, got {array.shape}")
    return array
