"""CPU time of a new process until the package, the command line and parts of both are there.

    python benchmarks/bench_start.py [--repeats 15]

User and system time of all threads, the median of processes that are started in turns. Run it
twice: the first time reads files from the disk.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
from collections import defaultdict

import click

from timing import bind, print_table

LIMIT = 0.25
"""Seconds."""
LINES = {
    "import numpy": None,
    "import gymnasium": None,
    "import matrixworld": LIMIT,
    "from matrixworld import World, rollout": None,
    "import matrixworld.envs": None,
    "import matrixworld.coevolution": None,
    "from matrixworld.cli import main; main(['--help'])": LIMIT,
}
"""What a process runs, and its limit."""


def cpu_seconds(line: str) -> float:
    start = children()
    subprocess.run([sys.executable, "-c", line], stdout=subprocess.DEVNULL, check=True)
    return children() - start


def children() -> float:
    """Return the CPU time of all processes that this one has waited for."""
    times = os.times()
    return times.children_user + times.children_system


@click.command()
@click.option("--repeats", default=15, show_default=True)
def main(repeats: int) -> None:
    bind(1)
    taken = defaultdict(list)
    for _ in range(repeats):
        for line in LINES:
            taken[line].append(cpu_seconds(line))
    seconds = {line: statistics.median(times) for line, times in taken.items()}
    rows = [
        (
            f"`{line}`",
            f"{seconds[line]:.2f}",
            f"{seconds[line] / seconds['import numpy']:.1f}",
            "" if limit is None else f"at most {limit:g}",
        )
        for line, limit in LINES.items()
    ]
    print_table(["a process with", "CPU seconds", "times NumPy's", "limit"], rows)


if __name__ == "__main__":
    main()
