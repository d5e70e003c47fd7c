"""The arrays of one moment that a drawing is made from, checked once."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from matrixworld.episodes.render.raster import png
from matrixworld.world.conflicts import agent_name

Cell = tuple[int, int]


@dataclass
class CellContents:
    """The living agents on one cell.

    Parameters
    ----------
    pursuers, evaders : list of int, optional
        The numbers of the agents in their team.
    captured : int, optional
        How many of the evaders are captured at this moment.
    """

    pursuers: list[int] = field(default_factory=list)
    evaders: list[int] = field(default_factory=list)
    captured: int = 0

    @property
    def all_captured(self) -> bool:
        """Whether no evader on the cell is free."""
        return self.captured == len(self.evaders)


@dataclass(frozen=True, eq=False, repr=False)
class Scene:
    """One moment of a world, to be drawn.

    The world has P pursuers and E evaders, A = P + E agents, pursuers first.

    Parameters
    ----------
    positions : ndarray of int, shape (A, 2)
        Row and column of each agent. For an agent that is gone, the cell where it disappeared or
        (-1, -1).
    alive : ndarray of bool, shape (A,)
        Whether each agent is alive.
    captured : ndarray of bool, shape (E,)
        Whether each evader is captured at this moment.
    map : ndarray of bool, shape (rows, cols)
        True for an obstacle.
    n_pursuers : int
        P.
    involved, fault : ndarray of bool, shape (A, 3), optional
        Collisions of the last step by kind: obstacle, teammate, adversary.
    trail : ndarray of int, shape (K, A, 2), optional
        Earlier positions, oldest first; (-1, -1) for an agent that is gone.
    captures, deaths : ndarray of int, shape (n, 3), optional
        Recent captures, and recent deaths by collision: row, column, and age in steps. Age 0 is the
        last step.
    title : str, optional
        One line of text.

    Raises
    ------
    ValueError
        If an array has another shape or a living agent is outside the map.
    TypeError
        If an array is not a NumPy array.
    """

    positions: NDArray[np.integer]
    alive: NDArray[np.bool_]
    captured: NDArray[np.bool_]
    map: NDArray[np.bool_]
    n_pursuers: int
    involved: NDArray[np.bool_] | None = None
    fault: NDArray[np.bool_] | None = None
    trail: NDArray[np.integer] | None = None
    captures: NDArray[np.integer] | None = None
    deaths: NDArray[np.integer] | None = None
    title: str = ""

    def __post_init__(self) -> None:
        _check_shape("map", self.map, (None, None))
        _check_shape("alive", self.alive, (None,))
        agents = len(self.alive)
        if not 0 <= self.n_pursuers <= agents:
            raise ValueError(f"n_pursuers: expected 0 to {agents} (agents), got {self.n_pursuers}")
        _check_shape("positions", self.positions, (agents, 2))
        _check_shape("captured", self.captured, (agents - self.n_pursuers,))
        _check_shape("involved", self.involved, (agents, 3))
        _check_shape("fault", self.fault, (agents, 3))
        _check_shape("trail", self.trail, (None, agents, 2))
        _check_shape("captures", self.captures, (None, 3))
        _check_shape("deaths", self.deaths, (None, 3))
        self._check_inside()

    def _check_inside(self) -> None:
        living = self.positions[self.alive]
        outside = ((living < 0) | (living >= self.map.shape)).any(axis=1)
        if outside.any():
            agent = int(np.flatnonzero(self.alive)[outside][0])
            cell = tuple(self.positions[agent].tolist())
            raise ValueError(
                f"positions: expected cells of a {self.map.shape[0]} x {self.map.shape[1]} map, "
                f"got {cell} for agent {agent}"
            )

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        rows, cols = self.map.shape
        return rows, cols

    def __repr__(self) -> str:
        rows, cols = self.shape
        pursuers, evaders = self.team_sizes()
        return f"<Scene: {rows} x {cols} cells, {pursuers} pursuers, {evaders} evaders>"

    def _repr_png_(self) -> bytes:
        """Return the picture that a notebook shows."""
        return png(self)

    def agents(self) -> Iterator[tuple[int, Cell, bool]]:
        """Yield the index of every living agent, its cell, and whether it is a pursuer."""
        for agent in np.flatnonzero(self.alive).tolist():
            row, col = self.positions[agent].tolist()
            yield agent, (row, col), agent < self.n_pursuers

    def agent(self, who: int | str) -> int:
        """Return the number of an agent given by number or name; ValueError if there is none."""
        n_agents = len(self.alive)
        names = [agent_name(agent, self.n_pursuers) for agent in range(n_agents)]
        if isinstance(who, str) and who in names:
            return names.index(who)
        if isinstance(who, str) or not 0 <= who < n_agents:
            expected = (
                f"0 to {n_agents - 1} or a name such as {names[0]}" if names else "no viewers"
            )
            raise ValueError(f"viewers: expected {expected}, got {who!r}")
        return who

    def occupied_cells(self) -> dict[Cell, CellContents]:
        """Return what is on each cell that has living agents."""
        cells: dict[Cell, CellContents] = {}
        for agent, cell, is_pursuer in self.agents():
            contents = cells.setdefault(cell, CellContents())
            if is_pursuer:
                contents.pursuers.append(agent)
            else:
                contents.evaders.append(agent - self.n_pursuers)
                contents.captured += bool(self.captured[agent - self.n_pursuers])
        return cells

    def team_sizes(self) -> tuple[int, int]:
        """Return how many pursuers and how many evaders are alive."""
        return int(self.alive[: self.n_pursuers].sum()), int(self.alive[self.n_pursuers :].sum())

    def collided(self) -> tuple[set[Cell], set[Cell]]:
        """Return the cells of agents at fault in a collision, and of other agents involved.

        Agents that disappeared in a collision are included. A contact of adversaries without fault
        is not: it is the aim of the game.
        """
        at_fault: set[Cell] = set()
        involved: set[Cell] = set()
        if self.fault is None:
            return at_fault, involved
        for agent, (row, col) in enumerate(self.positions.tolist()):
            if row < 0:
                continue
            if self.fault[agent].any():
                at_fault.add((row, col))
            elif self.involved is not None and self.involved[agent, :2].any():  # no adversaries
                involved.add((row, col))
        return at_fault, involved - at_fault


def _check_shape(
    name: str, array: NDArray[np.generic] | None, expected: tuple[int | None, ...]
) -> None:
    if array is None:
        return
    if not isinstance(array, np.ndarray):
        raise TypeError(f"{name}: expected a NumPy array, got {type(array).__name__}")
    # None in an expected shape stands for any length.
    fits = array.ndim == len(expected) and all(
        want in (None, have) for want, have in zip(expected, array.shape, strict=True)
    )
    if not fits:
        wanted = tuple("any" if want is None else want for want in expected)
        shown = "(" + ", ".join(map(str, wanted)) + ("," if len(wanted) == 1 else "") + ")"
        raise ValueError(f"{name}: expected shape {shown}, got {array.shape}")
