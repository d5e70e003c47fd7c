"""Races on maps that evolve with the teams."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.maps import MAP_FITNESS, NONE, Map, MapArchive, Trial, random_map
from matrixworld.coevolution.runs.race import Race
from matrixworld.coevolution.schedules import Maps, Schedule
from matrixworld.coevolution.seeding import Phase, Purpose, keyed_generator, training_seeds
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.types import TEAMS, Stateful, Team
from matrixworld.play.rollout import EpisodeStatistics, Matches
from matrixworld.solve.solution import parts_of
from matrixworld.solve.states import check_size
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Population


class MapRace(Race):
    """A race in turns on maps that evolve, against the newest genomes of both teams.

    ::

        maps = N random ones
        for k in 1 .. generations:
            p[k], e[k] = as in `Race`, each epoch on one of the maps
            maps = the N best of: maps, edits of them, fresh ones, scored by p[k] and e[k]

    The maps belong to the stage of the evaders, so that a generation is two stages as in any race
    in turns. All other matches (archives, retention, payoff) are played in the world of the
    settings.
    """

    schedule: Maps
    schedule_class: ClassVar[type[Schedule]] = Maps

    @classmethod
    def check_settings(cls, settings: RaceSettings) -> None:
        """Raise ValueError also if maps need to be solved and cannot be."""
        super().check_settings(settings)
        check_maps(settings)

    @cached_property
    def maps(self) -> MapArchive:
        """The archive of maps."""
        return MapArchive(self._fresh(self.schedule.maps, self._map_generator(0)))

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
        self.training.world = self._world(self.maps.maps[offered])

    def evolve_maps(self, generation: int) -> None:
        """Let the archive keep the best of its own maps and new ones."""
        schedule, maps, rng = self.schedule, self.maps, self._map_generator(generation)
        fitness = MAP_FITNESS[schedule.map_fitness]
        if schedule.map_fitness == NONE:
            maps.restore(MapArchive(self._fresh(schedule.maps, rng)).state())
            return
        maps.add([
            *maps.children(schedule.children, schedule.edits, self._least, rng),
            *self._fresh(schedule.fresh, rng),
        ])  # fmt: skip
        champions = {
            team: self.training.population(team, self.archive[team][-1][np.newaxis])
            for team in TEAMS
        }

        def play(world: WorldConfig) -> EpisodeStatistics:
            # The same episodes on each map, so that luck does not rank them.
            key = (self.settings.seed, generation, generation, Phase.MAPS, 0)
            matches = Matches.of(0, 0, training_seeds(*key, schedule.map_matches))
            self.training.world = world
            return self.training.play(champions["pursuer"], champions["evader"], matches)

        trial = Trial(
            maps.maps,
            self.settings.training_world,
            champions,
            schedule.map_team,
            play,
            self.settings.fitness.measure,
            maps.values,
            maps.best,
            self.training.threads,
        )
        try:
            maps.scores = fitness.of(trial)
        finally:
            self.training.world = self.settings.training_world
        self.training.count_in_last_epoch()
        maps.keep_best(schedule.maps)

    def results_of_stage(self) -> Mapping[str, NDArray[Any]]:
        """Return the maps and their scores after each generation."""
        return {} if self.stage % 2 else {"maps": self.maps.maps, "scores": self.maps.scores}

    def _parts(self) -> dict[str, Stateful]:
        return {**super()._parts(), "maps": self.maps}

    @property
    def _least(self) -> int:
        """Free cells that a map needs."""
        return self.settings.world.n_agents

    def _fresh(self, count: int, rng: np.random.Generator) -> list[Map]:
        shape = self.settings.world.rows, self.settings.world.cols
        return [random_map(shape, self.schedule.walls, self._least, rng) for _ in range(count)]

    def _world(self, walls: Map) -> WorldConfig:
        return replace(self.settings.training_world, obstacles=walls)

    def _map_generator(self, generation: int) -> np.random.Generator:
        return keyed_generator(self.settings.seed, Purpose.MAPS, len(TEAMS), generation, 0)


def check_maps(settings: RaceSettings) -> None:
    """Raise ValueError if a race needs exact regret, and its worlds or networks do not allow it."""
    schedule = settings.schedule
    if not (isinstance(schedule, Maps) and MAP_FITNESS[schedule.map_fitness].exact):
        return
    empty = np.zeros((settings.world.rows, settings.world.cols), bool)
    world = replace(settings.training_world, obstacles=empty)
    try:
        check_size(world)
        for team in TEAMS:
            parts_of(world, Population(settings.untrained(team, 1), settings.network), team)
    except ValueError as error:
        raise type(error)(
            f"schedule.map_fitness: {schedule.map_fitness} is exact: {error}"
        ) from None
