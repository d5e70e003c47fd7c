"""Seconds to solve small worlds exactly, beside the limits that they have to keep.

    python benchmarks/bench_solve.py [--repeats 3]

CPU time of the process on one core, the least of some repeats: other programs can only add to it.
With two threads the ratio of the times on the clock is measured; it needs two idle cores. Before
the measurement, known values are checked.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace

import click
import numpy as np

import matrixworld as mw
from matrixworld.coevolution import TEAMS, held_out_maps
from matrixworld.solve import States, best_response, solve
from timing import bind, n_cores, print_table

LIMITS = {
    "O, 6 x 6, 2 against 1, 20 steps": 20.0,
    "TO, 8 x 8, 2 against 1, to the end": 1.0,
    "O, 6 x 6, best response to a network": 1.0,
    "TO, 6 x 6, NashConv of two networks on 8 held-out maps": 7.5,
}
"""Seconds."""
SPEEDUP = 1.8


def world(variant: str, side: int, steps: int) -> mw.WorldConfig:
    sizes = {"rows": side, "cols": side, "n_pursuers": 2, "n_evaders": 1, "max_steps": steps}
    return mw.WorldConfig(variant, **sizes)


def check() -> None:
    """Check a value found by regret matching, and the capture time of a grid."""
    assert abs(solve(world("O", 4, 5)).value - 0.838) < 0.005
    assert solve(world("TO", 5, 5)).capture_time == 4


def nash_convs(champion: mw.Population) -> None:
    for walls in held_out_maps(6, 6, 8):
        states = States(replace(world("TO", 6, 20), obstacles=walls), threads=1)
        for team in TEAMS:
            best_response(states, champion, team)


def cases() -> dict[str, Callable[[], object]]:
    simultaneous, turns = world("O", 6, 20), world("TO", 8, 20)
    network = mw.Network.for_config(simultaneous)
    champion = mw.Population(network.initial(np.random.default_rng(0)), network)
    states = States(simultaneous, threads=1)
    works: list[Callable[[], object]] = [
        lambda: solve(States(simultaneous, threads=1)),
        lambda: solve(States(turns, threads=1)),
        lambda: best_response(states, champion, "pursuer"),
        lambda: nash_convs(champion),
    ]
    return dict(zip(LIMITS, works, strict=True))


def cpu_seconds(work: Callable[[], object], repeats: int) -> float:
    taken = []
    for _ in range(repeats):
        start = time.process_time()
        work()
        taken.append(time.process_time() - start)
    return min(taken)


def clock_seconds(threads: int, repeats: int) -> float:
    # Simultaneous moves of a third pursuer: enough work for two threads.
    config = mw.WorldConfig("O", rows=4, cols=4, n_pursuers=3, n_evaders=1, max_steps=20)
    taken = []
    for _ in range(repeats):
        start = time.perf_counter()
        solve(States(config, threads=threads))
        taken.append(time.perf_counter() - start)
    return min(taken)


@click.command()
@click.option("--repeats", default=3, show_default=True)
def main(repeats: int) -> None:
    check()
    bind(1)
    rows: list[tuple[str, str, str]] = []
    for what, work in cases().items():
        rows.append((what, f"{cpu_seconds(work, repeats):.2f}", f"at most {LIMITS[what]:g}"))
    print_table(["CPU seconds", "one core", "limit"], rows)
    if n_cores() < 2:
        return
    bind(2)
    ratio = clock_seconds(1, repeats) / clock_seconds(2, repeats)
    print_table(
        ["threads", "times as fast", "limit"], [("2", f"{ratio:.2f}", f"at least {SPEEDUP}")]
    )


if __name__ == "__main__":
    main()
