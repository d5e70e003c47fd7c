"""A run that goes on in its directory: a `Training` that is saved at the end of each stage.

Everything that a stage changes (states of learners and samplers, archive, counters, log) is saved
at its end. A run that is stopped within a stage, even by a power cut, repeats that stage when it
goes on, and ends bit for bit as if it had never been stopped.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from matrixworld._util import checks
from matrixworld._util.callers import warn_caller
from matrixworld._util.plugins import no_exit
from matrixworld.analysis.progress import PATIENCE
from matrixworld.coevolution.games.own_game import OwnGame
from matrixworld.coevolution.games.workers import end_workers
from matrixworld.coevolution.progress import LOG, OnEpoch, Progress, Report, silent
from matrixworld.coevolution.runs.results import disengagements_of, evaluate, summary_of
from matrixworld.coevolution.runs.stored import StoredRun
from matrixworld.coevolution.runs.stored_files import PAYOFF
from matrixworld.coevolution.runs.writer import RunWriter
from matrixworld.coevolution.settings.race_settings import RaceSettings
from matrixworld.coevolution.settings.schedules import OfGenerations
from matrixworld.coevolution.training.loops import run_stage
from matrixworld.coevolution.training.training import Training
from matrixworld.coevolution.types import Row, Team


class DisengagementWarning(UserWarning):
    """One team wins nearly everything, so that neither team has much to learn from."""


class Run:
    """A run that goes on in its directory, from its last finished stage.

    Parameters
    ----------
    directory : str or Path
        A directory that `create` has made.
    threads : int, optional
        As for `Training`.
    training : callable, optional
        What makes the training, such as a class derived from `Training`, the default.

    Attributes
    ----------
    files : RunWriter
        The files that it writes.
    settings : RaceSettings
        Settings of the run.
    training : Training
        The training, as of the last finished stage.

    Raises
    ------
    FileNotFoundError, OtherVersionError, DamagedFileError
        If the directory holds no run of this version, or no intact stage with a checkpoint.
    ValueError
        If its game cannot be imported, is another one, or has changed.
    LockedError
        If another process runs it.
    """

    def __init__(
        self,
        directory: str | Path,
        *,
        threads: int | None = None,
        training: Callable[..., Training] = Training,
    ) -> None:
        self.files: RunWriter = RunWriter(directory)
        self.files.check_format()
        check_source(self.files)
        self.settings: RaceSettings = self.files.settings
        self.training = training(
            self.settings,
            threads=threads,
            rivals=self._rivals,
            on_row=self._tell_row,
            on_activity=self._tell_activity,
            on_stage=self._end_stage,
        )
        self._stage_scores: list[float] = []
        self._report: Report = silent
        self._on_epoch: OnEpoch | None = None
        self._total = total_epochs(self.settings)
        self._before = 0  # epochs that were played before this start
        with self.files.lock():
            self._restore()

    def run(self, report: Report = silent, on_epoch: OnEpoch | None = None) -> StoredRun:
        """Go on to the end; `report` and `on_epoch` are called as by `evolve`.

        After any error the files hold the last finished stage, from which the run goes on.

        Raises
        ------
        DamagedFileError, LockedError
            As for `Run`, or if the results of a finished run are damaged.
        PluginError, ValueError
            If code of your own fails, or returns what it may not; errors of its own, and those of
            `report` and `on_epoch`, are not caught.
        """
        self._report = report
        self._on_epoch = on_epoch
        schedule = self.settings.schedule
        path = self.files.path
        try:
            with self.files.lock():
                # Since this object was made, another process may have continued the run, or an
                # interrupted stage of its own may have changed states.
                self._restore()
                self._before = schedule.epochs_until(self.training.stage)
                LOG.info(
                    "%s: goes on from stage %d of %d", path, self.training.stage, schedule.n_stages
                )
                while self.training.stage < schedule.n_stages:
                    self._run_stage()
                if self.files.finished:
                    self.files.check_results()
                else:
                    self._save_results()
                    LOG.info("%s: ended", path)
        finally:
            end_workers(self.settings.evaluation_game)
        return StoredRun(path)

    def _run_stage(self) -> None:
        """Run the next stage; errors tell which one."""
        where = f"stage {self.training.stage + 1} of the run {self.files.path}"
        try:
            with no_exit(where):
                run_stage(self.training)
        except Exception as error:
            if sys.version_info >= (3, 11):
                error.add_note(f"in {where}")
            raise

    def _save_results(self) -> None:
        """Play the evaluation, as far as it is not known from a shorter race, and save it."""
        known = self.files.payoff() if (self.files.path / PAYOFF).exists() else None
        with no_exit(f"evaluation of the run {self.files.path}"):
            payoff = evaluate(self.training, known, lambda now: self._tell(now.what, now.done))
        self.files.save_results(
            payoff.arrays(), summary_of(self.training, self._stage_scores, payoff)
        )

    def _restore(self) -> None:
        """Take up the last finished stage from the files."""
        stages, archive, checkpoint = self.files.restore()
        counts = {name: int(stages[-1][name]) for name in self.training.counts}
        # Stage 0 is before training.
        self.training.restore(len(stages) - 1, archive, counts, checkpoint)
        self._stage_scores = [float(stage["score"]) for stage in stages[1:]]

    # What a training asks for, and tells:

    def _rivals(self, team: Team) -> Any:
        """Return what plays for a team that does not learn: its archive, or its script."""
        return self.files.player(self.settings.evaluation_game, team, self.training.genomes(team))

    def _tell_row(self, row: Row) -> None:
        if self._on_epoch is not None:
            name = self.files.path.absolute().name
            self._on_epoch({"run": name, "seed": self.settings.seed, **row})

    def _tell_activity(self, activity: str) -> None:
        self._tell(activity)

    def _tell(self, activity: str, evaluated: int = 0) -> None:
        """Report the progress: the current activity, and evaluation episodes played so far."""
        training = self.training
        done = self.settings.schedule.epochs_until(training.stage)
        done += len({row["epoch"] for row in training.rows})
        if evaluated:
            done += self.settings.in_epochs(evaluated)
        # A team alone may be evaluated against several opponents.
        self._report(Progress(activity, min(done, self._total), self._total, self._before))

    def _end_stage(self) -> None:
        """Save a finished stage; warn of a disengagement."""
        self._save_stage()
        generation, left = divmod(self.training.stage, self.settings.schedule.stages_per_generation)
        if left == 0:
            self._warn_of_disengagement(generation)

    def _save_stage(self) -> None:
        training = self.training
        # In the second half of the epochs the team has mostly adapted to its opponents.
        score, *_ = training.game.columns
        rates = [row[score] for row in training.rows[len(training.rows) // 2 :]]
        self._stage_scores.append(float(np.mean(rates)))
        counters = {**training.counts, "score": self._stage_scores[-1]}
        self.files.save(training.stage, training.archive, training.rows, counters, training.parts())
        n_stages = self.settings.schedule.n_stages
        LOG.info("%s: saved stage %d of %d", self.files.path, training.stage, n_stages)
        training.rows = []

    def _warn_of_disengagement(self, generation: int) -> None:
        """Warn of a disengagement, once, after the generation in which it becomes one."""
        for stretch in disengagements_of(self.training, self._stage_scores):
            # Equal, not at least: a longer stretch has been reported before.
            if stretch.last == generation and len(stretch) == PATIENCE:
                warn_caller(stretch.in_words(self.settings.teams), DisengagementWarning)


def check_source(run: StoredRun) -> None:
    """Raise ValueError if a game of your own has changed since a run began."""
    game = run.settings.game
    if isinstance(game, OwnGame) and (changed := game.changed()):
        raise ValueError(f"{run.path}: {changed}")


def accept_source(directory: str | Path) -> None:
    """Let a run go on with the game as it is now, whose source has changed."""
    files = RunWriter(directory)
    with files.lock():
        game = files.settings.game
        if isinstance(game, OwnGame) and game.changed():
            files.change(files.settings.changed({"game.digest": ""}))


def lengthen(directory: str | Path, generations: int) -> None:
    """Let a race have more generations; it then goes on as if it had had them from the beginning.

    ValueError if that cannot be; see `SavedRun.extend`.
    """
    files = RunWriter(directory)
    with files.lock():
        files.check_format()
        check_source(files)
        check_longer(files, generations)
        files.change(files.settings.changed({"schedule.generations": generations}))


def check_longer(run: StoredRun, generations: int) -> None:
    """Raise ValueError unless a race can have so many generations; its game is not imported."""
    settings = run.settings
    schedule = settings.schedule
    path = run.path
    if not isinstance(schedule, OfGenerations):
        raise ValueError(f"{path}: expected a race, got a run of one team")
    if checks.check_integer("generations", generations, 1) < schedule.generations:
        expected = f"at least the {schedule.generations} of {path}"
        raise ValueError(f"generations: expected {expected}, got {generations}")
    for team in settings.learning_teams:
        if getattr(settings.learner_of(team), "anneal", False):
            raise ValueError(
                f"{path}: {settings.learner_path(team)}.anneal: expected false in a race that "
                f"becomes longer, got true: its rates depend on the number of all epochs"
            )
    if run.newest() not in run.numbers("checkpoint"):
        raise ValueError(
            f"{path}: expected the checkpoint of its last stage, got none, as in a race that a "
            f"page saved"
        )


def total_epochs(settings: RaceSettings) -> int:
    """Return the epochs of a run, and those that take as long as its evaluation."""
    schedule = settings.schedule
    entries = schedule.entries
    pairs = settings.game.known.pairs_of(entries, entries) if settings.is_race else 1
    evaluation = settings.in_epochs(pairs * settings.evaluation_episodes)
    return schedule.epochs_until(schedule.n_stages) + evaluation


def go_on(
    directory: str | Path,
    *,
    threads: int | None = None,
    report: Report = silent,
    on_epoch: OnEpoch | None = None,
) -> None:
    """Play what is left of the run in a directory; see `finish`. Errors are those of `Run`."""
    files = RunWriter(directory)
    # A page saves finished races without checkpoints, from which nothing can go on.
    if files.exists and files.finished and not files.numbers("checkpoint"):
        files.payoff()
        return
    Run(directory, threads=threads).run(report, on_epoch)
