"""``matrixworld explore`` and ``playground``: pages and figures."""

from __future__ import annotations

import os
import webbrowser
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TypeVar

import click

from matrixworld.cli import console, options, replay
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import RunGroup, open_run
from matrixworld.explorer import playground, runs_page
from matrixworld.explorer.page import write_page
from matrixworld.world.rules import Rules

Run = TypeVar("Run")


def open_page(page: Path, opens: bool) -> None:
    """Open a page in a browser if it is asked for, or say that there is none."""
    if opens and not webbrowser.open(page.absolute().as_uri()):
        console.note("No browser was found here; open the file in one.")


@click.command("explore")
@options.runs()
@options.out(
    f"the page  [default: {runs_page.PAGE} in the directory of the job, or in that of all runs]"
)
@options.shared("open")
@click.option("--figures", is_flag=True, help="draw figures, and write no page")
@click.option(
    "--format",
    "suffix",
    type=click.Choice(["png", "pdf", "svg"]),
    help="format of the figures; pdf and svg are vector graphics  [default: png]",
)
@click.option("--each", is_flag=True, help="of several seeds, draw the figures of each run, too")
@click.option("--column", is_flag=True, help="figures for one column of a paper, 3.4 inches wide")
@options.shared("force")
def explore_command(
    runs: list[Path],
    out: Path | None,
    opens: bool,
    figures: bool,
    suffix: str | None,
    each: bool,
    column: bool,
    force: bool,
) -> None:
    """Write one page that shows runs and plays their matches, and open it; or draw figures.

    RUN is the directory of a job or of a run. The page is a single file that needs no network. It
    holds the genomes and the engine: a click on a cell of the payoff matrix plays that very match.
    Of many runs, the page shows the first seeds of each group.

    With --figures the figures of each run go into its directory. Races of one seed are also drawn
    side by side; of several seeds all are drawn together, and single runs only with --each.
    """
    with usage_errors():
        groups = options.finished_groups(runs)
    root = _root_of(runs)
    if figures:
        if out is not None:
            raise click.UsageError("--out: expected no --figures beside it: they have their places")
        _draw_figures(groups, root, suffix or "png", each=each, column=column, force=force)
        return
    for option, value in {"--format": suffix, "--each": each, "--column": column}.items():
        if value:
            raise click.UsageError(f"{option}: expected --figures beside it")
    page = out or root / runs_page.PAGE
    options.check_outputs(page, force=force)
    with console.warnings_as_notes(), usage_errors():
        write_explorer(groups, page)
    console.say(page)
    open_page(page, opens)


def _root_of(directories: Sequence[Path]) -> Path:
    """Return the directory that holds all of these, relative if the first one is."""
    if len(directories) == 1:
        return directories[0]
    root = os.path.commonpath([path.absolute() for path in directories])
    return Path(root if directories[0].is_absolute() else os.path.relpath(root))


def _draw_figures(
    groups: Sequence[RunGroup], root: Path, suffix: str, *, each: bool, column: bool, force: bool
) -> None:
    """Draw figures into the directories of runs, and those of several runs into `root`."""
    from matrixworld import plots
    from matrixworld.plots.saved import figures_of

    with usage_errors():
        inside = [group.inside(root) for group in groups]
        files = figures_of(inside, root, suffix=suffix, each=each, column=column)
        # All files are checked before the first is drawn.
        options.check_outputs(*files, force=force)
        for file, drawn in files.items():
            plots.save_figure(drawn(), file)
            console.say(file)


def write_explorer(groups: Sequence[RunGroup], page: Path) -> None:
    """Write the page of finished runs, of the first ones if there are many, and say which."""
    shown = first_seeds([group.runs for group in groups], runs_page.MOST_RUNS)
    count = sum(len(group.runs) for group in groups)
    left_out = ""
    if len(shown) < count:
        left_out = (
            f"The page shows {len(shown)} of {count} runs, the first seeds of each group; "
            "matrixworld explore RUN... makes one of others."
        )
        console.print_wrapped(left_out)
    write_page(page, runs_page.explorer_page(shown, note=left_out, groups=groups))


def first_seeds(groups: Sequence[Sequence[Run]], most: int) -> list[Run]:
    """Return at most so many runs, in their order: of each group the first seeds, in turn."""
    turns = sorted(
        (turn, number) for number, group in enumerate(groups) for turn in range(len(group))
    )
    shares = Counter(number for _, number in turns[:most])
    return [run for number, group in enumerate(groups) for run in group[: shares[number]]]


@click.command("playground")
@click.argument("source", metavar="[RUN|VARIANT]", default="O", callback=replay.source_of)
@options.shared("race")
@options.out(f"the page  [default: {playground.PAGE}, of a RUN in its directory]")
@options.shared("open", "force")
def playground_command(
    source: Path | Rules, race: str | None, out: Path | None, opens: bool, force: bool
) -> None:
    """Write a page on which you play, and open it.

    You are the only evader in three rounds against ever stronger pursuers, or any agent in one
    match: with RUN against its generations, in its world; with VARIANT (default O) against scripts
    and the evolved opponents that come with the package, in a small world. Or choose rules, place
    agents and obstacles, and read every conflict of a step in words.

    The page is a single file that needs no network. It keeps a played match as a file, which
    matrixworld replay FILE shows.

    \b
    Examples:
      matrixworld playground
      matrixworld playground SB
      matrixworld playground runs/courtyard-seed0 --race hall-of-fame
    """
    title = "matrixworld playground"
    directory = Path()
    if isinstance(source, Rules):
        opponents = playground.shipped(source)
    else:
        directory = options.run_in(source, race)
        with usage_errors():
            run = open_run(directory)
            run.check_pursuit("`matrixworld explore` shows its matches")
        title = f"{run.title} - {title}"
        opponents = playground.of_run(run)
    page = out or directory / playground.PAGE
    options.check_outputs(page, force=force)
    write_page(page, playground.playground_page("", opponents, title))
    console.say(page)
    open_page(page, opens)
