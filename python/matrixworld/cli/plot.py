"""``matrixworld plot``: draw the figures of finished runs again."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

import click

from matrixworld.cli.arguments import all_of, failures, find_runs
from matrixworld.cli.figures import draw_comparison, draw_run, figure_files
from matrixworld.cli.held_out import held_out_scores
from matrixworld.cli.options import force_option, refuse_existing
from matrixworld.cli.race_groups import run_groups
from matrixworld.cli.run_groups import finished_runs, of_seeds, root_of
from matrixworld.cli.seed_figures import draw_seeds, seed_figure_files


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
@click.option("--each", is_flag=True, help="of several seeds, draw the figures of each run, too")
@force_option
def plot_command(runs: list[Path], comparison: Path | None, each: bool, force: bool) -> None:
    """Draw the figures of finished runs again.

    RUN is a run directory, or a directory of several. Each run's figures go into its directory.
    Two or more races are also drawn side by side. Of a job of several seeds (evolve --seeds) the
    groups of seeds are drawn, with their spread, and single runs only with --each.
    """
    with failures():
        results, unfinished = finished_runs(runs)
        races = [run for run in results if run.is_race]
        common = Path(os.path.commonpath([run.path.absolute() for run in results]))
        root = root_of(results)
        if comparison is not None and len(races) < 2:
            raise click.UsageError(f"--comparison: expected at least two races, got {len(races)}")
        seeds = of_seeds(runs) and len(races) > 1
        singles = results if each or not seeds else []
        compared = len(races) > 1 and not seeds
        side_by_side = comparison or (common / "comparison.png" if compared else None)
        # All files are checked before the first is drawn.
        figures = [file for run in singles for file in figure_files(run)]
        figures += seed_figure_files(root) if seeds else []
        refuse_existing(*figures, side_by_side, force=force)
        for run in singles:
            _print_all(draw_run(run))
        if side_by_side is not None:
            # Relative paths: runs of different jobs often have the same name.
            named = {str(run.path.absolute().relative_to(common)): run for run in races}
            _print_all([draw_comparison(named, side_by_side)])
        if seeds:
            scores = held_out_scores(races, None)
            _print_all(draw_seeds(run_groups(races, unfinished), scores, root))


def _print_all(files: Sequence[Path]) -> None:
    for file in files:
        click.echo(file)
