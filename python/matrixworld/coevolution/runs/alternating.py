"""An alternating race: one team learns while the other stands still, turn and turn about."""

from __future__ import annotations

import warnings
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import Disengagement, disengagements, summarize
from matrixworld.analysis.engagement import PATIENCE
from matrixworld.checks import check_choice
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.opponents.registry import ALTERNATING, SCHEDULES, available
from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.runs.matchmaking import Matchmaking
from matrixworld.coevolution.runs.run import Run, Stateful
from matrixworld.coevolution.runs.team_phase import TeamPhase
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.types import TEAMS, Team, other


class DisengagementWarning(UserWarning):
    """One team wins nearly everything, so neither has much to learn from."""


class Race(Run[RaceSettings]):
    """Co-evolution in turns: by one of the paper's three schedules, or by samplers of one's own.

    ::

        p[0], e[0] untrained
        for k in 1 .. generations:
            p[k] = p[k-1], improved for some epochs against evaders that its selection names
            e[k] = e[k-1], improved for some epochs against pursuers that its selection names
        payoff[g, h] = capture rate of p[g] against e[h]

    Learners keep their state from generation to generation. A stage is a team phase: one team's
    epochs of one generation. Parameters and attributes as in `Run`.
    """

    kind: ClassVar[str] = "race"
    settings_class: ClassVar[type[Any]] = RaceSettings
    stages_per_generation: ClassVar[int] = 2

    def check_settings(self) -> None:
        """Raise ValueError unless the teams learn in turns."""
        super().check_settings()
        check_choice("schedule", self.settings.schedule, [*SCHEDULES, ALTERNATING])

    def begin(self) -> None:
        """Give each team the selection of those whom it meets."""
        self.matchmaking = Matchmaking(self.settings, self.training, self.archive)

    def stateful(self) -> dict[str, Stateful]:
        """Return learners and samplers."""
        met = {f"{team}.met": selection for team, selection in self.matchmaking.samplers.items()}
        return {**super().stateful(), **met}

    @property
    def n_stages(self) -> int:
        """The team phases of the run."""
        return self.stages_per_generation * self.settings.generations

    def learning_teams(self) -> tuple[Team, ...]:
        """Return both teams."""
        return TEAMS

    def learn(self, stage: int) -> None:
        """Let one team learn for the epochs of a generation, and archive what it has become."""
        generation, team = 1 + stage // 2, TEAMS[stage % 2]
        rivals = available(team, generation)
        before = available(team, generation - 1) if generation > 1 else 0
        self.matchmaking.admit(team, range(generation - 1, generation), range(before, rivals))
        team_phase = TeamPhase(
            self.training,
            self.learners[team],
            team,
            generation,
            opponents=self.training.population(self.genomes(other(team))),
            selection=self.matchmaking.samplers[team],
            on_epoch=lambda: self.report(f"generation {generation}: {team}s"),
        )
        team_phase.run(range(self.settings.epochs(team)))
        self.archive[team].append(self.learners[team].genome)

    def training_matches(self) -> int:
        """Return the episodes of the training, or the most that there can be with archives."""
        return sum(
            self.settings.epochs(team) * self._candidates_matches(team, k)
            + self.matchmaking.most_admitted(team, k, available(team, k))
            for k in range(1, self.settings.generations + 1)
            for team in TEAMS
        )

    def _candidates_matches(self, team: Team, k: int) -> int:
        """Return the episodes of an epoch."""
        met = min(self.settings.met(team), available(team, k))
        return met * self.settings.population * self.settings.worlds

    def total_matches(self) -> int:
        """Return the episodes of the training and of the payoff matrix."""
        cells = (self.settings.generations + 1) ** 2
        return self.training_matches() + cells * self.settings.eval_episodes

    def evaluate(self) -> Payoff:
        """Play every archived generation against every other, the untrained ones included."""
        settings, training = self.settings, self.training
        return tournament(
            settings.world(settings.eval_steps),
            training.population(self.genomes("pursuer")),
            training.population(self.genomes("evader")),
            seed=settings.seed,
            episodes=settings.eval_episodes,
            threads=training.threads,
            play=training.rollout,
            on_row=lambda played: self.report("tournament", played),
        )

    def after_stage(self) -> None:
        """Warn when a race has been disengaged for just as long as it takes to count."""
        if self.stage % self.stages_per_generation == 0:
            generation = self.stage // self.stages_per_generation
            for stretch in self.disengagements():
                if stretch.last == generation and len(stretch) == PATIENCE:
                    warnings.warn(str(stretch), DisengagementWarning, stacklevel=4)

    def disengagements(self) -> tuple[Disengagement, ...]:
        """Return the stretches of finished generations in which one team won everything."""
        return disengagements(self.phase_rates())

    def phase_rates(self) -> NDArray[np.float64]:
        """Return the capture rates (K, 2) of both team phases of the K finished generations."""
        stages = self.stages_per_generation
        finished = len(self.captures) // stages
        rates = np.array(self.captures[: finished * stages]).reshape(finished, stages)
        return np.broadcast_to(rates, (finished, 2))

    def summary(self, payoff: Payoff) -> dict[str, Any]:
        """Return counts, stretches of disengagement, and the analysis of the payoff matrix."""
        return {
            **super().summary(payoff),
            "disengagement": [str(stretch) for stretch in self.disengagements()],
            "analysis": summarize(payoff.capture_rate).to_dict(),
        }
