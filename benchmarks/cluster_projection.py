"""What a Dask cluster costs here, and what follows for 10 and 100 nodes.

    python benchmarks/cluster_projection.py            measures on this machine, about a minute
    python benchmarks/cluster_projection.py --race 75  with a race of 75 s instead of a measured one

Measured: the time that Dask takes for one task (alone, and in a row), the time that a worker takes
for its first task (imports and checks), and the size of a race's files. The projection takes the
worst of them: one scheduler and one client serve all workers, one task after the other, and the
last races of a job leave workers idle. Shared file systems are not in it: compare the bytes per
second that it prints with yours.
"""

from __future__ import annotations

import argparse
import math
import operator
import tempfile
import time
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path

from matrixworld.cluster import cluster
from matrixworld.coevolution import RaceSettings, finish, start
from matrixworld.coevolution.evaluation.tournament import BLOCK_SECONDS

TASKS = 300
SHORT = {
    "schedule.generations": 3,
    "schedule.pursuer_epochs": 8,
    "schedule.evader_epochs": 16,
    "evaluation_episodes": 2,
}
"""A race of few matches, which tells the processor time of a match."""
SMALL = {"learner.population": 2, "train_steps": 1, "world.max_steps": 1}
"""A race of short matches, whose files are as large as those of a default race."""


@dataclass(frozen=True)
class Costs:
    """What one task costs besides its work, in seconds, and a race in bytes."""

    alone: float
    in_a_row: float
    first: float
    race: float
    bytes: int


def measured(race: float | None) -> Costs:
    """Measure the costs with two workers on this machine."""
    with cluster("auto") as executor:
        began = time.perf_counter()
        executor.submit(operator.add, 1, 2).result()
        first = time.perf_counter() - began
        # The smallest of several: other programs can only add to it.
        alone = min(seconds_of(executor, 1) for _ in range(50))
        in_a_row = min(seconds_of(executor, TASKS) for _ in range(5))
    seconds, size = race_costs()
    return Costs(alone, in_a_row, first, seconds if race is None else race, size)


def seconds_of(executor: Executor, tasks: int) -> float:
    """Return the time of a task that does nothing, if so many are handed in together."""
    began = time.perf_counter()
    for future in [executor.submit(operator.add, 1, n) for n in range(tasks)]:
        future.result()
    return (time.perf_counter() - began) / tasks


def race_costs() -> tuple[float, int]:
    """Return processor time and bytes of a default race, from those of smaller ones."""
    full, short, small = RaceSettings(), RaceSettings.of(SHORT), RaceSettings.of(SMALL)
    with tempfile.TemporaryDirectory() as place:
        run = start(short, Path(place) / "short", threads=1)
        began = time.process_time()
        run.run()
        seconds = time.process_time() - began
        share = start(full, Path(place) / "full").total_matches() / run.total_matches()
        files = finish(small, Path(place) / "small", threads=1).files.path.iterdir()
        return seconds * share, sum(file.stat().st_size for file in files)


def makespan(tasks: int, seconds: float, workers: int, costs: Costs) -> float:
    """Return the time of equal tasks on so many workers."""
    # Each wave begins when the scheduler has handed out the one before; it serves one at a time.
    waves = math.ceil(tasks / workers)
    work = waves * (seconds + costs.alone) + min(tasks, workers) * costs.in_a_row
    return costs.first + max(work, tasks * costs.in_a_row + seconds)


def table(costs: Costs, nodes: tuple[int, ...], cores: int) -> str:
    """Return the projection in Markdown."""
    lines = [
        f"| work | one core | {' | '.join(f'{n} x {cores} cores' for n in nodes)} |",
        "|---" * (2 + len(nodes)) + "|",
    ]
    for name, tasks, seconds in (
        ("100 races", 100, costs.race),
        ("1,000 races", 1000, costs.race),
        ("10,000 races", 10_000, costs.race),
        ("1,000 blocks of a tournament", 1000, BLOCK_SECONDS),
    ):
        cells = [f"{tasks * seconds / 3600:.1f} h"]
        times = [makespan(tasks, seconds, each * cores, costs) for each in nodes]
        cells += [f"{each / 60:.1f} min ({times[0] / each:.1f} x)" for each in times]
        lines.append(f"| {name} | {' | '.join(cells)} |")
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--race", type=float, help="seconds of a race on one core")
    parser.add_argument("--cores", type=int, default=32, help="cores of a node")
    args = parser.parse_args()
    costs = measured(args.race)
    print(
        f"a task alone {1000 * costs.alone:.1f} ms; in a row {1000 * costs.in_a_row:.1f} ms each; "
        f"a worker's first {costs.first:.1f} s\n"
        f"a race {costs.race:.0f} s on one core, {costs.bytes / 1e6:.1f} MB\n"
    )
    print(table(costs, (1, 10, 100), args.cores))
    rate = 100 * args.cores / costs.race * costs.bytes
    print(f"\nThe files of finished races: {rate / 1e6:.0f} MB/s from 100 nodes.")


if __name__ == "__main__":
    main()
