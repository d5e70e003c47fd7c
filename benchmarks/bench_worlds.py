"""How many agent-steps a second worlds play.

    python benchmarks/bench_worlds.py [--seconds 1] [--repeats 5]

An agent-step is one step of one agent. Actions are random and drawn before the clock starts; ended
episodes begin anew within the time that is measured. Each figure is the median of some repeats on
one core, to which the process binds itself where the system can; a line for two threads is measured
on two. Before anything is timed, what is timed is compared with worlds played one by one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray

import matrixworld as mw
from timing import Clock, bind, n_cores, print_table

VARIANTS = ("O", "SDB")
MANY = 1024
ROWS_OF_ACTIONS = 16


@dataclass(frozen=True)
class Measured:
    """A line of the table."""

    what: str
    worlds: int
    threads: int
    rates: dict[str, float]  # agent-steps a second, by variant


def actions_for(config: mw.WorldConfig, worlds: int) -> NDArray[np.uint8]:
    rng = np.random.default_rng(0)
    shape = (ROWS_OF_ACTIONS, worlds, config.n_agents)
    return rng.integers(config.n_actions, size=shape, dtype=np.uint8)


# ---- What is timed ---------------------------------------------------------------------------


def batch(config: mw.WorldConfig, worlds: int, threads: int, *names: str) -> mw.Batch:
    specs = mw.array_specs(config)
    buffers = {name: np.zeros((worlds, *specs[name][0]), specs[name][1]) for name in names}
    mode = mw.Autoreset.SAME_STEP
    return mw.Batch(worlds, config, threads=threads, autoreset=mode, buffers=buffers)


def step_only(config: mw.WorldConfig, worlds: int, threads: int) -> Any:
    return batch(config, worlds, threads)


def step_and_views(config: mw.WorldConfig, worlds: int, threads: int) -> Any:
    return batch(config, worlds, threads, "views")


def vector_env(config: mw.WorldConfig, worlds: int, threads: int) -> Any:
    env = mw.VectorEnv(config, worlds, threads=threads, autoreset_mode="SameStep")
    env.reset(seed=0)
    return env


# ---- The answer, first -------------------------------------------------------------------------


def check(config: mw.WorldConfig) -> None:
    """What a `VectorEnv` shows is what single worlds show."""
    worlds = [mw.World(config) for _ in range(5)]
    env = mw.VectorEnv(config, len(worlds), autoreset_mode="Disabled")
    env.reset(seed=0)
    for seed, world in enumerate(worlds):
        world.reset(seed)
    for actions in actions_for(config, len(worlds)):
        env.step(actions)
        for number, world in enumerate(worlds):
            world.step(actions[number])
            assert (env.observations[number] == world.views()).all()
            assert (env.rewards[number] == world.rewards).all()


# ---- Timing ------------------------------------------------------------------------------------


def measure(
    what: str,
    make: Callable[[mw.WorldConfig, int, int], Any],
    worlds: int,
    threads: int,
    clock: Clock,
) -> Measured:
    rates = {}
    for variant in VARIANTS:
        config = mw.WorldConfig(variant)
        timed, actions = make(config, worlds, threads), actions_for(config, worlds)

        def play(i: int, timed: Any = timed, actions: NDArray[np.uint8] = actions) -> int:
            timed.step(actions[i % ROWS_OF_ACTIONS])
            return actions[0].size

        rates[variant] = clock.rate(play)
    return Measured(what, worlds, threads, rates)


@click.command()
@click.option("--seconds", default=1.0, show_default=True, help="time of one repeat")
@click.option("--repeats", default=5, show_default=True, help="repeats of which the median counts")
def main(seconds: float, repeats: int) -> None:
    """Print a table in Markdown."""
    clock = Clock(seconds, repeats)
    for variant in VARIANTS:
        check(mw.WorldConfig(variant))
    bind(1)
    lines = [
        measure(what, make, worlds, 1, clock)
        for what, make in (
            ("step only", step_only),
            ("step and views", step_and_views),
            ("`VectorEnv`", vector_env),
        )
        for worlds in (MANY, 1)
    ]
    if n_cores() > 1:
        bind(2)
        lines.append(measure("step and views", step_and_views, MANY, 2, clock))
    rows = [
        (line.what, line.worlds, line.threads, *(f"{line.rates[v] / 1e6:.1f}" for v in VARIANTS))
        for line in lines
    ]
    print_table(("million agent-steps/s", "worlds", "threads", *(f"-{v}" for v in VARIANTS)), rows)


if __name__ == "__main__":
    main()
