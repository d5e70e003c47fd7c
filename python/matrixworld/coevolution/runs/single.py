"""One team learns against fixed opponents: scripts, or genomes of another run."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, ClassVar, cast

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.intervals import does_not_vary, t_ends
from matrixworld.coevolution.opponents import RoundRobin
from matrixworld.coevolution.runs.run import Run, TeamPhase
from matrixworld.coevolution.schedules import Against, Schedule
from matrixworld.coevolution.seeding import Purpose, keyed_generator
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import (
    Restored,
    RunDirectory,
    archive_network,
    last_generation,
    script_of,
)
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

    Parameters
    ----------
    opponents : Population, optional
        Opponents in place of `schedule.opponent`.
    start : array_like of float32, shape (genes,), optional
        Genome to start from, in place of `schedule.start`.

    Attributes
    ----------
    opponents : Population or str
        The opponents, or the name of a script.

    Notes
    -----
    A stage is `archive_every` epochs. The archive holds the learning team's genome at the start
    and after each stage. It also holds the opponents' genomes, if they have any, so that a run
    does not depend on other directories. The payoff is that of the last genome, on episodes that
    were not used in training. For other parameters and attributes see `Run`.
    """

    schedule: Against
    schedule_class: ClassVar[type[Schedule]] = Against

    def __init__(
        self,
        settings: RaceSettings,
        directory: str | Path | RunDirectory,
        *,
        opponents: Population | None = None,
        start: ArrayLike | None = None,
        threads: int | None = None,
        play: Rollout = rollout,
    ) -> None:
        self.settings = settings
        self.check_settings()
        schedule = cast(Against, settings.schedule)  # `check_settings` refuses others
        self.opponents: TeamPolicy = "random"
        self._start: Genome | None = None
        # In an existing run, `_restore` takes them from the archive.
        if not isinstance(directory, RunDirectory):
            self.opponents = _opponents(settings, opponents)
            self._start = _start(settings, start)
            # The settings in config.json must not name opponents that were not used.
            changes = {"opponent": opponents, "start": start}
            given: Any = {name: GIVEN for name, value in changes.items() if value is not None}
            settings = replace(settings, schedule=replace(schedule, **given))
        super().__init__(settings, directory, threads=threads, play=play)

    def first_population(self, team: Team) -> Genomes:
        """Return untrained genomes, or the genome to start from and mutants of it."""
        if self._start is None:
            return super().first_population(team)
        rng = keyed_generator(self.settings.seed, Purpose.INITIAL, TEAMS.index(team))
        return self.settings.learner.population_of(self._start, rng)

    def first_archive(self) -> dict[Team, list[Genome]]:
        """Return the genome to start from, and the opponents if they have genomes."""
        team = self.schedule.team
        opponents = [] if isinstance(self.opponents, str) else list(self.opponents.genomes)
        return {team: [self.learners[team].genome], other(team): opponents}

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
        TeamPhase(self, team, 1 + stage, self.opponents, RoundRobin(), activity).learn(epochs)
        self.archive_genome(team)

    def total_matches(self) -> int:
        """Return the episodes of the training and of the evaluation."""
        settings = self.settings
        opponents = 1 if isinstance(self.opponents, str) else len(self.opponents.genomes)
        # One opponent an epoch.
        champions = self.n_stages * settings.learner.elite_matches
        per_run = self.schedule.epochs * settings.learner.population + champions
        training = per_run * settings.match_episodes
        return training + opponents * settings.evaluation_episodes

    def finalists(self) -> dict[Team, tuple[TeamPolicy, int]]:
        """Return the last genome, and all opponents."""
        team = self.schedule.team
        champion = self.training.population(self.archive[team][-1][np.newaxis])
        return {team: (champion, self.n_stages), other(team): (self.opponents, 0)}

    def summary(self, payoff: Payoff) -> dict[str, Any]:
        """Return counts, and the mean capture rate and length with intervals over the episodes."""
        return {
            **super().summary(payoff),
            **_episode_summary("capture_rate", payoff.capture_rates, most=1.0),
            **_episode_summary("length", payoff.lengths, most=self.settings.world.max_steps),
        }

    def _take(self, restored: Restored) -> None:
        super()._take(restored)
        team = other(self.schedule.team)
        if self.archive[team]:
            self.opponents = Population(self.genomes(team), archive_network(self.files, team))
        else:
            self.opponents = script_of(self.schedule.opponent)


def _episode_summary(name: str, episodes: ArrayLike, *, most: float) -> dict[str, float | None]:
    """Return mean, ends of its interval, and standard deviation of a number over the episodes.

    The ends are those of Student's t interval, cut at 0 and at `most`, the largest possible number.
    They are None if the episodes do not differ, or if there is only one.
    """
    values = np.asarray(episodes, dtype=np.float64).ravel()
    # Equal episodes say nothing of their spread: the formula would give an interval of width 0.
    varies = not does_not_vary(values)
    low, high = t_ends(values, CONFIDENCE, (0.0, most)) if varies else (None, None)
    return {
        name: float(values.mean()),
        f"{name}_low": low,
        f"{name}_high": high,
        f"{name}_std": float(values.std()),
    }


def check_sources(settings: RaceSettings) -> None:
    """Raise an error unless opponents and start genome can be read and fit; keep nothing."""
    _opponents(settings, None)
    _start(settings, None)


def _opponents(settings: RaceSettings, given: Population | None) -> TeamPolicy:
    """Return the opponents: those given, a script, or the last generation of a run."""
    schedule = cast(Against, settings.schedule)
    if given is None and schedule.opponent in SCRIPTS:
        return script_of(schedule.opponent)
    population = given or last_generation(schedule.opponent, other(schedule.team))
    check_fits("opponents", population.network, settings.world)
    return population


def _start(settings: RaceSettings, given: ArrayLike | None) -> Genome | None:
    """Return the genome to start from: that given, the last one of a run, or None."""
    schedule, network = cast(Against, settings.schedule), settings.network
    if given is None:
        if schedule.start is None:
            return None
        population = last_generation(schedule.start, schedule.team)
        if population.network != network:
            raise ValueError(f"start: expected a genome of {network}, got {population.network}")
        given = population.genomes[0]
    genome, size = np.asarray(given, dtype=np.float32), network.genome_size
    if genome.shape != (size,) or not np.isfinite(genome).all():
        raise ValueError(f"start: expected {size} finite genes, got shape {genome.shape}")
    return genome
