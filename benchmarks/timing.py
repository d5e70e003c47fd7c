"""Cores, rates and tables of the benchmarks. Imports the standard library only."""

from __future__ import annotations

import os
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass


def bind(cores: int) -> None:
    """Bind this process to a number of cores, if the system supports it."""
    # The last cores: the first ones tend to serve interrupts.
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, _CORES[-cores:])


def n_cores() -> int:
    """Return the number of cores that this process could use when it started."""
    return len(_CORES)


@dataclass(frozen=True)
class Rate:
    """What a measurement came to.

    Parameters
    ----------
    per_second : float
        Work done per second of wall time, the median of the repeats.
    cpu : float
        Seconds of CPU time of all threads for a unit of work, the least of the repeats: other
        programs can only add to it.
    """

    per_second: float
    cpu: float


@dataclass(frozen=True)
class Clock:
    """Measurement of rates.

    Parameters
    ----------
    seconds : float
        Shortest time of a repeat; a call that has started is always finished.
    repeats : int
        Number of repeats; the median counts.
    """

    seconds: float
    repeats: int

    def rate(self, play: Callable[[int], float]) -> float:
        """Return the work done per second, the median of the repeats.

        Parameters
        ----------
        play : callable
            Takes the number i of the call, from 0, does some work and returns its amount.
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


def print_table(header: Sequence[str], rows: Sequence[Sequence[object]]) -> None:
    """Print a table in Markdown and an empty line."""
    lines = ["| " + " | ".join(str(cell) for cell in row) + " |" for row in (header, *rows)]
    lines.insert(1, "|" + "---|" * len(header))
    print(*lines, "", sep="\n", flush=True)


def _cores() -> list[int]:
    if hasattr(os, "sched_getaffinity"):
        return sorted(os.sched_getaffinity(0))
    return list(range(os.cpu_count() or 1))


_CORES = _cores()
