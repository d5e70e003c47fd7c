"""Races on maps that evolve with the teams."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from common import kept
from maps.archive import BOTH, MAP_FITNESS, NONE, Map, MapArchive, MapTeam, Trial, random_map
from matrixworld.coevolution import (
    TEAMS,
    Pursuit,
    RaceSettings,
    Run,
    SavedRun,
    Team,
    Training,
    create,
)
from matrixworld.coevolution.seeding import keyed_generator, training_seeds
from matrixworld.coevolution.states import State, below
from matrixworld.coevolution.types import Genomes
from matrixworld.play.rollout import EpisodeStatistics, Matches
from matrixworld.world.config import WorldConfig

MAPS, MATCHES = 5, 8
"""Keys of random numbers beside those of the package's purposes and phases: of maps, and of the
matches that score them."""


@dataclass(frozen=True)
class MapSettings:
    """A race, and how its maps evolve."""

    race: RaceSettings
    """In turns; all matches but those of epochs and of maps are played in its world."""
    fitness: str = "learnability"
    """What maps are selected by, a name in `MAP_FITNESS`."""
    team: MapTeam = BOTH
    """Whose regret is computed or estimated."""
    maps: int = 16
    """Maps in the archive."""
    children: int = 12
    fresh: int = 4
    """New maps in each generation: edits of those of the archive, and maps that are drawn."""
    edits: int = 3
    """Edits of each child: a wall added, removed or moved."""
    walls: float = 0.2
    """Share of walls in maps that are drawn."""
    matches: int = 16
    """Matches of the newest genomes on each map in a generation, by which it is scored."""
    seed: int = 0


class MapTraining(Training):
    """A race in turns on maps that evolve, against the newest genomes of both teams.

    ::

        maps = N random ones
        for k in 1 .. generations:
            p[k], e[k] = as in `InTurns`, each epoch on one of the maps
            maps = the N best of: maps, edits of them, fresh ones, scored by p[k] and e[k]

    The maps belong to the stage of the evaders, so that a generation is two stages as in any race
    in turns.
    """

    def __init__(self, *args: Any, how: MapSettings, **options: Any) -> None:
        super().__init__(*args, **options)
        self.how = how
        self.maps = self._first_maps()
        """The archive of maps, as it was after the last generation."""

    def parts(self) -> dict[str, State]:
        """Return the states of learners and samplers, and the archive of maps."""
        return {**super().parts(), "maps": vars(self.maps)}

    def restore(
        self,
        stage: int,
        archive: Mapping[str, Genomes],
        counts: Mapping[str, int],
        arrays: Mapping[str, NDArray[Any]],
    ) -> None:
        """Take up a finished stage; before the first one no archive of maps is saved."""
        super().restore(stage, archive, counts, arrays)
        maps = below(arrays, "maps")
        self.maps = MapArchive.of(maps) if maps else self._first_maps()

    def end_stage(self) -> None:
        """After the stage of both teams, let the maps evolve."""
        if TEAMS[self.stage % 2] == "evader":
            self.maps = self.evolved_maps(1 + self.stage // 2)
        super().end_stage()

    def begin_epoch(self, team: Team, generation: int, epoch: int) -> None:
        """Play the epoch on a map that the archive offers."""
        offered = self.maps.offer(self._map_generator(TEAMS.index(team), generation, epoch))
        self.play_in(replace(self._world, obstacles=self.maps.maps[offered]))

    def evolved_maps(self, generation: int) -> MapArchive:
        """Return the best of the archived maps and of new ones."""
        how = self.how
        rng = self._map_generator(len(TEAMS), generation, 0)
        if how.fitness == NONE:
            return MapArchive(self._fresh(how.maps, rng))
        maps = MapArchive.of(vars(self.maps))
        children = maps.children(how.children, how.edits, self._world.n_agents, rng)
        maps.add([*children, *self._fresh(how.fresh, rng)])
        champions = {
            team: self.population(team, self.archive[team][-1][np.newaxis]) for team in TEAMS
        }

        def play(world: WorldConfig) -> EpisodeStatistics:
            # The same episodes on each map, so that luck does not rank them.
            key = (self.settings.seed, generation, generation, MATCHES, 0)
            matches = Matches.of(0, 0, training_seeds(*key, how.matches))
            self.play_in(world)
            scores = self.play(champions["pursuer"], champions["evader"], matches)
            return EpisodeStatistics(**scores.extras)

        trial = Trial(
            maps.maps, self._world, champions, how.team, play, maps.values, maps.best, self.threads
        )
        maps.scores = MAP_FITNESS[how.fitness].of(trial)
        self.count_in_last_epoch()
        maps.keep_best(how.maps)
        return maps

    @property
    def _world(self) -> WorldConfig:
        """The world in which teams learn, without a map."""
        game = self.settings.training_game
        assert isinstance(game, Pursuit)
        return game.world

    def _first_maps(self) -> MapArchive:
        return MapArchive(self._fresh(self.how.maps, self._map_generator(len(TEAMS), 0, 0)))

    def _fresh(self, count: int, rng: np.random.Generator) -> list[Map]:
        world = self._world
        shape = world.rows, world.cols
        return [random_map(shape, self.how.walls, world.n_agents, rng) for _ in range(count)]

    def _map_generator(self, *key: int) -> np.random.Generator:
        return keyed_generator(self.settings.seed, MAPS, *key)


def begun(
    settings: MapSettings,
    directory: str | Path,
    *,
    threads: int | None = None,
    training: Callable[..., MapTraining] = MapTraining,
) -> Run:
    """Return a race on maps before it goes on; ``maps.json`` in it says how the maps evolve."""
    create(settings.race.changed({"seed": settings.seed}), directory)
    expected = asdict(replace(settings, race=None))  # type: ignore[arg-type]
    found = kept(Path(directory) / "maps.json", lambda: expected)
    if found != expected:
        got = f"expected {expected}, got {found}"
        raise ValueError(f"{directory}: holds a race on maps of other settings: {got}")
    return Run(directory, threads=threads, training=partial(training, how=settings))


def play(settings: MapSettings, directory: Path, *, threads: int) -> SavedRun:
    """Play what is left of a race on maps."""
    begun(settings, directory, threads=threads).run()
    return SavedRun(directory)
