"""Jobs: runs that were asked for together, played side by side, here or by any executor.

The file of a job is written before any run begins: a job that is stopped, even at once, knows the
runs that have not begun. All runs go on from their last stage, so that a stop, a crash and the
death of a worker cost the work since then only.

While a job is played, its directory holds a folder ``.running-*`` with a file for each run. Whoever
plays the run, on whatever machine, writes its progress there, and ends when the file is gone.
"""

from __future__ import annotations

import json
import multiprocessing
import os
import re
import shutil
import signal
import tempfile
import threading
import time
import warnings
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
    wait,
)
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import replace
from multiprocessing import resource_tracker
from pathlib import Path
from typing import Any

from matrixworld._util.checks import check_instance, check_threads, shown
from matrixworld._util.files import DamagedFileError, locked, save_json, sentence_of
from matrixworld._util.imports import HAS_PROCESSES
from matrixworld.coevolution.progress import (
    LOG,
    SECONDS,
    OnEpoch,
    Progress,
    Report,
    StopRun,
    silent,
)
from matrixworld.coevolution.runs import check_own_code, finish
from matrixworld.coevolution.runs.map_race import check_maps
from matrixworld.coevolution.runs.race import DisengagementWarning, race_to_replay
from matrixworld.coevolution.runs.run import check_same
from matrixworld.coevolution.runs.single import check_sources
from matrixworld.coevolution.schedules import Maps, Yoked
from matrixworld.coevolution.settings import RaceSettings, check_run_memory, run_memory
from matrixworld.coevolution.storage import (
    LOCK,
    OtherVersionError,
    SavedRun,
    check_empty,
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
RUNNING = ".running-"
"""Begin of the name of the folder that a job has while it is played."""
FEW = 3
"""Most runs, such as those of a default `matrixworld evolve`, whose first one should end early."""
STOP_WAIT = 3.0
"""Seconds for which runs that have been stopped are waited for."""
BAD_FILES = (DamagedFileError, OtherVersionError, OSError, ValueError)
"""Errors of a run directory, which concern one run and no other."""

Job = Mapping[str, RaceSettings]
"""Runs that were asked for together: settings by the path of a run's directory in the job's."""


def job_of(settings: RaceSettings | Sequence[RaceSettings] | Mapping[str, RaceSettings]) -> Job:
    """Return the job of these settings, perhaps by name; without names each run gets one.

    Raises TypeError or ValueError if there are no settings, two runs have the same name or the same
    settings, or a name is not the path of a directory.
    """
    given: Any = [settings] if isinstance(settings, RaceSettings) else settings
    if not isinstance(given, Sequence | Mapping):  # a set has no order
        expected = "RaceSettings, or a sequence or mapping of them"
        raise TypeError(f"settings: expected {expected}, got {shown(given)}")
    each_named = given.items() if isinstance(given, Mapping) else [(None, each) for each in given]
    runs: dict[str, RaceSettings] = {}
    names: dict[RaceSettings, str] = {}
    for given_name, each in each_named:
        if not isinstance(each, RaceSettings):
            raise TypeError(f"settings: expected RaceSettings, got {shown(each)}")
        name = f"{each.schedule.name}/seed-{each.seed}" if given_name is None else given_name
        if name in runs:
            raise ValueError(
                f"settings: expected runs of different schedules or seeds, or a name for each, "
                f"got two of {name}"
            )
        runs[name] = _from_anywhere(each)
        # Equal runs are no independent observations.
        other = names.setdefault(runs[name], name)
        if other != name:
            raise ValueError(f"settings: expected different runs, got {other} and {name}, equal")
    _check_names(runs)
    return runs


def _check_names(runs: Job) -> None:
    if not runs:
        raise ValueError("settings: expected at least one run, got none")
    for name in runs:
        if not isinstance(name, str) or not NAME.fullmatch(name):
            expected = "names such as sigma-0.1 or sigma-0.1/seed-3"
            raise ValueError(f"settings: expected {expected}, got {shown(name)}")


def _from_anywhere(settings: RaceSettings) -> RaceSettings:
    """Return settings whose paths mean the same in another current directory, as workers have."""
    paths = {n: getattr(settings.schedule, n, None) for n in ("race", "opponent", "start")}
    absolute: dict[str, Any] = {
        name: str(Path(path).absolute())
        for name, path in paths.items()
        if path is not None and path not in SCRIPTS
    }
    return replace(settings, schedule=replace(settings.schedule, **absolute))


def group_of(name: str) -> str:
    """Return the name of the runs that differ from a run in their seed only, such as a schedule."""
    return name.rpartition("/")[0] or name


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
            name: RaceSettings.of({**group["settings"], "seed": seed})
            for group in values["groups"]
            for name, seed in group["seeds"].items()
        }
        _check_names(job)
    return job


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
    kind, text = type(error), sentence_of(error) or type(error).__name__
    # Such as KeyError, in the user's own code: its message alone says little.
    if kind.__module__ == "builtins" and not isinstance(error, OSError | ValueError):
        text = f"{kind.__name__}: {error}"
    return text.removeprefix(f"{path.absolute()}: ").removeprefix(f"{path}: ")


# Playing:


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

    The runs are in the order of the settings. After Ctrl-C, a crash or a failure, the same call
    continues. Each run directory has the same bytes as by `finish`, whatever the executor, the
    threads and the order. A run whose process dies is played once more, from its last stage.

    In a script, call it below ``if __name__ == "__main__":``, as everything that starts processes.

    Parameters
    ----------
    settings : RaceSettings, or a sequence or mapping of them
        Settings of each run, by the names of the directories that they get, such as
        ``sigma-0.1/seed-3``. Without names these are ``<schedule>/seed-<n>``, and
        ``<team>-against-<opponent>/seed-<n>`` for one team alone.
    directory : str or Path
        A new or empty directory, or that of the same runs, which are continued.
    executor : concurrent.futures.Executor, optional
        Plays the runs, one thread each, wherever the directory has the same path:
        `concurrent.futures`, MPI (``mpi4py.futures.MPIPoolExecutor``), loky and Dask
        (``Client.get_executor(pure=False)``) serve. By default each run has a process of this
        machine, with as many threads as there are more cores than runs; a single run, and in a
        browser any run, is played in this process.
    threads : int, optional
        Threads in all, without an executor. By default one per usable core.
    report : callable, optional
        Called often with a `Progress`, such as a `ProgressBar`.
    on_epoch : callable, optional
        Called in this process as by `finish`, with the name of each run in the job as ``run``. With
        several runs the rows of a stage come when it has been saved, and none comes twice.

    Raises
    ------
    FileExistsError, TypeError, ValueError
        If settings are bad or need too much memory, two runs have the same name, or the directory
        holds something else, such as other runs. Nothing is written then.
    FailedRunsError
        If runs failed, after all others have ended.
    BrokenExecutor, LockedError
        If no worker can begin a run, or another process plays the job.
    StopRun
        If `on_epoch` raises it. All runs have stopped then.
    """
    if executor is not None:
        check_instance("executor", executor, Executor)
        if threads is not None:
            raise ValueError(f"threads: expected None with an executor, got {threads}")
    root, job = Path(directory), job_of(settings)
    check_directory(root, job)
    check_job(job, root, threads, elsewhere=executor is not None)
    errors = play_job(
        job, root, executor=executor, threads=threads, report=report, on_epoch=on_epoch
    )
    finished = [open_run(root / name) for name in job if name not in errors]
    if errors:
        failures = {root / name: error for name, error in errors.items()}
        raise FailedRunsError(failures, finished) from next(iter(errors.values()))
    return finished


def check_directory(root: Path, job: Job) -> None:
    """Raise an error unless a directory is new, empty, or that of the same job."""
    found = open_job(root)
    if found is None and root.exists():
        check_empty(root)
    if found is not None and found != job:
        names = sorted({name for name, _ in found.items() ^ job.items()})
        raise ValueError(
            f"{root}: expected the runs in its {JOB}, got others: "
            f"{', '.join(names[:3])}{' ...' if len(names) > 3 else ''}"
        )


def check_job(job: Job, root: Path, threads: int | None, *, elsewhere: bool = False) -> None:
    """Raise an error if the unfinished runs of a job cannot be played; nothing is written.

    `elsewhere` says whether other machines play them, each of which checks its memory itself.
    """
    left = {n: each for n, each in job.items() if not _finished(root, n)}
    at_once = 1 if elsewhere else shares(len(left), threads)[0]
    largest = sorted(left.values(), key=lambda each: -sum(run_memory(each).values()))[:at_once]
    check_run_memory(f"{at_once} runs at one time" if at_once > 1 else "run", largest)
    # Seeds make no difference here, and a job may have a thousand.
    for method in dict.fromkeys(each.method for each in left.values()):
        check_own_code(method)
    for each in left.values():
        if isinstance(each.schedule, Yoked):
            race_to_replay(each)
    for method in dict.fromkeys(each.method for each in left.values()):
        if isinstance(method.schedule, Maps):
            check_maps(method)
    # A run that has begun has its opponents in its own archive.
    new = dict.fromkeys(each.method for n, each in left.items() if not SavedRun(root / n).exists)
    for method in new:
        if not method.is_race:
            check_sources(method)


def shares(runs: int, threads: int | None) -> tuple[int, int]:
    """Return how many runs play at one time, and the threads of each."""
    cores = check_threads(threads)
    # A few runs more than cores share them from the beginning: the last one would play alone.
    workers = max(1, runs if runs < 2 * cores else cores)
    if runs <= FEW:  # two threads each lose little, and the first run is there in half the time
        workers = max(1, min(runs, cores // 2))
    return workers, max(1, cores // workers)


def _finished(root: Path, name: str) -> bool:
    """Return whether nothing has to be done for a run."""
    # A run that is a job of its own is restored in any case, to tell of any damage.
    return name != ITSELF and SavedRun(root / name).finished


def play_job(
    job: Job,
    root: Path,
    *,
    keep: bool = True,
    executor: Executor | None = None,
    threads: int | None = None,
    report: Report = silent,
    on_epoch: OnEpoch | None = None,
) -> dict[str, BaseException]:
    """Play what is unfinished of a job that `check_job` has checked; return the errors by name.

    `keep` says whether to write the file of the job, if there is none.
    """
    root.mkdir(parents=True, exist_ok=True)
    # A run that is a job of its own locks its directory itself.
    with nullcontext() if ITSELF in job else locked(root / LOCK):
        if keep:
            # Again, because another process may have begun a job before this one got the lock.
            check_directory(root, job)
            if open_job(root) is None:
                save_job(root, job)
        play = _Play(job, root, report, on_epoch)
        # If the job is stopped, its groups have about equally many seeds.
        names = sorted((n for n in job if not play.ended(n)), key=lambda n: job[n].seed)
        if executor is None and (len(names) == 1 or not HAS_PROCESSES):
            for name in names:
                play.here(name, threads)
        elif names:
            play.side_by_side(names, executor, threads)
    return play.failures


class _Play:
    """A job while it is played: what has ended, and the progress of the rest."""

    def __init__(self, job: Job, root: Path, report: Report, on_epoch: OnEpoch | None) -> None:
        self._job, self._root, self._report, self._on_epoch = job, root, report, on_epoch
        # The newest stage of each run that is told, matches of finished runs, progress of those in
        # work, and matches that were played before this start.
        self._stages = {name: SavedRun(root / name).newest() for name in job if on_epoch}
        self._done: dict[str, int] = {}
        self._work: dict[str, Progress] = {}
        self.failures: dict[str, BaseException] = {}
        for name, settings in job.items():
            if _finished(root, name):
                try:
                    check_same(SavedRun(root / name), settings)
                    self._end(name)
                except BAD_FILES as error:
                    self.failures[name] = error
        self._before = dict(self._done)

    def ended(self, name: str) -> bool:
        """Return whether a run is finished or has failed."""
        return name in self._done or name in self.failures

    def here(self, name: str, threads: int | None) -> None:
        """Play a run in this process, the only one that is left or where there are no others.

        Another process would take half a second to start, and hide where an error came from.
        """
        on_epoch = self._on_epoch
        told = on_epoch and (lambda row: on_epoch({**row, "run": name}))
        try:
            finish(
                self._job[name],
                self._root / name,
                threads=threads,
                report=lambda progress: self._tell({name: progress}),
                on_epoch=told,
            )
            self._end(name)
        except StopRun:
            raise
        except Exception as error:  # noqa: BLE001, of the run
            self.failures[name] = error
        self._work.clear()
        self._tell({})

    def side_by_side(
        self, names: Sequence[str], executor: Executor | None, threads: int | None
    ) -> None:
        """Play runs by an executor, or each in a process of its own, until all have ended."""
        workers, each = shares(len(names), threads) if executor is None else (1, 1)
        play = play_in_process if executor is None else play_run
        futures: dict[Future[None], str] = {}
        with ThreadPoolExecutor(workers) as own:  # its threads wait for processes
            try:
                with _running(self._root.absolute(), names) as files:
                    for name, told in files.items():
                        task = self._job[name], self._root.absolute() / name, told, each
                        futures[(executor or own).submit(play, *task)] = name
                    self._tell({})
                    pending = {*futures}
                    while pending:
                        done, pending = wait(pending, SECONDS, FIRST_COMPLETED)
                        self._tell(_progress_in(files))
                        for future in done:
                            self._take(futures[future], future)
                        for name in names:
                            self._tell_epochs(name)
            finally:
                # After Ctrl-C or an error runs may be left, which end now.
                wait([future for future in futures if not future.cancel()], STOP_WAIT)
        self._tell({})

    def _take(self, name: str, future: Future[None]) -> None:
        """Take the result of a run that has ended."""
        try:
            future.result()
            numbers = self._end(name)
        except (BrokenExecutor, CancelledError) as error:
            if name not in self._work:  # nor can any other run begin
                raise BrokenExecutor(
                    f"{name}: expected a worker that begins it, got: {error!r}; perhaps memory or "
                    "the number of processes has too low a limit, or a script has no "
                    '`if __name__ == "__main__":`'
                ) from error
            self.failures[name] = error
        except Exception as error:  # noqa: BLE001, of one run: the others go on
            self.failures[name] = error
        else:
            LOG.info("%s: ended", self._root / name)  # its process has told it to nobody
            # The warning of the run itself stayed in its process.
            for text in numbers.get("disengagement", []):
                warnings.warn(f"{name}: {text}", DisengagementWarning, stacklevel=5)
        self._work.pop(name, None)

    def _end(self, name: str) -> dict[str, Any]:
        """Count the matches of a finished run; return its summary."""
        numbers = SavedRun(self._root / name).summary()
        played = (int(numbers[f"{each}_matches"]) for each in ("training", "evaluation"))
        self._done[name] = self._job[name].counted(*played)
        return numbers

    def _tell_epochs(self, name: str) -> None:
        """Tell the rows of the stages that a run has saved since the last call."""
        if self._on_epoch is None or name in self.failures:
            return
        for row in SavedRun(self._root / name).rows(self._stages[name]):
            self._on_epoch({"run": name, "seed": self._job[name].seed, **row})
            self._stages[name] = row["stage"]

    def _tell(self, told: Mapping[str, Progress]) -> None:
        """Report the progress of all runs, with what those in work have told."""
        self._work.update({n: each for n, each in told.items() if not self.ended(n)})
        work = {name: each for name, each in self._work.items() if each.total}
        for name, each in work.items():
            self._before.setdefault(name, each.before)
        done = sum(self._done.values()) + sum(each.done for each in work.values())
        # Runs that have not begun count as the mean of the others.
        known = [*self._done.values(), *(each.total for each in work.values())]
        total = sum(known) * len(self._job) // max(len(known), 1)
        failed = f", {len(self.failures)} failed" if self.failures else ""
        what = f"{len(self._done)} of {len(self._job)} runs{failed}"
        if len(self._job) == 1 and work:
            what, work = next(iter(work.values())).what, {}
        self._report(Progress(what, done, max(total, 1), sum(self._before.values()), work))


@contextmanager
def _running(root: Path, names: Sequence[str]) -> Iterator[dict[str, Path]]:
    """Yield a new file for the progress of each run; those who play them end with the block."""
    for left in root.glob(f"{RUNNING}*"):  # by a job that was killed
        shutil.rmtree(left, ignore_errors=True)
    folder = Path(tempfile.mkdtemp(prefix=RUNNING, dir=root))
    files = {name: folder / str(number) for number, name in enumerate(names)}
    try:
        for file in files.values():
            file.touch()
        yield files
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _progress_in(files: Mapping[str, Path]) -> dict[str, Progress]:
    """Return the progress of the runs that have begun."""
    found = {}
    for name, file in files.items():
        if file.stat().st_size:
            with suppress(ValueError):  # it is just being written
                found[name] = Progress(*json.loads(file.read_text(encoding="utf-8")))
    return found


# What plays a run, on any machine:


def play_run(settings: RaceSettings, path: Path, told: Path, threads: int) -> None:
    """Finish a run, wherever this is called, and tell its progress in the file `told`.

    FileNotFoundError when the job has been stopped.
    """
    following = 0.0

    def tell(progress: Progress) -> None:
        nonlocal following
        # Called after each epoch, which may take less than a millisecond.
        if time.monotonic() < following:
            return
        following = time.monotonic() + SECONDS
        if not told.exists():
            raise FileNotFoundError(f"{told.parent}: expected a directory that all workers share")
        with told.open("r+", encoding="utf-8") as file:  # which never makes it anew
            file.write(json.dumps((progress.what, progress.done, progress.total, progress.before)))
            file.truncate()

    # Before anything else: if this process dies, it is known that the run had begun.
    tell(Progress("begins", 0, 0))
    finish(settings, path, threads=threads, report=tell)


def play_in_process(
    settings: RaceSettings, path: Path, told: Path, threads: int, *, tries: int = 2
) -> None:
    """Do what `play_run` does in a process of its own; once more if that dies."""
    # spawn: a fork would copy locks that other threads of this process hold.
    context = multiprocessing.get_context("spawn")
    try:
        with without_interrupts(), ProcessPoolExecutor(1, context, _begin, (told,)) as process:
            process.submit(play_run, settings, path, told, threads).result()
    except BrokenProcessPool:
        if not told.exists():  # stopped
            raise
        if tries == 1:
            text = "its process died twice, for example for lack of memory"
            raise BrokenProcessPool(text) from None
        play_in_process(settings, path, told, threads, tries=tries - 1)


@contextmanager
def without_interrupts() -> Iterator[None]:
    """Keep Ctrl-C from the processes that are started here.

    A terminal sends it to all processes. Only this one must act: it ends the others.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    # Started later, it would unblock Ctrl-C in the thread that starts it.
    resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _begin(told: Path) -> None:
    """Begin a process that ends with its job, even if the process of that is killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # The main process warns when a run has ended, with its name.
    warnings.simplefilter("ignore", DisengagementWarning)
    threading.Thread(target=_end_with, args=(told,), daemon=True).start()


def _end_with(told: Path) -> None:
    parent = multiprocessing.parent_process()
    assert parent is not None
    while parent.is_alive() and told.exists():
        time.sleep(SECONDS)
    os._exit(1)  # not sys.exit, which ends this thread only; files are safe at any moment
