"""Held-out maps: rooms, mazes and caves on which no run has learned, and what teams do there."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_integer, check_threads, shown
from matrixworld._util.readable import Parts, Readable
from matrixworld.coevolution.maps import Map, playable
from matrixworld.coevolution.seeding import Phase, training_seeds
from matrixworld.coevolution.types import TEAMS, FloatArray, Team
from matrixworld.play.rollout import Matches, rollout
from matrixworld.solve import States, guarantees
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
    from scipy import ndimage

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
    from scipy import ndimage

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

    Parameters
    ----------
    rows, cols : int
        Size of the maps, at least 2.
    n : int
        How many.
    seed : int, optional
        Other seeds have other maps.

    Examples
    --------
    >>> from matrixworld.coevolution import held_out_maps
    >>> held_out_maps(6, 6, 3).shape
    (3, 6, 6)
    """
    shape = check_integer("rows", rows, 2), check_integer("cols", cols, 2)
    count, key = check_integer("n", n, 1), check_integer("seed", seed, 0)
    return np.stack([_held_out(shape, number, key) for number in range(count)])


def _held_out(shape: tuple[int, int], number: int, seed: int) -> Map:
    rng = np.random.default_rng((seed, number))
    while True:
        # Upside down or mirrored, too: mazes begin in a corner.
        rows, cols = rng.choice((-1, 1), 2)
        walls = GENERATORS[number % len(GENERATORS)](shape, rng)[::rows, ::cols]
        if playable(walls, -(-walls.size // 2)):
            return walls


@dataclass(frozen=True, eq=False, repr=False)
class MapScores(Readable):
    """What two teams do on n maps.

    Parameters
    ----------
    capture_rate : ndarray of float64, shape (n,)
        The capture rate on each map.
    regret : dict of str to ndarray of float64, shape (n,)
        By how much each team falls short of perfect play on each map, exactly; empty if the maps
        were not solved.
    """

    capture_rate: FloatArray
    regret: Mapping[Team, FloatArray]

    def _parts(self) -> Parts:
        rows = [("capture rate", f"{self.capture_rate.mean():.3f}")]
        rows += [
            (f"regret of the {team}s", f"{each.mean():.3f}") for team, each in self.regret.items()
        ]
        return [[("MapScores", f"means over {len(self.capture_rate)} maps"), *rows]]


def score_on_maps(
    teams: Mapping[Team, TeamPolicy],
    config: WorldConfig,
    maps: Sequence[Map] | NDArray[np.bool_],
    *,
    exact: bool = False,
    episodes: int = 100,
    seed: int = 0,
    threads: int | None = None,
) -> MapScores:
    """Play two teams against each other on maps, and if wanted compare them with perfect play.

    Parameters
    ----------
    teams : mapping of str to policy
        What each team plays: a population of one genome, such as ``run.last("pursuer")``, the name
        of a script, or what `solve.Solution.policy` returns.
    config : WorldConfig
        The world, on any map.
    maps : array_like of bool, shape (n, rows, cols)
        The maps.
    exact : bool, optional
        Whether to compute exact regret, which takes a world that `solve` can solve.
    episodes : int, optional
        Episodes on each map. The default is 100.
    seed, threads : int, optional
        As in `score`.

    Raises
    ------
    ValueError, TypeError
        If a map does not fit the world; with `exact` as `solve.guarantees` does.
    """
    if not isinstance(teams, Mapping) or teams.keys() != set(TEAMS):
        raise TypeError(f"teams: expected a mapping with the keys {TEAMS}, got {shown(teams)}")
    check_threads(threads)
    worlds = [replace(config, obstacles=np.asarray(walls)) for walls in maps]
    if not worlds:
        raise ValueError("maps: expected at least one, got none")
    rates, found = [], []
    for number, world in enumerate(worlds):
        seeds = training_seeds(seed, number, number, Phase.HELD_OUT, 0, 1)
        played = rollout(
            world, teams["pursuer"], teams["evader"], Matches.of(0, 0, seeds),
            episodes=check_integer("episodes", episodes, 1), threads=threads,
        )  # fmt: skip
        rates.append(float(played.capture_rate.mean(dtype=np.float64)))
        if exact:
            found.append(guarantees(States(world, threads=threads), teams).exploitability)
    regret = {team: np.array([each[team][-1] for each in found]) for team in TEAMS if exact}
    return MapScores(np.array(rates), regret)
