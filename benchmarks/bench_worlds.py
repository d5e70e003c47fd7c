"""Agent-steps per second of worlds: ``matrixworld bench`` for two games, bound to cores.

    python benchmarks/bench_worlds.py [--seconds 1] [--repeats 5]

An agent-step is one step of one living agent. Actions are random and are drawn before the
measurement; resets of ended episodes are part of it. Each number is the median of some repeats. The
process is bound to one core, and for two threads to two cores, if the system supports it.
"""

from __future__ import annotations

import click

import matrixworld as mw
from matrixworld.cli.bench import Timing, timings_of_worlds
from timing import bind, n_cores, print_table

VARIANTS = ("O", "SDB")


def measured(variant: str, threads: int, seconds: float, repeats: int) -> list[Timing]:
    """Measure worlds of a variant on one thread and on several."""
    config = mw.WorldConfig(variant)
    bind(1)
    planned = timings_of_worlds(config, threads)
    for each in planned:
        bind(each.threads)
        for _ in range(repeats):
            each.repeat(seconds)
    return planned


@click.command()
@click.option("--seconds", default=1.0, show_default=True, help="time of one repeat")
@click.option("--repeats", default=5, show_default=True, help="repeats of which the median counts")
def main(seconds: float, repeats: int) -> None:
    """Print a table in Markdown."""
    threads = min(2, n_cores())
    by_variant = [measured(variant, threads, seconds, repeats) for variant in VARIANTS]
    rows = [
        (
            lines[0].what,
            lines[0].at_once,
            lines[0].threads,
            *(f"{line.rate * line.agent_steps / 1e6:.1f}" for line in lines),
            *(f"{line.rate * line.world_steps / 1e6:.3f}" for line in lines),
        )
        for lines in zip(*by_variant, strict=True)
    ]
    agents, steps = ([f"-{v}, {of}" for v in VARIANTS] for of in ("agent-steps", "steps"))
    print_table(("million per second", "worlds", "threads", *agents, *steps), rows)


if __name__ == "__main__":
    main()
