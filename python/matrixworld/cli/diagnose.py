"""``matrixworld diagnose``: what happened in a race, or in several of the same settings."""

from __future__ import annotations

from pathlib import Path

import click

from matrixworld.analysis import describe, explain
from matrixworld.cli.advice import advice
from matrixworld.cli.arguments import failures
from matrixworld.cli.console import TERMS, print_wrapped
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
from matrixworld.cli.seed_tables import STRIP_LEGEND, print_missing, print_strip

SINGLE_RUN = "The intervals are about this run. Runs with other seeds may differ."
EACH = " (--each judges each of them)"


@click.command("diagnose")
@races_argument
@click.option("--each", is_flag=True, help="judge each group of runs of the same settings")
@click.option("--explain", "explained", is_flag=True, help="reasons and numbers in sentences, too")
@known_episodes_option
@json_option
@force_option
def diagnose_command(
    races: list[Path],
    each: bool,
    explained: bool,
    episodes: int | None,
    json_file: Path | None,
    force: bool,
) -> None:
    """Say what happened in a race: arms race, cycling, disengagement, forgetting, stagnation.

    Each condition is present or absent, or its intervals cannot tell. RUN is a finished run
    directory or a directory of several, FILE a payoff matrix (.csv or .npz). Several runs are
    judged together: they must have the same settings and different seeds. Of a job of several
    seeds (evolve --seeds) each group of seeds is judged, with the verdict on each seed.
    """
    refuse_existing(json_file, force=force)
    with failures():
        # The directories of a job of several seeds say which runs belong together.
        several = each or of_several_seeds(races)
        groups = groups_of(races, episodes) if several else [one_group(races, episodes, EACH)]
        for group in groups:
            _print(group, explained)
        click.echo(f"\n{TERMS}")
        plain = {group.name: group.judgement.to_json() for group in groups}
        alone = len(plain) == 1 and not each
        write_json(json_file, next(iter(plain.values())) if alone else {"judgements": plain})


def _print(group: Group, explained: bool) -> None:
    judgement = group.judgement
    print_head(f"{group.name}: {counts(judgement)}")
    print_judgement(judgement)
    if len(group.seeds) > 1 or group.missing:
        click.echo()
        print_strip(group)
        print_missing(group)
        print_wrapped(STRIP_LEGEND)
    if judgement.runs == 1:
        print_wrapped(SINGLE_RUN)
    if explained:
        click.echo()
        print_wrapped(explain(judgement))
        _print_numbers(group)
    lines = advice(judgement, group.settings)
    if lines:
        click.echo("\nWhat to try:")
        for line in lines:
            print_wrapped(line)


def _print_numbers(group: Group) -> None:
    """Print the headline numbers of a single run; those of several runs differ."""
    if len(group.payoffs.matrices) == 1 and min(group.payoffs.matrices.shape[1:]) > 1:
        print_wrapped(describe(group.payoffs.matrices[0]))
