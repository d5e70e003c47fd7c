"""Cores, rates, actions and tables of the benchmarks."""

from __future__ import annotations

import math
import os
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

SPARE, PLACES = 2**20, 4093
"""Random actions beside those of one step, and windows of them that are played in turn."""
CORES = range(os.cpu_count() or 1)
if hasattr(os, "sched_getaffinity"):
    CORES = sorted(os.sched_getaffinity(0))  # that this process could use when it started


def bind(cores: int) -> None:
    """Bind this process to a number of cores, if the system supports it."""
    # The last cores: the first ones tend to serve interrupts.
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, CORES[-cores:])


@dataclass(frozen=True)
class Rate:
    """Work done per second, the median of repeats, and the least CPU time of a unit of work.

    Other programs can only add to the CPU time, that of all threads in seconds.
    """

    per_second: float
    cpu: float


@dataclass(frozen=True)
class Clock:
    """Measurement of rates: the shortest time of a repeat, and the number of repeats.

    A call that has started is always finished.
    """

    seconds: float
    repeats: int

    def rate(self, play: Callable[[int], float]) -> float:
        """Return the work done per second, the median of the repeats.

        `play` takes the number of the call, from 0, does some work and returns its amount.
        """
        return self.measure(play).per_second

    def measure(self, play: Callable[[int], float]) -> Rate:
        """Return the work done per second, and the CPU time that a unit of it takes."""
        play(0)  # the first call allocates memory and fills caches
        repeats = [self._once(play) for _ in range(self.repeats)]
        return Rate(statistics.median(rate for rate, _ in repeats), min(cpu for _, cpu in repeats))

    def _once(self, play: Callable[[int], float]) -> tuple[float, float]:
        # Work and time are taken at the same moment, so a long last call does not bias the rate.
        calls, work, start, cpu = 0, 0.0, time.perf_counter(), time.process_time()
        passed = 0.0
        while calls == 0 or passed < self.seconds:
            work += play(calls)
            calls += 1
            passed = time.perf_counter() - start
        return work / passed, (time.process_time() - cpu) / work


def random_actions(n_actions: int, shape: tuple[int, ...]) -> Callable[[int], NDArray[np.uint8]]:
    """Return a function of the step: random actions of this shape.

    Each step's actions are a window, at a random place, of numbers drawn beforehand: a few rows of
    actions in turn would drive all agents to the borders, where they collide more.
    """
    rng, size = np.random.default_rng(0), math.prod(shape)
    drawn = rng.integers(n_actions, size=size + SPARE, dtype=np.uint8)
    # PLACES is prime, so that its period hardly ever coincides with that of the episodes.
    windows = [drawn[place : place + size] for place in rng.integers(SPARE, size=PLACES)]
    return lambda step: windows[step % PLACES].reshape(shape)


def print_table(header: Sequence[str], rows: Sequence[Sequence[object]]) -> None:
    """Print a table in Markdown and an empty line."""
    lines = ["| " + " | ".join(str(cell) for cell in row) + " |" for row in (header, *rows)]
    lines.insert(1, "|" + "---|" * len(header))
    print(*lines, "", sep="\n", flush=True)
