"""What a worker does: one run, from its start or its checkpoint to its end.

Workers and the process that plays the job see the same directory, and nothing else of each other.
Each start of a job writes a random token to the file ``.start``, and hands it to its tasks. Tasks
look at the file twice a second, and end when it holds another token or is gone. This stops tasks on
any machine, a stop never reaches a later start, and what a killed program has left on other
machines ends when the job is started again. In ``.progress`` there is a small file for each run in
work; it may be old or missing.
"""

from __future__ import annotations

import json
import multiprocessing
import os
import secrets
import shutil
import signal
import sys
import threading
import time
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Future, ProcessPoolExecutor
from contextlib import contextmanager, suppress
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection
from multiprocessing.connection import wait as wait_for_end
from pathlib import Path
from typing import Any, TypeVar

from matrixworld._util.files import LockedError, replacing
from matrixworld.coevolution.progress import Progress, Report
from matrixworld.coevolution.runs.race import DisengagementWarning
from matrixworld.coevolution.runs.start import finish
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import CONFIG, RunDirectory

LOCK_WAIT = 120.0
"""Seconds for which a locked run directory is waited for. A worker that was declared lost may only
be frozen, and still holds the lock."""
LOOK = 0.5
"""Seconds between two looks at the file of the start."""
START = ".start"
PROGRESS = ".progress"
SEPARATOR = "@"
"""Stands for the slash of a run's name in the name of a file. No name of a run has it."""

Result = TypeVar("Result")
Played = dict[str, int | str]
"""What a finished run tells: its ``matches``, and its ``disengagement`` in words."""


class StoppedError(RuntimeError):
    """A task has ended because its job was stopped, or started again."""


class WorkerDiedError(RuntimeError):
    """A run has lost several worker processes, for example for lack of memory."""


def run_task(settings: str, directory: str, name: str, token: str, threads: int) -> Played:
    """Finish the run `name` of a job, wherever this is called.

    Only text and numbers go in and out, so that every executor can carry them. Errors are those of
    `finish`, StoppedError, and LockedError if another process holds the run for too long.
    """
    root = Path(directory)

    def look(progress: Progress) -> None:
        check_start(root, token)
        write_progress(root, name, progress)

    # Before anything else: if this process dies, it is known which run it was playing.
    look(Progress("begins", 0, 0))
    try:
        asked = RaceSettings.from_json(json.loads(settings))
        run = waiting(
            lambda: finish(asked, root / name, threads=threads, report=at_times(look)),
            root / name,
            check=lambda: check_start(root, token),
        )
    finally:
        progress_file(root, name).unlink(missing_ok=True)
    return played(run.files)


def played(files: RunDirectory) -> Played:
    """Return what a finished run tells."""
    numbers = files.summary()
    matches = int(numbers["training_matches"]) + int(numbers["evaluation_matches"])
    return {"matches": matches, "disengagement": "; ".join(numbers.get("disengagement", []))}


def at_times(look: Report) -> Report:
    """Return a report that calls `look` with the progress of a run, but only twice a second."""
    following = 0.0

    def report(progress: Progress) -> None:
        nonlocal following
        # Called after each epoch, which may take less than a millisecond.
        if time.monotonic() >= following:
            following = time.monotonic() + LOOK
            look(progress)

    return report


def waiting(
    play: Callable[[], Result],
    path: Path,
    lock_wait: float | None = None,
    check: Callable[[], None] = lambda: None,
) -> Result:
    """Return what `play` returns; repeat it while another process holds the run directory."""
    until = time.monotonic() + (LOCK_WAIT if lock_wait is None else lock_wait)
    while True:
        try:
            return play()
        except LockedError:
            if time.monotonic() > until:
                raise
        except FileExistsError:
            # The process that held the directory has made the run since: now it can be resumed.
            if not (path / CONFIG).exists():
                raise
        time.sleep(LOOK)
        check()


# The file of the start:


@contextmanager
def started(directory: Path) -> Iterator[str]:
    """Yield the token of a new start of a job; its tasks end with the block."""
    token = secrets.token_hex(8)
    with replacing(directory / START) as file:
        file.write(token.encode())
    remove_progress(directory)
    try:
        yield token
    finally:
        # Another program may play the job by now: its file stays.
        if _is_current(directory, token):
            (directory / START).unlink(missing_ok=True)


def check_start(directory: Path, token: str) -> None:
    """Raise StoppedError unless the newest start of a job is that of this token."""
    if not _is_current(directory, token):
        raise StoppedError(f"{directory}: the job was stopped, or started again")


def _is_current(directory: Path, token: str) -> bool:
    # Opened at each look, because network file systems ask the server when a file is opened.
    try:
        return (directory / START).read_bytes() == token.encode()
    except FileNotFoundError:
        return False


# Files of progress:


def progress_file(directory: Path, name: str) -> Path:
    """Return the file of a run in work."""
    return directory / PROGRESS / name.replace("/", SEPARATOR)


def write_progress(directory: Path, name: str, progress: Progress) -> None:
    """Write the progress of a run, in one step."""
    file = progress_file(directory, name)
    temporary = file.with_name(f"{file.name}.new")
    values = (progress.what, progress.done, progress.total, progress.before)
    # Not by `files.replacing`: it syncs, and this file may be lost.
    try:
        file.parent.mkdir(exist_ok=True)
        temporary.write_text(json.dumps(values), encoding="utf-8")
        os.replace(temporary, file)
    except OSError:
        return  # a full disk is reported by the run itself, which writes files that matter


def read_progress(directory: Path) -> dict[str, Progress]:
    """Return the progress of all runs in work, by name, in the order of the names."""
    try:
        # One listing, although there may be a thousand runs that have not begun.
        files = sorted((directory / PROGRESS).iterdir())
    except FileNotFoundError:
        return {}
    found = {}
    for file in files:
        try:
            what, done, total, before = json.loads(file.read_text(encoding="utf-8"))
        except (OSError, TypeError, ValueError):
            continue  # being written or removed, or left by a killed process
        found[file.name.replace(SEPARATOR, "/")] = Progress(what, done, total, before)
    return found


def remove_progress(directory: Path) -> None:
    """Remove the files of all runs, and their directory."""
    shutil.rmtree(directory / PROGRESS, ignore_errors=True)


# Worker processes of this machine:


class WorkerProcesses(ProcessPoolExecutor):
    """Worker processes that ignore Ctrl-C, and end with this executor or its process."""

    def __init__(self, workers: int) -> None:
        # spawn: a fork would copy locks that other threads of this process hold.
        context = multiprocessing.get_context("spawn")
        # When this end closes, even because this process was killed, the workers end.
        with _starting():
            self._ends, self._lifeline = context.Pipe(duplex=False)
            super().__init__(workers, context, _begin, (self._ends,))
        self._calls: list[Future[Any]] = []
        self._problem: BrokenExecutor | None = None
        self._hook, threading.excepthook = threading.excepthook, self._lost

    def _lost(self, args: threading.ExceptHookArgs) -> None:
        """Fail all calls if the thread that hands them out dies: they would wait for ever."""
        manager: Any = self._executor_manager_thread
        if args.thread is not manager:
            self._hook(args)
            return
        self._problem = BrokenExecutor(str(args.exc_value))
        for call in self._calls:
            if not call.done():
                call.set_exception(self._problem)

    def submit(self, fn: Callable[..., Result], /, *args: Any, **kwargs: Any) -> Future[Result]:
        """Return the future of a call; OSError if a process cannot be started."""
        with _starting():
            self._calls.append(super().submit(fn, *args, **kwargs))
        if self._problem:
            raise self._problem
        return self._calls[-1]

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = True) -> None:
        """End the workers at once, whatever they do: files are safe at any moment."""
        self._lifeline.close()
        # Those that have not begun do not look at their end. Python 3.14 has kill_workers.
        for process in (processes := [*(self._processes or {}).values()]):
            process.kill()
        with suppress(RuntimeError):  # its own thread could not be started, either
            super().shutdown(wait, cancel_futures=cancel_futures)
        for process in processes:
            process.join()
        threading.excepthook = self._hook
        self._ends.close()


@contextmanager
def _starting() -> Iterator[None]:
    try:
        with without_interrupts():
            yield
    except BrokenExecutor:
        raise
    except (OSError, RuntimeError) as error:  # such as the limits of ulimit -u and -n
        raise OSError(f"worker processes: expected to start one, got: {error}") from error


@contextmanager
def without_interrupts() -> Iterator[None]:
    """Block Ctrl-C for the processes that are started, now or later by threads that are.

    A terminal sends it to all processes. Only this one must act: it tells the others to stop.
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


def _begin(lifeline: Connection) -> None:
    if sys.platform == "win32":  # elsewhere it is blocked
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    # The main process warns when a run has ended, with its name.
    warnings.simplefilter("ignore", DisengagementWarning)
    try:
        threading.Thread(target=_end_with, args=(lifeline,), daemon=True).start()
    except RuntimeError:  # the limit of ulimit -u: the main process counts the workers it loses
        os._exit(1)


def _end_with(lifeline: Connection) -> None:
    parent = multiprocessing.parent_process()
    assert parent is not None
    wait_for_end([lifeline, parent.sentinel])
    # Not sys.exit, which ends this thread only.
    os._exit(1)
