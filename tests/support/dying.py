"""Tasks and learners that kill their own process, or take their time."""

import os
import signal
import sys
import threading
import time
from multiprocessing.connection import Connection
from pathlib import Path

from matrixworld.coevolution.jobs import worker
from own_code import HillClimber


def slow(seconds: float, directory: str) -> int:
    """Write a file, take some time, and return the number of this process."""
    (Path(directory) / str(os.getpid())).touch()
    time.sleep(seconds)
    return os.getpid()


def begin_without_threads(lifeline: Connection) -> None:
    """Begin as a worker for which the system starts no thread."""

    def fail(self: object) -> None:
        raise RuntimeError("can't start new thread")

    threading.Thread.start = fail  # type: ignore[method-assign]
    worker._begin(lifeline)


class Exits(HillClimber):
    """A learner that ends its process each time that it is told the fitness of a third epoch."""

    told = 0

    def tell(self, fitness):
        self.told += 1
        if self.told == 3:
            os._exit(9)
        super().tell(fitness)


class DiesOnce(HillClimber):
    """A learner that kills its process once, when it has learned for some epochs."""

    told = 0

    def __init__(self, genome, samples, *, marker, sigma=0.1):
        super().__init__(genome, samples, sigma=sigma)
        self.marker = Path(marker)

    def tell(self, fitness):
        self.told += 1
        if self.told == 3 and not self.marker.exists():
            time.sleep(0.5)  # another learner dies first
            self.marker.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        super().tell(fitness)


# Learners on a worker of a cluster

EPOCH_SECONDS = 0.1


def on_worker() -> bool:
    """Return whether this process is a worker of the tests' cluster."""
    return "dask_worker" in " ".join(sys.orig_argv)


class Slow(HillClimber):
    """Takes its time on a worker, and learns the same."""

    def ask(self, rng):
        if on_worker():
            time.sleep(EPOCH_SECONDS)
        return super().ask(rng)


class Deadly(HillClimber):
    """Kills its worker."""

    def ask(self, rng):
        if on_worker():
            os._exit(1)
        return super().ask(rng)
