"""``matrixworld judge``: what happened in races, and what to try."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from matrixworld._util.checks import INT_MAX
from matrixworld.analysis import explain
from matrixworld.analysis.words import all_results, measure_table
from matrixworld.cli.advice import advice
from matrixworld.cli.console import TERMS, print_wrapped, say
from matrixworld.cli.groups import Group, groups_of, runs_argument
from matrixworld.cli.options import force_option, json_option, refuse_existing, write_json
from matrixworld.cli.setting_options import usage_errors
from matrixworld.cli.tables import print_judged

SINGLE_RUN = "The intervals are about this run. Runs with other seeds may differ."


@click.command("judge")
@runs_argument(files=True)
@click.option("--all", "everything", is_flag=True, help="all measures, after the judgement")
@click.option("--each", is_flag=True, help="judge each run and each file by itself")
@click.option("--explain", "explained", is_flag=True, help="the reasons in sentences, too")
@click.option(
    "--episodes",
    type=click.IntRange(1, INT_MAX),
    metavar="INTEGER",
    help="episodes behind each cell of a file that holds means only",
)
@json_option
@force_option
def judge_command(
    runs: list[Path],
    everything: bool,
    each: bool,
    explained: bool,
    episodes: int | None,
    json_file: Path | None,
    force: bool,
) -> None:
    """Say what happened in races, and what to try.

    Arms race, one-sided progress, rise, intransitivity, cycling, disengagement, forgetting,
    stagnation: each is present or absent, or the intervals cannot tell. RUN is the directory of a
    job or of a run. Runs that differ in their seed only are judged together, with the verdict on
    each seed.

    FILE is a payoff matrix of your own, .csv or .npz: pursuers in rows, evaders in columns, capture
    rates from 0 to 1; or one line for each pair, run and episode. Several files are judged
    together, as runs of one race.
    """
    refuse_existing(json_file, force=force)
    groups = groups_of(runs, episodes=episodes)
    if each:
        groups = [single for group in groups for single in group.singles]
    for group in groups:
        _check(group, everything)
    for group in groups:
        _print(group, everything, explained)
    say(f"\n{TERMS}")
    write_json(json_file, {"groups": {g.name: _plain(g, everything) for g in groups}})


def _check(group: Group, everything: bool) -> None:
    """Refuse what cannot be judged, before anything is printed."""
    # The payoff of one team alone is a single cell.
    for run in group.runs:
        if not run.settings.is_race:
            raise click.UsageError(
                f"{run.path}: expected a race, got a run in which one team evolved"
            )
    with usage_errors():
        shape = group.payoffs.matrices.shape[1:]
    if everything and min(shape) < 2:
        raise click.UsageError(
            f"--all: expected at least 2 x 2 generations, got {shape[0]} x {shape[1]}"
        )


def _print(group: Group, everything: bool, explained: bool) -> None:
    judgement = group.judgement
    print_judged(group)
    if judgement.runs == 1:
        print_wrapped(SINGLE_RUN)
    if explained:
        say()
        print_wrapped(explain(judgement))
    if everything:
        say(f"\n{measure_table(group.payoffs)}")
    lines = advice(judgement, group.settings)
    if lines:
        say("\nWhat to try:")
        for line in lines:
            print_wrapped(line)


def _plain(group: Group, everything: bool) -> dict[str, Any]:
    judgement = group.judgement.to_json()
    return {"judgement": judgement, **all_results(group.payoffs)} if everything else judgement
