"""Races: which opponents a team meets while it learns, for how many epochs, and the loop itself.

`k` is the generation that learns (from 1), `i` the epoch inside it (from 0). The archives begin
with the untrained `p[0]` and `e[0]`. The paper's three schedules (Sun et al. 2023, "MatrixWorld",
arXiv:2307.14854) are races in turns:

==========================  =========================  =========================
schedule                    opponents of the pursuers  opponents of the evaders
==========================  =========================  =========================
specialist-specialist       ``e[k - 1]``               ``p[k]``
generalist-specialist       ``e[i mod k]``             ``p[k]``
generalist-generalist       ``e[i mod k]``             ``p[i mod (k + 1)]``
==========================  =========================  =========================

The opponents of specialists are the `Latest`, those of generalists all by `RoundRobin`. A fourth
one, `psro`, draws them from Nash mixtures (`NashOpponents`). Each class here is the settings of a
kind of race, its own defaults of other settings, and its loop, `learn`. What a loop does with a
`Run` (ask, play, tell, archive) is in `run`.
"""

from __future__ import annotations

import math
import re
from abc import abstractmethod
from collections.abc import Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from matrixworld._util.checks import check_choice, check_integer
from matrixworld.analysis import intervals
from matrixworld.coevolution import opponents as samplers
from matrixworld.coevolution import pursuit, seeding, types
from matrixworld.coevolution.sections import Section, by_race, kinds_in, section, setting
from matrixworld.coevolution.types import TEAMS, FloatArray, Genomes, Indices, Payoff, Team, other

if TYPE_CHECKING:
    from matrixworld.coevolution.run import Run, RunInMemory


@section
class Race(Section):
    """Base of the kinds of races."""

    stages_per_generation: ClassVar[int] = 1
    """Stages of a generation; a run is saved after each of them."""

    # What a kind of race states:

    @property
    def name(self) -> str:
        """What the race is called, such as in directories."""
        return self.kind

    @property
    def defaults(self) -> Mapping[str, Any]:
        """Settings that have other defaults in this kind of race, by their paths."""
        return {}

    @property
    def learning_teams(self) -> tuple[Team, ...]:
        """Teams that learn."""
        return TEAMS

    @property
    def opponents_met(self) -> int:
        """Most opponents of a candidate in an epoch."""
        return 1

    @property
    def limits(self) -> str:
        """What races with so few epochs may hide, in a sentence; empty if nothing is known."""
        return ""

    @property
    @abstractmethod
    def entries(self) -> int:
        """Genomes in the archive of a learning team at the end of a run."""

    def total_epochs(self, team: Team) -> int:
        """Return the epochs of the whole run in which `team` learns."""
        return self.epochs_until(self.n_stages)

    @abstractmethod
    def epochs_in(self, stage: int) -> int:
        """Return the epochs of a stage."""

    def epochs_until(self, stage: int) -> int:
        """Return the epochs of all stages before one."""
        return sum(map(self.epochs_in, range(stage)))

    def sampler(self, team: Team) -> samplers.Opponents:
        """Return how a team chooses opponents; imports code of your own."""
        return samplers.RoundRobin()

    @abstractmethod
    def learn(self, run: RunInMemory, stage: int) -> None:
        """Run one stage: improve learners, extend the archive, log each epoch."""

    def finalists(self, run: RunInMemory) -> dict[Team, tuple[Any, int]]:
        """Return who plays the evaluation for each team, and the generation of the first."""
        return {team: (run.population(team, run.genomes(team)), 0) for team in TEAMS}

    def summary(self, run: Run, payoff: Payoff) -> dict[str, Any]:
        """Return what summary.json holds besides counts."""
        teams = run.settings.teams
        stretches = [stretch.in_words(teams) for stretch in run.disengagements()]
        return {"disengagement": stretches}

    @property
    def n_stages(self) -> int:
        """The number of stages: of each entry that the run adds to the archive of a team."""
        return self.stages_per_generation * (self.entries - 1)


@section
class OfGenerations(Race):
    """Base of the races in which both teams learn."""

    generations: int = setting(30, "generations after the untrained generation 0", least=1)
    pursuers_meet: samplers.AnyOpponents = setting(
        samplers.Uniform(),
        f"whom pursuers meet: {', '.join(kinds_in(samplers.AnyOpponents))} or module:object",
    )
    evaders_meet: samplers.AnyOpponents = setting(
        samplers.Uniform(), "whom evaders meet; as for the pursuers"
    )

    @property
    def entries(self) -> int:
        """Genomes in the archive of a team at the end of a race."""
        return 1 + self.generations

    def sampler(self, team: Team) -> samplers.Opponents:
        """Return how a team chooses opponents; imports code of your own."""
        met = self.pursuers_meet if team == "pursuer" else self.evaders_meet
        sampler: samplers.Opponents = met.load() if isinstance(met, samplers.OwnOpponents) else met
        return sampler


# In turns:

PSRO = "psro"  # name of a schedule in which both teams meet Nash mixtures
ENOUGH_EPOCHS = 60
HIDES_CYCLING = (
    "Short races of specialists may hide cycling: with 28 and 58 epochs in a generation it was "
    f"found in 5 of 20 races, with {ENOUGH_EPOCHS} and 120 in 12 of 20."
)
"""By ``evolution/race_budgets.py``; epochs of pursuers and of evaders."""


@section
class InTurns(OfGenerations):
    """The teams learn in turns, against archived opponents that their samplers choose.

    ::

        p[0], e[0] untrained
        for k in 1 .. generations:
            p[k] = p[k-1], improved for some epochs against evaders among e[0 .. k-1]
            e[k] = e[k-1], improved for some epochs against pursuers among p[0 .. k]
        payoff[g, h] = capture rate of p[g] against e[h]

    A stage is a team phase: one team's epochs of one generation. Learners keep their state from
    generation to generation.
    """

    kind: ClassVar[str] = "alternating"
    stages_per_generation: ClassVar[int] = 2
    shorthands: ClassVar[Mapping[str, Mapping[str, Any]]] = {
        "specialist-specialist": {"pursuers_meet": "latest", "evaders_meet": "latest"},
        "generalist-specialist": {"pursuers_meet": "round-robin", "evaders_meet": "latest"},
        "generalist-generalist": {"pursuers_meet": "round-robin", "evaders_meet": "round-robin"},
        PSRO: {"pursuers_meet": "nash", "evaders_meet": "nash"},
    }

    opponents: int = setting(1, "opponents of each candidate in an epoch", least=1)
    pursuer_epochs: int = by_race(28, "epochs per generation in which pursuers learn", least=1)
    evader_epochs: int = by_race(58, "epochs per generation in which evaders learn", least=1)

    @property
    def name(self) -> str:
        """The name in the paper of a schedule that has one, "psro", or "alternating"."""
        kinds = {"pursuers_meet": self.pursuers_meet.kind, "evaders_meet": self.evaders_meet.kind}
        names = [name for name, each in self.shorthands.items() if each == kinds]
        return names[0] if names and (self.opponents == 1 or names == [PSRO]) else self.kind

    @property
    def limits(self) -> str:
        """What races with so few epochs may hide, in a sentence; empty if nothing is known."""
        specialists = self.name == "specialist-specialist"
        return HIDES_CYCLING if specialists and self.pursuer_epochs < ENOUGH_EPOCHS else ""

    @property
    def opponents_met(self) -> int:
        """Most opponents of a candidate in an epoch."""
        return self.opponents

    def epochs(self, team: Team) -> int:
        """Return the epochs of a generation in which `team` learns."""
        return self.pursuer_epochs if team == "pursuer" else self.evader_epochs

    def total_epochs(self, team: Team) -> int:
        """Return the epochs of the whole run in which `team` learns."""
        return self.generations * self.epochs(team)

    def epochs_in(self, stage: int) -> int:
        """Return the epochs of a stage, of the pursuers if it is even."""
        return self.epochs(TEAMS[stage % 2])

    def learn(self, run: RunInMemory, stage: int) -> None:
        """Let one team learn for the epochs of a generation, and archive its genome."""
        # Pursuers in even stages, evaders in odd ones; generation 0 is untrained.
        generation, team = 1 + stage // 2, TEAMS[stage % 2]
        run.update_sampler(team, generation, available(team, generation))
        epochs = range(self.epochs(team))
        activity = f"generation {generation}: {run.name_of(team)}"
        genome = improve(run, team, generation, self.opponents, epochs, activity)
        run.archive_genome(team, genome)


def available(team: Team, k: int) -> int:
    """Return how many generations of the other team are archived when `team` learns, in turns.

    `k` is the generation that the team learns, at least 1: generation 0 is untrained.
    """
    check_choice("team", team, TEAMS)
    check_integer("k", k, 1)
    # The pursuers learn first, so the evaders can play against generation k already.
    return k if team == "pursuer" else k + 1


def improve(
    run: RunInMemory, team: Team, generation: int, count: int, epochs: Iterable[int], activity: str
) -> types.Genome:
    """Let a team learn for some epochs against `count` opponents each; return its genome."""
    opponents = run.opponents(team)
    groups = run.learners[team].seed_groups
    n = len(groups)

    def table(values: FloatArray) -> FloatArray:
        return values.reshape(n, -1)

    for epoch in epochs:
        run.begin_epoch(team, generation, epoch)
        candidates = run.ask(team, generation, epoch)
        rng = run.generator(seeding.Purpose.OPPONENTS, team, generation, epoch)
        met = run.sample(team, types.team_size(opponents), count, epoch, rng)
        seeds = match_seeds(run, team, generation, epoch, met)
        scores = run.play_candidates(team, candidates, opponents, met, seeds)
        # Win rates, not fitness: samplers expect numbers in [0, 1].
        run.tell_sampler(team, met, table(scores.of(team).mean(axis=1)))
        opponent = int(met[0]) if len(met) == 1 else types.SEVERAL
        fitness = run.log_fitness(team, scores, table, generation, epoch, opponent)
        run.report(activity)
        run.tell(team, fitness, opponents, np.tile(met, n), seeds.ravel())
    return run.champion(team, generation, candidates, fitness, opponents, met)


def match_seeds(run: RunInMemory, team: Team, generation: int, epoch: int, met: Indices) -> Any:
    """Return the seeds (n, c) of n candidates against the opponents (c,) of an epoch."""
    # Candidates of the same match, such as a mirrored pair, differ in nothing but their genes.
    groups = run.learners[team].seed_groups
    seeds = []
    for opponent in map(int, met):
        # They depend on both generations, so that no two phases play the same episodes.
        pair = (generation, opponent) if team == "pursuer" else (opponent, generation)
        phase = seeding.Phase.PURSUERS_LEARN if team == "pursuer" else seeding.Phase.EVADERS_LEARN
        count = int(groups.max()) + 1
        seeds.append(seeding.training_seeds(run.settings.seed, *pair, phase, epoch, count)[groups])
    return np.stack(seeds, axis=1)


# At the same time:


@section
class AtOnce(OfGenerations):
    """Both teams learn at the same time, from living opponents and a hall of fame.

    ::

        in each epoch:
            both populations breed
            each individual plays against some living opponents, and against members of the
            opponents' hall of fame that its team's sampler chooses
            its fitness is the mean over its matches, or the result of fitness sharing
        at the end of a generation the champion of each team enters its hall of fame

    The halls of fame are the archive, so that payoff and analysis are those of races in turns. A
    stage is a generation. Any learner can take part: the individuals of an evolution strategy are
    its samples, and its mean is the champion.

    Rosin & Belew 1997, "New methods for competitive coevolution", Evolutionary Computation 5(1).
    """

    kind: ClassVar[str] = "hall-of-fame"

    joint_epochs: int = by_race(43, "epochs per generation, in which both teams learn", least=1)
    contemporaries: int = setting(2, "living opponents of each individual")
    hall_sample: int = setting(1, "opponents of each individual from the hall of fame")

    def check(self) -> None:
        """Raise ValueError without opponents, or if a sampler is named that draws none."""
        if not self.opponents_met:
            raise ValueError("contemporaries and hall_sample: expected at least 1 opponent, got 0")
        for name in ("pursuers_meet", "evaders_meet"):
            if not self.hall_sample and getattr(self, name) != samplers.Uniform():
                raise ValueError(f"{name}: expected no value with a hall_sample of 0")

    @property
    def defaults(self) -> Mapping[str, Any]:
        """Individuals of both teams share the matches."""
        return {"learner.population": 24}

    @property
    def opponents_met(self) -> int:
        """Most opponents of a candidate in an epoch."""
        return self.contemporaries + self.hall_sample

    def epochs_in(self, stage: int) -> int:
        """Return the epochs of a stage, in which both teams learn."""
        return self.joint_epochs

    def learn(self, run: RunInMemory, stage: int) -> None:
        """Let both teams evolve for the epochs of a generation, and archive their champions."""
        generation = 1 + stage
        for team in TEAMS:
            run.update_sampler(team, generation, generation)
        for epoch in range(self.joint_epochs):
            run.begin_epoch("pursuer", generation, epoch)
            populations = {team: run.ask(team, generation, epoch) for team in TEAMS}
            played = self._play(run, generation, epoch, populations)
            run.report(f"generation {generation}: both")
        # Both teams before either archive grows, so that the order of the teams does not matter.
        genomes = {
            team: run.champion(team, generation, populations[team], *played[team]) for team in TEAMS
        }
        for team in TEAMS:
            run.archive_genome(team, genomes[team])

    def _play(
        self, run: RunInMemory, generation: int, epoch: int, populations: Mapping[Team, Genomes]
    ) -> dict[Team, tuple[FloatArray, Any, Indices]]:
        """Play the matches of an epoch, and let both teams learn from them.

        Returns the fitness (n,), all possible opponents, and those of the fittest, of each team.
        """
        # One for both teams: their matches are drawn together.
        rng = run.generator(seeding.Purpose.OPPONENTS, "pursuer", generation, epoch)
        sampled: dict[Team, Indices] = dict.fromkeys(TEAMS, np.zeros(0, dtype=np.intp))
        if self.hall_sample:
            size = len(run.archive["pursuer"])
            sampled = {t: run.sample(t, size, self.hall_sample, epoch, rng) for t in TEAMS}
        halls = {team: run.genomes(team)[sampled[other(team)]] for team in TEAMS}
        # Both teams have the same learner, and with it the same groups.
        groups = run.learners["pursuer"].seed_groups
        n, hall_sizes = len(groups), (len(halls["pursuer"]), len(halls["evader"]))
        pursuers, evaders, group = pairings(groups, self.contemporaries, hall_sizes, rng)
        everyone = {
            team: run.population(team, np.concatenate([populations[team], halls[team]]))
            for team in TEAMS
        }
        key = (run.settings.seed, generation, generation, seeding.Phase.BOTH_LEARN, epoch)
        seeds = seeding.training_seeds(*key, int(group.max()) + 1)[group]
        scores = run.play(everyone["pursuer"], everyone["evader"], (pursuers, evaders, seeds))
        found: dict[Team, tuple[FloatArray, Any, Indices]] = {}
        players = dict(zip(TEAMS, (pursuers, evaders), strict=True))
        for team in TEAMS:
            own, opponents = players[team], players[other(team)]
            rivals = everyone[other(team)]
            table = partial(table_of_individuals, own, opponents, n)
            fitness = run.log_fitness(team, scores, table, generation, epoch, types.SEVERAL)
            if len(sampled[team]):
                # Columns from n on are the hall of fame.
                won = table(scores.of(team).mean(axis=1))[:, n:]
                run.tell_sampler(team, sampled[team], won)
            found[team] = fitness, rivals, opponents[own == np.argmax(fitness)]
            living = own < n
            run.tell(team, fitness, rivals, opponents[living], seeds[living])
        return found


def pairings(
    seed_groups: Indices, contemporaries: int, hall: tuple[int, int], rng: types.Rng
) -> tuple[Indices, Indices, Indices]:
    """Return pursuers, evaders and groups (M,) of matches; those of a group have the same seed.

    Numbers below n are individuals, others members of the `hall` of fame, whose sizes are given.
    """
    # Groups meet groups in random order, and their members meet in turn: between mirrored samples
    # the strength of the opponents then cancels out, like the luck of the match seed. Where all
    # individuals are one group, each meets single opponents in random order.
    n, groups = len(seed_groups), int(seed_groups.max()) + 1
    size = n // groups if groups > 1 else 1
    blocks = np.argsort(seed_groups, kind="stable").reshape(-1, size)
    individuals = blocks.ravel()
    rounds = []
    for meeting in range(contemporaries):
        if meeting % size == 0:
            opponents = blocks[rng.permutation(len(blocks))]
        met = np.roll(opponents, meeting % size, axis=1) if size > 1 else opponents
        rounds.append((individuals, met.ravel()))
    rounds += [(individuals, np.full(n, n + member)) for member in range(hall[1])]
    rounds += [(np.full(n, n + member), individuals) for member in range(hall[0])]
    pursuers, evaders = zip(*rounds, strict=True)
    # The same seeds for the members of a group, other ones in each round.
    first = np.arange(len(rounds))[:, np.newaxis] * groups
    seeds = first + seed_groups[individuals]
    return np.concatenate(pursuers), np.concatenate(evaders), seeds.ravel()


def table_of_individuals(
    own: Indices, opponents: Indices, n: int, values: FloatArray
) -> FloatArray:
    """Return the values (M,) of matches as a table (n, m): means of pairs, NaN without a match."""
    # Matches of hall members themselves are not needed: they do not evolve any more.
    living, m = own < n, int(opponents.max()) + 1
    pair = own[living] * m + opponents[living]
    count = np.bincount(pair, minlength=n * m)
    table = np.full(n * m, np.nan)
    np.divide(np.bincount(pair, values[living], n * m), count, out=table, where=count > 0)
    return table.reshape(n, m)


# Against fixed opponents:


@section
class Against(Race):
    """One team learns alone, against fixed opponents, one of them in each epoch.

    ::

        for k in 1 .. epochs / archive_every:
            g[k] = g[k-1], improved for `archive_every` epochs against each opponent in turn
        payoff = capture rate of the last genome against, or of, each opponent

    The archive holds the opponents' genomes, too, if they have any, so that a run does not depend
    on other directories.
    """

    kind: ClassVar[str] = "against"

    team: Team = setting("pursuer", "team that learns: pursuer or evader", choices=TEAMS)
    opponent: str = setting(
        "random", f"{', '.join(pursuit.SCRIPTS)}, or a run directory (its last generation)"
    )
    start: str | None = setting(
        None, "run directory; start from its last generation instead of an untrained genome"
    )
    epochs: int = by_race(6000, "epochs of the run", least=1)
    archive_every: int = setting(
        100, "epochs between entries of the archive; each is a checkpoint", least=1
    )

    @property
    def name(self) -> str:
        """What the run is called, such as ``evader-against-random``."""
        path = Path(self.opponent)
        # Runs of a job are called after their seeds, which says nothing: their folder does.
        name = path.parent.name if re.fullmatch(r"seed-\d+", path.name) else path.name
        name = re.sub(r"[^\w.=+-]", "-", name)
        return f"{self.team}-against-{name}"

    @property
    def defaults(self) -> Mapping[str, Any]:
        """More epochs, in which steps fall: n random steps lead a root of n as far as one.

        Updates by Adam have about the length of the rate in each gene, and mostly random
        directions. So a rate in proportion to 1 / root(n) lets a genome go equally far in short
        runs and in long ones. The factors are chosen by trial.
        """
        pursuers = self.team == "pursuer"
        epochs = 6000 if pursuers else 4000
        rate = 1.25 / math.sqrt(self.epochs or epochs)
        return {
            "schedule.epochs": epochs,
            "learner.population": 128,
            "learner.learning_rate": rate,
            "learner.sigma": math.sqrt(rate / 2.0),
            "learner.relative_sigma": 0.0,
            "learner.anneal": True,
            "learner.mutation": 0.2,
            "policy.initial_weight": 0.2 if pursuers else 0.05,
            "policy.initial_head": 0.09 if pursuers else 0.1,
            "train_steps": 500 if pursuers else 300,
            "evaluation_episodes": 200,
        }

    @property
    def learning_teams(self) -> tuple[Team, ...]:
        """The one team that learns."""
        return (self.team,)

    @property
    def entries(self) -> int:
        """Genomes in the archive at the end of the run."""
        return 1 + -(-self.epochs // self.archive_every)

    def epochs_in(self, stage: int) -> int:
        """Return the epochs until the next entry of the archive."""
        return min(self.archive_every, self.epochs - stage * self.archive_every)

    def learn(self, run: RunInMemory, stage: int) -> None:
        """Let the team learn until the next entry of the archive."""
        first = stage * self.archive_every
        epochs = range(first, first + self.epochs_in(stage))
        activity = f"{run.name_of(self.team)} against {self.opponent}"
        genome = improve(run, self.team, 1 + stage, 1, epochs, activity)
        run.archive_genome(self.team, genome)

    def finalists(self, run: RunInMemory) -> dict[Team, tuple[Any, int]]:
        """Return the last genome, and all opponents."""
        last = run.population(self.team, run.archive[self.team][-1][np.newaxis])
        rivals = run.opponents(self.team)
        return {self.team: (last, self.n_stages), other(self.team): (rivals, 0)}

    def summary(self, run: Run, payoff: Payoff) -> dict[str, Any]:
        """Return the mean score and, of pursuit, length with intervals over the episodes.

        An interval is Student's t, cut at 0 and at the largest possible number; its ends are None
        if the episodes do not differ.
        """
        score, *_ = run.game.columns
        rows = [(score, payoff.scores, 1.0)]
        if "lengths" in payoff.extras:
            rows.append(("length", payoff.extras["lengths"], run.settings.world.max_steps))
        found: dict[str, Any] = {}
        for name, episodes, most in rows:
            values = np.asarray(episodes, dtype=np.float64).ravel()
            # Equal episodes say nothing of their spread: the interval would have a width of 0.
            same = intervals.does_not_vary(values)
            ends = (None, None) if same else intervals.t_ends(values, intervals.LEVEL, (0.0, most))
            found |= {
                name: float(values.mean()),
                f"{name}_low": ends[0],
                f"{name}_high": ends[1],
                f"{name}_std": float(values.std()),
            }
        return found


SCHEDULES: dict[str, InTurns] = {
    name: InTurns(**kinds) for name, kinds in InTurns.shorthands.items() if name != PSRO
}
"""The paper's schedules by name."""
ALL_SCHEDULES = (*[*SCHEDULES][:-1], AtOnce.kind, [*SCHEDULES][-1], PSRO, InTurns.kind)
"""Names of the schedules of races, in the order in which a job plays them: from the newest
opponents only to those of all generations."""


def curve_window(schedule: Race) -> int:
    """Return the epochs of the moving average of a training curve, the same for both teams."""
    if isinstance(schedule, OfGenerations):
        return max(1, min(map(schedule.epochs_in, range(schedule.stages_per_generation))) // 4)
    return max(1, schedule.total_epochs("pursuer") // 100)
