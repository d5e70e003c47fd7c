"""A job while it is played: what has ended, and the progress of the rest."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from matrixworld.coevolution.jobs.job import ITSELF, Job
from matrixworld.coevolution.progress import OnEpoch, Progress, Report
from matrixworld.coevolution.runs.play import total_epochs
from matrixworld.coevolution.runs.stored import StoredRun


class Watch:
    """A job while it is played: what has ended, and the progress of the rest.

    `ended` are the names of the runs that are finished or failed, `failures` the errors of the
    latter by name. `report` is called with the progress, `on_epoch`, if there is one, with the
    epochs that the runs have saved.
    """

    def __init__(
        self, job: Job, root: Path, report: Report, on_epoch: OnEpoch | None = None
    ) -> None:
        self.job = job
        self.root = root
        self._on_epoch = on_epoch
        self._report: Callable[[Progress], None] = report
        self.failures: dict[str, BaseException] = {}
        self.ended: set[str] = set()
        # Of each run: the newest stage that was read, and its progress.
        self._stages: dict[str, int] = {}
        self._progress: dict[str, Progress] = {}
        for name in job:
            self._read_before_start(name)

    def _read_before_start(self, name: str) -> None:
        """Read what a run has saved before this start; it may be finished or damaged."""
        try:
            self._read_saved(name)
            # A run that is a job of its own is restored in any case, to tell of any damage.
            if name != ITSELF and StoredRun(self.root / name).finished:
                self.mark_finished(name)
        except (OSError, ValueError) as error:  # such as a damaged file
            self.mark_failed(name, error)

    def name_of(self, name: str) -> str:
        """Return what rows of epochs call a run: its name, or that of the directory."""
        return self.root.absolute().name if name == ITSELF else name

    def mark_failed(self, name: str, error: BaseException) -> None:
        """Count a run as failed."""
        self.failures[name] = error
        self.ended.add(name)

    def mark_finished(self, name: str) -> dict[str, Any]:
        """Count a run as finished, and pass on its last epochs; return its summary."""
        summary = StoredRun(self.root / name).summary()
        self.ended.add(name)
        self._read_saved(name)
        return summary

    def _read_saved(self, name: str) -> None:
        """Read what a run has saved since it was last read, and pass on its epochs."""
        saved = StoredRun(self.root / name)
        settings = self.job[name]
        stage = saved.newest()
        stages = settings.schedule.n_stages
        total = total_epochs(settings)
        done = total if saved.finished else settings.schedule.epochs_until(stage)
        before = self._progress[name].before if name in self._progress else done
        what = f"stage {stage} of {stages}" if stage < stages else "tournament"
        self._progress[name] = Progress(what, done, total, before)
        if self._on_epoch is not None:
            for row in saved.rows(self._stages.get(name, stage)):
                stage = row["stage"]  # it may have saved one more meanwhile
                self._on_epoch({"run": self.name_of(name), "seed": settings.seed, **row})
        self._stages[name] = stage

    def poll(self) -> None:
        """Read what the runs that go on have saved since the last time; report the progress."""
        for name in self.job:
            if name in self.ended:
                continue
            if StoredRun(self.root / name).newest() > self._stages[name]:
                self._read_saved(name)
        self.report({})

    def report(self, progress: Mapping[str, Progress]) -> None:
        """Report the progress of all runs together, after that of some has changed."""
        self._progress |= progress
        parts = [part for name, part in self._progress.items() if name not in self.failures]
        what = f"{len(self.ended) - len(self.failures)} of {len(self.job)} runs"
        if self.failures:
            what += f", {len(self.failures)} failed"
        if len(self.job) == 1 and parts:
            what = parts[0].what
        self._report(
            Progress(
                what,
                done=sum(part.done for part in parts),
                total=max(sum(part.total for part in parts), 1),
                before=sum(part.before for part in parts),
            )
        )
