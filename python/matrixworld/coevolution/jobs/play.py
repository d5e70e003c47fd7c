"""Jobs are played: runs side by side, here or by any executor.

All runs of a job are made before any of them begins, so that a job that is stopped, even at once,
is the directories of its runs: what is missing is what is not finished. Runs go on from their last
stage, whether they were stopped, crashed, or lost their worker. Their progress is what they have
saved.
"""

from __future__ import annotations

import multiprocessing
from collections.abc import Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from pathlib import Path
from typing import Any

from matrixworld._util import checks, imports
from matrixworld._util.callers import warn_caller
from matrixworld._util.processes import processes, without_interrupts
from matrixworld.coevolution.jobs.job import (
    ITSELF,
    Job,
    check_job,
    create_job,
    default_directory,
    described,
    job_of,
    shares,
)
from matrixworld.coevolution.jobs.watch import Watch
from matrixworld.coevolution.progress import LOG, SECONDS, OnEpoch, Progress, Report, silent
from matrixworld.coevolution.runs.play import DisengagementWarning, go_on
from matrixworld.coevolution.runs.stored import StoredRun
from matrixworld.coevolution.saved_run import SavedRun, open_run
from matrixworld.coevolution.settings.race_settings import RaceSettings

DEATHS = 3
"""Processes that die in succession, without a stage that is saved, before it is an error."""


class FailedRunsError(RuntimeError):
    """Some runs of a job have failed (`failures`, by directory); the others are `finished`."""

    def __init__(
        self, failures: Mapping[Path, BaseException], finished: Sequence[SavedRun] = ()
    ) -> None:
        super().__init__(failures, finished)
        self.failures: dict[Path, BaseException] = dict(failures)
        self.finished: list[SavedRun] = list(finished)

    def __str__(self) -> str:
        """Return a line for each failed run."""
        lines = [f"{path}: {described(path, error)}" for path, error in self.failures.items()]
        head = "1 run failed:" if len(lines) == 1 else f"{len(lines)} runs failed:"
        return "\n".join([head, *lines])


def evolve(
    settings: RaceSettings
    | Sequence[RaceSettings]
    | Mapping[str, RaceSettings]
    | str
    | None = None,
    out: str | Path | None = None,
    *,
    seeds: Sequence[int] | None = None,
    executor: Executor | None = None,
    threads: int | None = None,
    report: Report = silent,
    on_epoch: OnEpoch | None = None,
    **named: Any,
) -> Any:
    """Return the finished runs of these settings: start them, continue them, or only open them.

    The runs are in the order of the settings. After Ctrl-C, a crash or a failure, the same call
    continues. Each run directory has the same bytes, whatever the executor, the threads and the
    order.

    In a script, call it below ``if __name__ == "__main__":``, as everything that starts processes.

    Parameters
    ----------
    settings : RaceSettings, or a sequence or mapping of them; or str, optional
        Settings of a run, which is then made in `out` itself; or of each run, by the names of their
        directories in it, such as ``sigma-0.1/seed-3``, without names ``<schedule>/seed-<n>``. By
        default the run has the settings that are `named`; a text is then its variant.
    out : str or Path, optional
        A new or empty directory, or that of the same runs, which are continued. By default one in
        ``runs/`` that is named after variant and seeds.
    seeds : sequence of int, optional
        Seeds, of each of which there is a run of the same settings.
    executor : concurrent.futures.Executor, optional
        Plays the runs, one thread each, wherever the directory has the same path:
        `concurrent.futures`, MPI, loky and Dask (``Client.get_executor(pure=False)``) serve. By
        default the runs have processes of this machine; a single run is played in this one.
    threads : int, optional
        Threads in all, without an executor. By default one per usable core.
    report : callable, optional
        Called often with a `Progress`, such as a `ProgressBar`.
    on_epoch : callable, optional
        Called in this process after each epoch with a dict: the columns of ``log.csv``, ``run``
        (its name in the job, or that of the directory) and ``seed``. The rows of a run that another
        process plays come when their stage has been saved. What it raises, such as `StopRun`, ends
        this call.
    **named
        Settings by the last part of their path, such as ``learner="ga"`` or ``population=32``; see
        `RaceSettings.of`.

    Returns
    -------
    SavedRun or list of SavedRun
        The run of settings without `seeds`, else those of all settings and seeds.

    Raises
    ------
    FileExistsError, TypeError, ValueError
        If settings are bad or need too much memory, two runs have the same name, or the directory
        holds something else, such as other runs. Nothing is written then.
    FailedRunsError, BrokenExecutor
        If runs failed, after all others have ended; or the worker of an executor has died, or
        processes of this machine die again and again.
    """
    if getattr(multiprocessing.current_process(), "_inheriting", False):
        raise RuntimeError(
            'evolve: expected a script that calls it below `if __name__ == "__main__":`, got one '
            "that each process which it starts runs anew"
        )
    job = job_of(_asked(settings, seeds, named))
    root = default_directory(job) if out is None else Path(out)
    if executor is not None:
        checks.check_instance("executor", executor, Executor)
        if threads is not None:
            raise ValueError(f"threads: expected None with an executor, got {threads}")
    check_job(job, root, threads, elsewhere=executor is not None)
    create_job(job, root)
    errors = play_job(
        job, root, executor=executor, threads=threads, report=report, on_epoch=on_epoch
    )
    if ITSELF in errors:
        raise errors[ITSELF]
    runs = [open_run(root / name) for name in job if name not in errors]
    if errors:
        failures = {root / name: error for name, error in errors.items()}
        raise FailedRunsError(failures, runs) from next(iter(errors.values()))
    return runs[0] if ITSELF in job else runs


def _asked(settings: Any, seeds: Sequence[int] | None, named: Mapping[str, Any]) -> Any:
    """Return the settings that `evolve` was asked for, perhaps of several seeds."""
    if isinstance(settings, str):
        named = {"variant": settings, **named}
        settings = None
    if settings is None:
        settings = RaceSettings.of(**named)
    elif named:
        expected = "RaceSettings alone, or a variant and settings by name"
        raise TypeError(f"settings: expected {expected}, got both: {', '.join(named)}")
    if seeds is None:
        return settings
    checks.check_instance("settings", settings, RaceSettings)
    every = checks.check_sequence("seeds", seeds, "integers")
    return [settings.changed({"seed": seed}) for seed in every]


def play_job(
    job: Job,
    root: Path,
    *,
    executor: Executor | None = None,
    threads: int | None = None,
    report: Report = silent,
    on_epoch: OnEpoch | None = None,
) -> dict[str, BaseException]:
    """Play what is unfinished of a job that has been made; return the errors by name."""
    left = [name for name in job if not StoredRun(root / name).finished]
    # No other process can import what is in a notebook.
    in_notebook = any(settings.game.source.startswith("__main__:") for settings in job.values())
    # Another process takes half a second to start, and hides errors.
    here = executor is None and (len(left) <= 1 or in_notebook or not imports.HAS_PROCESSES)
    watch = Watch(job, root, report, None if here else on_epoch)
    # If the job is stopped, its groups have about equally many seeds.
    left = sorted((name for name in job if name not in watch.ended), key=lambda n: job[n].seed)
    if executor is not None:
        _play_by(executor, watch, left, threads=1)
    elif here:
        for name in left:
            _play_here(watch, name, threads, on_epoch)
    else:
        _play_in_processes(watch, left, threads)
    watch.poll()
    return watch.failures


def _play_in_processes(watch: Watch, names: Sequence[str], threads: int | None) -> None:
    """Play runs in processes of this machine; those of a process that dies go on in another one.

    BrokenExecutor if that goes on without a stage that is saved.
    """
    deaths = 0
    while left := [name for name in names if name not in watch.ended]:
        in_threads = any(watch.job[name].game.in_threads for name in left)
        workers, threads_of_each = shares(len(left), threads, in_threads=in_threads)
        saved = [StoredRun(watch.root / name).newest() for name in names]
        try:
            # This process warns when a run has ended, with its name.
            with processes(workers, ignore=DisengagementWarning) as pool:
                _play_by(pool, watch, left, threads_of_each)
        except BrokenExecutor:
            now = [StoredRun(watch.root / name).newest() for name in names]
            deaths = deaths + 1 if now == saved else 1
            if deaths == DEATHS:
                raise
            warn_caller(f"{watch.root}: a process has died; its runs go on from what is saved")


class _CallerError(Exception):
    """`report` or `on_epoch` has raised an `error`, which is no failure of the run."""

    def __init__(self, error: Exception) -> None:
        super().__init__(error)
        self.error = error


def _play_here(watch: Watch, name: str, threads: int | None, on_epoch: OnEpoch | None) -> None:
    """Play a run in this process; what `report` and `on_epoch` raise ends the job."""

    def report(progress: Progress) -> None:
        try:
            watch.report({name: progress})
        except Exception as error:
            raise _CallerError(error) from error

    def pass_on(row: Mapping[str, Any]) -> None:
        if on_epoch is None:
            return
        try:
            on_epoch({**row, "run": watch.name_of(name)})
        except Exception as error:
            raise _CallerError(error) from error

    try:
        go_on(watch.root / name, threads=threads, report=report, on_epoch=pass_on)
        watch.mark_finished(name)
    except _CallerError as error:
        raise error.error from None
    except Exception as error:  # noqa: BLE001, of the run
        watch.mark_failed(name, error)


def _play_by(executor: Executor, watch: Watch, names: Sequence[str], threads: int) -> None:
    """Play runs by an executor, each with so many threads, until all of them have ended."""
    futures: dict[Future[None], str] = {}
    try:
        with without_interrupts():  # which the processes inherit that this starts
            for name in names:
                path = (watch.root / name).absolute()
                futures[executor.submit(go_on, path, threads=threads)] = name
        pending = {*futures}
        while pending:
            done, pending = wait(pending, SECONDS, FIRST_COMPLETED)
            watch.poll()
            for future in done:
                _take_result(watch, futures[future], future)
    except BaseException:
        # After Ctrl-C or an error: what has not begun does not begin.
        for future in futures:
            future.cancel()
        raise


def _take_result(watch: Watch, name: str, future: Future[None]) -> None:
    """Take the result of a run that has ended; BrokenExecutor if its worker has died."""
    try:
        future.result()
        summary = watch.mark_finished(name)
    except BrokenExecutor as error:
        raise BrokenExecutor(
            f"{name}: expected a worker that plays it, got: {error!r}; perhaps memory or the "
            "number of processes has too low a limit, or a script has no `if __name__ == "
            '"__main__":`; finished parts are saved'
        ) from error
    except Exception as error:  # noqa: BLE001, of one run: the others go on
        watch.mark_failed(name, error)
    else:
        LOG.info("%s: ended", watch.root / name)  # its process has told it to nobody
        # The warning of the run itself stayed in its process.
        for text in summary.get("disengagement", []):
            warn_caller(f"{name}: {text}", DisengagementWarning)
