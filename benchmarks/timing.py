"""What the benchmarks share: cores, rates and tables. Imports the standard library only."""

from __future__ import annotations

import os
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass


def bind(cores: int) -> None:
    """Keep this process on so many cores, where the system can."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, _CORES[-cores:])


def n_cores() -> int:
    """Cores that this process may use when it is not bound to fewer."""
    return len(_CORES)


@dataclass(frozen=True)
class Clock:
    """How long a rate is measured.

    seconds: the least time of a repeat; the work in hand is always finished
    repeats: of which the median counts
    """

    seconds: float
    repeats: int

    def rate(self, play: Callable[[int], float]) -> float:
        """Work done a second, the median of the repeats.

        play: does the work number i, from 0, and returns how much that was, in any unit
        """
        play(0)
        return statistics.median(self._once(play) for _ in range(self.repeats))

    def _once(self, play: Callable[[int], float]) -> float:
        calls, work, start = 0, 0.0, time.perf_counter()
        while (passed := time.perf_counter() - start) < self.seconds:
            work += play(calls)
            calls += 1
        return work / passed


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
