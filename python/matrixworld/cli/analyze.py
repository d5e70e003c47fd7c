"""``matrixworld analyze``: all measures of payoffs, also of a matrix of one's own."""

from __future__ import annotations

from pathlib import Path

import click

from matrixworld.analysis import Payoffs, all_results, measure_table
from matrixworld.cli.arguments import failures
from matrixworld.cli.console import TERMS
from matrixworld.cli.judgements import counts, print_head, print_judgement
from matrixworld.cli.options import (
    force_option,
    json_option,
    known_episodes_option,
    refuse_existing,
    write_json,
)
from matrixworld.cli.race_groups import Group, groups_of, one_group, races_argument
from matrixworld.cli.run_groups import of_several_seeds
from matrixworld.cli.seed_tables import print_missing


@click.command("analyze")
@races_argument
@known_episodes_option
@json_option
@force_option
def analyze_command(
    races: list[Path], episodes: int | None, json_file: Path | None, force: bool
) -> None:
    """Compute all measures of a payoff matrix, after the judgement of the race.

    FILE is a .csv or .npz file: pursuers in rows, evaders in columns, capture rates from 0 to 1;
    or one line for each pair, run and episode. RUN is a finished run directory or a directory of
    several. Several runs must have the same settings; intervals are then over runs. Of a job of
    several seeds (evolve --seeds) each group of seeds is analysed.
    """
    refuse_existing(json_file, force=force)
    with failures():
        # The directories of a job of several seeds say which runs belong together.
        seeds = of_several_seeds(races)
        groups = groups_of(races, episodes) if seeds else [one_group(races, episodes)]
        for group in groups:
            _check(group.payoffs)
            _print(group)
        click.echo(f"\n{TERMS}")
        plain = {
            group.name: {"judgement": group.judgement.to_json(), **all_results(group.payoffs)}
            for group in groups
        }
        alone = len(plain) == 1
        write_json(json_file, next(iter(plain.values())) if alone else {"analyses": plain})


def _print(group: Group) -> None:
    print_head(f"{group.name}: {counts(group.judgement)}")
    print_judgement(group.judgement)
    print_missing(group)
    click.echo(f"\n{measure_table(group.payoffs)}")


def _check(payoffs: Payoffs) -> None:
    if min(payoffs.shape) < 2:
        n, m = payoffs.shape
        raise click.UsageError(f"expected at least 2 x 2 generations, got {n} x {m}")
