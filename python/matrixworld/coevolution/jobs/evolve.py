"""A job: the runs that were asked for together, its file, and how all of them are played.

The file is written before any run begins. A job that is stopped, even at once, therefore knows the
runs that have not begun. Runs are played in this process, side by side, or by any executor.
"""

from __future__ import annotations

import json
import re
import warnings
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import Any

from matrixworld._util import HAS_PROCESSES
from matrixworld._util.checks import check_instance, check_memory, check_threads, shown
from matrixworld._util.files import (
    DamagedFileError,
    is_temporary,
    locked,
    remove_temporary_files,
    save_json,
)
from matrixworld.coevolution.jobs.worker import (
    Played,
    WorkerDiedError,
    WorkerProcesses,
    at_times,
    played,
    read_progress,
    remove_progress,
    run_task,
    started,
    waiting,
)
from matrixworld.coevolution.progress import (
    SECONDS,
    OnEpoch,
    Progress,
    Report,
    StopRun,
    silent,
)
from matrixworld.coevolution.runs.race import DisengagementWarning, race_to_replay
from matrixworld.coevolution.runs.single import check_sources
from matrixworld.coevolution.runs.start import check_own_code, check_same, finish
from matrixworld.coevolution.schedules import Against, Yoked
from matrixworld.coevolution.settings import RaceSettings, run_memory
from matrixworld.coevolution.storage import (
    CONFIG,
    LOCK,
    OtherVersionError,
    RunDirectory,
    SavedRun,
    load_format,
    open_run,
    settings_of_this_version,
)
from matrixworld.version import __version__
from matrixworld.world.policy import SCRIPTS

JOB = "job.json"
FORMAT = 1
"""Version of the file's layout; another one is refused."""
NAME = re.compile(r"\w[\w.=+-]*(/\w[\w.=+-]*)?")
"""Names of runs: relative paths of one or two parts that every system accepts."""

ITSELF = "."
"""Name of the only run of a job whose directory is that of the run, as `finish` makes it."""
STOP_WAIT = 3.0
"""Seconds for which stopped tasks are waited for."""
TRIES = 4
"""Worker processes that a run may lose before it fails."""
BESIDE_OTHERS = 2
"""Losses after which a run is played alone: until then another run may be the cause."""
BAD_FILES = (DamagedFileError, OtherVersionError, OSError, ValueError)
"""Errors of a run directory, which concern one run and no other."""

Job = Mapping[str, RaceSettings]
"""Runs that were asked for together: settings by the path of a run's directory in the job's."""


# Names:


def job_of(settings: RaceSettings | Sequence[RaceSettings] | Mapping[str, RaceSettings]) -> Job:
    """Return the job of these settings, perhaps by name; without names each run gets one.

    Raises TypeError or ValueError if there are no settings, two runs have the same name or the same
    settings, or a name is not the path of a directory.
    """
    if isinstance(settings, RaceSettings):
        settings = [settings]
    given: Iterable[tuple[str, Any]] = (
        settings.items() if isinstance(settings, Mapping) else map(_named, settings)
    )
    runs: dict[str, RaceSettings] = {}
    for name, each in given:
        if not isinstance(each, RaceSettings):
            raise TypeError(f"settings: expected RaceSettings, got {shown(each)}")
        if name in runs:
            raise ValueError(
                f"settings: expected runs of different schedules or seeds, or a name for each, "
                f"got two of {name}"
            )
        runs[name] = _from_anywhere(each)
    _check_names(runs)
    # Equal runs are no independent observations.
    names: dict[RaceSettings, str] = {}
    for name, each in runs.items():
        other = names.setdefault(each, name)
        if other != name:
            raise ValueError(f"settings: expected different runs, got {other} and {name}, equal")
    return runs


def _named(settings: Any) -> tuple[str, Any]:
    # What is no settings is refused by `job_of`.
    folder = settings.schedule.name if isinstance(settings, RaceSettings) else ""
    return f"{folder}/seed-{getattr(settings, 'seed', None)}", settings


def _check_names(runs: Mapping[str, RaceSettings]) -> None:
    if not runs:
        raise ValueError("settings: expected at least one run, got none")
    for name in runs:
        if not isinstance(name, str) or not NAME.fullmatch(name) or name == JOB:
            expected = "names such as sigma-0.1 or sigma-0.1/seed-3"
            raise ValueError(f"settings: expected {expected}, got {shown(name)}")
        # A run inside the directory of another one would be one of its files.
        if "/" in name and name.partition("/")[0] in runs:
            raise ValueError(f"settings: expected runs beside each other, got {name} in a run")


def _from_anywhere(settings: RaceSettings) -> RaceSettings:
    """Return settings whose paths mean the same in another current directory, as workers have."""
    schedule = settings.schedule
    if isinstance(schedule, Yoked):
        race = str(Path(schedule.race).absolute())
        return replace(settings, schedule=replace(schedule, race=race))
    if not isinstance(schedule, Against):
        return settings
    paths = {"opponent": schedule.opponent, "start": schedule.start}
    absolute: dict[str, Any] = {
        name: str(Path(path).absolute())
        for name, path in paths.items()
        if path is not None and path not in SCRIPTS
    }
    return replace(settings, schedule=replace(schedule, **absolute))


def group_of(name: str) -> str:
    """Return the name of the runs that differ from a run in their seed only, such as a schedule."""
    return name.rpartition("/")[0] or name


# The file:


def save_job(directory: Path, job: Job) -> None:
    """Write the file of a job into its directory."""
    # Settings that differ in the seed only are written once: 1,000 seeds take 40 kB, not 3 MB.
    groups: dict[str, dict[str, Any]] = {}
    for name, settings in job.items():
        values = settings.to_json()
        seed = values.pop("seed")
        key = json.dumps(values, sort_keys=True)
        groups.setdefault(key, {"settings": values, "seeds": {}})["seeds"][name] = seed
    head = {"format": FORMAT, "matrixworld": __version__}
    save_json(directory / JOB, {**head, "groups": list(groups.values())})


def open_job(directory: str | Path) -> Job | None:
    """Return the job of a directory, None if it holds no file of a job.

    Raises DamagedFileError or OtherVersionError if the file cannot be read.
    """
    path = Path(directory) / JOB
    if not path.exists():
        return None
    values = load_format(path, FORMAT)
    with settings_of_this_version(path, values):
        job = {
            name: RaceSettings.from_json({**group["settings"], "seed": seed})
            for group in values["groups"]
            for name, seed in group["seeds"].items()
        }
        _check_names(job)
    return job


# Playing:


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
        return "\n".join([f"{len(lines)} runs failed:", *lines])


def described(path: Path, error: BaseException) -> str:
    """Return an error of a run in words, without the path if the message begins with it."""
    text = f"{error}" or type(error).__name__
    return text.removeprefix(f"{path.absolute()}: ").removeprefix(f"{path}: ")


def evolve(
    settings: RaceSettings | Sequence[RaceSettings] | Mapping[str, RaceSettings],
    directory: str | Path,
    *,
    executor: Executor | None = None,
    threads: int | None = None,
    report: Report = silent,
    on_epoch: OnEpoch | None = None,
) -> list[SavedRun]:
    """Return the finished runs of these settings: start them, continue them, or only open them.

    The runs are in the order of the settings.

    Parameters
    ----------
    settings : RaceSettings, or a sequence or mapping of them
        Settings of each run, by the names of the directories that they get, such as
        ``sigma-0.1/seed-3``. Without names these are ``<schedule>/seed-<n>``, and
        ``<team>-against-<opponent>/seed-<n>`` for one team alone.
    directory : str or Path
        A new or empty directory, or that of the same runs, which are continued.
    executor : concurrent.futures.Executor, optional
        Plays the runs, one thread each. By default worker processes of this machine, each with as
        many threads as there are more cores than runs; a single run, and in a browser any run, is
        played in this process.
    threads : int, optional
        Threads in all, without an executor. By default one per usable core.
    report : callable, optional
        Called twice a second with a `Progress`, such as a `ProgressBar`.
    on_epoch : callable, optional
        Called in this process as by `finish`, with the name of each run in the job as ``run``. With
        several runs the rows of a stage come when it has been saved, and none comes twice.

    Raises
    ------
    FileExistsError, TypeError, ValueError
        If settings are bad, two runs have the same name, an executor and `threads` are given, or
        the directory holds something else, such as other runs.
    OutOfMemoryError
        If the runs that play at one time need more memory than this machine has available.
    LockedError
        If another process plays the job.
    FailedRunsError
        If runs failed, after all others have ended.
    StopRun
        If `on_epoch` raises it. All runs have stopped then, and the same call continues them.

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
    check_directory(root, job)
    check_job(job, root, executor, threads)
    names, errors = play_job(
        job, root, executor=executor, threads=threads, report=report, on_epoch=on_epoch
    )
    failures = {root / name: error for name, error in errors.items()}
    finished = []
    for path in (root / name for name in names):
        try:
            finished.append(open_run(path))
        except BAD_FILES as error:  # noqa: PERF203, of one run: the others are returned
            failures[path] = error
    if failures:
        cause = next(iter(failures.values())) if len(job) == 1 else None
        raise FailedRunsError(failures, finished) from cause
    return finished


def check_job(job: Job, root: Path, executor: Executor | None, threads: int | None) -> None:
    """Raise an error if the unfinished runs of a job cannot be played; nothing is written."""
    check_threads(threads)
    if executor is not None:
        check_instance("executor", executor, Executor)
        if threads is not None:
            raise ValueError(f"threads: expected None with an executor, got {threads}")
    left = {n: each for n, each in job.items() if not _finished(root, n)}
    # Runs on other machines check the memory there; here one learner is made, to try it.
    workers = 1 if executor is not None else shares(len(left), threads)[0]
    needs = [sum(run_memory(each).values()) for each in left.values()]
    largest = sorted(needs, reverse=True)[:workers]
    check_memory(f"{workers} runs at one time" if workers > 1 else "run", runs=sum(largest))
    # Seeds make no difference here, and a job may have a thousand.
    for each in dict.fromkeys(each.method for each in left.values()):
        check_own_code(each)
    for each in left.values():
        if isinstance(each.schedule, Yoked):
            race_to_replay(each)
    # A run that has begun has its opponents in its own archive.
    new = [each for name, each in left.items() if not (root / name / CONFIG).exists()]
    for each in dict.fromkeys(each.method for each in new):
        if not each.is_race:
            check_sources(each)


def check_directory(root: Path, job: Job) -> None:
    """Raise an error unless a directory is new, empty, or that of the same job."""
    found = open_job(root)
    # A cluster's probe is a temporary file, and may be there.
    if found is None and root.exists() and not all(is_temporary(f.name) for f in root.iterdir()):
        RunDirectory(root).check_empty()
    if found is not None and found != job:
        different = found.items() ^ job.items()
        names = sorted({name for name, _ in different})
        raise ValueError(
            f"{root}: expected the runs in its {JOB}, got others: "
            f"{', '.join(names[:3])}{' ...' if len(names) > 3 else ''}"
        )


def shares(runs: int, threads: int | None) -> tuple[int, int]:
    """Return how many runs play at one time, and the threads of each."""
    cores = check_threads(threads)
    # A few runs more than cores share them from the beginning: the last one would play alone.
    workers = max(1, runs if runs < 2 * cores else cores)
    return workers, max(1, cores // workers)


def play_job(
    job: Job,
    root: Path,
    *,
    keep: bool = True,
    executor: Executor | None = None,
    threads: int | None = None,
    report: Report = silent,
    on_epoch: OnEpoch | None = None,
) -> tuple[list[str], dict[str, BaseException]]:
    """Play what is unfinished of a job that `check_job` has checked.

    `keep` says whether to write the file of the job, if there is none. Returns the names of the
    finished runs, in the order of the job, and the errors of the others. After Ctrl-C all tasks
    have ended at a checkpoint.
    """
    root.mkdir(parents=True, exist_ok=True)
    # A run that is a job of its own locks its directory itself.
    with nullcontext() if ITSELF in job else locked(root / LOCK):
        if executor is None:  # or one of them may be a cluster's probe
            remove_temporary_files(root)
        if keep:
            # Again, because another process may have begun a job before this one got the lock.
            check_directory(root, job)
            # Before any run begins: what was asked for is known from now on.
            if open_job(root) is None:
                save_job(root, job)
        play = JobPlay(job, root, report, on_epoch)
        names = play.unfinished()
        try:
            if executor is not None and names:
                play.by_executor(executor, names)
            elif len(names) == 1 or not HAS_PROCESSES:
                for name in names:
                    play.here(name, threads)
            elif names:
                play.by_processes(*shares(len(names), threads))
        finally:
            remove_progress(root)
    return [name for name in job if name in play.finished], play.failures


class JobPlay:
    """A job while it is played: what has finished and failed, and the progress of the rest."""

    def __init__(
        self, job: Job, root: Path, report: Report, on_epoch: OnEpoch | None = None
    ) -> None:
        self._job, self._root, self._report = job, root, report
        self._on_epoch = on_epoch
        self._told = {name: RunDirectory(root / name).newest() for name in job if on_epoch}
        self.finished: dict[str, Played] = {}
        self.failures: dict[str, BaseException] = {}
        self._losses: Counter[str] = Counter()
        for name, settings in job.items():
            if _finished(root, name):
                self._open(name, settings)
        self._totals = {name: int(each["matches"]) for name, each in self.finished.items()}
        self._before = dict(self._totals)

    def _open(self, name: str, settings: RaceSettings) -> None:
        files = RunDirectory(self._root / name)
        try:
            check_same(files.path, files.settings, settings)
            self.finished[name] = played(files)
        except BAD_FILES as error:
            self.failures[name] = error

    def unfinished(self) -> list[str]:
        """Return the names of the runs to play: the first one of each group, then the second ones.

        If the job is stopped, the groups have about equally many seeds.
        """
        counts: Counter[str] = Counter()
        order = {}
        for name in self._job:
            counts[group_of(name)] += 1
            order[name] = counts[group_of(name)]
        return sorted(filter(lambda name: not self._ended(name), order), key=order.__getitem__)

    def _ended(self, name: str) -> bool:
        return name in self.finished or name in self.failures

    def here(self, name: str, threads: int | None) -> None:
        """Play a run in this process, the only one that is left or where there are no others.

        A worker process would take half a second to start, and hide where an error came from.
        """
        path, alone = self._root / name, name == ITSELF
        report = at_times(lambda progress: self._tell({name: progress}))
        on_epoch = self._on_epoch
        told = on_epoch and (lambda row: on_epoch({**row, "run": name}))
        # Tasks that an earlier start left behind end now.
        with nullcontext() if alone else started(self._root):
            try:
                run = waiting(
                    lambda: finish(
                        self._job[name], path, threads=threads, report=report, on_epoch=told
                    ),
                    path,
                    lock_wait=0.0 if alone else None,
                )
                self._finish(name, played(run.files))
            except StopRun:
                raise
            except Exception as error:  # noqa: BLE001, of the run
                self.failures[name] = error
        self._tell({})

    def by_processes(self, workers: int, threads: int) -> None:
        """Play all unfinished runs, so many at one time; workers that die are replaced."""
        starts_lost = 0
        while left := self.unfinished():
            # A dead worker breaks its pool, with all runs in it.
            together = [name for name in left if self._losses[name] < BESIDE_OTHERS]
            names = together or left[:1]
            try:
                with WorkerProcesses(min(workers, len(names))) as processes:
                    self.by_executor(processes, names, threads)
            except BrokenExecutor as error:
                in_work = [*self._in_work(read_progress(self._root))]
                starts_lost = 0 if in_work else starts_lost + 1
                if starts_lost == TRIES:
                    raise BrokenExecutor(
                        f"worker processes: expected some that start, lost {TRIES}; memory or "
                        "the number of processes has too low a limit, or a script has no "
                        '`if __name__ == "__main__":`'
                    ) from error
                self._losses.update(in_work)
                for name in in_work:
                    if self._losses[name] == TRIES:
                        problem = f"expected one that lives, lost {TRIES}"
                        self.failures[name] = WorkerDiedError(f"worker process: {problem}")

    def by_executor(self, executor: Executor, names: Sequence[str], threads: int = 1) -> None:
        """Play these runs by an executor; BrokenExecutor if it can do no task any more."""
        root, futures = str(self._root.absolute()), dict[Future[Played], str]()
        try:
            with started(self._root) as token:
                for name in names:
                    text = json.dumps(self._job[name].to_json())
                    futures[executor.submit(run_task, text, root, name, token, threads)] = name
                pending = set(futures)
                while pending:
                    told = read_progress(self._root)
                    self._tell(told)
                    done, pending = wait(pending, SECONDS, FIRST_COMPLETED)
                    for future in done:
                        self._take(futures[future], future)
                    for name in [*self._in_work(told), *(futures[each] for each in done)]:
                        self._tell_epochs(name)
        finally:
            # After Ctrl-C or an error tasks may be left, which end now.
            wait([future for future in futures if not future.cancel()], STOP_WAIT)
        self._tell({})

    def _take(self, name: str, future: Future[Played]) -> None:
        try:
            self._finish(name, future.result())
        except BrokenExecutor:  # of the whole job: no task can be done any more
            raise
        except Exception as error:  # noqa: BLE001, of one run: the others go on
            self.failures[name] = error
            return
        # The warning of the run itself stayed in its process.
        if self.finished[name]["disengagement"]:
            text = f"{name}: {self.finished[name]['disengagement']}"
            warnings.warn(text, DisengagementWarning, stacklevel=5)

    def _finish(self, name: str, played: Played) -> None:
        self.finished[name], self._totals[name] = played, int(played["matches"])

    def _tell_epochs(self, name: str) -> None:
        """Tell the rows of the stages that a run has saved since the last call."""
        if self._on_epoch is None or name in self.failures:
            return
        for row in RunDirectory(self._root / name).rows(self._told[name]):
            self._on_epoch({"run": name, "seed": self._job[name].seed, **row})
            self._told[name] = row["stage"]

    def _in_work(self, told: Mapping[str, Progress]) -> dict[str, Progress]:
        """Return the progress of runs of this job that have not ended."""
        return {n: each for n, each in told.items() if n in self._job and not self._ended(n)}

    def _tell(self, told: Mapping[str, Progress]) -> None:
        work = {name: each for name, each in self._in_work(told).items() if each.total}
        for name, each in work.items():
            self._before.setdefault(name, each.before)
            self._totals[name] = each.total
        done = sum(self._totals[name] for name in self.finished)
        done += sum(each.done for each in work.values())
        # Runs that have not begun count as the mean of the others.
        known = [*self._totals.values()]
        total = sum(known) * len(self._job) // max(len(known), 1)
        failed = f", {len(self.failures)} failed" if self.failures else ""
        what = f"{len(self.finished)} of {len(self._job)} runs{failed}"
        if len(self._job) == 1 and work:
            what, work = next(iter(work.values())).what, {}
        self._report(Progress(what, done, max(total, 1), sum(self._before.values()), work))


def _finished(root: Path, name: str) -> bool:
    """Return whether nothing has to be done for a run."""
    # A run that is a job of its own is restored in any case, to tell of any damage.
    return name != ITSELF and RunDirectory(root / name).finished
