"""Races: both teams learn, in turns (`Race`) or at the same time (`HallOfFameRace`).

In turns, a team meets archived opponents of the other team: those of one of the paper's three
schedules, or what opponent samplers choose; in a `YokedRace` they are those of another race. At the
same time, each individual meets living opponents and members of a hall of fame (Rosin & Belew
1997). A sampler with an archive compares candidates in matches of their own (`Race.admit`).
"""

from __future__ import annotations

import hashlib
import warnings
from dataclasses import replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any, ClassVar, NamedTuple, cast

import numpy as np

from matrixworld._util.files import DamagedFileError
from matrixworld.analysis import disengagements
from matrixworld.analysis.progress import PATIENCE, Disengagement
from matrixworld.coevolution.fitness import win_rates
from matrixworld.coevolution.opponents import ArchiveSampler
from matrixworld.coevolution.runs.run import Run
from matrixworld.coevolution.schedules import (
    Alternating,
    RaceSchedule,
    Schedule,
    Simultaneous,
    Yoked,
    available,
)
from matrixworld.coevolution.sections import different_settings, values_of
from matrixworld.coevolution.seeding import Phase, Purpose, training_seeds
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import SEVERAL, Archive, SavedRun
from matrixworld.coevolution.types import (
    TEAMS,
    FloatArray,
    Genomes,
    Indices,
    Members,
    Payoff,
    State,
    Team,
    other,
)
from matrixworld.play.rollout import Matches
from matrixworld.world.policy import Population, TeamPolicy

EVEN = 0.5
"""Capture rate at which neither team wins."""
DECIMALS = 6
"""Capture rates are float32: differences beyond this decimal are rounding errors."""

Met = tuple[Population, Indices]
"""The possible opponents of an individual, and those that it has met."""


class DisengagementWarning(UserWarning):
    """One team wins nearly everything, so that neither team has much to learn from."""


class Race(Run):
    """Co-evolution in turns, by one of the paper's three schedules or by opponent samplers.

    ::

        p[0], e[0] untrained
        for k in 1 .. generations:
            p[k] = p[k-1], improved for some epochs against evaders that its sampler chooses
            e[k] = e[k-1], improved for some epochs against pursuers that its sampler chooses
        payoff[g, h] = capture rate of p[g] against e[h]

    A stage is a team phase: one team's epochs of one generation. Learners keep their state from
    generation to generation.

    For parameters and other attributes see `Run`.
    """

    schedule: RaceSchedule
    schedule_class: ClassVar[type[Schedule]] = Alternating
    stages_per_generation: ClassVar[int] = 2

    def learn(self, stage: int) -> None:
        """Let one team learn for the epochs of a generation, and archive its genome."""
        # Pursuers in even stages, evaders in odd ones; generation 0 is untrained.
        generation, team = 1 + stage // 2, TEAMS[stage % 2]
        n_before = available(team, generation - 1) if generation > 1 else 0
        self.admit(team, generation, range(n_before, available(team, generation)))
        before = self.learners[team].state()
        epochs, activity = range(self.schedule.epochs(team)), f"generation {generation}: {team}s"
        self.improve(team, generation, self.opponents(team), epochs, activity)
        self.retain(team, generation, before)
        self.archive_genome(team)

    def opponents(self, team: Team) -> Population:
        """Return all generations of the other team that a team can meet now."""
        return self.training.population(other(team), self.genomes(other(team)))

    def retain(self, team: Team, generation: int, before: State) -> None:
        """Undo what a team has learned in a generation if it got worse against all opponents.

        Only with the setting `retention_episodes`; `before` is the state of the learner before the
        generation. The random numbers of the next generation are others, so that a discarded
        generation is not learned again.
        """
        episodes, learner = self.schedule.retention_episodes, self.learners[team]
        if not episodes:
            return
        opponents = self.opponents(team)
        previous = self.archive[team][-1]
        if not self.training.keeps(team, generation, learner.genome, previous, opponents, episodes):
            learner.restore(before)

    def finalists(self) -> dict[Team, tuple[TeamPolicy, int]]:
        """Return all archived generations of both teams."""
        return {team: (self.training.population(team, self.genomes(team)), 0) for team in TEAMS}

    # Disengagement:

    def end_stage(self) -> None:
        """Save the stage; warn once of each disengagement, when it is long enough."""
        super().end_stage()
        if self.stage % self.stages_per_generation == 0:
            generation = self.stage // self.stages_per_generation
            for stretch in self.disengagements():
                # Equal, not at least: a longer stretch has been reported before.
                if stretch.last == generation and len(stretch) == PATIENCE:
                    warnings.warn(str(stretch), DisengagementWarning, stacklevel=3)

    def disengagements(self) -> tuple[Disengagement, ...]:
        """Return the stretches of finished generations in which one team won everything."""
        stages = self.stages_per_generation
        finished = self.stage // stages
        rates = np.array(self.stage_capture_rates[: finished * stages]).reshape(finished, stages)
        # If a stage is a generation (as in `HallOfFameRace`), both phases have its rate.
        return disengagements(np.broadcast_to(rates, (finished, 2)))

    def summary(self, payoff: Payoff) -> dict[str, Any]:
        """Return counts, and stretches of disengagement; commands judge the payoffs when asked."""
        stretches = [str(stretch) for stretch in self.disengagements()]
        return {**super().summary(payoff), "disengagement": stretches}

    # Matches in which samplers with an archive compare candidates:

    def admit(self, team: Team, generation: int, opponents: range) -> None:
        """Add the team's newest genome and new `opponents` to its sampler's archive, if any."""
        sampler = self.samplers[team]
        if isinstance(sampler, ArchiveSampler):
            payoff = partial(self._payoff, team, graded=sampler.archive.graded)
            sampler.update(np.array([generation - 1]), np.array(opponents), payoff)

    def _payoff(
        self, team: Team, candidates: Members, tests: Members, *, graded: bool
    ) -> FloatArray:
        """Play generations (n,) of a team against opponents (m,), and return the payoffs (n, m).

        They are rates if `graded`, otherwise 1 for a win, 0.5 for a draw and 0.
        """
        met = {team: candidates.astype(int), other(team): tests.astype(int)}
        episodes = self.schedule.archive_episodes(team)
        # The order of the seeds: all episodes of a pair, which have seeds of their own, then the
        # next pair.
        pairs = [(int(g), int(h)) for g in met["pursuer"] for h in met["evader"]]
        seeds = [
            training_seeds(self.settings.seed, g, h, Phase.ARCHIVE, 0, episodes) for g, h in pairs
        ]
        pursuers, evaders = (self.training.population(each, self.genomes(each)) for each in TEAMS)
        g, h = np.repeat(pairs, episodes, axis=0).T
        scores = self.training.play(pursuers, evaders, Matches.of(g, h, np.concatenate(seeds)))
        rates = scores.capture_rate.mean(axis=1, dtype=np.float64)
        shape = len(met["pursuer"]), len(met["evader"]), episodes
        captured = np.asarray(rates.reshape(shape).mean(axis=2))
        # Archives are the same for both teams: rows are candidates, and higher is better.
        payoff = captured if team == "pursuer" else 1.0 - captured.T
        if graded:
            return payoff
        return np.asarray((1.0 + np.sign(np.round(payoff - EVEN, DECIMALS))) / 2.0)


class YokedRace(Race):
    """A race in turns whose opponents are replayed from the finished race of another seed.

    ::

        P, E the archives of the other race; all else as in `Race`
        p[k] = p[k-1], improved for some epochs against evaders that its sampler chooses in E
        e[k] = e[k-1], improved for some epochs against pursuers that its sampler chooses in P

    config.json holds a digest of P and E, so that no run goes on against others.
    """

    schedule: Yoked
    schedule_class: ClassVar[type[Schedule]] = Yoked

    @cached_property
    def replayed(self) -> Archive:
        """Genomes of both teams in the other race."""
        return race_to_replay(self.settings).archive()

    def extra_config(self) -> dict[str, Any]:
        """Return a digest of these genomes."""
        content = b"".join(self.replayed[team].tobytes() for team in TEAMS)
        return {"replayed": hashlib.sha256(content).hexdigest()}

    def learn(self, stage: int) -> None:
        """Let one team learn; DamagedFileError if the race to replay has changed."""
        if self.files.config["replayed"] != self.extra_config()["replayed"]:
            problem = f"expected the race that {self.files.path} has replayed so far, got another"
            raise DamagedFileError(Path(self.schedule.race), problem)
        super().learn(stage)

    def opponents(self, team: Team) -> Population:
        """Return as many generations of the other race as this one has itself."""
        replayed, own = self.replayed[other(team)], self.archive[other(team)]
        return self.training.population(other(team), replayed[: len(own)])


def race_to_replay(settings: RaceSettings) -> SavedRun:
    """Return the race to which a race is yoked; ValueError unless it is finished and fits."""
    schedule = cast(Yoked, settings.schedule)
    race = SavedRun(schedule.race)
    if not race.finished:
        raise ValueError(f"schedule.race: expected a finished race to replay, got {schedule.race}")
    found = race.settings
    if found.seed == settings.seed:
        raise ValueError(
            f"schedule.race: expected a race of another seed than {found.seed}, got {schedule.race}"
        )
    fitting = replace(settings, seed=found.seed, schedule=schedule.replayed)
    for path in different_settings(fitting, found):
        mine, its = (values_of(each).get(path) for each in (fitting, found))
        raise ValueError(
            f"schedule.race: expected a race with {path} {mine}, as the yoked one, got {its} in "
            f"{schedule.race}"
        )
    return race


class HallOfFameRace(Race):
    """Simultaneous co-evolution of two populations with halls of fame (Rosin & Belew 1997).

    ::

        in each epoch:
            both populations breed
            each individual plays against some living opponents, and against members of the
            opponents' hall of fame that its team's sampler chooses
            its fitness is the mean over its matches, or the result of fitness sharing
        at the end of a generation the champion of each team enters its hall of fame

    The halls of fame are the archive, so that payoff and analysis are those of `Race`. A stage is
    a generation. Any learner can take part: the individuals of an evolution strategy are its
    samples, and its mean is the champion. See Rosin & Belew (1997), "New methods for competitive
    coevolution", Evolutionary Computation 5(1).
    """

    schedule: Simultaneous
    schedule_class: ClassVar[type[Schedule]] = Simultaneous
    stages_per_generation: ClassVar[int] = 1

    def learn(self, stage: int) -> None:
        """Let both teams evolve for the epochs of a generation, and archive their champions."""
        generation = 1 + stage
        for team in TEAMS:
            self.admit(team, generation, range(stage, generation))
        before = {team: self.learners[team].state() for team in TEAMS}
        for epoch in range(self.schedule.joint_epochs):
            populations = {
                team: self.learners[team].ask(
                    self.generator(Purpose.LEARN, team, generation, epoch)
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
            self.archive_genome(team)

    def _evaluate(
        self, generation: int, epoch: int, populations: dict[Team, Genomes]
    ) -> tuple[dict[Team, FloatArray], dict[Team, Met]]:
        """Play and log the matches of an epoch.

        Returns the fitness (n,) of each team, and whom its fittest individual has met.
        """
        # One for both teams: their matches are drawn together.
        rng = self.generator(Purpose.OPPONENTS, "pursuer", generation, epoch)
        sampled = self._sample_halls(epoch, rng)
        halls = {team: self.genomes(team)[sampled[other(team)]] for team in TEAMS}
        n = self.settings.learner.population
        # Both teams have the same learner, and with it the same groups.
        groups = self.learners["pursuer"].seed_groups
        hall_sizes = (len(halls["pursuer"]), len(halls["evader"]))
        pairs = pairings(groups, self.schedule.contemporaries, hall_sizes, rng)
        everyone = {
            team: self.training.population(team, np.concatenate([populations[team], halls[team]]))
            for team in TEAMS
        }
        seeds = training_seeds(
            self.settings.seed, generation, generation, Phase.BOTH_LEARN, epoch,
            int(pairs.group.max()) + 1,
        )[pairs.group]  # fmt: skip
        scores = self.training.play(
            everyone["pursuer"], everyone["evader"], Matches.of(pairs.pursuer, pairs.evader, seeds)
        )
        fitness: dict[Team, FloatArray] = {}
        met: dict[Team, Met] = {}
        for team in TEAMS:
            own, opponents = getattr(pairs, team), getattr(pairs, other(team))
            table = partial(table_of_individuals, own, opponents, n)
            fitness[team] = self.training.fitness_of_epoch(
                scores, table, team=team, generation=generation, epoch=epoch, opponent=SEVERAL
            )
            living, fittest = own < n, own == np.argmax(fitness[team])
            self.training.teach(
                self.learners[team], team, everyone[other(team)], opponents[living], seeds[living]
            )
            met[team] = everyone[other(team)], opponents[fittest]
            if len(sampled[team]):
                # Columns from n on are the hall of fame.
                self.samplers[team].tell(sampled[team], table(win_rates(scores, team))[:, n:])
        return fitness, met

    def _sample_halls(self, epoch: int, rng: np.random.Generator) -> dict[Team, Indices]:
        """Return for each team its opponents from the other team's hall of fame."""
        if not self.schedule.hall_sample:
            return {team: np.zeros(0, dtype=np.intp) for team in TEAMS}
        samplers, size = self.samplers, len(self.archive["pursuer"])
        return {team: samplers[team].sample(size, epoch, rng) for team in TEAMS}


class Pairings(NamedTuple):
    """The M matches of one epoch between two populations of n individuals.

    Players with numbers below n are individuals, the others members of the hall of fame. Matches of
    the same group have the same seed.
    """

    pursuer: Indices
    evader: Indices
    group: Indices


def pairings(
    seed_groups: Indices, contemporaries: int, hall: tuple[int, int], rng: np.random.Generator
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
