"""What a drawing is made from: the arrays of one moment, checked once."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Cell = tuple[int, int]


@dataclass
class Crowd:
    """How many living agents stand on one cell."""

    pursuers: int = 0
    evaders: int = 0
    captured: int = 0  # of the evaders, those captured at this moment


@dataclass(frozen=True, eq=False, repr=False)
class Scene:
    """One moment of a world with P pursuers and E evaders, A = P + E agents, pursuers first.

    positions: ``(A, 2)`` int, row and column; of an agent that is gone where it went, or (-1, -1)
    alive: ``(A,)`` bool
    captured: ``(E,)`` bool, captured at this moment
    map: ``(rows, cols)`` bool, True for an obstacle
    n_pursuers: P
    involved, fault: ``(A, 3)`` bool or None, collisions of the last step by kind
        (obstacle, teammate, adversary)
    trail: ``(K, A, 2)`` int, earlier positions, oldest first, (-1, -1) for an agent that is gone
    captures, deaths: ``(n, 3)`` int, row, column and age in steps (0: in the last step) of the
        evaders caught, and of the agents that crashed, lately
    title: one line of text

    Raises ValueError for an array of another shape and for a living agent outside the map.
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
        """The picture that a notebook shows."""
        from matrixworld.render.raster import png

        return png(self)

    def agents(self) -> Iterator[tuple[int, Cell, bool]]:
        """Every living agent: its index, its cell, and whether it is a pursuer."""
        for agent in np.flatnonzero(self.alive).tolist():
            row, col = self.positions[agent].tolist()
            yield agent, (row, col), agent < self.n_pursuers

    def agent(self, who: int | str) -> int:
        """The number of an agent given by number or name; ValueError where there is none."""
        n_agents = len(self.alive)
        names = [f"pursuer_{i}" for i in range(self.n_pursuers)]
        names += [f"evader_{i}" for i in range(n_agents - self.n_pursuers)]
        if isinstance(who, str) and who in names:
            return names.index(who)
        if isinstance(who, str) or not 0 <= who < n_agents:
            expected = f"0 to {n_agents - 1} or a name such as {names[0]}" if names else "nobody"
            raise ValueError(f"viewers: expected {expected}, got {who!r}")
        return who

    def crowds(self) -> dict[Cell, Crowd]:
        """Who stands where: only cells with somebody on them."""
        crowds: dict[Cell, Crowd] = {}
        for agent, cell, is_pursuer in self.agents():
            crowd = crowds.setdefault(cell, Crowd())
            if is_pursuer:
                crowd.pursuers += 1
            else:
                crowd.evaders += 1
                crowd.captured += bool(self.captured[agent - self.n_pursuers])
        return crowds

    def team_sizes(self) -> tuple[int, int]:
        """How many pursuers and how many evaders are alive."""
        return int(self.alive[: self.n_pursuers].sum()), int(self.alive[self.n_pursuers :].sum())

    def collided(self) -> tuple[set[Cell], set[Cell]]:
        """Cells of agents at fault in a collision, and of the others involved in one.

        Those who went in it are there as well. A contact of adversaries without anybody at fault
        is the game, not a collision.
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
            elif self.involved is not None and self.involved[agent, :2].any():
                involved.add((row, col))
        return at_fault, involved - at_fault


def _check_shape(
    name: str, array: NDArray[np.generic] | None, expected: tuple[int | None, ...]
) -> None:
    if array is None:
        return
    if not isinstance(array, np.ndarray):
        raise TypeError(f"{name}: expected a NumPy array, got {type(array).__name__}")
    fits = array.ndim == len(expected) and all(
        want in (None, have) for want, have in zip(expected, array.shape, strict=True)
    )
    if not fits:
        wanted = tuple("any" if want is None else want for want in expected)
        shown = "(" + ", ".join(map(str, wanted)) + ("," if len(wanted) == 1 else "") + ")"
        raise ValueError(f"{name}: expected shape {shown}, got {array.shape}")
