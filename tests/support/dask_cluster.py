"""A real Dask cluster of processes on this machine, to be damaged by tests."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

DEADLINE = 30.0
"""Seconds in which anything that is waited for must happen."""

# Short limits: a worker that does not answer is given up after ten seconds, not five minutes.
SETTINGS = {
    "DASK_DISTRIBUTED__SCHEDULER__WORKER_TTL": "10s",
    "DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "1",
    "DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "5s",
    "OPENBLAS_NUM_THREADS": "1",
}


def wait_until(happened: Callable[[], bool], what: str) -> None:
    """Wait for something, or fail."""
    end = time.monotonic() + DEADLINE
    while not happened():
        assert time.monotonic() < end, f"{what}: did not happen within {DEADLINE} s"
        time.sleep(0.02)


class DaskCluster:
    """A scheduler and workers, each a process of one thread."""

    def __init__(self, place: Path) -> None:
        self.place = place
        self.file = place / "scheduler.json"
        self.processes: list[subprocess.Popen[bytes]] = []
        self.scheduler = self._start("dask_scheduler", "--port", "0", "--host", "127.0.0.1")
        wait_until(self._announced, "scheduler")

    def _announced(self) -> bool:
        try:
            return bool(json.loads(self.file.read_text()))
        except (OSError, ValueError):
            return False

    @property
    def address(self) -> str:
        """The scheduler's address."""
        return str(json.loads(self.file.read_text())["address"])

    def add_worker(self, *options: str, path: Path | None = None) -> subprocess.Popen[bytes]:
        """Start a worker; modules in `path` are found before all others."""
        first = [str(path)] if path else []
        return self._start(
            "dask_worker", "--nthreads", "1", "--no-nanny", "--death-timeout", "20",
            "--local-directory", str(self.place), *options, first=first,
        )  # fmt: skip

    def add_workers(self, count: int) -> list[subprocess.Popen[bytes]]:
        """Start workers."""
        return [self.add_worker() for _ in range(count)]

    def _start(
        self, module: str, *options: str, first: list[str] | None = None
    ) -> subprocess.Popen[bytes]:
        command = [
            sys.executable, "-m", f"distributed.cli.{module}", "--no-dashboard",
            "--scheduler-file", str(self.file), *options,
        ]  # fmt: skip
        path = os.pathsep.join([*(first or []), *filter(None, sys.path)])
        with (self.place / "cluster.log").open("ab") as log:
            process = subprocess.Popen(
                command,
                env={**os.environ, **SETTINGS, "PYTHONPATH": path},
                stdout=log,
                stderr=log,
                start_new_session=True,  # a process group for each, to find orphans
            )
        self.processes.append(process)
        return process

    def close(self) -> None:
        """Kill everything, frozen processes, too."""
        for process in reversed(self.processes):
            kill_group(process.pid)
            process.wait()


def kill_group(leader: int) -> None:
    """Kill a process and all that it has started."""
    with suppress(ProcessLookupError):
        os.killpg(leader, signal.SIGKILL)


@contextmanager
def dask_cluster(place: Path, workers: int = 2) -> Iterator[DaskCluster]:
    """Yield a cluster."""
    place.mkdir(exist_ok=True)
    cluster = DaskCluster(place)
    try:
        cluster.add_workers(workers)
        yield cluster
    finally:
        cluster.close()
