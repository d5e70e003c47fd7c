"""Runs in processes of their own, to be killed. The processes are forked, so that they start fast.

Everything here is found by name in the server from which they are forked.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from multiprocessing import forkserver
from pathlib import Path
from typing import Any
from unittest import mock

from matrixworld import coevolution, files
from matrixworld.coevolution.storage import run_log
from matrixworld.rollout import rollout
from tiny_race import tiny_race, tiny_single

CONTEXT = multiprocessing.get_context("forkserver")
CONTEXT.set_forkserver_preload(["killed"])

HALL = {"schedule": "hall-of-fame", "contemporaries": 1, "hall_sample": 1}
SHORT = {"generations": 1, "pursuer_epochs": 1, "evader_epochs": 1, "joint_epochs": 1}
RUNS: dict[str, Any] = {
    "race": tiny_race(),
    "hall-of-fame": tiny_race(**HALL),
    "single": tiny_single(team="evader", learner="ga", archive_every=1),
}
SHORT_RUNS: dict[str, Any] = {
    "short race": tiny_race(**SHORT),
    "short hall-of-fame": tiny_race(**{**HALL, **SHORT}),
    "short single": tiny_single(team="evader", learner="ga", archive_every=1, epochs=2),
}


def go_on(kind: str, directory: Path, play: Any = rollout) -> None:
    """Make the run, or go on with it if it has been made; to its end."""
    if (directory / "config.json").exists():
        run = coevolution.resume(directory, threads=1, play=play)
    else:
        run = coevolution.start({**RUNS, **SHORT_RUNS}[kind], directory, threads=1, play=play)
    run.run()


@cache
def start_server() -> None:
    """Start the server that forks, where it finds all modules: else each process imports anew."""
    found = {"PYTHONPATH": os.pathsep.join(sys.path), "OPENBLAS_NUM_THREADS": "1"}
    with mock.patch.dict(os.environ, found):
        forkserver.ensure_running()


def process(target: Callable[..., None], *args: Any) -> Any:
    """Start a process that does ``target(*args)``."""
    start_server()
    child = CONTEXT.Process(target=target, args=args, daemon=True)
    child.start()
    return child


class Events:
    """Counts what a process does to files, and every call of `rollout`; at one it does `then`."""

    def __init__(self, at: int, then: Callable[[], None]) -> None:
        self.count, self.at, self.then = 0, at, then

    def happen(self) -> None:
        """Count one, and do `then` if it is its turn."""
        if self.count == self.at:
            self.then()
        self.count += 1

    def before(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """Return a function that first counts."""

        def counted(*args: Any, **options: Any) -> Any:
            self.happen()
            return function(*args, **options)

        return counted

    def open(self, path: Any, mode: str, **options: Any) -> Any:
        """Open a file that counts when it is written, half of it being there by then."""
        self.happen()
        file = open(path, mode, **options)  # noqa: SIM115, who asked for it closes it
        return HalfWritten(file, self) if set(mode) & set("wa") else file


class HalfWritten:
    """A file that writes in two halves, with an event between them."""

    def __init__(self, file: Any, events: Events) -> None:
        self.file, self.events = file, events

    def __getattr__(self, name: str) -> Any:
        return getattr(self.file, name)

    def __enter__(self) -> HalfWritten:
        return self

    def __exit__(self, *error: Any) -> None:
        self.file.close()

    def write(self, content: bytes) -> None:
        half = len(content) // 2
        self.file.write(content[:half])
        self.file.flush()
        self.events.happen()
        self.file.write(content[half:])


@contextmanager
def watched(events: Events) -> Iterator[None]:
    """Let everything that this process does to files of runs happen to `events`."""
    plain = os.replace, os.fsync, os.truncate
    os.replace, os.fsync, os.truncate = map(events.before, plain)  # type: ignore[assignment]
    files.open = run_log.open = events.open  # type: ignore[attr-defined]
    try:
        yield
    finally:
        os.replace, os.fsync, os.truncate = plain
        del files.open, run_log.open  # type: ignore[attr-defined]


def go_on_and_die(kind: str, directory: Path, at: int) -> None:
    """As `go_on`, killed at an event; exit code 0 if there are fewer."""
    events = Events(at, lambda: os.kill(os.getpid(), signal.SIGKILL))
    with watched(events):
        go_on(kind, directory, play=events.before(rollout))


REFUSED = 3
"""Exit code of a process that was told why it could not write a file."""


def go_on_with_small_files(kind: str, directory: Path, limit: int, message: Path) -> None:
    """As `go_on`, where no file may have more than `limit` bytes; writes the error's message."""
    import resource

    with message.open("w") as told:
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY))
        try:
            go_on(kind, directory)
        except OSError as error:
            resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY,) * 2)
            told.write(str(error))
            raise SystemExit(REFUSED) from error


NOBODY = 65534


def go_on_without_rights(kind: str, directory: Path, message: Path) -> None:
    """As `go_on`, by a user who is no administrator; writes the error's message."""
    if os.getuid() == 0:
        os.setuid(NOBODY)
    try:
        go_on(kind, directory)
    except OSError as error:
        message.write_text(str(error))
        raise SystemExit(REFUSED) from error


def hold(directory: Path, held: Path) -> None:
    """Hold the lock of a run until killed; make the file `held` when it is."""
    with coevolution.RunDirectory.open(directory).lock():
        held.touch()
        signal.pause()
