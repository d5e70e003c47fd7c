"""Two populations that evolve at the same time, with halls of fame (Rosin & Belew 1997)."""

from __future__ import annotations

from functools import partial
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld.checks import check_choice
from matrixworld.coevolution.fitness import win_rates
from matrixworld.coevolution.learners.toolbox import Candidates, learner_toolbox
from matrixworld.coevolution.opponents.registry import HALL_OF_FAME
from matrixworld.coevolution.runs.alternating import Race
from matrixworld.coevolution.runs.run import Run
from matrixworld.coevolution.seeding import (
    Phase,
    Purpose,
    keyed_generator,
    training_seeds,
)
from matrixworld.coevolution.storage.run_log import SEVERAL
from matrixworld.coevolution.types import TEAMS, Genomes, Indices, Team, other
from matrixworld.rollout import EpisodeStatistics, Matches


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


def table_of_individuals(
    own: Indices, opponents: Indices, n: int, values: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return values (M,) of matches as (n, m), individuals against opponents; NaN: not met.

    Two that met several times get the mean. `own` and `opponents` (M,) name who played; of `own`
    those from n on belong to the hall.
    """
    living, m = own < n, int(opponents.max()) + 1
    pair = own[living] * m + opponents[living]
    count = np.bincount(pair, minlength=n * m)
    table = np.full(n * m, np.nan)
    np.divide(np.bincount(pair, values[living], n * m), count, out=table, where=count > 0)
    return table.reshape(n, m)


class HallOfFameRace(Race):
    """Simultaneous co-evolution of two genetic algorithms with halls of fame.

    ::

        in each epoch:
            both populations breed
            each individual meets some living opponents, and those of the opponents' hall of fame
            that its team's selection names
            its fitness is the mean over its matches, or what sharing makes of them
        at the end of a generation the champion of each team enters its hall of fame

    Method: Rosin & Belew 1997, "New methods for competitive coevolution".
    The halls of fame are the archive, so that payoff and analysis are those of `Race`. A stage is
    a generation. Parameters and attributes as in `Run`.
    """

    kind: ClassVar[str] = "hall-of-fame"
    stages_per_generation: ClassVar[int] = 1

    def check_settings(self) -> None:
        """Raise ValueError unless the schedule is the hall of fame."""
        Run.check_settings(self)
        check_choice("schedule", self.settings.schedule, [HALL_OF_FAME])

    def learn(self, stage: int) -> None:
        """Let both teams evolve for the epochs of a generation, and archive their champions."""
        generation = 1 + stage
        epochs = range(self.settings.joint_epochs)
        new = range(generation - 1, generation)
        for team in TEAMS:
            self.matchmaking.admit(team, new, new)
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
        met = self._met(epoch, rng)
        halls = {team: self.genomes(team)[met[other(team)]] for team in TEAMS}
        n = self.settings.population
        hall_sizes = (len(halls["pursuer"]), len(halls["evader"]))
        who = pairings(n, self.settings.contemporaries, hall_sizes, rng)
        scores = self._play(populations, halls, who, generation, epoch)
        sides = {"pursuer": who.pursuer, "evader": who.evader}
        for team in TEAMS:
            table = partial(table_of_individuals, sides[team], sides[other(team)], n)
            values = self.training.fitness(scores, team, table)
            if len(met[team]):
                self.matchmaking.samplers[team].tell(
                    met[team], table(win_rates(scores, team))[:, n:]
                )
            for individual, value in zip(populations[team], values, strict=True):
                individual.fitness.values = (float(value),)
            self.training.record(
                scores, values, team=team, generation=generation, epoch=epoch, opponent=SEVERAL
            )

    def _met(self, epoch: int, rng: np.random.Generator) -> dict[Team, Indices]:
        """Return per team whom of the other's hall of fame it meets."""
        if not self.settings.hall_sample:
            return {team: np.zeros(0, dtype=np.intp) for team in TEAMS}
        samplers, size = self.matchmaking.samplers, len(self.archive["pursuer"])
        return {team: samplers[team].sample(size, epoch, rng) for team in TEAMS}

    def _play(
        self,
        populations: dict[Team, Candidates],
        halls: dict[Team, Genomes],
        met: Pairings,
        generation: int,
        epoch: int,
    ) -> EpisodeStatistics:
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

    def _generator(
        self, purpose: Purpose, generation: int, epoch: int, team: Team = "pursuer"
    ) -> np.random.Generator:
        return keyed_generator(self.settings.seed, purpose, TEAMS.index(team), generation, epoch)

    def training_matches(self) -> int:
        """Return the episodes of the training, or the most that there can be with archives.

        The halls of fame grow with the generations.
        """
        settings = self.settings
        each = settings.joint_epochs * settings.population * settings.worlds
        rounds = settings.generations * settings.contemporaries
        admitted = 0
        for k in range(1, settings.generations + 1):
            for team in TEAMS:
                rounds += min(settings.met(team), k)
                admitted += self.matchmaking.most_admitted(team, k, k)
        return rounds * each + admitted
