"""``matrixworld diagnose``: what happened in a race, or in several of the same settings."""

from __future__ import annotations

from pathlib import Path

import click
import numpy as np

from matrixworld.analysis import Diagnosis, Payoffs, diagnose, read_payoffs
from matrixworld.cli.arguments import failures, find_runs
from matrixworld.cli.report import is_race, print_wrapped
from matrixworld.coevolution import open_run
from matrixworld.files import save_json

FILES = (".csv", ".npz")
SINGLE_RUN = (
    "This is a single run, and says nothing of what its settings would do again: give several runs "
    "that differ in their seed only."
)


def _sources(ctx: click.Context, param: click.Parameter, values: tuple[str, ...]) -> list[Path]:
    """Payoff files as they are; the runs that a directory is or holds."""
    paths = []
    for value in values:
        path = Path(value)
        found = [path] if path.suffix.lower() in FILES and path.is_file() else find_runs(path)
        if not found:
            raise click.BadParameter(
                f"expected run directories, or {' or '.join(FILES)} files, got {value!r}"
            )
        paths += found
    return list(dict.fromkeys(paths))


@click.command("diagnose")
@click.argument("runs", nargs=-1, required=True, metavar="RUN...", callback=_sources)
@click.option(
    "--json", "json_file", type=click.Path(path_type=Path, dir_okay=False),
    help="where to write the findings, too",
)  # fmt: skip
@click.option("--seed", type=click.IntRange(min=0), default=0, help="seed of the bootstrap")
def diagnose_command(runs: list[Path], json_file: Path | None, seed: int) -> None:
    """Name what happened in a race: arms race, cycling, disengagement, forgetting, stagnation.

    Each comes with a verdict, how sure it is, the numbers behind it, and what to try. RUN is a
    finished run directory, a directory of several, or a payoff matrix (.csv or .npz). Several must
    be of the same settings with different seeds: they are taken together, with intervals over runs.
    """
    with failures():
        payoffs = [_payoffs(path) for path in runs]
        found = _diagnose(runs, payoffs, seed)
        if json_file is not None:
            save_json(json_file, found.to_json())
    print_wrapped(str(found))
    if found.runs == 1:
        print_wrapped(SINGLE_RUN)
    if json_file is not None:
        click.echo(f"\nWritten: {json_file}")


def _payoffs(path: Path) -> Payoffs:
    """Those of a file, or of a run."""
    if path.suffix.lower() in FILES and path.is_file():
        try:
            return read_payoffs(path)
        except ValueError as error:
            raise click.UsageError(str(error)) from error
    run = open_run(path)
    if not is_race(run):
        raise click.UsageError(f"{path}: expected a race, got a run in which one team evolved")
    if not run.files.finished:
        raise click.UsageError(
            f"{path}: expected a finished run; matrixworld evolve --resume {path} goes on with it"
        )
    return read_payoffs(run.payoff().capture_rates, episodes=True)


def _diagnose(paths: list[Path], payoffs: list[Payoffs], seed: int) -> Diagnosis:
    """All runs together: by their episodes if these are known of every one, and are as many."""
    for path, one in zip(paths, payoffs, strict=True):
        if one.matrices.shape[1:] != payoffs[0].matrices.shape[1:]:
            raise click.UsageError(
                f"{path}: expected the generations of {paths[0]}, {payoffs[0].matrices.shape[1:]}, "
                f"got {one.matrices.shape[1:]}"
            )
    scores = [one.scores for one in payoffs if one.scores is not None]
    if len(scores) == len(payoffs) and len({each.shape[3] for each in scores}) == 1:
        return diagnose(np.concatenate(scores), episodes=True, rng=seed)
    return diagnose(np.concatenate([one.matrices for one in payoffs]), rng=seed)
