"""``matrixworld diagnose``: what happened in a race, or in several of the same settings."""

from __future__ import annotations

from pathlib import Path

import click
import numpy as np

from matrixworld.analysis import Diagnosis, Payoffs, diagnose, read_payoffs
from matrixworld.cli.arguments import all_of, failures, find_runs
from matrixworld.cli.console import TERMS, print_wrapped
from matrixworld.cli.jobs import open_result
from matrixworld.cli.options import (
    force_option,
    json_option,
    refuse_existing,
    seed_option,
    write_json,
)

FILES = (".csv", ".npz")
SINGLE_RUN = (
    "This is a single run. It does not show what the same settings do with another seed: give "
    "several runs that differ in their seed only."
)


def _is_payoff_file(path: Path) -> bool:
    return path.suffix.lower() in FILES and path.is_file()


def _sources(path: Path) -> list[Path]:
    """Return a payoff file as it is, else the runs that a directory is or holds."""
    return [path] if _is_payoff_file(path) else find_runs(path)


@click.command("diagnose")
@click.argument(
    "runs",
    nargs=-1,
    required=True,
    metavar="RUN...",
    callback=all_of(_sources, f"run directories, or {' or '.join(FILES)} files"),
)
@seed_option
@json_option
@force_option
def diagnose_command(runs: list[Path], seed: int, json_file: Path | None, force: bool) -> None:
    """Name what happened in a race: arms race, cycling, disengagement, forgetting, stagnation.

    Each finding has a verdict, a confidence, its evidence in numbers, and what to try. RUN is a
    finished run directory, a directory of several, or a payoff matrix (.csv or .npz). Several runs
    must have the same settings and different seeds; intervals are then over runs.

    --seed is that of the bootstrap, from which the intervals come.
    """
    refuse_existing(json_file, force=force)
    with failures():
        found = _diagnose(runs, [_payoffs(path) for path in runs], seed)
        print_wrapped(str(found))
        if found.runs == 1:
            print_wrapped(SINGLE_RUN)
        click.echo(f"\n{TERMS}")
        write_json(json_file, found.to_json())


def _payoffs(path: Path) -> Payoffs:
    """Return the payoffs in a file, or of a run."""
    if _is_payoff_file(path):
        try:
            return read_payoffs(path)
        except ValueError as error:
            raise click.UsageError(str(error)) from error
    run = open_result(path)
    # The payoff of one team alone is a single cell.
    if not run.is_race:
        raise click.UsageError(f"{path}: expected a race, got a run in which one team evolved")
    return read_payoffs(run.payoff.capture_rates, episodes=True)


def _diagnose(paths: list[Path], payoffs: list[Payoffs], seed: int) -> Diagnosis:
    """Diagnose all runs together, by their episodes if all runs have equally many."""
    for path, one in zip(paths, payoffs, strict=True):
        if one.matrices.shape[1:] != payoffs[0].matrices.shape[1:]:
            raise click.UsageError(
                f"{path}: expected the generations of {paths[0]}, {payoffs[0].matrices.shape[1:]}, "
                f"got {one.matrices.shape[1:]}"
            )
    # A file may hold means only. Then the means of all runs are used.
    scores = [one.scores for one in payoffs if one.scores is not None]
    if len(scores) == len(payoffs) and len({each.shape[3] for each in scores}) == 1:
        return diagnose(np.concatenate(scores), episodes=True, rng=seed)
    return diagnose(np.concatenate([one.matrices for one in payoffs]), rng=seed)
