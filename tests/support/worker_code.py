"""Learners that behave badly, or slowly, where they play on a worker of a cluster."""

from __future__ import annotations

import os
import sys
import time

from own_code import HillClimber

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
