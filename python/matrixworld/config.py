"""What is fixed for a world before its first episode."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld import _core
from matrixworld._core import Capture
from matrixworld.checks import check_bool, check_integer
from matrixworld.maps import MapLike, read_map
from matrixworld.rules import Rewards, Rules, rules_of

Obstacles: TypeAlias = "float | MapLike | None"

_SIDE = 40
_TEAM_SIZES = {Capture.OCCUPATION: (8, 30), Capture.SURROUND: (20, 5)}  # the paper's


def _obstacles(given: Obstacles) -> float | NDArray[np.bool_]:
    if given is None:
        return 0.0
    if isinstance(given, bool):
        raise TypeError(f"obstacles: expected a number in [0, 1) or a map, got {given!r}")
    if isinstance(given, int | float | np.floating):
        return float(given)
    return read_map(given)


@dataclass(frozen=True, eq=False, init=False)
class WorldConfig:
    """The settings of a world.

    rules: a row of rules, or the name of a variant
    rows, cols: cells, 1 to 4096 a side; by default those of the obstacle map, or 40
    n_pursuers, n_evaders: 1 to 4,194,303; by default the paper's 8 and 30, under surround 20 and 5
    fov: side of an agent's square view in cells, odd, at most 255
    diagonal: whether agents move in 8 directions instead of 4
    max_steps: rounds until an episode is truncated
    obstacles: none; the share of the cells, in [0, 1), that become obstacles anew at every reset
        (drawn uniformly, without care for connectedness); or a map as `read_map` takes it
    rewards: what is paid

    Raises TypeError for values of a wrong type and ValueError for values out of range, such as
    more agents than free cells. Warns where the rules can never capture anybody.
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
        n_pursuers: int | None = None,
        n_evaders: int | None = None,
        fov: int = 11,
        diagonal: bool = False,
        max_steps: int = 500,
        obstacles: Obstacles = None,
        rewards: Rewards | None = None,
    ) -> None:
        row = rules_of(rules)
        ground = _obstacles(obstacles)
        height, width = ground.shape if isinstance(ground, np.ndarray) else (_SIDE, _SIDE)
        pursuers, evaders = _TEAM_SIZES[row.capture]
        if rewards is not None and not isinstance(rewards, Rewards):
            raise TypeError(f"rewards: expected Rewards, got {rewards!r}")
        values: dict[str, Any] = {
            "rules": row,
            "rows": height if rows is None else rows,
            "cols": width if cols is None else cols,
            "n_pursuers": pursuers if n_pursuers is None else n_pursuers,
            "n_evaders": evaders if n_evaders is None else n_evaders,
            "fov": fov,
            "diagonal": check_bool("diagonal", diagonal),
            "max_steps": max_steps,
            "obstacles": ground,
            "rewards": Rewards() if rewards is None else rewards,
        }
        for name in ("rows", "cols", "n_pursuers", "n_evaders", "fov", "max_steps"):
            values[name] = check_integer(name, values[name])
        for name, value in values.items():
            object.__setattr__(self, name, value)
        self.check_map(self.map)
        self.setup  # noqa: B018  (the engine checks the ranges)
        if not row.captures:
            warnings.warn("these rules can never capture an evader", stacklevel=2)

    @classmethod
    def of(cls, config: WorldConfig | Rules | str = "O", **changes: Any) -> WorldConfig:
        """``config`` itself or the config of these rules, with some fields changed."""
        if isinstance(config, WorldConfig):
            return replace(config, **changes) if changes else config
        return cls(config, **changes)

    @property
    def n_agents(self) -> int:
        """Agents of both teams."""
        return self.n_pursuers + self.n_evaders

    @property
    def n_actions(self) -> int:
        """5, or 9 with diagonal moves."""
        return 9 if self.diagonal else 5

    @property
    def map(self) -> NDArray[np.bool_] | None:
        """The given obstacle map, ``(rows, cols)`` bool, or None."""
        return self.obstacles if isinstance(self.obstacles, np.ndarray) else None

    @property
    def density(self) -> float:
        """The share of cells that become obstacles at a reset; 0 with a given map."""
        return 0.0 if isinstance(self.obstacles, np.ndarray) else self.obstacles

    def agent_name(self, agent: int) -> str:
        """``pursuer_0`` ... and then ``evader_0`` ..."""
        if agent < self.n_pursuers:
            return f"pursuer_{agent}"
        return f"evader_{agent - self.n_pursuers}"

    def check_map(self, obstacles: NDArray[np.bool_] | None) -> None:
        """Raise ValueError where a map is not of this size."""
        if obstacles is not None and obstacles.shape != (self.rows, self.cols):
            raise ValueError(
                f"obstacle map: expected shape {(self.rows, self.cols)} as rows and cols say, "
                f"got {obstacles.shape}"
            )

    def to_json(self) -> dict[str, Any]:
        """The settings as plain values: numbers, names, and rows of text for a map."""
        plain = {item.name: getattr(self, item.name) for item in fields(self)}
        plain["rules"] = {
            item.name: getattr(value, "name", value)
            for item in fields(self.rules)
            for value in [getattr(self.rules, item.name)]
        }
        plain["rewards"] = {
            item.name: getattr(value, "name", list(value) if isinstance(value, tuple) else value)
            for item in fields(self.rewards)
            for value in [getattr(self.rewards, item.name)]
        }
        if self.map is not None:
            plain["obstacles"] = ["".join(".#"[int(cell)] for cell in row) for row in self.map]
        return plain

    def __getstate__(self) -> dict[str, Any]:
        """The fields: the engine's form of them can be made again."""
        return {item.name: getattr(self, item.name) for item in fields(self)}

    @cached_property
    def setup(self) -> _core.Setup:
        """The engine's form of these settings."""
        rules = {item.name: getattr(self.rules, item.name) for item in fields(self.rules)}
        paid = self.rewards
        return _core.Setup(
            rules=_core.Rules(**rules),
            rewards=_core.Rewards(
                capture=paid.by_team("capture"),
                neighbor=paid.by_team("neighbor"),
                collide=paid.by_team("collide"),
                step=paid.by_team("step"),
                blame=paid.blame,
                capture_repeats=paid.capture_repeats,
            ),
            rows=self.rows,
            cols=self.cols,
            n_pursuers=self.n_pursuers,
            n_evaders=self.n_evaders,
            fov=self.fov,
            diagonal=self.diagonal,
            max_steps=self.max_steps,
            density=self.density,
            map=None if self.map is None else self.map.astype(np.uint8),
        )
