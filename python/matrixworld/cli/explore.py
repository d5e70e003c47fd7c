"""``matrixworld explore``: write the page of finished runs, and open it."""

from __future__ import annotations

import webbrowser
from collections.abc import Sequence
from itertools import zip_longest
from pathlib import Path

import click

from matrixworld.cli.arguments import all_of, failures, find_runs
from matrixworld.cli.console import note, print_wrapped
from matrixworld.cli.held_out import kept_scores
from matrixworld.cli.jobs import Result
from matrixworld.cli.options import force_option, refuse_existing
from matrixworld.cli.run_groups import (
    by_settings,
    finished_runs,
    of_several_seeds,
    root_of,
)
from matrixworld.coevolution import open_run
from matrixworld.explorer.page import write_page
from matrixworld.explorer.runs_page import MOST_RUNS, PAGE, explorer_page, page_file


@click.command("explore")
@click.argument(
    "runs",
    nargs=-1,
    required=True,
    metavar="RUN...",
    callback=all_of(find_runs, "directories that hold runs"),
)
@click.option(
    "--output",
    "-o",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help="the page  [default: explorer.html in the run directory, or in the directory that holds "
    "all of the runs]",
)
@click.option("--open/--no-open", "opens", default=True, help="open the page in a browser")
@force_option
def explore_command(runs: list[Path], output: Path | None, opens: bool, force: bool) -> None:
    """Write one page that shows finished runs and plays their matches, and open it.

    The page is a single file that needs no network and no installation. It holds the genomes and
    the engine: a click on a cell of the payoff matrix plays that very match. RUN is a run
    directory, or a directory of several; of many runs, the page shows the first seeds of each
    schedule.
    """
    with failures():
        results, _ = finished_runs(runs)
        beside = root_of(results) / PAGE if of_several_seeds(runs) else page_file(runs)
        page = output or beside
        refuse_existing(page, force=force)
        write_explorer(results, page)
        click.echo(page)
        if opens and not webbrowser.open(page.absolute().as_uri()):
            note("No browser was found here; open the file in one.")


def write_explorer(results: Sequence[Result], page: Path) -> None:
    """Write the page of finished runs, of the first ones if there are many, and say which."""
    shown = of_each_group(results, MOST_RUNS)
    left_out = ""
    if len(shown) < len(results):
        left_out = (
            f"The page shows {len(shown)} of {len(results)} runs, the first seeds of each group; "
            "matrixworld explore RUN... makes one of others."
        )
        print_wrapped(left_out)
    scores = {result.path: kept for result in shown if (kept := kept_scores(result)) is not None}
    html = explorer_page(
        [open_run(result.path) for result in shown], held_out=scores, note=left_out
    )
    write_page(page, html)


def of_each_group(results: Sequence[Result], most: int) -> list[Result]:
    """Return at most so many runs, in their order: of each group the first seeds, in turn."""
    if len(results) <= most:
        return list(results)
    in_turn = [run for turn in zip_longest(*by_settings(results)) for run in turn if run]
    chosen = {run.path for run in in_turn[:most]}
    return [result for result in results if result.path in chosen]
