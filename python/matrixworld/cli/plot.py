"""``matrixworld plot``: figures of finished runs."""

from __future__ import annotations

import os
from pathlib import Path

import click

from matrixworld.cli.arguments import failures, find_runs
from matrixworld.cli.figures import draw_comparison, draw_run
from matrixworld.cli.report import is_race
from matrixworld.coevolution import open_run


def _all_runs(ctx: click.Context, param: click.Parameter, values: tuple[str, ...]) -> list[Path]:
    paths = []
    for value in values:
        runs = find_runs(Path(value))
        if not runs:
            raise click.BadParameter(f"expected directories that hold runs, got {value!r}")
        paths += runs
    return list(dict.fromkeys(paths))


@click.command("plot")
@click.argument("runs", nargs=-1, required=True, metavar="RUN...", callback=_all_runs)
@click.option(
    "--comparison",
    type=click.Path(path_type=Path, dir_okay=False),
    help="where to draw several races side by side  "
    "[default: comparison.png in the directory that holds them all]",
)
def plot_command(runs: list[Path], comparison: Path | None) -> None:
    """Draw the figures of finished runs again.

    They go into the run directories. RUN is a run directory, or a directory of several. Two races
    or more are also drawn side by side.
    """
    with failures():
        for path in runs:
            _check_finished(path)
        for path in runs:
            for figure in draw_run(path):
                click.echo(figure)
        races = [path for path in runs if is_race(open_run(path))]
        if len(races) > 1:
            click.echo(_compare(races, comparison))


def _check_finished(path: Path) -> None:
    if not open_run(path).files.finished:
        raise click.UsageError(
            f"{path}: expected a finished run; matrixworld evolve --resume {path} goes on with it"
        )


def _compare(races: list[Path], comparison: Path | None) -> Path:
    common = Path(os.path.commonpath([path.absolute() for path in races]))
    payoffs = {
        str(path.absolute().relative_to(common)): open_run(path).payoff().capture_rate
        for path in races
    }
    return draw_comparison(payoffs, comparison or common / "comparison.png")
