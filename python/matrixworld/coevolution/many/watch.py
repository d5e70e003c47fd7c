"""Play the runs of a job by an executor: hand out tasks, watch the files, stop, collect."""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from dataclasses import dataclass, field
from pathlib import Path

from matrixworld.coevolution.many.job import ITSELF, Job, Settings, group_of, settings_to_text
from matrixworld.coevolution.many.run_progress import RunProgress, read_progress, remove_progress
from matrixworld.coevolution.many.run_task import Values, counts_of, run_task, waiting
from matrixworld.coevolution.many.stop_mark import StopMark
from matrixworld.coevolution.runs.alternating import DisengagementWarning
from matrixworld.coevolution.runs.start import finish

SECONDS = 0.5
"""Seconds between two reports."""
STOP_WAIT = 3.0
"""Seconds for which stopped tasks are waited for."""


@dataclass(frozen=True)
class JobProgress:
    """Progress of a job.

    Parameters
    ----------
    running : mapping of str to RunProgress
        The runs in work, by name, as far as they have told it.
    finished, failed, asked : int
        Numbers of runs.
    done, total : int
        Episodes that all runs have played, and all of them. As long as runs have not begun, `total`
        is an estimate from the others.
    before : int
        Episodes of `done` that were played before this start: they do not count for the rate.
    """

    running: Mapping[str, RunProgress]
    finished: int
    failed: int
    asked: int
    done: int
    total: int
    before: int

    @property
    def counts(self) -> str:
        """How many runs have ended, in words."""
        failed = f", {self.failed} failed" if self.failed else ""
        return f"{self.finished} of {self.asked} runs{failed}"


JobReport = Callable[[JobProgress], None]


def silent(progress: JobProgress) -> None:
    """Report nothing."""


@dataclass
class Watch:
    """The state of a job that is being played.

    Parameters
    ----------
    job : Job
        The runs.
    directory : Path
        Directory of the job.
    finished : dict of str to dict
        What the tasks of finished runs returned; of runs that were finished before, their counts.
    failures : dict of str to Exception
        Errors of the runs that failed.
    """

    job: Job
    directory: Path
    finished: dict[str, Values]
    failures: dict[str, BaseException] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._earlier = set(self.finished)
        self._before: dict[str, int] = {}
        self._totals: dict[str, int] = {}

    def play(
        self,
        executor: Executor,
        *,
        threads: int,
        lock_wait: float,
        report: JobReport = silent,
    ) -> None:
        """Play all runs that are neither finished nor failed.

        Parameters
        ----------
        executor : Executor
            Plays them.
        threads : int
            Threads of each.
        lock_wait : float
            Seconds for which a task waits for a locked run directory.
        report : callable, optional
            Called twice a second with a `JobProgress`.
        """
        remove_progress(self.directory)
        mark = StopMark.start(self.directory)
        futures: dict[Future[Values], str] = {}
        try:
            for name, settings in self.unfinished():
                text, root = settings_to_text(settings), str(self.directory.absolute())
                task = executor.submit(run_task, text, root, name, mark.token, threads, lock_wait)
                futures[task] = name
            self._collect(futures, report)
        finally:
            # After Ctrl-C, or an error of this process; in the end there is nothing to stop.
            mark.stop()
            _end(futures)
            remove_progress(self.directory)

    def play_here(
        self, *, threads: int | None, lock_wait: float, report: JobReport = silent
    ) -> None:
        """Play the only run that is neither finished nor failed, in this process; see `play`."""
        [(name, settings)] = self.unfinished()
        path = self.directory / name
        remove_progress(self.directory)
        # Tasks that an earlier start left behind end from now on.
        mark = None if name == ITSELF else StopMark.start(self.directory)
        look = _Report(lambda now: report(self.progress({name: now})))
        try:
            run = waiting(
                lambda: finish(settings, path, threads=threads, report=look),
                path, mark, 0.0 if mark is None else lock_wait,
            )  # fmt: skip
            self.finished[name] = {"name": name, **counts_of(run.files)}
        except Exception as error:  # noqa: BLE001, of the run
            self.failures[name] = error
        finally:
            if mark is not None:
                mark.stop()
        report(self.progress({}))

    def unfinished(self) -> list[tuple[str, Settings]]:
        """Return the runs to play: the first one of each group, then the second ones, ..."""
        runs = self.job.runs.items()
        counts: dict[str, int] = {}
        order = {}
        for name in self.job.runs:
            group = group_of(name)
            order[name] = counts[group] = counts.get(group, 0) + 1
        left = [run for run in runs if run[0] not in self.finished and run[0] not in self.failures]
        # If the job is stopped, the groups have about equally many seeds.
        return sorted(left, key=lambda run: order[run[0]])

    def _collect(self, futures: Mapping[Future[Values], str], report: JobReport) -> None:
        pending = set(futures)
        while pending:
            report(self.progress(read_progress(self.directory)))
            done, pending = wait(pending, timeout=SECONDS, return_when=FIRST_COMPLETED)
            for future in done:
                self._take(futures[future], future)
        report(self.progress({}))

    def _take(self, name: str, future: Future[Values]) -> None:
        try:
            self.finished[name] = future.result()
            if self.finished[name]["disengagement"]:
                text = f"{name}: {self.finished[name]['disengagement']}"
                warnings.warn(text, DisengagementWarning, stacklevel=6)
        except BrokenExecutor:  # of the whole job: no task can be done any more
            raise
        except Exception as error:  # noqa: BLE001, of one run: the others go on
            self.failures[name] = error

    def progress(self, told: Mapping[str, RunProgress]) -> JobProgress:
        """Return the progress of the job, from what its runs in work have told."""
        running = {
            name: each
            for name, each in told.items()
            if name in self.job.runs and name not in self.finished and name not in self.failures
        }
        for name, each in running.items():
            self._before.setdefault(name, each.before)
            self._totals[name] = each.total
        for name, values in self.finished.items():
            self._totals[name] = matches_of(values)
            if name in self._earlier:
                self._before[name] = self._totals[name]
        done = {name: self._totals[name] for name in self.finished}
        done |= {name: each.done for name, each in running.items()}
        return JobProgress(
            running=running,
            finished=len(self.finished),
            failed=len(self.failures),
            asked=len(self.job.runs),
            done=sum(done.values()),
            total=max(sum(self._estimates()), 1),
            before=sum(self._before.values()),
        )

    def _estimates(self) -> Iterable[int]:
        """Return the episodes of each run: known, or as of the last known run of its group."""
        by_group = {group_of(name): total for name, total in self._totals.items()}
        mean = sum(by_group.values()) // max(len(by_group), 1)
        for name in self.job.runs:
            yield self._totals.get(name, by_group.get(group_of(name), mean))


def matches_of(values: Values) -> int:
    """Return the episodes of a finished run."""
    return int(values["training_matches"]) + int(values["evaluation_matches"])


class _Report:
    """The report of a run that is played in this process."""

    def __init__(self, tell: Callable[[RunProgress], None]) -> None:
        self._tell, self._next = tell, 0.0
        self._before: int | None = None

    def __call__(self, what: str, done: int, total: int) -> None:
        """Tell the progress, unless it has been told less than half a second ago."""
        self._before = done if self._before is None else self._before
        if time.monotonic() >= self._next:
            self._next = time.monotonic() + SECONDS
            self._tell(RunProgress(what, done, total, self._before))


def _end(futures: Iterable[Future[Values]]) -> None:
    """Cancel tasks that have not begun, and wait a moment for the others."""
    wait([future for future in futures if not future.cancel()], timeout=STOP_WAIT)
