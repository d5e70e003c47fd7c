"""The option ``--seeds``: several seeds, such as 0-9 or 0,3,5-7."""

from __future__ import annotations

import re
from collections import Counter

import click

from matrixworld.coevolution.settings import MOST_SEED

MOST_SEEDS = 100_000
"""Most seeds of a job. Each is a directory."""
RANGE = r"\d{1,19}(-\d{1,19})?"


def seeds_of(
    ctx: click.Context, param: click.Parameter, value: str | None
) -> tuple[int, ...] | None:
    """Return the seeds that a text names, in its order."""
    if value is None:
        return None
    if not re.fullmatch(f"{RANGE}(,{RANGE})*", value):
        raise click.BadParameter(f"expected seeds such as 0-9 or 0,3,5-7, got {value!r}")
    ends = [[int(end) for end in part.split("-")] for part in value.split(",")]
    _check_ends([(part[0], part[-1]) for part in ends])
    seeds = Counter(seed for part in ends for seed in range(part[0], part[-1] + 1))
    [(seed, times)] = seeds.most_common(1)
    if times > 1:
        raise click.BadParameter(f"expected each seed once, got {seed} several times")
    return tuple(seeds)


def _check_ends(ends: list[tuple[int, int]]) -> None:
    for first, last in ends:
        if first > last:
            raise click.BadParameter(f"expected the lower seed first, got {first}-{last}")
        if last > MOST_SEED:
            raise click.BadParameter(f"expected seeds from 0 to {MOST_SEED}, got {last}")
    count = sum(last - first + 1 for first, last in ends)
    # Before any list is made: 0-9999999999 would fill the memory.
    if count > MOST_SEEDS:
        raise click.BadParameter(f"expected at most {MOST_SEEDS:,} seeds, got {count:,}")


seeds_option = click.option(
    "--seeds",
    callback=seeds_of,
    metavar="SEEDS",
    help="a run of each seed, side by side: such as 0-9 or 0,3,5-7, in place of --seed",
)
