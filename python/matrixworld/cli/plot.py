"""``matrixworld plot``: draw the figures of finished runs again."""

from __future__ import annotations

import os
from pathlib import Path

import click

from matrixworld.cli.arguments import all_of, failures, find_runs
from matrixworld.cli.figures import draw_comparison, draw_run, figure_files
from matrixworld.cli.jobs import open_result
from matrixworld.cli.options import force_option, refuse_existing


@click.command("plot")
@click.argument(
    "runs",
    nargs=-1,
    required=True,
    metavar="RUN...",
    callback=all_of(find_runs, "directories that hold runs"),
)
@click.option(
    "--comparison",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="figure of several races side by side  "
    "[default: comparison.png in the directory that holds them all]",
)
@force_option
def plot_command(runs: list[Path], comparison: Path | None, force: bool) -> None:
    """Draw the figures of finished runs again.

    RUN is a run directory, or a directory of several. Each run's figures go into its directory.
    Two or more races are also drawn side by side.
    """
    with failures():
        results = [open_result(path) for path in runs]
        races = [each for each in results if each.is_race]
        common = Path(os.path.commonpath([each.path.absolute() for each in results]))
        if comparison is not None and len(races) < 2:
            raise click.UsageError(f"--comparison: expected at least two races, got {len(races)}")
        compared = [comparison or common / "comparison.png"] if len(races) > 1 else []
        # All files are checked before the first is drawn.
        figures = [file for each in results for file in figure_files(each)]
        refuse_existing(*figures, *compared, force=force)
        for each in results:
            for file in draw_run(each):
                click.echo(file)
        for file in compared:
            # Relative paths: runs of different jobs often have the same name.
            named = {str(each.path.absolute().relative_to(common)): each for each in races}
            click.echo(draw_comparison(named, file))
