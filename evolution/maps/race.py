"""Races on maps that evolve with the teams."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from common import kept
from maps.archive import BOTH, MAP_FITNESS, NONE, Map, MapArchive, MapTeam, Trial, random_map
from matrixworld.coevolution import TEAMS, RaceSettings, Run, SavedRun, Team, create
from matrixworld.coevolution.seeding import keyed_generator, training_seeds
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


class MapRace(Run):
    """A race in turns on maps that evolve, against the newest genomes of both teams.

    ::

        maps = N random ones
        for k in 1 .. generations:
            p[k], e[k] = as in `InTurns`, each epoch on one of the maps
            maps = the N best of: maps, edits of them, fresh ones, scored by p[k] and e[k]

    The maps belong to the stage of the evaders, so that a generation is two stages as in any race
    in turns. ``maps.json`` in the directory says how they evolve.
    """

    def __init__(self, settings: MapSettings, directory: str | Path, **options: Any) -> None:
        self.how = settings
        create(settings.race.changed({"seed": settings.seed}), directory)
        expected = asdict(replace(settings, race=None))  # type: ignore[arg-type]
        found = kept(Path(directory) / "maps.json", lambda: expected)
        if found != expected:
            told = f"expected {expected}, got {found}"
            raise ValueError(f"{directory}: holds a race on maps of other settings: {told}")
        super().__init__(directory, **options)

    @property
    def maps(self) -> MapArchive:
        """The archive of maps, as it was after the last generation."""
        if "maps" not in self.states:
            fresh = self._fresh(self.how.maps, self._map_generator(len(TEAMS), 0, 0))
            self.states["maps"] = vars(MapArchive(fresh))
        return MapArchive.of(self.states["maps"])

    def learn(self, stage: int) -> None:
        """Let one team learn; after both, let the maps evolve."""
        super().learn(stage)
        if TEAMS[stage % 2] == "evader":
            self.states["maps"] = vars(self.evolved_maps(1 + stage // 2))

    def begin_epoch(self, team: Team, generation: int, epoch: int) -> None:
        """Play the epoch on a map that the archive offers."""
        maps = self.maps
        offered = maps.offer(self._map_generator(TEAMS.index(team), generation, epoch))
        self.play_in(replace(self.settings.training_game.world, obstacles=maps.maps[offered]))

    def evolved_maps(self, generation: int) -> MapArchive:
        """Return the best of the archived maps and of new ones."""
        how, maps, rng = self.how, self.maps, self._map_generator(len(TEAMS), generation, 0)
        if how.fitness == NONE:
            return MapArchive(self._fresh(how.maps, rng))
        children = maps.children(how.children, how.edits, self.settings.world.n_agents, rng)
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
            maps.maps, self.settings.training_game.world, champions, how.team, play, maps.values,
            maps.best, self.threads,
        )  # fmt: skip
        maps.scores = MAP_FITNESS[how.fitness].of(trial)
        self._count_in_last_epoch()
        maps.keep_best(how.maps)
        return maps

    def _fresh(self, count: int, rng: np.random.Generator) -> list[Map]:
        world = self.settings.world
        shape = world.rows, world.cols
        return [random_map(shape, self.how.walls, world.n_agents, rng) for _ in range(count)]

    def _map_generator(self, *key: int) -> np.random.Generator:
        return keyed_generator(self.settings.seed, MAPS, *key)


def play(settings: MapSettings, directory: Path, *, threads: int) -> SavedRun:
    """Play what is left of a race on maps."""
    return MapRace(settings, directory, threads=threads).run()
