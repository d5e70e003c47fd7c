"""A team phase: epochs in which one team learns against fixed opponents."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from deap import base

from matrixworld.coevolution.fitness import win_rates
from matrixworld.coevolution.learners.learner import GradientLearner, Learner
from matrixworld.coevolution.opponents.samplers import OpponentSampler, Stateless
from matrixworld.coevolution.runs.champions import crown_elite
from matrixworld.coevolution.runs.training import Training
from matrixworld.coevolution.seeding import (
    Purpose,
    keyed_generator,
    learning_phase,
    training_seeds,
)
from matrixworld.coevolution.storage.run_log import SEVERAL
from matrixworld.coevolution.types import TEAMS, FloatArray, Genomes, Indices, Seeds, Team
from matrixworld.world.policy import TeamPolicy


class Matchup(NamedTuple):
    """The opponents of one epoch, and the seeds of its matches.

    Parameters
    ----------
    epoch : int
        Number of the epoch in its generation.
    opponents : ndarray of int, shape (c,)
        Indices of the opponents.
    seeds : ndarray of uint64, shape (n, c)
        Match seed of each candidate against each opponent.
    """

    epoch: int
    opponents: Indices
    seeds: Seeds


@dataclass(frozen=True)
class TeamPhase:
    """Epochs in which one team learns one generation.

    Parameters
    ----------
    training : Training
        Plays, counts and logs the matches.
    learner : Learner
        Learner of the team; improved in place.
    team : {"pursuer", "evader"}
        The team that learns.
    generation : int
        Generation of the team that is being learned.
    opponents : Population or str
        All available opponents, or the name of a script.
    sampler : OpponentSampler
        Chooses the opponents of each epoch.
    on_epoch : callable
        Called after the matches of each epoch.
    """

    training: Training
    learner: Learner
    team: Team
    generation: int
    opponents: TeamPolicy
    sampler: OpponentSampler
    on_epoch: Callable[[], None]

    def run(self, epochs: range) -> None:
        """Let the team learn for `epochs`.

        Notes
        -----
        The loop is that of `deap.algorithms.eaGenerateUpdate`, but fitness is an array (n,) of all
        candidates instead of one object for each, and each epoch has its own random numbers.
        """
        toolbox = base.Toolbox()
        toolbox.register("generate", self.learner.ask)
        toolbox.register("evaluate", self.evaluate)
        toolbox.register("update", self.learner.tell)
        for matchup in self._matchups(epochs):
            candidates = toolbox.generate(self._generator(Purpose.LEARN, matchup.epoch))
            fitness = toolbox.evaluate(candidates, matchup)
            toolbox.update(fitness)
            met = matchup.opponents
        crown_elite(self.training, self.learner, self.team, self.generation, self.opponents, met)

    def evaluate(self, candidates: Genomes, matchup: Matchup) -> FloatArray:
        """Play the matches of an epoch, and log them.

        Parameters
        ----------
        candidates : ndarray of float32, shape (n, genes)
            Genomes of the team.
        matchup : Matchup
            Opponents and seeds.

        Returns
        -------
        ndarray of float64, shape (n,)
            Fitness of the candidates.
        """
        team, opponents = self.team, matchup.opponents
        scores = self.training.play_candidates(
            team, candidates, self.opponents, opponents, matchup.seeds
        )

        def table(values: FloatArray) -> FloatArray:
            return values.reshape(matchup.seeds.shape)

        # Win rates, not fitness: samplers expect numbers in [0, 1].
        if not isinstance(self.sampler, Stateless):
            self.sampler.tell(opponents, table(win_rates(scores, team)))
        fitness = self.training.fitness(scores, team, table)
        self.training.record(
            scores,
            fitness,
            team=team,
            generation=self.generation,
            epoch=matchup.epoch,
            opponent=int(opponents[0]) if len(opponents) == 1 else SEVERAL,
        )
        if learner := self._gradient_learner:
            # The same matches once more, step by step.
            learner.learn(
                self.training.experience(
                    learner, team, self.learner.genome, self.opponents,
                    np.tile(opponents, len(candidates)), matchup.seeds.ravel(),
                )
            )  # fmt: skip
        self.on_epoch()
        return fitness

    @cached_property
    def _gradient_learner(self) -> GradientLearner | None:
        # Once a phase: to ask a protocol is slow beside an epoch.
        return self.learner if isinstance(self.learner, GradientLearner) else None

    def _matchups(self, epochs: range) -> Iterable[Matchup]:
        """Return the matchups of all epochs, in order."""
        matchups = map(self._matchup, epochs)
        # A sampler without state can choose for all epochs ahead. Between matches, which fill the
        # caches with other data, the same work takes several times as long.
        return list(matchups) if isinstance(self.sampler, Stateless) else matchups

    def _matchup(self, epoch: int) -> Matchup:
        available = 1 if isinstance(self.opponents, str) else len(self.opponents.genomes)
        rng = self._generator(Purpose.OPPONENTS, epoch)
        opponents = self.sampler.sample(available, epoch, rng)
        # Candidates of the same match, such as a mirrored pair, differ in nothing but their genes.
        match = self.learner.match_of_candidate
        seeds = [self._seeds(int(opponent), epoch)[match] for opponent in opponents]
        return Matchup(epoch, opponents, np.stack(seeds, axis=1))

    def _seeds(self, opponent: int, epoch: int) -> Seeds:
        """Return the seeds of an epoch's matches against one opponent."""
        # Seeds depend on both generations, so that no two phases play the same episodes.
        own, seed = self.generation, self.training.settings.seed
        generations = (own, opponent) if self.team == "pursuer" else (opponent, own)
        count = int(self.learner.match_of_candidate.max()) + 1
        return training_seeds(seed, *generations, learning_phase(self.team), epoch, count)

    def _generator(self, purpose: Purpose, epoch: int) -> np.random.Generator:
        key = (TEAMS.index(self.team), self.generation, epoch)
        return keyed_generator(self.training.settings.seed, purpose, *key)
