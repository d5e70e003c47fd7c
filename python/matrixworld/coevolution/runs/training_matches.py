"""The training matches of a run: played, counted and logged, and turned into fitness.

Besides the matches of the epochs there are some at the end of a generation, which decide which
genome represents a team (`TrainingMatches.choose_champion` and `TrainingMatches.keeps`). They count
towards the budget of the run.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from itertools import product
from typing import Any

import numpy as np

from matrixworld.coevolution.fitness import (
    collisions,
    feasible_first,
    fitness,
    mean_over_opponents,
    shared_fitness,
)
from matrixworld.coevolution.opponents import ArchiveSampler, OpponentSampler
from matrixworld.coevolution.schedules import Against, Maps, Simultaneous, available
from matrixworld.coevolution.seeding import Phase, training_seeds
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import Row
from matrixworld.coevolution.types import TEAMS, FloatArray, Genome, Genomes, Indices, Seeds, Team
from matrixworld.play.rollout import EpisodeStatistics, Matches, Rollout
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network, Population, TeamPolicy

Table = Callable[[FloatArray], FloatArray]
"""Arranges one value of each match (M,) as a table (n, m) of individuals against opponents, with
NaN for pairs that did not play."""

COUNTERS = ("matches", "steps", "agent_steps")
"""Episodes, world steps, and steps of living agents: what a run counts."""


class TrainingMatches:
    """Plays matches in the training world of a run, counts them, and keeps the log of epochs."""

    def __init__(self, settings: RaceSettings, play: Rollout, threads: int | None) -> None:
        self.settings: RaceSettings = settings
        self.network: Network = settings.network
        self.world: WorldConfig = settings.training_world
        self.threads: int | None = threads
        self.matches: int = 0
        self.steps: int = 0
        self.agent_steps: int = 0
        self.rows: list[Row] = []
        self.on_row: Callable[[Row], None] | None = None
        self.rollout: Rollout = play

    def counters(self) -> dict[str, float]:
        """Return what has been counted so far, by name."""
        return {name: getattr(self, name) for name in COUNTERS}

    def restore(self, counters: Mapping[str, Any]) -> None:
        """Go on from counters that were saved, with an empty log."""
        for name in COUNTERS:
            setattr(self, name, int(counters[name]))
        self.rows = []

    # Playing:

    def population(self, team: Team, genomes: Genomes) -> Population:
        """Return genomes (n, genes) of a team as a population; DivergedError for infinite ones."""
        try:
            return Population(genomes, self.network)
        except ValueError as error:
            if np.isfinite(genomes).all():  # of another shape, by a learner of the user's own
                raise
            path = self.settings.learner_path(team)
            raise self.settings.learner_of(team).diverged(path) from error

    def play(
        self, pursuers: TeamPolicy, evaders: TeamPolicy, matches: Matches
    ) -> EpisodeStatistics:
        """Play and count M matches; the arrays of the result have shape (M, worlds)."""
        worlds, threads = self.settings.match_episodes, self.threads
        scores = self.rollout(
            self.world, pursuers, evaders, matches, episodes=worlds, threads=threads
        )
        self.matches += int(scores.length.size)
        self.steps += int(scores.length.sum())
        self.agent_steps += int(scores.agent_steps.sum())
        return scores

    def play_candidates(
        self, team: Team, candidates: Genomes, opponents: TeamPolicy, indices: Indices, seeds: Seeds
    ) -> EpisodeStatistics:
        """Play each candidate (n, genes) of a team against the opponents of some indices (c,).

        Returns the statistics of n * c matches in the order of ``seeds.ravel()``, seeds (n, c): the
        matches of a candidate are adjacent. A script has no indices, and ignores them.
        """
        n, c = seeds.shape
        others = 0 if isinstance(opponents, str) else indices
        own, met = np.repeat(np.arange(n, dtype=np.int32), c), np.full((n, c), others, np.int32)
        learning = self.population(team, candidates)
        if team == "pursuer":
            return self.play(learning, opponents, Matches(own, met.ravel(), seeds.ravel()))
        return self.play(opponents, learning, Matches(met.ravel(), own, seeds.ravel()))

    def teach(
        self, learner: Any, team: Team, opponents: TeamPolicy, chosen: Indices, seeds: Seeds
    ) -> None:
        """Let a learner by gradients learn from matches (M,) that have been played and counted.

        They are those of its genome against the opponents `chosen` (M,).
        """
        if self.settings.learner_of(team).by_gradients:
            learner.learn_from(
                config=self.world,
                team=team,
                opponents=opponents,
                chosen=chosen,
                seeds=seeds,
                worlds=self.settings.match_episodes,
                threads=self.threads,
            )

    # Fitness and log:

    def fitness(
        self, scores: EpisodeStatistics, team: Team, table: Table, *, shared: bool = True
    ) -> FloatArray:
        """Return the fitness (n,) of a team's individuals, as the settings define it.

        It is the mean over opponents, without sharing and virulence, if not `shared`.
        """
        chosen, penalty = self.settings.fitness, self.settings.overlap_penalty
        virulence = chosen.virulence(team)
        measured = partial(fitness, scores, team, measure=chosen.measure)
        values = table(measured(overlap_penalty=penalty))
        if not shared or (chosen.sharing == "none" and virulence is None):
            found = mean_over_opponents(values)
        else:
            # Sharing is of results in [0, 1]; the penalty is subtracted afterwards.
            payoff = table(measured(overlap_penalty=0.0))
            found = shared_fitness(values, payoff, virulence)
        if chosen.cost_limit is None:
            return found
        excess = mean_over_opponents(table(collisions(scores, team))) - chosen.cost_limit
        return feasible_first(found, excess)

    def fitness_of_epoch(
        self,
        scores: EpisodeStatistics,
        table: Table,
        *,
        team: Team,
        generation: int,
        epoch: int,
        opponent: int,
    ) -> FloatArray:
        """Return the fitness (n,) of a team's individuals, and log the epoch (see `COLUMNS`)."""
        fitness = self.fitness(scores, team, table)
        # (M, worlds, teams, kinds of collision) -> (teams,)
        faults = scores.faults.sum(axis=3).mean(axis=(0, 1))
        row: Row = {
            "generation": generation,
            "team": team,
            "epoch": epoch,
            "opponent": opponent,
            "fitness_mean": float(fitness.mean()),
            "fitness_std": float(fitness.std()),
            "fitness_best": float(fitness.max()),
            "capture_rate": float(scores.capture_rate.mean(dtype=np.float64)),
            "length": float(scores.length.mean()),
            "pursuer_faults": float(faults[0]),
            "evader_faults": float(faults[1]),
            "matches": self.matches,
            "steps": self.steps,
        }
        self.rows.append(row)
        if self.on_row is not None:
            self.on_row(row)
        return fitness

    # The end of a generation:

    def choose_champion(
        self, learner: Any, team: Team, generation: int, opponents: TeamPolicy, met: Indices
    ) -> None:
        """Make the best elite in new matches the champion of a learner, if it is set so.

        The best candidate of the last epoch may be the luckiest one. The elite meets the opponents
        `met` (c,) that the fittest individual has met in that epoch.
        """
        matches = self.settings.learner_of(team).elite_matches
        if matches:
            elites = learner.elite_genomes()
            # The run's own fitness, with sharing and virulence: only the luck of the epoch is new.
            again = self._fitness_again(
                team, generation, elites, opponents, met,
                phase=Phase.ELITE, episodes=matches // len(elites), shared=True,
            )  # fmt: skip
            learner.choose_champion(again)

    def keeps(
        self,
        team: Team,
        generation: int,
        genome: Genome,
        previous: Genome,
        opponents: Population,
        episodes: int,
    ) -> bool:
        """Return whether a new genome is not worse than the previous one against all opponents.

        Both play the same `episodes` against each opponent, and all opponents have the same weight:
        variations that gain against current opponents and lose against others are filtered out
        (Simione & Nolfi 2021, "Long-term progress and behavior complexification in competitive
        coevolution", Artificial Life 26(4)).
        """
        new, old = self._fitness_again(
            team, generation, np.stack([genome, previous]), opponents,
            np.arange(len(opponents.genomes)),
            phase=Phase.RETENTION, episodes=episodes, shared=False,
        )  # fmt: skip
        return bool(new >= old)

    def _fitness_again(
        self,
        team: Team,
        generation: int,
        genomes: Genomes,
        opponents: TeamPolicy,
        indices: Indices,
        *,
        phase: Phase,
        episodes: int,
        shared: bool,
    ) -> FloatArray:
        """Return the fitness (n,) of genomes in new matches, all with the same seeds."""
        n, c = len(genomes), len(indices)
        key = (self.settings.seed, generation, generation, phase, TEAMS.index(team))
        seeds = np.tile(training_seeds(*key, c * episodes), (n, 1))
        met = np.repeat(indices, episodes)
        scores = self.play_candidates(team, genomes, opponents, met, seeds)
        self.count_in_last_epoch()

        def table(values: FloatArray) -> FloatArray:
            return np.asarray(values.reshape(n, c, episodes).mean(axis=2))

        return self.fitness(scores, team, table, shared=shared)

    def count_in_last_epoch(self) -> None:
        """Count matches after an epoch in its rows: two in a race with halls of fame."""
        last = self.rows[-1]["matches"]
        for row in self.rows:
            if row["matches"] == last:
                row |= {"matches": self.matches, "steps": self.steps}


def training_matches(
    settings: RaceSettings, samplers: Mapping[Team, OpponentSampler] | None = None
) -> int:
    """Return the episodes of the training of a whole run.

    With `samplers` that have an archive they are an upper bound; without `samplers` the matches by
    which archives compare candidates are not counted.
    """
    schedule = settings.schedule
    if isinstance(schedule, Against):
        # One opponent an epoch.
        learner = settings.learner_of(schedule.team)
        stages = schedule.entries - 1
        matches = schedule.epochs * learner.population + stages * learner.elite_matches
        return matches * settings.match_episodes
    living = schedule.contemporaries if isinstance(schedule, Simultaneous) else 0
    matches = schedule.generations * schedule.scored_matches if isinstance(schedule, Maps) else 0
    for team, k in product(TEAMS, range(1, schedule.entries)):
        archived = k if isinstance(schedule, Simultaneous) else available(team, k)
        sampled = min(schedule.sampled_opponents, archived)
        learner = settings.learner_of(team)
        # A match of two living individuals counts for both teams, and here for the pursuers.
        met = sampled + (living if team == "pursuer" else 0)
        matches += schedule.epochs(team) * met * learner.population
        matches += learner.elite_matches * (sampled + living)
        # Retention compares two genomes.
        matches += 2 * archived * schedule.retention_episodes
        sampler = samplers and samplers[team]
        if isinstance(sampler, ArchiveSampler):
            pairs = sampler.max_pairs(k, archived)
            matches += pairs * schedule.archive_episodes(team)
    return matches * settings.match_episodes
