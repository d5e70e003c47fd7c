"""Runs in separate processes, to be killed. The processes are forked, so that they start fast.

The server from which they are forked imports this module and finds its functions by name.
"""

import io
import multiprocessing
import os
import signal
import sys
from contextlib import contextmanager
from functools import cache
from multiprocessing import forkserver
from unittest import mock

from matrixworld._util import files
from matrixworld.coevolution.jobs.job import create_job, job_of
from matrixworld.coevolution.runs.writer import RunWriter
from matrixworld.play.rollout import rollout
from tiny_race import played, tiny_race, tiny_single

CONTEXT = multiprocessing.get_context("forkserver")
CONTEXT.set_forkserver_preload(["killed"])

HALL = {"schedule": "hall-of-fame", "contemporaries": 1, "hall_sample": 1}
# As many stages as epochs, so as many writes.
SINGLE = {"team": "evader", "learner": "ga", "archive_every": 1}
RUNS = {"race": tiny_race(), "hall-of-fame": tiny_race(**HALL), "single": tiny_single(**SINGLE)}
SHORT_RUNS = {
    "short race": tiny_race(generations=1, pursuer_epochs=1, evader_epochs=1),
    "short hall-of-fame": tiny_race(**HALL, generations=1, joint_epochs=1),
    "short single": tiny_single(**SINGLE, epochs=2),
}
SETTINGS = {**RUNS, **SHORT_RUNS}
JOB = job_of([RUNS["single"], RUNS["race"]])


def play_run(kind, directory, play=rollout):
    """Make the run, unless it is there, and play it to its end."""
    played(SETTINGS[kind], directory, play=play)


@cache
def start_server():
    """Start the server that forks. It needs the path of all modules, to import them only once."""
    found = {"PYTHONPATH": os.pathsep.join(sys.path), "OPENBLAS_NUM_THREADS": "1"}
    with mock.patch.dict(os.environ, found):
        forkserver.ensure_running()


def process(target, *args):
    start_server()
    child = CONTEXT.Process(target=target, args=args, daemon=True)
    child.start()
    return child


class Events:
    """Counts file operations and calls of `rollout` in a process; calls `then` at one of them."""

    def __init__(self, at, then):
        self.count, self.at, self.then = 0, at, then

    def happen(self):
        if self.count == self.at:
            self.then()
        self.count += 1

    def before(self, function):
        def counted(*args, **options):
            self.happen()
            return function(*args, **options)

        return counted

    def open(self, path, mode, **options):
        """Open a file; writing is an event that happens when half of the content is written."""
        self.happen()
        file = open(path, mode, **options)  # noqa: SIM115, the caller closes it
        return HalfWritten(file, self) if set(mode) & set("wax") else file


class HalfWritten(io.BytesIO):
    """Content that goes to a file in two halves when it is flushed, with an event between them."""

    def __init__(self, file, events):
        super().__init__()
        self.file, self.events, self.fileno = file, events, file.fileno

    def __exit__(self, *error):
        self.file.close()

    def flush(self):
        content = self.getvalue()[self.file.tell() :]
        if content:
            half = len(content) // 2  # a kill between the halves leaves a cut file
            self.file.write(content[:half])
            self.file.flush()
            self.events.happen()
            self.file.write(content[half:])
            self.file.flush()


@contextmanager
def watched(events):
    """Make every operation of this process on files of runs an event, but for removals."""
    plain = os.replace, os.fsync
    os.replace, os.fsync = map(events.before, plain)
    files.open = events.open
    try:
        yield
    finally:
        os.replace, os.fsync = plain
        del files.open


@contextmanager
def killed(at):
    """Kill this process at one of the file operations in the block, removals among them."""
    events = Events(at, lambda: os.kill(os.getpid(), signal.SIGKILL))
    with watched(events), mock.patch.object(os, "unlink", events.before(os.unlink)):
        yield events


def run_until_killed(kind, directory, at):
    """As `play_run`, but killed at an event; exit code 0 if there are fewer events."""
    with killed(at) as events:
        play_run(kind, directory, play=events.before(rollout))


def create_until_killed(directory, at):
    """Make a job, but killed at an event."""
    with killed(at) as events:
        plain = {"rename": os.rename, "rmdir": os.rmdir}
        with mock.patch.multiple(os, **{name: events.before(each) for name, each in plain.items()}):
            create_job(JOB, directory)


def hold(directory, held):
    """Hold the lock of a run until killed; make the file `held` when the lock is held."""
    with RunWriter(directory).lock():
        held.touch()
        signal.pause()
