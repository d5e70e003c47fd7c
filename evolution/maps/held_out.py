"""Held-out maps: rooms, mazes and caves on which no run has learned, and regret there."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from maps.archive import Map, playable
from matrixworld.coevolution.types import TEAMS, FloatArray, Team
from matrixworld.solver import States, best_response, solve
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import TeamPolicy

DIVIDED = 5
"""Length from which a room is divided, in cells."""
OPENED = 1 / 3
"""Share of the walls beside a passage that are opened after a maze was carved."""
SOLID, SMOOTHINGS, CROWD = 0.35, 2, 5
"""Of caves: share of walls at the start, rounds of smoothing, and of 9 cells the walls that make
the middle one a wall."""


def rooms(shape: tuple[int, int], rng: np.random.Generator) -> Map:
    """Return rooms with doors, by dividing the board again and again."""
    walls = np.zeros(shape, bool)

    def divide(part: Map) -> None:
        if part.shape[0] < part.shape[1]:
            part = part.T  # a view: the wall is drawn across the longer side
        length, width = part.shape
        if length < DIVIDED:
            return
        # Walls in odd places and doors in even ones: no wall ends before a door.
        row = int(rng.choice(range(1, length - 1, 2)))
        part[row] = True
        part[row, rng.choice(range(0, width, 2))] = False
        divide(part[:row])
        divide(part[row + 1 :])

    divide(walls)
    return walls


def maze(shape: tuple[int, int], rng: np.random.Generator) -> Map:
    """Return a maze by a random walk that goes back where it is stuck, with some walls opened."""
    walls = np.ones(shape, bool)
    path = [(0, 0)]
    walls[0, 0] = False
    while path:
        row, col = path[-1]
        steps = [(row + r, col + c) for r, c in ((-2, 0), (2, 0), (0, -2), (0, 2))]
        new = [(r, c) for r, c in steps if 0 <= r < shape[0] and 0 <= c < shape[1] and walls[r, c]]
        if not new:
            path.pop()
            continue
        r, c = new[rng.integers(len(new))]
        walls[(row + r) // 2, (col + c) // 2] = walls[r, c] = False
        path.append((r, c))
    beside = walls & ndimage.binary_dilation(~walls)
    return np.asarray(walls & ~(beside & (rng.random(shape) < OPENED)))


def cave(shape: tuple[int, int], rng: np.random.Generator) -> Map:
    """Return the largest cave that a cellular automaton leaves."""
    walls = rng.random(shape) < SOLID
    for _ in range(SMOOTHINGS):
        crowd = ndimage.convolve(walls.astype(int), np.ones((3, 3), int), mode="nearest")
        walls = crowd >= CROWD
    labels, _ = ndimage.label(~walls)
    sizes = np.bincount(labels.ravel(), minlength=2)[1:]
    return np.asarray(labels != 1 + int(sizes.argmax()))


GENERATORS: tuple[Callable[[tuple[int, int], np.random.Generator], Map], ...] = (rooms, maze, cave)


def held_out_maps(rows: int, cols: int, n: int, seed: int = 0) -> NDArray[np.bool_]:
    """Return n held-out maps, bool (n, rows, cols): rooms, a maze, a cave, and so on.

    Map i depends on its number, the size and the seed only. At least half of its cells are free,
    and all free cells are connected.
    """
    return np.stack([_held_out((rows, cols), number, seed) for number in range(n)])


def _held_out(shape: tuple[int, int], number: int, seed: int) -> Map:
    rng = np.random.default_rng((seed, number))
    while True:
        # Upside down or mirrored, too: mazes begin in a corner.
        rows, cols = rng.choice((-1, 1), 2)
        walls = GENERATORS[number % len(GENERATORS)](shape, rng)[::rows, ::cols]
        if playable(walls, -(-walls.size // 2)):
            return walls


def regrets(
    teams: Mapping[Team, TeamPolicy], config: WorldConfig, maps: Sequence[Map] | NDArray[np.bool_]
) -> dict[Team, FloatArray]:
    """Return by how much each team falls short of perfect play on each map (n,), exactly.

    A team is a population of one genome, such as ``run.last("pursuer")``, or the name of a script.
    """
    found = []
    for walls in maps:
        states = States(replace(config, obstacles=np.asarray(walls)))
        value = solve(states).value
        pursuers, evaders = (best_response(states, teams[team], team).value for team in TEAMS)
        found.append((value - pursuers, evaders - value))
    return dict(zip(TEAMS, np.array(found).T, strict=True))
