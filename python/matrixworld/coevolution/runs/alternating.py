"""An alternating race: the teams learn in turns, against archived opponents of the other team.

The opponents are those of one of the paper's three schedules, or what opponent samplers choose. A
sampler with an archive compares candidates in matches of their own (`Race.admit`).
"""

from __future__ import annotations

import warnings
from typing import Any, ClassVar, cast

import numpy as np

from matrixworld.analysis import disengagements
from matrixworld.analysis.engagement import PATIENCE, Disengagement
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.opponents import OpponentSampler
from matrixworld.coevolution.opponents.archives import PayoffFunction
from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.runs.run import Run, TeamPhase
from matrixworld.coevolution.schedules import (
    Alternating,
    RaceSchedule,
    Schedule,
    archive_of,
    available,
)
from matrixworld.coevolution.seeding import Phase, training_seeds
from matrixworld.coevolution.types import (
    TEAMS,
    FloatArray,
    Genomes,
    Members,
    State,
    Stateful,
    Team,
    other,
)
from matrixworld.play.rollout import Matches
from matrixworld.world.policy import Population

EVEN = 0.5
"""Capture rate at which neither team wins."""
DECIMALS = 6
"""Capture rates are float32: differences beyond this decimal are rounding errors."""


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

    Parameters
    ----------
    settings : RaceSettings
        Settings of the race.
    directory, threads, play
        As in `Run`.

    Attributes
    ----------
    samplers : dict of str to OpponentSampler
        Opponent sampler of each team, which chooses among the archived generations of the other.

    Notes
    -----
    A stage is a team phase: one team's epochs of one generation. Learners keep their state from
    generation to generation. For other attributes see `Run`.
    """

    schedule_class: ClassVar[type[Schedule]] = Alternating
    stages_per_generation: ClassVar[int] = 2

    @property
    def schedule(self) -> RaceSchedule:
        """Which opponents the teams meet, and for how long."""
        return cast(RaceSchedule, self.settings.schedule)  # `check_settings` refuses others

    def set_up(self) -> None:
        """Make the opponent samplers of both teams."""
        self.samplers: dict[Team, OpponentSampler] = {
            team: self.schedule.new_sampler(team) for team in TEAMS
        }

    def stateful_parts(self) -> dict[str, Stateful]:
        """Return learners and opponent samplers."""
        samplers = {f"{team}.sampler": sampler for team, sampler in self.samplers.items()}
        return {**super().stateful_parts(), **samplers}

    @property
    def n_stages(self) -> int:
        """The number of team phases in the run."""
        return self.stages_per_generation * self.schedule.generations

    def learn(self, stage: int) -> None:
        """Let one team learn for the epochs of a generation, and archive its genome."""
        # Pursuers in even stages, evaders in odd ones; generation 0 is untrained.
        generation, team = 1 + stage // 2, TEAMS[stage % 2]
        n_opponents = available(team, generation)
        n_before = available(team, generation - 1) if generation > 1 else 0
        self.admit(team, range(generation - 1, generation), range(n_before, n_opponents))
        before = self.learners[team].state()
        team_phase = TeamPhase(
            self.training,
            self.learners[team],
            team,
            generation,
            opponents=self.training.population(self.genomes(other(team))),
            sampler=self.samplers[team],
            on_epoch=lambda: self.report(f"generation {generation}: {team}s"),
        )
        team_phase.run(range(self.schedule.epochs(team)))
        self.retain(team, generation, before)
        self.archive[team].append(self.learners[team].genome)

    def retain(self, team: Team, generation: int, before: State) -> None:
        """Undo what a team has learned in a generation if it got worse against all opponents.

        Only with the setting `retention_episodes`; `before` is the state of the learner before the
        generation. The random numbers of the next generation are others, so that a discarded
        generation is not learned again.
        """
        episodes, learner = self.schedule.retention_episodes, self.learners[team]
        if not episodes:
            return
        opponents = self.training.population(self.genomes(other(team)))
        previous = self.archive[team][-1]
        if not self.training.keeps(team, generation, learner.genome, previous, opponents, episodes):
            learner.restore(before)

    def training_matches(self) -> int:
        """Return the number of training episodes; with archives, an upper bound of it."""
        return sum(
            self.schedule.epochs(team) * self._matches_per_epoch(team, k)
            + self.selection_matches(self._opponents(k, team), available(team, k))
            + self.max_admission_matches(team, k, available(team, k))
            for k in range(1, self.schedule.generations + 1)
            for team in TEAMS
        )

    def _matches_per_epoch(self, team: Team, k: int) -> int:
        """Return the episodes of one epoch in which `team` learns its generation `k`."""
        matches = self.settings.learner.population * self.settings.match_episodes
        return self._opponents(k, team) * matches

    def _opponents(self, k: int, team: Team) -> int:
        """Return the opponents of each candidate in an epoch of generation `k`."""
        return min(self.schedule.sampled_opponents, available(team, k))

    def selection_matches(self, met: int, archived: int) -> int:
        """Return the episodes at the end of a generation that choose a team's genome.

        In an epoch an individual meets `met` opponents; `archived` ones are there.
        """
        # Retention compares two genomes.
        retention = 2 * archived * self.schedule.retention_episodes
        champion = self.settings.learner.elite_matches * met
        return (champion + retention) * self.settings.match_episodes

    def total_matches(self) -> int:
        """Return the episodes of the training and of the payoff matrix."""
        cells = (self.schedule.generations + 1) ** 2
        return self.training_matches() + cells * self.settings.evaluation_episodes

    def evaluate(self) -> Payoff:
        """Play every archived generation of one team against every one of the other team."""
        settings, training = self.settings, self.training
        return tournament(
            settings.world,
            training.population(self.genomes("pursuer")),
            training.population(self.genomes("evader")),
            seed=settings.seed,
            episodes=settings.evaluation_episodes,
            threads=training.threads,
            play=training.rollout,
            on_row=lambda played: self.report("tournament", played),
        )

    def warn(self) -> None:
        """Warn once of each disengagement, at the generation in which it is long enough."""
        if self.stage % self.stages_per_generation == 0:
            generation = self.stage // self.stages_per_generation
            for stretch in self.disengagements():
                # Equal, not at least: a longer stretch has been reported before.
                if stretch.last == generation and len(stretch) == PATIENCE:
                    warnings.warn(str(stretch), DisengagementWarning, stacklevel=4)

    def disengagements(self) -> tuple[Disengagement, ...]:
        """Return the stretches of finished generations in which one team won everything."""
        return disengagements(self.phase_rates())

    def phase_rates(self) -> FloatArray:
        """Return the capture rates (K, 2) of both team phases of the K finished generations."""
        stages = self.stages_per_generation
        finished = len(self.stage_capture_rates) // stages
        rates = np.array(self.stage_capture_rates[: finished * stages]).reshape(finished, stages)
        # If a stage is a generation (as in `HallOfFameRace`), both phases have its rate.
        return np.broadcast_to(rates, (finished, 2))

    def summary(self, payoff: Payoff) -> dict[str, Any]:
        """Return counts, and stretches of disengagement; commands judge the payoffs when asked."""
        stretches = [str(stretch) for stretch in self.disengagements()]
        return {**super().summary(payoff), "disengagement": stretches}

    # Matches in which samplers with an archive compare candidates:

    def admit(self, team: Team, new: range, opponents: range) -> None:
        """Add the generations of both teams since the last call to a sampler's archive, if any."""
        sampler = archive_of(self.samplers[team])
        if sampler is not None:
            payoff = self._payoff_function(team, graded=sampler.archive.graded)
            sampler.update(np.array(new), np.array(opponents), payoff)

    def max_admission_matches(self, team: Team, new: int, opponents: int) -> int:
        """Return an upper bound of the episodes of `admit`, for the generations so far."""
        sampler = archive_of(self.samplers[team])
        if sampler is None:
            return 0
        pairs = sampler.max_pairs(new, opponents)
        return pairs * self._archive_episodes(team) * self.settings.match_episodes

    def _archive_episodes(self, team: Team) -> int:
        """Return the matches of each pair that a team's archive compares."""
        return self.schedule.opponents_of(team).archive_episodes

    def _payoff_function(self, team: Team, *, graded: bool) -> PayoffFunction:
        """Return a function that plays generations (n,) against opponents (m,).

        Its payoffs (n, m) are rates if `graded`, otherwise 1 for a win, 0.5 for a draw and 0.
        """

        def payoff(candidates: Members, tests: Members) -> FloatArray:
            generations = {team: candidates, other(team): tests}
            captured = self._capture_rates(
                generations["pursuer"], generations["evader"], self._archive_episodes(team)
            )
            # Archives are the same for both teams: rows are candidates, and higher is better.
            rates = captured if team == "pursuer" else 1.0 - captured.T
            return rates if graded else (1.0 + np.sign(np.round(rates - EVEN, DECIMALS))) / 2.0

        return payoff

    def _capture_rates(self, pursuers: Members, evaders: Members, episodes: int) -> FloatArray:
        """Return mean capture rates (n, m); the seeds of a pair depend on that pair only."""
        seed = self.settings.seed
        seeds = [
            training_seeds(seed, int(g), int(h), Phase.ARCHIVE, 0, episodes)
            for g in pursuers
            for h in evaders
        ]
        # Matches in the order of the seeds: all episodes of a pair, then the next pair.
        n, m = len(pursuers), len(evaders)
        g, h = np.repeat(np.arange(n), m * episodes), np.tile(np.arange(m).repeat(episodes), n)
        scores = self.training.play(
            self._members("pursuer", pursuers),
            self._members("evader", evaders),
            Matches.of(g, h, np.concatenate(seeds)),
        )
        rates = scores.capture_rate.mean(axis=1, dtype=np.float64)
        return np.asarray(rates.reshape(n, m, episodes).mean(axis=2))

    def _members(self, team: Team, generations: Members) -> Population:
        genomes: Genomes = np.stack([self.archive[team][int(g)] for g in generations])
        return self.training.population(genomes)
