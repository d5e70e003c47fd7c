"""Bytes that one more world takes, or a genome in the hands of a rollout's thread.

    python benchmarks/memory.py world '{"rows": 10, "cols": 10}' 20000 [views]
    python benchmarks/memory.py thread '[64, 64]' 32

Arguments are changes to the default configuration and a number of worlds, or hidden layers and a
number of threads. Prints a number, nan where the system is not Linux, which counts the pages that a
process has in memory. A process of its own, since memory that is freed may stay with a process.
"""

from __future__ import annotations

import json
import sys
from math import nan
from pathlib import Path

import numpy as np

import matrixworld as mw


def resident(field: str) -> float:
    """Bytes of this process in memory: ``VmRSS`` now, ``VmHWM`` at most so far."""
    status = Path("/proc/self/status")
    lines = status.read_text().splitlines() if status.exists() else []
    return next((float(line.split()[1]) * 1024 for line in lines if line.startswith(field)), nan)


def batch(config: mw.WorldConfig, n_worlds: int, names: list[str]) -> mw.Batch:
    """A batch after a step, so that all its memory has been touched."""
    specs = mw.array_specs(config)
    buffers = {name: np.ones((n_worlds, *specs[name][0]), specs[name][1]) for name in names}
    made = mw.Batch(n_worlds, config, threads=1, buffers=buffers)
    made.step(np.zeros((n_worlds, config.n_agents), np.uint8))
    return made


def of_world(config: mw.WorldConfig, n_worlds: int, names: list[str]) -> float:
    """Growth by a second batch, a world, where there is a smaller one already."""
    kept = [batch(config, n_worlds // 10, names)]
    before = resident("VmRSS")
    kept.append(batch(config, n_worlds, names))
    return (resident("VmRSS") - before) / n_worlds


def of_thread(hidden: tuple[int, ...], n_threads: int) -> float:
    """Growth of the peak from scripts to networks on as many threads, a team and thread."""
    config = mw.WorldConfig("O", max_steps=100)
    network = mw.Network.for_config(config, hidden)
    team = mw.Population(network.initial(np.random.default_rng(0)), network)
    matches = mw.Matches.of(0, 0, np.arange(50 * n_threads))
    peaks = []
    for players in ("random", team):
        mw.rollout(config, players, players, matches, threads=n_threads)
        peaks.append(resident("VmHWM"))
    return (peaks[1] - peaks[0]) / (2 * n_threads)


def main() -> None:
    what, settings, n, *names = sys.argv[1:]
    if what == "world":
        config = mw.WorldConfig("O", **json.loads(settings))
        print(of_world(config, int(n), names))
    else:
        print(of_thread(tuple(json.loads(settings)), int(n)))


if __name__ == "__main__":
    main()
