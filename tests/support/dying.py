"""Learners that end the process in which they learn."""

import os
import signal
from pathlib import Path

from own_code import HillClimber


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
