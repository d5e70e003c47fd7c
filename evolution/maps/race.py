"""Races on maps that evolve with the teams."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from maps.archive import BOTH, MAP_FITNESS, NONE, Map, MapArchive, MapTeam, Trial, random_map
from matrixworld.coevolution import TEAMS, Race, RaceSettings, SavedRun, Team, open_run
from matrixworld.coevolution.seeding import Phase, Purpose, keyed_generator, training_seeds
from matrixworld.play.rollout import EpisodeStatistics, Matches
from matrixworld.world.config import WorldConfig


@dataclass(frozen=True)
class MapSettings:
    """A race, and how its maps evolve.

    Parameters
    ----------
    race : RaceSettings
        The race, in turns; all matches but those of epochs and of maps are played in its world.
    fitness : str
        What maps are selected by, a name in `MAP_FITNESS`.
    team : {"pursuer", "evader", "both"}
        Whose regret is computed or estimated.
    maps, children, fresh : int
        Maps in the archive, and in each generation edits of them and those that are drawn anew.
    edits : int
        Edits of each child: a wall added, removed or moved.
    walls : float
        Share of walls in maps that are drawn.
    matches : int
        Matches of the newest genomes on each map in a generation, by which it is scored.
    seed : int
        Seed of the run.
    """

    race: RaceSettings
    fitness: str = "learnability"
    team: MapTeam = BOTH
    maps: int = 16
    children: int = 12
    fresh: int = 4
    edits: int = 3
    walls: float = 0.2
    matches: int = 16
    seed: int = 0

    @property
    def learner(self) -> Any:
        """How teams learn."""
        return self.race.learner

    def changed(self, changes: Mapping[str, Any]) -> MapSettings:
        """Return these settings with changes of the race by their paths."""
        return replace(self, race=self.race.changed(changes))


class MapRace(Race):
    """A race in turns on maps that evolve, against the newest genomes of both teams.

    ::

        maps = N random ones
        for k in 1 .. generations:
            p[k], e[k] = as in `Race`, each epoch on one of the maps
            maps = the N best of: maps, edits of them, fresh ones, scored by p[k] and e[k]

    The maps belong to the stage of the evaders, so that a generation is two stages as in any race
    in turns.
    """

    def __init__(self, settings: MapSettings, directory: str | Path, **options: Any) -> None:
        self.how = settings
        super().__init__(settings.race.changed({"seed": settings.seed}), directory, **options)
        if self.files.config["maps"] != self.extra_config()["maps"]:
            told = f"expected {self.extra_config()['maps']}, got {self.files.config['maps']}"
            raise ValueError(f"{directory}: holds a race on maps of other settings: {told}")

    def extra_config(self) -> dict[str, Any]:
        """Return how maps evolve."""
        return {"maps": asdict(replace(self.how, race=None))}  # type: ignore[arg-type]

    @cached_property
    def maps(self) -> MapArchive:
        """The archive of maps."""
        return MapArchive(self._fresh(self.how.maps, self._map_generator(0)))

    def learn(self, stage: int) -> None:
        """Let one team learn; after both, let the maps evolve."""
        super().learn(stage)
        if TEAMS[stage % 2] == "evader":
            self.evolve_maps(1 + stage // 2)

    def improve(self, team: Team, *args: Any, **options: Any) -> None:
        """Let a team learn as in `Run`; then play in the world of the settings again."""
        try:
            super().improve(team, *args, **options)
        finally:
            self.training.world = self.settings.training_world

    def begin_epoch(self, team: Team, generation: int, epoch: int) -> None:
        """Play the epoch on a map that the archive offers."""
        offered = self.maps.offer(self.generator(Purpose.MAPS, team, generation, epoch))
        walls = self.maps.maps[offered]
        self.training.world = replace(self.settings.training_world, obstacles=walls)

    def evolve_maps(self, generation: int) -> None:
        """Let the archive keep the best of its own maps and new ones."""
        how, maps, rng = self.how, self.maps, self._map_generator(generation)
        if how.fitness == NONE:
            maps.restore(MapArchive(self._fresh(how.maps, rng)).state())
            return
        children = maps.children(how.children, how.edits, self.settings.world.n_agents, rng)
        maps.add([*children, *self._fresh(how.fresh, rng)])
        champions = {
            team: self.training.population(team, self.archive[team][-1][np.newaxis])
            for team in TEAMS
        }

        def play(world: WorldConfig) -> EpisodeStatistics:
            # The same episodes on each map, so that luck does not rank them.
            key = (self.settings.seed, generation, generation, Phase.MAPS, 0)
            matches = Matches.of(0, 0, training_seeds(*key, how.matches))
            self.training.world = world
            return self.training.play(champions["pursuer"], champions["evader"], matches)

        trial = Trial(
            maps.maps, self.settings.training_world, champions, how.team, play, maps.values,
            maps.best, self.training.threads,
        )  # fmt: skip
        try:
            maps.scores = MAP_FITNESS[how.fitness].of(trial)
        finally:
            self.training.world = self.settings.training_world
        self.training.count_in_last_epoch()
        maps.keep_best(how.maps)

    def _parts(self) -> dict[str, Any]:
        return {**super()._parts(), "maps": self.maps}

    def _fresh(self, count: int, rng: np.random.Generator) -> list[Map]:
        world = self.settings.world
        shape = world.rows, world.cols
        return [random_map(shape, self.how.walls, world.n_agents, rng) for _ in range(count)]

    def _map_generator(self, generation: int) -> np.random.Generator:
        return keyed_generator(self.settings.seed, Purpose.MAPS, len(TEAMS), generation, 0)


def play(settings: MapSettings, directory: Path, *, threads: int) -> SavedRun:
    """Play what is left of a race on maps."""
    MapRace(settings, directory, threads=threads).run()
    return open_run(directory)
