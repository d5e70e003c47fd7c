"""A real Dask cluster of processes on this machine, to be damaged by tests."""

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from distributed import Client

from scripts import group_lives, kill_group, wait_until

Process = subprocess.Popen[bytes]
SILENCE = 8.0
"""Seconds without a heartbeat after which a test gives up a worker; by default five minutes."""

# A race that kills two workers is bad. A lost connection shows soon.
SETTINGS = {
    "DASK_DISTRIBUTED__SCHEDULER__WORKER_TTL": "60s",
    "DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "1",
    "DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "5s",
    "OPENBLAS_NUM_THREADS": "1",
}


class DaskCluster:
    """A scheduler and workers, each a process of one thread."""

    def __init__(self, place: Path) -> None:
        self.place = place
        self.file = place / "scheduler.json"
        self.processes: list[Process] = []
        self._workers: dict[str, Process] = {}
        self.scheduler = self._start("dask_scheduler", "--port", "0", "--host", "127.0.0.1")
        wait_until(self._announced, "scheduler")
        self._client: Any = Client(self.address, set_as_default=False)

    def _announced(self) -> bool:
        try:
            return bool(json.loads(self.file.read_text()))
        except (OSError, ValueError):
            return False

    @property
    def address(self) -> str:
        """The scheduler's address."""
        return str(json.loads(self.file.read_text())["address"])

    def workers(self, count: int) -> list[Process]:
        """Return so many workers that take part: those that live, and new ones."""
        names = self.known()
        living = [name for name, each in self._workers.items() if each.poll() is None]
        for name in living[count:]:
            self.kill(self._workers[name])
        names = living[:count]
        while len(names) < count:
            names.append(self.add_worker())
        wait_until(lambda: sorted(self.known()) == sorted(names), f"{count} workers")
        return [self._workers[name] for name in names]

    def add_worker(self, path: Path | None = None) -> str:
        """Start a worker and return its name; modules in `path` are found before all others."""
        name = f"worker-{len(self.processes)}"
        self._workers[name] = self._start(
            "dask_worker", "--nthreads", "1", "--no-nanny", "--name", name,
            "--local-directory", str(self.place), first=[str(path)] if path else [],
        )  # fmt: skip
        return name

    def known(self) -> dict[str, str]:
        """Return the addresses of the workers that the scheduler knows, by name."""
        workers = self._client.scheduler_info(n_workers=-1)["workers"]
        return {str(each["name"]): address for address, each in workers.items()}

    def given_up(self, worker: Process) -> bool:
        """Return whether the scheduler has given up a worker that is silent for `SILENCE`."""

        async def check(dask_scheduler: Any) -> None:
            dask_scheduler.worker_ttl = SILENCE
            await dask_scheduler.check_worker_ttl()

        self._client.run_on_scheduler(check)
        [name] = [name for name, each in self._workers.items() if each is worker]
        return name not in self.known()

    def kill(self, worker: Process) -> None:
        """Kill a worker."""
        worker.kill()
        worker.wait()

    def left(self) -> list[int]:
        """Return the process groups of workers that have members left."""
        for each in self._workers.values():
            each.poll()  # a dead child counts as a member until its parent has looked
        return [each.pid for each in self._workers.values() if group_lives(each.pid)]

    def _start(self, module: str, *options: str, first: list[str] | None = None) -> Process:
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
        self._client.close()
        for process in reversed(self.processes):
            kill_group(process.pid)
            process.wait()


@contextmanager
def dask_cluster(place: Path, workers: int = 2) -> Iterator[DaskCluster]:
    """Yield a cluster."""
    place.mkdir(exist_ok=True)
    cluster = DaskCluster(place)
    try:
        cluster.workers(workers)
        yield cluster
    finally:
        cluster.close()
