"""Playing the matches of training, and keeping count of them."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.fitness import fitness, mean_over_opponents, shared_fitness
from matrixworld.coevolution.settings import TrainingSettings
from matrixworld.coevolution.storage.run_log import Row
from matrixworld.coevolution.types import Genomes, Indices, Seeds, Team
from matrixworld.policy import Population, TeamPolicy
from matrixworld.rollout import EpisodeStatistics, Matches, Rollout

Table = Callable[[NDArray[np.float64]], NDArray[np.float64]]
"""Lays out one value of each match (M,) as a table (n, m)."""


class Training:
    """EpisodeStatistics candidates in the training world of a run, and logs what it sees.

    Parameters
    ----------
    settings : of the run.
    play : scores matches, with the arguments of `matrixworld.rollout`.
    threads : handed to `play`.

    Attributes
    ----------
    matches, steps : episodes and world steps played so far.
    rows : of the log, one per epoch, since the last checkpoint.
    """

    def __init__(self, settings: TrainingSettings, play: Rollout, threads: int | None) -> None:
        self.settings = settings
        self.network = settings.network
        self.world = settings.world(settings.train_steps)
        self.threads = threads
        self.matches = self.steps = 0
        self.rows: list[Row] = []
        self.rollout = play

    def population(self, genomes: Genomes) -> Population:
        """Return genomes (n, genes) as a population of the run's network."""
        return Population(genomes, self.network)

    def play(
        self, pursuers: TeamPolicy, evaders: TeamPolicy, matches: Matches
    ) -> EpisodeStatistics:
        """Play and count matches; the scores' arrays are (M, worlds)."""
        worlds, threads = self.settings.worlds, self.threads
        scores = self.rollout(
            self.world, pursuers, evaders, matches, worlds=worlds, threads=threads
        )
        self.matches += int(scores.length.size)
        self.steps += int(scores.length.sum())
        return scores

    def play_candidates(
        self, team: Team, candidates: Genomes, opponents: TeamPolicy, met: Indices, seeds: Seeds
    ) -> EpisodeStatistics:
        """Play each candidate (n, genes) of `team` against each opponent met (c,).

        `opponents` are a population that `met` points into, or a scripted team; `seeds` are (n, c).
        Returns scores of n c matches, those of a candidate side by side.
        """
        n, c = seeds.shape
        own, learning = np.repeat(np.arange(n), c), self.population(candidates)
        rivals = 0 if isinstance(opponents, str) else np.tile(met, n)
        if team == "pursuer":
            return self.play(learning, opponents, Matches.of(own, rivals, seeds.ravel()))
        return self.play(opponents, learning, Matches.of(rivals, own, seeds.ravel()))

    def fitness(self, scores: EpisodeStatistics, team: Team, table: Table) -> NDArray[np.float64]:
        """Return the fitness (n,) of a team's individuals, by the run's measure.

        `table` lays values (M,) of all matches out as (n, m), individuals against opponents, NaN
        where two did not meet.
        """
        settings = self.settings
        measured = partial(fitness, scores, team, measure=settings.fitness)
        values = table(measured(overlap_penalty=settings.resolved_overlap_penalty))
        sharing, virulence = settings.sharing, settings.virulence(team)
        if sharing == "none" and virulence is None:
            return mean_over_opponents(values)
        payoff = table(measured(overlap_penalty=0.0))
        return shared_fitness(values, payoff, sharing=sharing, virulence=virulence)

    def record(
        self,
        scores: EpisodeStatistics,
        values: NDArray[np.float64],
        *,
        team: Team,
        generation: int,
        epoch: int,
        opponent: int,
    ) -> None:
        """Log one epoch of one team: its `scores` and the fitness `values` (n,) of candidates."""
        faults = scores.faults.sum(axis=3).mean(axis=(0, 1))
        row: Row = {
            "generation": generation,
            "team": team,
            "epoch": epoch,
            "opponent": opponent,
            "fitness_mean": float(values.mean()),
            "fitness_std": float(values.std()),
            "fitness_best": float(values.max()),
            "capture_rate": float(scores.capture_rate.mean(dtype=np.float64)),
            "length": float(scores.length.mean()),
            "pursuer_faults": float(faults[0]),
            "evader_faults": float(faults[1]),
            "matches": self.matches,
            "steps": self.steps,
        }
        self.rows.append(row)
