"""The training matches of a run: play, count and log them, and compute fitness."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from matrixworld.coevolution.fitness import (
    collisions,
    feasible_first,
    fitness,
    mean_over_opponents,
    shared_fitness,
)
from matrixworld.coevolution.learners.experience import Experience
from matrixworld.coevolution.learners.learner import GradientLearner
from matrixworld.coevolution.runs.experience import experience
from matrixworld.coevolution.settings.training import TrainingSettings
from matrixworld.coevolution.storage.run_log import Row
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, Seeds, Team
from matrixworld.play.rollout import EpisodeStatistics, Matches, Rollout
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network, Population, TeamPolicy

Table = Callable[[FloatArray], FloatArray]
"""Arranges one value of each match (M,) as a table (n, m) of individuals against opponents."""


class Training:
    """Plays matches in the training world of a run, and keeps the log of its epochs.

    Parameters
    ----------
    settings : TrainingSettings
        Settings of the run.
    play : callable
        Plays matches, with the arguments of `matrixworld.rollout`.
    threads : int or None
        Threads that `play` may use; None: all cores.

    Attributes
    ----------
    matches, steps, agent_steps : int
        Episodes, world steps, and steps of living agents played so far.
    rows : list of dict
        Rows of the log, one per epoch, since the last checkpoint.
    """

    def __init__(self, settings: TrainingSettings, play: Rollout, threads: int | None) -> None:
        self.settings: TrainingSettings = settings
        self.network: Network = settings.network
        self.world: WorldConfig = settings.world(settings.train_steps)
        self.overlap_penalty: float = settings.resolved_overlap_penalty
        # Learners by gradients keep to the limit themselves; their fitness is for the log.
        learner = settings.built_in_learner
        by_gradients = learner is not None and learner.by_gradients
        self.cost_limit: float | None = None if by_gradients else settings.cost_limit
        self.threads: int | None = threads
        self.matches: int = 0
        self.steps: int = 0
        self.agent_steps: int = 0
        self.rows: list[Row] = []
        self.rollout: Rollout = play

    def population(self, genomes: Genomes) -> Population:
        """Return genomes (n, genes) as a population of the run's network."""
        return Population(genomes, self.network)

    def play(
        self, pursuers: TeamPolicy, evaders: TeamPolicy, matches: Matches
    ) -> EpisodeStatistics:
        """Play and count M matches; the arrays of the result have shape (M, worlds)."""
        worlds, threads = self.settings.worlds, self.threads
        scores = self.rollout(
            self.world, pursuers, evaders, matches, episodes=worlds, threads=threads
        )
        self.matches += int(scores.length.size)
        self.steps += int(scores.length.sum())
        self.agent_steps += int(scores.agent_steps.sum())
        return scores

    def play_candidates(
        self,
        team: Team,
        candidates: Genomes,
        opponents: TeamPolicy,
        indices: Indices,
        seeds: Seeds,
    ) -> EpisodeStatistics:
        """Play each candidate of a team against each opponent.

        Parameters
        ----------
        team : {"pursuer", "evader"}
            Team of the candidates.
        candidates : ndarray of float32, shape (n, genes)
            Their genomes.
        opponents : Population or str
            Population of the other team, or the name of a script.
        indices : ndarray of int, shape (c,)
            Opponents of the population to play against; ignored for a script.
        seeds : ndarray of uint64, shape (n, c)
            Seed of each match.

        Returns
        -------
        EpisodeStatistics
            Of n * c matches, in the order of ``seeds.ravel()``.
        """
        # The matches of a candidate are adjacent, in the order of its opponents.
        n, c = seeds.shape
        others = 0 if isinstance(opponents, str) else indices
        own, met = np.repeat(np.arange(n, dtype=np.int32), c), np.full((n, c), others, np.int32)
        learning = self.population(candidates)
        if team == "pursuer":
            return self.play(learning, opponents, Matches(own, met.ravel(), seeds.ravel()))
        return self.play(opponents, learning, Matches(met.ravel(), own, seeds.ravel()))

    def experience(
        self,
        learner: GradientLearner,
        team: Team,
        genome: Genome,
        opponents: TeamPolicy,
        chosen: Indices,
        seeds: Seeds,
    ) -> Experience:
        """Return what a team experiences in matches that have been played and counted.

        Parameters
        ----------
        learner : GradientLearner
            Learner of the team.
        team : {"pursuer", "evader"}
            The team.
        genome : ndarray of float32, shape (genes,)
            Its genome in all matches.
        opponents : Population or str
            Population of the other team, or the name of a script.
        chosen : ndarray of int, shape (M,)
            Opponent of each match; ignored for a script.
        seeds : ndarray of uint64, shape (M,)
            Seed of each match.
        """
        return experience(
            self.world,
            team,
            self.population(genome),
            opponents,
            chosen,
            seeds,
            worlds=self.settings.worlds,
            states=learner.sees_states,
            threads=self.threads,
        )

    def fitness(self, scores: EpisodeStatistics, team: Team, table: Table) -> FloatArray:
        """Return the fitness (n,) of a team's individuals, as the settings define it.

        Parameters
        ----------
        scores : EpisodeStatistics
            Results of M matches.
        team : {"pursuer", "evader"}
            The team.
        table : callable
            Arranges values (M,) of the matches as a table (n, m) of individuals against opponents,
            with NaN for pairs that did not play.

        Returns
        -------
        ndarray of float64, shape (n,)
            Fitness, higher is better.
        """
        sharing, virulence = self.settings.sharing, self.settings.virulence(team)
        if sharing == "none" and virulence is None:
            return self.mean_fitness(scores, team, table)
        # Sharing is of results in [0, 1]; the penalty is subtracted afterwards.
        values, payoff = (table(self._values(scores, team, penalty=p)) for p in (True, False))
        shared = shared_fitness(values, payoff, sharing=sharing, virulence=virulence)
        return self._within_limit(shared, scores, team, table)

    def mean_fitness(self, scores: EpisodeStatistics, team: Team, table: Table) -> FloatArray:
        """Return the mean fitness (n,) over opponents, without sharing and virulence.

        Parameters
        ----------
        scores, team, table
            As in `fitness`.
        """
        means = mean_over_opponents(table(self._values(scores, team, penalty=True)))
        return self._within_limit(means, scores, team, table)

    def _within_limit(
        self, fitness: FloatArray, scores: EpisodeStatistics, team: Team, table: Table
    ) -> FloatArray:
        """Return the fitness (n,), with candidates within the limit of collisions first."""
        if self.cost_limit is None:
            return fitness
        found = mean_over_opponents(table(collisions(scores, team)))
        return feasible_first(fitness, found - self.cost_limit)

    def _values(self, scores: EpisodeStatistics, team: Team, *, penalty: bool) -> FloatArray:
        overlap_penalty = self.overlap_penalty if penalty else 0.0
        return fitness(scores, team, measure=self.settings.fitness, overlap_penalty=overlap_penalty)

    def recount_last_epoch(self) -> None:
        """Count the matches since the last epoch in the log of that epoch."""
        # Two rows in a hall-of-fame race, one of each team.
        last = self.rows[-1]["matches"]
        for row in self.rows:
            if row["matches"] == last:
                row |= {"matches": self.matches, "steps": self.steps}

    def record(
        self,
        scores: EpisodeStatistics,
        fitness: FloatArray,
        *,
        team: Team,
        generation: int,
        epoch: int,
        opponent: int,
    ) -> None:
        """Add one epoch of one team to the log.

        Parameters
        ----------
        scores : EpisodeStatistics
            Results of the epoch's matches.
        fitness : ndarray of float64, shape (n,)
            Fitness of the candidates.
        team, generation, epoch, opponent
            Columns of the log (see `run_log.COLUMNS`).
        """
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
