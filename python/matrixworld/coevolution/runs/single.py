"""One team learns against fixed opponents: scripts, or genomes of another run."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, ClassVar, cast

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_floats
from matrixworld.analysis.intervals import does_not_vary, t_ends
from matrixworld.coevolution.evaluation.tournament import team_size
from matrixworld.coevolution.runs.run import Run
from matrixworld.coevolution.schedules import Against, Schedule
from matrixworld.coevolution.seeding import Purpose, keyed_generator
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import SavedRun, check_empty, last_generation
from matrixworld.coevolution.types import TEAMS, Genome, Genomes, Payoff, Team, other
from matrixworld.play.network_policy import check_fits
from matrixworld.play.rollout import Rollout, rollout
from matrixworld.world.policy import SCRIPTS, Population, TeamPolicy

GIVEN = "given as genomes"
"""Value of the settings `opponent` and `start` if these were given as arrays."""
CONFIDENCE = 0.95
"""Probability with which an interval of the summary covers the true mean."""


class SingleTeam(Run):
    """A run in which one team learns against fixed opponents, one of them in each epoch.

    A stage is `archive_every` epochs. The archive holds the learning team's genome at the start
    and after each stage. It also holds the opponents' genomes, if they have any, so that a run
    does not depend on other directories. The payoff is that of the last genome, on episodes that
    were not used in training.

    Parameters
    ----------
    opponents : Population, optional
        Opponents in place of `schedule.opponent`, of a new run.
    start : array_like of float32, shape (genes,), optional
        Genome to start from in place of `schedule.start`, of a new run.

    Attributes
    ----------
    opponents : Population or str
        The opponents, or the name of a script. For other attributes and parameters see `Run`.
    """

    schedule: Against
    schedule_class: ClassVar[type[Schedule]] = Against

    def __init__(
        self,
        settings: RaceSettings,
        directory: str | Path,
        *,
        opponents: Population | None = None,
        start: ArrayLike | None = None,
        threads: int | None = None,
        play: Rollout = rollout,
    ) -> None:
        self.check_settings(settings)
        self.opponents: TeamPolicy = "random"
        self._start: Genome | None = None
        # The settings in config.json must not name opponents that were not used.
        changes = {"opponent": opponents, "start": start}
        given: Any = {name: GIVEN for name, value in changes.items() if value is not None}
        if given and Path(directory).exists():
            check_empty(Path(directory))
        # A run that exists has all genomes in its archive.
        if not SavedRun(directory).exists:
            self.opponents, self._start = check_sources(settings, opponents, start)
        settings = replace(settings, schedule=replace(settings.schedule, **given))
        super().__init__(settings, directory, threads=threads, play=play)

    def first_population(self, team: Team) -> Genomes:
        """Return untrained genomes, or the genome to start from and mutants of it."""
        if self._start is None:
            return super().first_population(team)
        rng = keyed_generator(self.settings.seed, Purpose.INITIAL, TEAMS.index(team))
        return self.settings.learner_of(team).population_of(self._start, rng)

    def first_archive(self) -> dict[Team, list[Genome]]:
        """Return the genome to start from, and the opponents if they have genomes."""
        team = self.schedule.team
        opponents = [] if isinstance(self.opponents, str) else list(self.opponents.genomes)
        return {team: [self.learners[team].genome.copy()], other(team): opponents}

    def extra_config(self) -> dict[str, Any]:
        """Return the network of the opponents, which may differ from the learning team's."""
        if isinstance(self.opponents, str):
            return {"opponent_network": None}
        network = self.opponents.network
        shape = {"activation": network.activation, "memory": network.memory}
        return {"opponent_network": {"hidden": list(network.hidden), **shape}}

    def learn(self, stage: int) -> None:
        """Let the team learn until the next entry of the archive."""
        team, schedule = self.schedule.team, self.schedule
        first = stage * schedule.archive_every
        epochs = range(first, min(first + schedule.archive_every, schedule.epochs))
        activity = f"{team}s against {schedule.opponent}"
        self.improve(team, 1 + stage, self.opponents, epochs, activity)
        self.archive_genome(team)

    def evaluated_pairs(self) -> int:
        """Return the number of opponents: one genome is evaluated."""
        return team_size(self.opponents)

    def finalists(self) -> dict[Team, tuple[TeamPolicy, int]]:
        """Return the last genome, and all opponents."""
        team = self.schedule.team
        champion = self.training.population(team, self.archive[team][-1][np.newaxis])
        return {team: (champion, self.n_stages), other(team): (self.opponents, 0)}

    def summary(self, payoff: Payoff) -> dict[str, Any]:
        """Return counts, and the mean capture rate and length with intervals over the episodes.

        An interval is Student's t, cut at 0 and at the largest possible number; its ends are None
        if the episodes do not differ.
        """
        found = super().summary(payoff)
        longest = self.settings.world.max_steps
        rows = ("capture_rate", payoff.capture_rates, 1.0), ("length", payoff.lengths, longest)
        for name, episodes, most in rows:
            values = np.asarray(episodes, dtype=np.float64).ravel()
            # Equal episodes say nothing of their spread: the interval would have a width of 0.
            varies = not does_not_vary(values)
            low, high = t_ends(values, CONFIDENCE, (0.0, most)) if varies else (None, None)
            found |= {
                name: float(values.mean()),
                f"{name}_low": low,
                f"{name}_high": high,
                f"{name}_std": float(values.std()),
            }
        return found

    def _restore(self) -> None:
        super()._restore()
        team = other(self.schedule.team)
        self.opponents = self.files.as_policy(team, self.genomes(team))


def check_sources(
    settings: RaceSettings, opponents: Population | None = None, start: ArrayLike | None = None
) -> tuple[TeamPolicy, Genome | None]:
    """Return the opponents and the genome to start from, those given or those of the settings.

    FileNotFoundError or ValueError if a run holds none, or if they do not fit the settings.
    """
    schedule, network = cast(Against, settings.schedule), settings.network
    policy: TeamPolicy
    if opponents is None and schedule.opponent in SCRIPTS:
        policy = schedule.opponent
    else:
        policy = opponents or last_generation(schedule.opponent, other(schedule.team))
        check_fits("opponents", policy.network, settings.world)
    if start is None and schedule.start is not None:
        population = last_generation(schedule.start, schedule.team)
        if population.network != network:
            raise ValueError(f"start: expected a genome of {network}, got {population.network}")
        start = population.genomes[0]
    if start is None:
        return policy, None
    genome, size = check_floats("start", start, np.float32), network.genome_size
    if genome.shape != (size,) or not np.isfinite(genome).all():
        raise ValueError(f"start: expected {size} finite genes, got shape {genome.shape}")
    return policy, genome
