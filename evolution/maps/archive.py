"""Maps that evolve: edits of their cells, what a map is worth, and an archive of the best.

::

    archive = N random maps
    in each epoch of a generation:
        both teams of every match play on a map that the archive offers, better ones more often
    after each generation:
        children = edits of archived maps, and some fresh ones
        all maps are scored against the newest champions; the N best are kept

This is the loop of generation, replay and edit of ACCEL (Parker-Holder et al. 2022, "Evolving
curricula with regret-based environment design"). What a map is worth is a row of `MAP_FITNESS`. In
small worlds it can be the exact regret of the champions, which others have to estimate.

A map is a bool array (rows, cols), True where a wall is. Its free cells are connected by steps to
the four sides, so that nobody is walled in.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from typing import Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from matrixworld.coevolution.states import State
from matrixworld.coevolution.types import TEAMS, FloatArray, Team
from matrixworld.play.rollout import EpisodeStatistics
from matrixworld.solver import States, best_response, solve
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import TeamPolicy

Map: TypeAlias = "NDArray[np.bool_]"
"""Walls, (rows, cols)."""
MapTeam: TypeAlias = Literal["pursuer", "evader", "both"]
BOTH: MapTeam = "both"
MAP_TEAMS = (*TEAMS, BOTH)
NEAREST = 3
"""Other maps to which novelty is the mean distance."""
MOST_EDITS = 10
"""Further edits of a child that is equal to another map."""


# Editing maps:


def playable(walls: Map, least: int) -> bool:
    """Return whether at least so many cells are free, and all free cells are connected."""
    return bool((~walls).sum() >= least and ndimage.label(~walls)[1] == 1)


def random_map(shape: tuple[int, int], share: float, least: int, rng: np.random.Generator) -> Map:
    """Return a map on whose cells a share of walls was placed one by one, wherever it fits."""
    walls, left = np.zeros(shape, bool), round(share * shape[0] * shape[1])
    for cell in rng.permutation(walls.size):
        if not left:
            break
        walls.flat[cell] = True
        if playable(walls, least):
            left -= 1
        else:
            walls.flat[cell] = False
    return walls


def edited(walls: Map, least: int, rng: np.random.Generator) -> Map:
    """Return a map with one wall added, removed or moved, each equally likely where it can be.

    A map that no edit leaves playable returns as it is.
    """
    cells: NDArray[np.intp] = rng.permutation(walls.size)
    is_wall: Map = walls.ravel()[cells]
    taken, placed = cells[is_wall].tolist(), cells[~is_wall].tolist()
    edits: list[Iterable[tuple[int, ...]]] = [
        product(placed), product(taken), product(taken, placed)
    ]  # fmt: skip
    for kind in rng.permutation(len(edits)):
        for flipped in edits[kind]:
            child: Map = walls.copy()
            child.flat[list(flipped)] ^= True
            if playable(child, least):
                return child
    return np.array(walls)


# What maps are worth:


@dataclass
class Trial:
    """What is found out about n maps, as soon as a fitness asks for it."""

    maps: NDArray[np.bool_]
    """(n, rows, cols)."""
    world: WorldConfig
    """The world, on any map."""
    champions: Mapping[Team, TeamPolicy]
    """What each team plays: a population of one genome."""
    team: MapTeam
    """For whom regret is computed or estimated; of both it is the sum."""
    play: Callable[[WorldConfig], EpisodeStatistics]
    """Plays the champions' episodes in a world."""
    values: FloatArray
    """Capture rates (n,) under perfect play; NaN where unknown."""
    best: FloatArray
    """Highest return (n, 2) of each team so far; minus infinity where nothing was played."""
    threads: int | None = None
    """Threads that solve a map."""

    @property
    def teams(self) -> tuple[Team, ...]:
        """The teams whose regret counts."""
        return tuple(team for team in TEAMS if self.team in (team, BOTH))

    @cached_property
    def worlds(self) -> list[WorldConfig]:
        """The world on each map."""
        return [replace(self.world, obstacles=walls) for walls in self.maps]

    @cached_property
    def scores(self) -> list[EpisodeStatistics]:
        """Statistics of the champions' episodes on each map."""
        return [self.play(world) for world in self.worlds]

    def returns(self, team: Team) -> FloatArray:
        """Return the captured fraction (n, episodes) of each episode, for evaders 1 minus it."""
        captured = np.stack([each.captured_fraction.ravel() for each in self.scores])
        return np.asarray(captured if team == "pursuer" else 1.0 - captured, dtype=np.float64)


def regret(trial: Trial) -> FloatArray:
    """Return by how much champions fall short of perfect play, exactly.

    For pursuers it is the capture rate under perfect play minus what they guarantee against any
    evaders, for evaders what they cannot prevent minus that value. The value cancels in the sum for
    both, which is the NashConv of the pair.
    """
    found = np.zeros(len(trial.maps))
    for n, world in enumerate(trial.worlds):
        states = States(world, threads=trial.threads)
        if trial.team != BOTH and np.isnan(trial.values[n]):
            trial.values[n] = solve(states).value
        value = 0.0 if trial.team == BOTH else trial.values[n]
        for team in trial.teams:
            sign = 1.0 if team == "pursuer" else -1.0
            best = best_response(states, trial.champions[team], team).value
            found[n] += sign * (value - best)
    return np.maximum(found, 0.0)  # less is a rounding error


def value_loss(trial: Trial) -> FloatArray:
    """Return the mean of what returns exceed their mean on the map by, 0 where they do not.

    The positive value loss of Jiang et al. (2021), "Prioritized level replay", at the start of an
    episode. The mean return stands for the critic, which a learner by episodes does not have.
    """
    returns = [trial.returns(team) for team in trial.teams]
    gains = [np.maximum(each - each.mean(axis=1, keepdims=True), 0.0) for each in returns]
    return np.asarray(np.sum([gain.mean(axis=1) for gain in gains], axis=0))


def max_monte_carlo(trial: Trial) -> FloatArray:
    """Return by how much the mean return stays below the highest that the map has ever seen.

    Jiang et al. (2021), "Replay-guided adversarial environment design".
    """
    found = np.zeros(len(trial.maps))
    for team in trial.teams:
        returns, column = trial.returns(team), trial.best[:, TEAMS.index(team)]
        np.maximum(column, returns.max(axis=1), out=column)
        found += column - returns.mean(axis=1)
    return found


def learnability(trial: Trial) -> FloatArray:
    """Return p (1 - p) of the capture rate p: the most where neither team always wins.

    Rutherford et al. (2024), "No regrets: investigating and improving regret approximations for
    curriculum discovery".
    """
    rates = np.array([each.capture_rate.mean(dtype=np.float64) for each in trial.scores])
    return np.asarray(rates * (1.0 - rates))


def novelty(trial: Trial) -> FloatArray:
    """Return the mean distance to the nearest other maps, in cells.

    The distance of two maps is the smallest number of cells in which any turned or mirrored copy of
    one differs from the other.
    """
    flat = trial.maps.reshape(len(trial.maps), -1)
    copies = np.array([[copy.ravel() for copy in symmetric(walls)] for walls in trial.maps])
    differ = (copies[:, :, None] != flat).sum(axis=3).min(axis=1)
    return np.asarray(np.sort(differ, axis=1)[:, 1 : 1 + NEAREST].mean(axis=1))


def symmetric(walls: Map) -> list[Map]:
    """Return all turned and mirrored copies of a map that have its shape."""
    turned = [np.rot90(walls, quarter) for quarter in range(4)]
    return [copy for each in turned for copy in (each, each.T) if copy.shape == walls.shape]


class MapFitness(NamedTuple):
    """A fitness of maps: its function, and what it needs."""

    of: Callable[[Trial], FloatArray]
    plays: bool = False
    """Whether the champions play episodes on each map."""
    exact: bool = False
    """Whether each map is solved."""


NONE = "none"
MAP_FITNESS: dict[str, MapFitness] = {
    "regret": MapFitness(regret, exact=True),
    "value-loss": MapFitness(value_loss, plays=True),
    "max-monte-carlo": MapFitness(max_monte_carlo, plays=True),
    "learnability": MapFitness(learnability, plays=True),
    "novelty": MapFitness(novelty),
    NONE: MapFitness(lambda trial: np.zeros(len(trial.maps))),
}
"""Name -> what a map is worth. With `none` all maps are replaced by fresh ones: domain
randomisation (Tobin et al. 2017)."""


# The archive:


class MapArchive:
    """N maps, their scores, and what is known of them; see `Trial` for `values` and `best`."""

    def __init__(self, maps: Sequence[Map]) -> None:
        self.maps: NDArray[np.bool_] = np.array(maps)
        self.scores: FloatArray = np.zeros(len(maps))
        self.values: FloatArray = np.full(len(maps), np.nan)
        self.best: FloatArray = np.full((len(maps), len(TEAMS)), -np.inf)

    @classmethod
    def of(cls, state: State) -> MapArchive:
        """Return the archive of a state: its arrays by name, as `vars` returns them."""
        archive = cls(state["maps"])
        vars(archive).update(state)
        return archive

    @property
    def weights(self) -> FloatArray:
        """Probability (N,) of each map: it falls with its rank; equal scores have equal ones."""
        higher = (self.scores > self.scores[:, np.newaxis]).sum(axis=1)
        weights = 1.0 / (1 + higher)
        return np.asarray(weights / weights.sum())

    def offer(self, rng: np.random.Generator) -> int:
        """Return the number of the map on which the matches of an epoch are played."""
        return int(rng.choice(len(self.maps), p=self.weights))

    def children(self, count: int, edits: int, least: int, rng: np.random.Generator) -> list[Map]:
        """Return edits of maps that are offered, each a new map if a few more edits make it one."""
        known = {walls.tobytes() for walls in self.maps}
        born = []
        for _ in range(count):
            child = self.maps[self.offer(rng)]
            for number in range(edits + MOST_EDITS):
                if number >= edits and child.tobytes() not in known:
                    break
                child = edited(child, least, rng)
            known.add(child.tobytes())
            born.append(child)
        return born

    def add(self, maps: Sequence[Map]) -> None:
        """Add maps behind its own, of which nothing is known."""
        if maps:
            new = vars(MapArchive(maps))
            for name, own in [*vars(self).items()]:
                setattr(self, name, np.concatenate([own, new[name]]))

    def keep_best(self, size: int) -> None:
        """Keep the maps of highest score; of equal ones the older ones."""
        best = np.argsort(-self.scores, kind="stable")[:size]
        for name, own in [*vars(self).items()]:
            setattr(self, name, own[best])
