"""How many agent-steps a second worlds play: ``matrixworld bench`` for two games, bound to cores.

    python benchmarks/bench_worlds.py [--seconds 1] [--repeats 5]

An agent-step is one step of one agent that is alive. Actions are random and drawn before the clock
starts; ended episodes begin anew within the time that is measured. Each figure is the median of
some repeats on one core, to which the process binds itself where the system can; lines for two
threads are measured on two. Before anything is timed, what is timed is compared with worlds played
one by one.
"""

from __future__ import annotations

import click

import matrixworld as mw
from matrixworld.bench import Measurement, check_worlds, measurements
from timing import bind, n_cores, print_table

VARIANTS = ("O", "SDB")


def measured(variant: str, threads: int, seconds: float, repeats: int) -> list[Measurement]:
    """Worlds of a variant, on one thread and on several."""
    config = mw.WorldConfig(variant)
    bind(1)
    check_worlds(config, threads)
    planned = measurements(config, config, [], population=1, threads=threads)
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
            lines[0].size,
            lines[0].threads,
            *(f"{line.rate * line.agent_steps / 1e6:.1f}" for line in lines),
            *(f"{line.rate * line.world_steps / 1e6:.3f}" for line in lines),
        )
        for lines in zip(*by_variant, strict=True)
    ]
    agents, steps = ([f"-{v}, {of}" for v in VARIANTS] for of in ("agent-steps", "steps"))
    print_table(("million a second", "worlds", "threads", *agents, *steps), rows)


if __name__ == "__main__":
    main()
