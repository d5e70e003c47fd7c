"""Many runs at one call: checked together, played side by side, collected."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, replace
from pathlib import Path

from matrixworld.coevolution.many.job import (
    ITSELF,
    JOB,
    Job,
    Settings,
    job_of,
    open_job,
    save_job,
)
from matrixworld.coevolution.many.local_executor import LocalExecutor
from matrixworld.coevolution.many.watch import JobReport, Watch, silent

from matrixworld._util.checks import check_instance, check_number, check_threads
from matrixworld._util.files import DamagedFileError, is_temporary, locked
from matrixworld._util.memory import check_memory
from matrixworld.coevolution.many.run_task import LOCK_WAIT, Values, counts_of
from matrixworld.coevolution.runs.single import check_sources
from matrixworld.coevolution.runs.start import check_own_code
from matrixworld.coevolution.settings.memory import run_memory
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.coevolution.storage.run_directory import (
    CONFIG,
    LOCK,
    OtherVersionError,
    RunDirectory,
)
from matrixworld.coevolution.storage.saved_run import SavedRun, open_run

BAD_FILES = (DamagedFileError, OtherVersionError, OSError, ValueError)
"""Errors of a run directory, which concern one run and no other."""


class FailedRunsError(RuntimeError):
    """Some runs of a job have failed; all others are finished.

    Parameters
    ----------
    failures : mapping of Path to Exception
        The error of each failed run, by its directory.
    finished : list of SavedRun
        The other runs.
    """

    def __init__(
        self, failures: Mapping[Path, BaseException], finished: Sequence[SavedRun] = ()
    ) -> None:
        super().__init__(failures, finished)
        self.failures: dict[Path, BaseException] = dict(failures)
        self.finished: list[SavedRun] = list(finished)

    def __str__(self) -> str:
        """Return a line for each failed run."""
        lines = [f"{path}: {described(path, error)}" for path, error in self.failures.items()]
        return "\n".join([f"{len(lines)} runs failed:", *lines])


def described(path: Path, error: BaseException) -> str:
    """Return an error of a run in words, without the path if the message begins with it."""
    text = f"{error}" or type(error).__name__
    return text.removeprefix(f"{path.absolute()}: ").removeprefix(f"{path}: ")


@dataclass(frozen=True)
class Outcome:
    """How the runs of a job ended.

    Parameters
    ----------
    finished : dict of str to dict
        What each finished run has played, by its name (see `run_task`).
    failures : dict of str to Exception
        The error of each other run.
    """

    finished: dict[str, Values]
    failures: dict[str, BaseException]


def evolve_many(
    settings: Sequence[Settings] | Mapping[str, Settings],
    directory: str | Path,
    *,
    executor: Executor | None = None,
    threads: int | None = None,
    report: JobReport = silent,
    lock_wait: float = LOCK_WAIT,
) -> list[SavedRun]:
    """Return the finished runs of these settings: start them, continue them, or only open them.

    Parameters
    ----------
    settings : sequence, or mapping of str, of RaceSettings or SingleSettings
        Settings of each run. In `directory` a race gets the directory ``<schedule>/seed-<n>`` and a
        run of one team ``<team>-against-<opponent>/seed-<n>``; or give a mapping from names, such
        as ``sigma-0.1/seed-3``.
    directory : str or Path
        A new or empty directory, or that of the same runs, which are continued.
    executor : concurrent.futures.Executor, optional
        Plays the runs, one thread each. By default worker processes of this machine, each with as
        many threads as there are more cores than runs; a single run is played in this process.
    threads : int, optional
        Threads of the default executor in all. By default one per usable core.
    report : callable, optional
        Called twice a second with a `JobProgress`.
    lock_wait : float, optional
        Seconds for which a run directory that another process holds is waited for.

    Returns
    -------
    list of SavedRun
        The runs, in the order of the settings.

    Raises
    ------
    TypeError, ValueError
        If settings are bad, two runs have the same name, an executor and `threads` are given, or
        the directory holds other runs.
    FileExistsError
        If the directory holds something else.
    OutOfMemoryError
        If the runs that play at one time need more memory than this machine has available.
    LockedError
        If another process plays the job.
    FailedRunsError
        If runs failed, after all others have ended.

    Notes
    -----
    Results do not depend on the executor, on threads, on the order of the runs or on
    interruptions: each run directory has the same bytes as by `finish`. Everything is checked
    before anything is written. After Ctrl-C, a crash or a failure, the same call continues.

    An executor carries a function of this package with text and numbers to wherever the directory
    has the same path: `concurrent.futures`, MPI (``mpi4py.futures.MPIPoolExecutor``), loky and
    Dask serve. The default one plays a run again, from its checkpoint, if its process dies.

    In a script, call it below ``if __name__ == "__main__":``, as everything that starts processes.
    """
    root, job = Path(directory), job_of(settings)
    check_number("lock_wait", lock_wait, least=0.0)
    check_directory(root, job)
    check_job(job, root, executor, threads)
    outcome = play_job(
        job, root, executor=executor, threads=threads, report=report, lock_wait=lock_wait
    )
    failures = {root / name: error for name, error in outcome.failures.items()}
    finished = []
    for path in (root / name for name in job.runs if name in outcome.finished):
        try:
            finished.append(open_run(path))
        except BAD_FILES as error:  # noqa: PERF203, of one run: the others are returned
            failures[path] = error
    if failures:
        cause = next(iter(failures.values())) if len(job.runs) == 1 else None
        raise FailedRunsError(failures, finished) from cause
    return finished


def check_job(job: Job, root: Path, executor: Executor | None, threads: int | None) -> None:
    """Raise an error if the unfinished runs of a job cannot be played; nothing is written.

    Parameters
    ----------
    job : Job
        The job.
    root : Path
        Its directory.
    executor, threads
        As for `evolve_many`.
    """
    check_threads(threads)
    if executor is not None:
        check_instance("executor", executor, Executor)
        if threads is not None:
            raise ValueError(f"threads: expected None with an executor, got {threads}")
    left = {n: each for n, each in job.runs.items() if not _finished(root, n)}
    # Runs on other machines check the memory there; here one learner is made, to try it.
    workers, _ = shares(len(left), threads) if executor is None else (1, 1)
    needs = [sum(run_memory(each).values()) for each in left.values()]
    largest = sorted(needs, reverse=True)[:workers]
    check_memory(f"{workers} runs at one time" if workers > 1 else "run", runs=sum(largest))
    # Seeds make no difference here, and a job may have a thousand.
    for each in dict.fromkeys(replace(each, seed=0) for each in left.values()):
        check_own_code(each)
    # A run that has begun has its opponents in its own archive.
    new = [each for name, each in left.items() if not (root / name / CONFIG).exists()]
    for each in dict.fromkeys(replace(each, seed=0) for each in new):
        if isinstance(each, SingleSettings):
            check_sources(each)


def check_directory(root: Path, job: Job) -> None:
    """Raise an error unless a directory is new, empty, or that of the same job."""
    found = open_job(root)
    # A cluster's probe is a temporary file, and may be there.
    if found is None and root.exists() and not all(is_temporary(f.name) for f in root.iterdir()):
        RunDirectory(root).check_empty()
    if found is not None and found.runs != job.runs:
        different = found.runs.items() ^ job.runs.items()
        names = sorted({name for name, _ in different})
        raise ValueError(
            f"{root}: expected the runs in its {JOB}, got others: "
            f"{', '.join(names[:3])}{' ...' if len(names) > 3 else ''}"
        )


def play_job(
    job: Job,
    root: Path,
    *,
    keep: bool = True,
    executor: Executor | None = None,
    threads: int | None = None,
    report: JobReport = silent,
    lock_wait: float = LOCK_WAIT,
) -> Outcome:
    """Play what is unfinished of a job.

    Parameters
    ----------
    job : Job
        The job, checked by `check_job`.
    root : Path
        Its directory.
    keep : bool, optional
        Whether to write the file of the job, if there is none.
    executor, threads, report, lock_wait
        As for `evolve_many`.

    Returns
    -------
    Outcome
        Which runs are finished, and which have failed.

    Raises
    ------
    FileExistsError, ValueError
        If the directory holds something else.
    LockedError
        If another process plays the job.
    KeyboardInterrupt
        After Ctrl-C, when the tasks have ended at a checkpoint.
    """
    root.mkdir(parents=True, exist_ok=True)
    # A run that is a job of its own locks its directory itself.
    with nullcontext() if ITSELF in job.runs else locked(root / LOCK):
        if keep:
            # Again, because another process may have begun a job before this one got the lock.
            check_directory(root, job)
            # Before any run begins: what was asked for is known from now on.
            if open_job(root) is None:
                save_job(root, job)
        watch = Watch(job, root, *_ended(job, root))
        unfinished = len(watch.unfinished())
        if unfinished == 1 and executor is None:
            # A worker process would take half a second to start, and hide where an error came from.
            watch.play_here(threads=threads, lock_wait=lock_wait, report=report)
        elif unfinished:
            with _executor(executor, unfinished, threads) as (player, each):
                watch.play(player, threads=each, lock_wait=lock_wait, report=report)
    return Outcome(watch.finished, watch.failures)


def shares(runs: int, threads: int | None) -> tuple[int, int]:
    """Return how many runs play at one time, and the threads of each."""
    cores = check_threads(threads)
    # A few runs more than cores share them from the beginning: the last one would play alone.
    workers = max(1, runs if runs < 2 * cores else cores)
    return workers, max(1, cores // workers)


@contextmanager
def _executor(
    given: Executor | None, runs: int, threads: int | None
) -> Iterator[tuple[Executor, int]]:
    """Yield an executor and the threads of each run."""
    if given is not None:
        yield given, 1
        return
    workers, each = shares(runs, threads)
    local = LocalExecutor(workers)
    try:
        yield local, each
    finally:
        # Tasks have ended, or did not see the stop mark in time.
        local.kill()
        local.shutdown()


def _ended(job: Job, root: Path) -> tuple[dict[str, Values], dict[str, BaseException]]:
    """Return what finished runs have played, and the errors of those that are not of this job."""
    finished: dict[str, Values] = {}
    failures: dict[str, BaseException] = {}
    for name, settings in job.runs.items():
        if _finished(root, name):
            try:
                finished[name] = {"name": name, **_counts(RunDirectory(root / name), settings)}
            except BAD_FILES as error:
                failures[name] = error
    return finished, failures


def _finished(root: Path, name: str) -> bool:
    """Return whether nothing has to be done for a run."""
    # A run that is a job of its own is restored in any case, to tell of any damage.
    return name != ITSELF and RunDirectory(root / name).finished


def _counts(files: RunDirectory, settings: Settings) -> Values:
    found = files.settings()
    if found != settings:
        raise ValueError(f"{files.path}: expected a run of {settings}, got {found}")
    return counts_of(files)
