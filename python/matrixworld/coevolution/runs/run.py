"""A run: stages of learning, each saved at its end, and then an evaluation.

This module tells what all kinds of runs share: how a run is made, continued and saved, and how one
team learns for some epochs (`Run.improve`). What a stage is, each kind of run says itself: a phase
of one team or a generation of both teams (`race`), or some epochs of a team that learns alone
(`single`).

Everything that a stage changes (learners, samplers, archive, counters, log) is saved at its end. A
run that is stopped within a stage, even by a power cut, repeats that stage when it is resumed, and
ends bit for bit as if it had never been stopped.
"""

from __future__ import annotations

import sys
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_threads
from matrixworld.coevolution.evaluation.tournament import team_size, tournament
from matrixworld.coevolution.fitness import win_rates
from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.opponents.samplers import OpponentSampler, Stateless
from matrixworld.coevolution.own_code import PluginError
from matrixworld.coevolution.progress import LOG, OnEpoch, Progress, Report, silent
from matrixworld.coevolution.runs.training_matches import TrainingMatches, training_matches
from matrixworld.coevolution.schedules import Schedule
from matrixworld.coevolution.sections import different_settings
from matrixworld.coevolution.seeding import Purpose, keyed_generator, learning_phase, training_seeds
from matrixworld.coevolution.settings import RaceSettings, check_run_memory
from matrixworld.coevolution.storage import SEVERAL, RunWriter, SavedRun
from matrixworld.coevolution.types import (
    TEAMS,
    FloatArray,
    Genome,
    Genomes,
    Indices,
    Payoff,
    Seeds,
    Stateful,
    Team,
)
from matrixworld.play.rollout import Rollout, rollout
from matrixworld.world.policy import Network, TeamPolicy


class Run(ABC):
    """A run in a directory; see `Race`, `HallOfFameRace`, `MapRace` and `SingleTeam`.

    ::

        learners, archive (generation 0), stage = 0; saved
        while stage < n_stages:
            learn(stage); stage += 1; saved
        payoff = evaluate(); saved

    Parameters
    ----------
    settings : RaceSettings
        Settings of the run.
    directory : str or Path
        A new or empty directory for a new run, or that of the same run, which is continued from its
        last finished stage.
    threads : int, optional
        Threads that `play` may use. By default all cores. Results do not depend on it.
    play : callable, optional
        Plays matches: a pure function with the arguments of `matrixworld.rollout`.

    Attributes
    ----------
    archive : dict of str to list of ndarray of float32, shape (genes,)
        Genomes of generations 0, 1, ... of each team.
    stage : int
        Number of finished stages.
    stage_capture_rates : list of float
        Mean capture rate in the second half of each finished stage.
    samplers : dict of str to OpponentSampler
        Opponent sampler of each learning team, which chooses among the genomes of the other one.
    training : TrainingMatches
        Plays the training matches, and counts matches and steps.

    Raises
    ------
    FileExistsError
        If the directory holds no run, and is not empty.
    ValueError
        If this kind of run cannot have these settings, the directory holds a run of other settings,
        or the run needs more memory than the machine has available
        (`matrixworld.coevolution.settings.run_memory`).
    """

    schedule_class: ClassVar[type[Schedule]]
    stages_per_generation: ClassVar[int] = 1

    def __init__(
        self,
        settings: RaceSettings,
        directory: str | Path,
        *,
        threads: int | None = None,
        play: Rollout = rollout,
    ) -> None:
        # Everything that can be wrong is checked before the directory is made.
        self.check_settings(settings)
        check_threads(threads)
        check_run_memory("run", [settings])
        self.settings: RaceSettings = settings
        self.schedule: Schedule = settings.schedule
        self.files: RunWriter = RunWriter(directory)
        self.training: TrainingMatches = TrainingMatches(settings, play, threads)
        self.network: Network = self.training.network
        self.stage: int = 0
        self.stage_capture_rates: list[float] = []
        self.learners: dict[Team, Learner] = {
            team: settings.new_learner(team, self.first_population(team))
            for team in settings.learning_teams
        }
        self.samplers: dict[Team, OpponentSampler] = {
            team: self.schedule.new_sampler(team) for team in settings.learning_teams
        }
        self.archive: dict[Team, list[Genome]] = self.first_archive()
        self._report: Report = silent
        self._before: int = 0
        self._total: int = 0
        if self.files.exists:
            check_same(self.files, settings)
            with self.files.lock():
                self._restore()
        else:
            with self.files.creating(settings.to_json(), **self.extra_config()):
                self._save()

    def __repr__(self) -> str:
        kind, seed = self.schedule.name, self.settings.seed
        stages = f"stage {self.stage} of {self.n_stages}"
        return f"<{type(self).__name__}: {self.files.path}, {kind}, seed {seed}, {stages}>"

    @property
    def n_stages(self) -> int:
        """The number of stages: of each entry that the run adds to the archive of a team."""
        return self.stages_per_generation * (self.schedule.entries - 1)

    # Each kind of run defines the following methods:

    @abstractmethod
    def learn(self, stage: int) -> None:
        """Run one stage: improve learners, extend the archive, record each epoch."""

    @abstractmethod
    def finalists(self) -> dict[Team, tuple[TeamPolicy, int]]:
        """Return who plays the evaluation for each team, and the generation of the first."""

    # Each kind of run may replace the following methods:

    def first_population(self, team: Team) -> Genomes:
        """Return the genomes from which a learner starts; the first one is generation 0."""
        return self.settings.untrained(team, self.settings.learner_of(team).starting_genomes)

    def first_archive(self) -> dict[Team, list[Genome]]:
        """Return the archive of a new run."""
        # Copies here and below: a learner of the user's own may change its genome in place.
        return {team: [self.learners[team].genome.copy()] for team in TEAMS}

    def evaluated_pairs(self) -> int:
        """Return how many pairs of genomes the evaluation plays: the cells of the payoff matrix."""
        return self.schedule.entries**2

    def extra_config(self) -> dict[str, Any]:
        """Return the entries of config.json besides the settings."""
        return {}

    def begin_epoch(self, team: Team, generation: int, epoch: int) -> None:  # noqa: B027
        """Prepare an epoch in which a team learns."""

    def results_of_stage(self) -> Mapping[str, NDArray[Any]]:
        """Return arrays of the last stage, for its file, besides genomes, log and counters."""
        return {}

    # The following methods are the same for all kinds:

    def total_matches(self) -> int:
        """Return the matches of the run as progress counts them; with archives, an upper bound."""
        evaluated = self.evaluated_pairs() * self.settings.evaluation_episodes
        return self.settings.counted(training_matches(self.settings, self.samplers), evaluated)

    def archive_genome(self, team: Team) -> None:
        """Add the genome of a team's learner to its archive; DivergedError if it is not finite."""
        genome = self.learners[team].genome.copy()
        self.archive[team].extend(self.training.population(team, genome).genomes)

    @classmethod
    def check_settings(cls, settings: RaceSettings) -> None:
        """Raise ValueError if this kind of run cannot have these settings."""
        if not isinstance(settings.schedule, cls.schedule_class):
            expected, got = cls.schedule_class.kind, settings.schedule.kind
            raise ValueError(f"schedule: expected {expected}, got {got}")

    def run(self, report: Report = silent, on_epoch: OnEpoch | None = None) -> Payoff:
        """Continue from the last stage to the end; save and return the payoff.

        `report` is called often with the progress (see `ProgressBar`), and `on_epoch` with a row
        for each epoch (see `finish`). After KeyboardInterrupt or any other error, such as one that
        `on_epoch` raises, the files hold the last finished stage, from which `run` or `resume`
        continues.
        """
        self._report = report
        head = {"run": self.files.path.absolute().name, "seed": self.settings.seed}
        self.training.on_row = on_epoch and (
            lambda row: on_epoch({**head, "stage": self.stage + 1, **row})
        )
        with self.files.lock():
            # Also if this object has just been made: an interrupted stage has changed learners, and
            # another process may have continued the run.
            self._restore()
            LOG.info("%s: goes on from stage %d of %d", self.files.path, self.stage, self.n_stages)
            self._before, self._total = self.training.matches, self.total_matches()
            while self.stage < self.n_stages:
                try:
                    self.learn(self.stage)
                except SystemExit as error:  # it would end the program without a word
                    where = f"stage {self.stage + 1} of the run {self.files.path}"
                    raise PluginError(f"{where}: code of your own called exit") from error
                except Exception as error:
                    if sys.version_info >= (3, 11):
                        error.add_note(f"in stage {self.stage + 1} of the run {self.files.path}")
                    raise
                self.end_stage()
            if not self.files.finished:
                payoff = self.evaluate()
                self.files.save_results(payoff.arrays(), self.summary(payoff))
                LOG.info("%s: ended", self.files.path)
                return payoff
            self.files.summary()  # only to raise an error if it is damaged
            return self.files.payoff()

    def evaluate(self) -> Payoff:
        """Play the finalists of one team against those of the other, on episodes of their own."""
        settings = self.settings
        (pursuers, g), (evaders, h) = (self.finalists()[team] for team in TEAMS)
        return tournament(
            settings.world,
            pursuers,
            evaders,
            seed=settings.seed,
            episodes=settings.evaluation_episodes,
            threads=self.training.threads,
            play=self.training.rollout,
            first=(g, h),
            on_row=lambda played: self.report("tournament", played),
        )

    def genomes(self, team: Team) -> Genomes:
        """Return a team's archive as one array (generations, genes) float32."""
        archive = self.archive[team]
        return np.stack(archive) if archive else np.empty((0, self.network.genome_size), np.float32)

    def report(self, activity: str, evaluated: int = 0) -> None:
        """Report the progress: the current activity, and evaluation episodes played so far."""
        done = self.settings.counted(self.training.matches, evaluated)
        self._report(Progress(activity, done, self._total, self._before))

    def summary(self, payoff: Payoff) -> dict[str, Any]:
        """Return the most important numbers of the run, which summary.json holds."""
        counters = {f"training_{name}": n for name, n in self.training.counters().items()}
        return {"stages": self.stage, **counters, "evaluation_matches": int(payoff.lengths.size)}

    def end_stage(self) -> None:
        """Count and save a finished stage."""
        # In the second half of the epochs the team has mostly adapted to its opponents.
        rows = self.training.rows
        rates = [row["capture_rate"] for row in rows[len(rows) // 2 :]]
        self.stage_capture_rates.append(float(np.mean(rates)))
        self.stage += 1
        self._save()

    def _parts(self) -> dict[str, Stateful]:
        """Return the parts of the run that a checkpoint saves and restores, by name."""
        samplers = {f"{team}.sampler": sampler for team, sampler in self.samplers.items()}
        return {**dict(self.learners.items()), **samplers}

    def _save(self) -> None:
        counters = self.training.counters()
        if self.stage:
            counters["capture_rate"] = self.stage_capture_rates[-1]
        state = {
            f"{part}.{name}": value
            for part, stateful in self._parts().items()
            for name, value in stateful.state().items()
        }
        more = self.results_of_stage()
        self.files.save(self.stage, self.archive, self.training.rows, counters, state, more)
        LOG.info("%s: saved stage %d of %d", self.files.path, self.stage, self.n_stages)
        self.training.rows = []

    def _restore(self) -> None:
        restored = self.files.restore()
        _, *stages = restored.stages  # stage 0 is before training
        self.stage = len(stages)
        self.stage_capture_rates = [float(each["capture_rate"]) for each in stages]
        self.training.restore(restored.stages[-1])
        self.archive = {team: [*genomes] for team, genomes in restored.archive.items()}
        for part, stateful in self._parts().items():
            # "pursuer.sampler.x" belongs to the part "pursuer.sampler", not to "pursuer".
            keys = (key.rpartition(".") for key in restored.state)
            names = [name for prefix, _, name in keys if prefix == part]
            stateful.restore({name: restored.state[f"{part}.{name}"] for name in names})

    # How a team learns while the other one stays as it is:

    def improve(
        self, team: Team, generation: int, opponents: TeamPolicy, epochs: range, activity: str
    ) -> None:
        """Let a team learn for some epochs against `opponents`, among which its sampler chooses.

        The learner is improved in place. After each epoch the `activity` is reported.
        """
        learner, sampler, training = self.learners[team], self.samplers[team], self.training
        choose = partial(self._choose, team, generation, opponents)

        def table(values: FloatArray) -> FloatArray:
            return values.reshape(len(learner.seed_groups), -1)

        choices: Iterable[tuple[Indices, Seeds]] = map(choose, epochs)
        # A sampler without state can choose for all epochs ahead. Between matches, which fill the
        # caches with other data, the same work takes several times as long.
        if isinstance(sampler, Stateless):
            choices = list(choices)
        for epoch, (met, seeds) in zip(epochs, choices, strict=True):
            self.begin_epoch(team, generation, epoch)
            candidates = learner.ask(self.generator(Purpose.LEARN, team, generation, epoch))
            scores = training.play_candidates(team, candidates, opponents, met, seeds)
            # Win rates, not fitness: samplers expect numbers in [0, 1].
            if not isinstance(sampler, Stateless):
                sampler.tell(met, table(win_rates(scores, team)))
            fitness = training.fitness_of_epoch(
                scores,
                table,
                team=team,
                generation=generation,
                epoch=epoch,
                opponent=int(met[0]) if len(met) == 1 else SEVERAL,
            )
            chosen = np.tile(met, len(candidates))
            training.teach(learner, team, opponents, chosen, seeds.ravel())
            self.report(activity)
            learner.tell(fitness)
        training.choose_champion(learner, team, generation, opponents, met)

    def _choose(
        self, team: Team, generation: int, opponents: TeamPolicy, epoch: int
    ) -> tuple[Indices, Seeds]:
        """Return the opponents (c,) of an epoch, and each candidate's seeds (n, c) against them."""
        available = team_size(opponents)
        rng = self.generator(Purpose.OPPONENTS, team, generation, epoch)
        met = self.samplers[team].sample(available, epoch, rng)
        # Candidates of the same match, such as a mirrored pair, differ in nothing but their genes.
        groups = self.learners[team].seed_groups
        seeds = []
        for opponent in map(int, met):
            # They depend on both generations, so that no two phases play the same episodes.
            pair = (generation, opponent) if team == "pursuer" else (opponent, generation)
            count, phase = int(groups.max()) + 1, learning_phase(team)
            seeds.append(training_seeds(self.settings.seed, *pair, phase, epoch, count)[groups])
        return met, np.stack(seeds, axis=1)

    def generator(
        self, purpose: Purpose, team: Team, generation: int, epoch: int
    ) -> np.random.Generator:
        """Return the random numbers of a team in an epoch."""
        return keyed_generator(self.settings.seed, purpose, TEAMS.index(team), generation, epoch)


def check_same(run: SavedRun, expected: RaceSettings) -> None:
    """Raise ValueError if a run has other settings than expected."""
    different = different_settings(run.settings, expected)
    if different:
        raise ValueError(f"{run.path}: holds a run with other settings: {', '.join(different)}")
