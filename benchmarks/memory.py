"""Bytes of memory for one more world, or for the genome that a thread of a rollout plays.

    python benchmarks/memory.py world '{"rows": 10, "cols": 10}' 20000 [views]
    python benchmarks/memory.py thread '[64, 64]' 32

The arguments are changes to the default configuration and a number of worlds, or hidden layers and
a number of threads. The script prints a number; nan on systems other than Linux, which counts the
resident pages of a process. It is a separate process because freed memory may stay with a process.
"""

from __future__ import annotations

import json
import sys
from math import nan
from pathlib import Path

import numpy as np

import matrixworld as mw


def resident(field: str) -> float:
    """Return the resident bytes of this process: ``VmRSS`` current, ``VmHWM`` peak."""
    status = Path("/proc/self/status")
    lines = status.read_text().splitlines() if status.exists() else []
    return next((float(line.split()[1]) * 1024 for line in lines if line.startswith(field)), nan)


def batch(config: mw.WorldConfig, n_worlds: int, names: list[str]) -> mw.Batch:
    """Return a batch after a step."""
    specs = mw.array_specs(config)
    # Pages count as resident only after they have been written, hence ones and a step.
    buffers = {name: np.ones((n_worlds, *specs[name][0]), specs[name][1]) for name in names}
    made = mw.Batch(n_worlds, config, threads=1, buffers=buffers)
    made.step(np.zeros((n_worlds, config.n_agents), np.uint8))
    return made


def of_world(config: mw.WorldConfig, n_worlds: int, names: list[str]) -> float:
    """Return the growth of memory per world by a second batch."""
    # A first, smaller batch takes the memory that does not depend on the number of worlds.
    kept = [batch(config, n_worlds // 10, names)]
    before = resident("VmRSS")
    kept.append(batch(config, n_worlds, names))
    return (resident("VmRSS") - before) / n_worlds


def of_thread(hidden: tuple[int, ...], n_threads: int) -> float:
    """Return the growth of the peak from scripts to networks, per team and thread."""
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
