"""Tasks and learners that kill their own process."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

from own_code import HillClimber


def die_until(directory: str, deaths: int) -> int:
    """Kill this process so many times; then return how often it was called."""
    calls = len(list(Path(directory).iterdir())) + 1
    (Path(directory) / str(calls)).touch()
    if calls <= deaths:
        os.kill(os.getpid(), signal.SIGKILL)
    return calls


def slow(seconds: float, directory: str) -> int:
    """Write a file, take some time, and return the number of this process."""
    (Path(directory) / str(os.getpid())).touch()
    time.sleep(seconds)
    return os.getpid()


def fail() -> None:
    """Raise an error."""
    raise KeyError("no luck")


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
            self.marker.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        super().tell(fitness)
