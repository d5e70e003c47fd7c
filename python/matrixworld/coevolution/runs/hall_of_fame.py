"""Two populations that evolve at the same time, with halls of fame (Rosin & Belew 1997)."""

from __future__ import annotations

from functools import partial
from typing import ClassVar, NamedTuple, cast

import numpy as np

from matrixworld.coevolution.fitness import win_rates
from matrixworld.coevolution.runs.alternating import Race
from matrixworld.coevolution.schedules import HallOfFame, Schedule
from matrixworld.coevolution.seeding import Phase, Purpose, keyed_generator, training_seeds
from matrixworld.coevolution.storage.run_directory import SEVERAL
from matrixworld.coevolution.types import TEAMS, FloatArray, Genomes, Indices, Team, other
from matrixworld.play.rollout import Matches
from matrixworld.world.policy import Population

Populations = dict[Team, Genomes]
"""Genomes (n, genes) float32 of each team."""
Met = tuple[Population, Indices]
"""The possible opponents of an individual, and those that it has met."""


class Pairings(NamedTuple):
    """The M matches of one epoch between two populations of n individuals.

    Players with numbers below n are individuals, the others members of the hall of fame. Matches of
    the same group have the same seed.
    """

    pursuer: Indices
    evader: Indices
    group: Indices


def pairings(
    seed_groups: Indices,
    contemporaries: int,
    hall: tuple[int, int],
    rng: np.random.Generator,
) -> Pairings:
    """Return the matches of two populations of n individuals.

    Every individual plays against `contemporaries` living opponents (such a match counts for both),
    and against every sampled member of the other team's hall of fame.

    `seed_groups` (n,) has the learner's groups (see `Learner`), and `hall` the number of
    sampled members of the pursuers' and of the evaders' hall of fame.

    Groups meet groups in random order, and their members meet in turn: with as many contemporaries
    as a group has members, every member meets all members of one opposing group. Between mirrored
    samples the strength of the opponents then cancels out, like the luck of the match seed. Where
    all individuals are one group, each meets single opponents in random order.
    """
    n, groups = len(seed_groups), int(seed_groups.max()) + 1
    size = n // groups if groups > 1 else 1
    blocks = np.argsort(seed_groups, kind="stable").reshape(-1, size)
    individuals = blocks.ravel()
    rounds = []
    for meeting in range(contemporaries):
        if meeting % size == 0:
            opponents = blocks[rng.permutation(len(blocks))]
        rounds.append((individuals, np.roll(opponents, meeting % size, axis=1).ravel()))
    rounds += [(individuals, np.full(n, n + member)) for member in range(hall[1])]
    rounds += [(np.full(n, n + member), individuals) for member in range(hall[0])]
    pursuers, evaders = zip(*rounds, strict=True)
    # The same seeds for the members of a group, other ones in each round.
    first = np.arange(len(rounds))[:, np.newaxis] * groups
    seeds = first + seed_groups[individuals]
    return Pairings(np.concatenate(pursuers), np.concatenate(evaders), seeds.ravel())


def table_of_individuals(
    own: Indices, opponents: Indices, n: int, values: FloatArray
) -> FloatArray:
    """Return the values (M,) of matches as a table (n, m) of individuals against opponents.

    It holds the mean over the matches of a pair, and NaN for a pair that did not play.
    """
    # Matches of hall members themselves are not needed: they do not evolve any more.
    living, m = own < n, int(opponents.max()) + 1
    pair = own[living] * m + opponents[living]
    count = np.bincount(pair, minlength=n * m)
    table = np.full(n * m, np.nan)
    np.divide(np.bincount(pair, values[living], n * m), count, out=table, where=count > 0)
    return table.reshape(n, m)


class HallOfFameRace(Race):
    """Simultaneous co-evolution of two populations with halls of fame.

    ::

        in each epoch:
            both populations breed
            each individual plays against some living opponents, and against members of the
            opponents' hall of fame that its team's sampler chooses
            its fitness is the mean over its matches, or the result of fitness sharing
        at the end of a generation the champion of each team enters its hall of fame

    Parameters
    ----------
    settings : RaceSettings
        Settings of the race, with the schedule "hall-of-fame".
    directory, threads, play
        As in `Run`.

    Notes
    -----
    The halls of fame are the archive, so that payoff and analysis are those of `Race`. A stage is
    a generation. Any learner can take part: the individuals of an evolution strategy are its
    samples, and its mean is the champion. For attributes see `Race`.

    References
    ----------
    Rosin, C. D. and Belew, R. K. (1997). New methods for competitive coevolution. Evolutionary
    Computation 5(1).
    """

    schedule_class: ClassVar[type[Schedule]] = HallOfFame
    stages_per_generation: ClassVar[int] = 1

    @property
    def schedule(self) -> HallOfFame:
        """Which opponents the teams meet, and for how long."""
        return cast(HallOfFame, self.settings.schedule)  # `check_settings` refuses others

    def learn(self, stage: int) -> None:
        """Let both teams evolve for the epochs of a generation, and archive their champions."""
        generation = 1 + stage
        new = range(generation - 1, generation)
        for team in TEAMS:
            self.admit(team, new, new)
        before = {team: self.learners[team].state() for team in TEAMS}
        for epoch in range(self.schedule.joint_epochs):
            populations = {
                team: self.learners[team].ask(
                    self._generator(Purpose.LEARN, generation, epoch, team)
                )
                for team in TEAMS
            }
            fitness, met = self._evaluate(generation, epoch, populations)
            for team in TEAMS:
                self.learners[team].tell(fitness[team])
            self.report(f"generation {generation}: both")
        # Both teams before either archive grows, so that the order of the teams does not matter.
        for team in TEAMS:
            self.training.choose_champion(self.learners[team], team, generation, *met[team])
            self.retain(team, generation, before[team])
        for team in TEAMS:
            self.archive[team].append(self.learners[team].genome)

    def _evaluate(
        self, generation: int, epoch: int, populations: Populations
    ) -> tuple[dict[Team, FloatArray], dict[Team, Met]]:
        """Play and log the matches of an epoch.

        Returns the fitness (n,) of each team, and whom its fittest individual has met.
        """
        rng = self._generator(Purpose.OPPONENTS, generation, epoch)
        sampled = self._sample_halls(epoch, rng)
        halls = {team: self.genomes(team)[sampled[other(team)]] for team in TEAMS}
        n = self.settings.learner.population
        hall_sizes = (len(halls["pursuer"]), len(halls["evader"]))
        # Both teams have the same kind of learner, and with it the same groups.
        match = self.learners["pursuer"].seed_groups
        pairs = pairings(match, self.schedule.contemporaries, hall_sizes, rng)
        everyone = {
            team: self.training.population(np.concatenate([populations[team], halls[team]]))
            for team in TEAMS
        }
        seeds = training_seeds(
            self.settings.seed, generation, generation, Phase.BOTH_LEARN, epoch,
            int(pairs.group.max()) + 1,
        )[pairs.group]  # fmt: skip
        scores = self.training.play(
            everyone["pursuer"],
            everyone["evader"],
            Matches.of(pairs.pursuer, pairs.evader, seeds),
        )
        players: dict[Team, Indices] = {"pursuer": pairs.pursuer, "evader": pairs.evader}
        fitness: dict[Team, FloatArray] = {}
        met: dict[Team, Met] = {}
        for team in TEAMS:
            table = partial(table_of_individuals, players[team], players[other(team)], n)
            fitness[team] = self.training.fitness(scores, team, table)
            living = players[team] < n
            self.training.teach(
                self.learners[team], team, everyone[other(team)],
                players[other(team)][living], seeds[living],
            )  # fmt: skip
            fittest = players[team] == np.argmax(fitness[team])
            met[team] = everyone[other(team)], players[other(team)][fittest]
            if len(sampled[team]):
                # Columns from n on are the hall of fame.
                self.samplers[team].tell(sampled[team], table(win_rates(scores, team))[:, n:])
            self.training.record(
                scores,
                fitness[team],
                team=team,
                generation=generation,
                epoch=epoch,
                opponent=SEVERAL,
            )
        return fitness, met

    def _sample_halls(self, epoch: int, rng: np.random.Generator) -> dict[Team, Indices]:
        """Return for each team its opponents from the other team's hall of fame."""
        if not self.schedule.hall_sample:
            return {team: np.zeros(0, dtype=np.intp) for team in TEAMS}
        samplers, size = self.samplers, len(self.archive["pursuer"])
        return {team: samplers[team].sample(size, epoch, rng) for team in TEAMS}

    def _generator(
        self, purpose: Purpose, generation: int, epoch: int, team: Team = "pursuer"
    ) -> np.random.Generator:
        return keyed_generator(self.settings.seed, purpose, TEAMS.index(team), generation, epoch)

    def training_matches(self) -> int:
        """Return the number of training episodes; with archives, an upper bound of it."""
        settings, schedule = self.settings, self.schedule
        matches = settings.learner.population * settings.match_episodes
        per_group = schedule.joint_epochs * matches
        groups = schedule.generations * schedule.contemporaries
        admission = champions = 0
        # The halls of fame grow with the generations.
        for k in range(1, schedule.generations + 1):
            for team in TEAMS:
                sampled = min(schedule.sampled_opponents, k)
                groups += sampled
                champions += self.selection_matches(schedule.contemporaries + sampled, k)
                admission += self.max_admission_matches(team, k, k)
        return groups * per_group + admission + champions
