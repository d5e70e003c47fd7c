"""Two populations that evolve at the same time, with halls of fame (Rosin & Belew 1997)."""

from __future__ import annotations

from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.keys import (
    TEAMS,
    Genomes,
    Phase,
    Purpose,
    Team,
    keyed_generator,
    training_seeds,
)
from matrixworld.coevolution.race import Race
from matrixworld.coevolution.run import Run
from matrixworld.coevolution.schedules import HALL_OF_FAME
from matrixworld.coevolution.toolbox import Candidates, learner_toolbox
from matrixworld.rollout import Matches, Scores

Indices = NDArray[np.intp]

SEVERAL = -1
"""In the log, the opponent of candidates that met several."""


class Pairings(NamedTuple):
    """Who meets whom in one epoch, M matches.

    Indices below n are individuals of a population, those from n on members of the hall of fame.
    All matches of one `round` are played on the same seed.
    """

    pursuer: Indices
    evader: Indices
    round: Indices


def pairings(
    n: int, contemporaries: int, hall: tuple[int, int], rng: np.random.Generator
) -> Pairings:
    """Return the matches of two populations of `n` individuals.

    Every individual meets `contemporaries` living opponents, by random permutations (each such
    match counts for both), and every sampled member of the other team's hall of fame.

    Parameters
    ----------
    hall : how many members of the pursuers' and of the evaders' hall of fame were sampled.
    """
    everybody = np.arange(n)
    rounds = [(everybody, rng.permutation(n)) for _ in range(contemporaries)]
    rounds += [(everybody, np.full(n, n + member)) for member in range(hall[1])]
    rounds += [(np.full(n, n + member), everybody) for member in range(hall[0])]
    pursuers, evaders = zip(*rounds, strict=True)
    numbers = np.repeat(np.arange(len(rounds)), n)
    return Pairings(np.concatenate(pursuers), np.concatenate(evaders), numbers)


def mean_of_individuals(index: Indices, values: NDArray[np.float64], n: int) -> NDArray[np.float64]:
    """Return the mean (n,) of the values of each individual's matches.

    `index` (M,) names the individual of each match; those from n on belong to the hall.
    """
    totals = np.bincount(index, weights=values, minlength=n)[:n]
    return totals / np.bincount(index, minlength=n)[:n]


class HallOfFameRace(Race):
    """Simultaneous co-evolution of two genetic algorithms with halls of fame.

    ::

        in each epoch:
            both populations breed
            each individual meets some living opponents and a sample of the opponents' hall of fame
            its fitness is the mean over its matches
        at the end of a generation the champion of each team enters its hall of fame

    Method: Rosin & Belew 1997, "New methods for competitive coevolution", with plain mean fitness.
    The halls of fame are the archive, so that payoff and analysis are those of `Race`. A stage is
    a generation. Parameters and attributes as in `Run`.
    """

    kind: ClassVar[str] = "hall-of-fame"
    stages_per_generation: ClassVar[int] = 1

    def check_settings(self) -> None:
        """Raise ValueError unless the schedule is the hall of fame."""
        Run.check_settings(self)
        if self.settings.schedule != HALL_OF_FAME:
            raise ValueError(f"schedule: expected {HALL_OF_FAME}, got {self.settings.schedule!r}")

    def learn(self, stage: int) -> None:
        """Let both teams evolve for the epochs of a generation, and archive their champions."""
        generation = 1 + stage
        epochs = range(self.settings.joint_epochs)
        toolboxes = {
            team: learner_toolbox(
                self.learners[team],
                (self._generator(Purpose.LEARN, generation, epoch, team) for epoch in epochs),
            )
            for team in TEAMS
        }
        for epoch in epochs:
            populations = {team: toolboxes[team].generate() for team in TEAMS}
            self._evaluate(populations, generation, epoch)
            for team in TEAMS:
                toolboxes[team].update(populations[team])
            self.report(f"generation {generation}: both")
        for team in TEAMS:
            self.archive[team].append(self.learners[team].genome)

    def _evaluate(self, populations: dict[Team, Candidates], generation: int, epoch: int) -> None:
        """Play one epoch's matches and give every individual its fitness."""
        rng = self._generator(Purpose.OPPONENTS, generation, epoch)
        halls = {team: self._hall_sample(team, rng) for team in TEAMS}
        hall_sizes = (len(halls["pursuer"]), len(halls["evader"]))
        n = self.settings.population
        met = pairings(n, self.settings.contemporaries, hall_sizes, rng)
        scores = self._play(populations, halls, met, generation, epoch)
        for team, index in zip(TEAMS, (met.pursuer, met.evader), strict=True):
            values = mean_of_individuals(index, self.training.fitness(scores, team), n)
            for individual, value in zip(populations[team], values, strict=True):
                individual.fitness.values = (float(value),)
            self.training.record(
                scores, values, team=team, generation=generation, epoch=epoch, opponent=SEVERAL
            )

    def _play(
        self,
        populations: dict[Team, Candidates],
        halls: dict[Team, Genomes],
        met: Pairings,
        generation: int,
        epoch: int,
    ) -> Scores:
        pursuers, evaders = (
            self.training.population(np.concatenate([populations[team].genomes, halls[team]]))
            for team in TEAMS
        )
        rounds = int(met.round.max()) + 1
        seeds = training_seeds(
            self.settings.seed, generation, generation, Phase.BOTH_LEARN, epoch, rounds
        )
        return self.training.play(
            pursuers, evaders, Matches.of(met.pursuer, met.evader, seeds[met.round])
        )

    def _hall_sample(self, team: Team, rng: np.random.Generator) -> Genomes:
        """Return genomes (m, genes) drawn from a team's hall of fame without replacement."""
        hall = self.genomes(team)
        size = min(self.settings.hall_sample, len(hall))
        sample: Genomes = hall[rng.choice(len(hall), size=size, replace=False)]
        return sample

    def _generator(
        self, purpose: Purpose, generation: int, epoch: int, team: Team = "pursuer"
    ) -> np.random.Generator:
        return keyed_generator(self.settings.seed, purpose, TEAMS.index(team), generation, epoch)

    def training_matches(self) -> int:
        """Return the episodes of the training; the halls of fame grow with the generations."""
        settings = self.settings
        halls = sum(min(settings.hall_sample, k) for k in range(1, settings.generations + 1))
        rounds = settings.generations * settings.contemporaries + 2 * halls
        return rounds * settings.joint_epochs * settings.population * settings.worlds
