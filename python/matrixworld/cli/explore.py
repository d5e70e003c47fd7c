"""``matrixworld explore`` and ``playground``: pages and figures of runs and of the game."""

from __future__ import annotations

import webbrowser
from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from itertools import zip_longest
from pathlib import Path
from typing import TypeVar

import click

from matrixworld.cli.console import note, print_wrapped, say
from matrixworld.cli.figures import (
    FORMATS,
    OF_GAME,
    OF_GROUPS,
    OF_RUN,
    Draw,
    Selection,
    baseline_option,
    draw,
    game_figure,
    open_baselines,
    planned,
)
from matrixworld.cli.groups import Group, groups_of, place_of, runs_argument
from matrixworld.cli.options import FiniteRange, force_option, out_option, refuse_existing
from matrixworld.coevolution import open_run
from matrixworld.explorer.page import write_page
from matrixworld.explorer.playground import PAGE as PLAYGROUND
from matrixworld.explorer.playground import Playground
from matrixworld.explorer.runs_page import MOST_RUNS, PAGE, explorer_page

Run = TypeVar("Run")

open_option = click.option(
    "--open/--no-open", "opens", default=True, help="open the page in a browser"
)


def open_page(page: Path) -> None:
    """Open a page in a browser, or say that there is none."""
    if not webbrowser.open(page.absolute().as_uri()):
        note("No browser was found here; open the file in one.")


@click.command("explore", short_help="Show runs as a page or as figures.")
@runs_argument(required=False)
@out_option(
    f"the page  [default: {PAGE} in the directory of the job, or in the one that holds all of the "
    "runs]; with --figure, the file of the figure"
)
@open_option
@click.option("--figures", is_flag=True, help="draw figures, and write no page")
@click.option(
    "--figure",
    type=click.Choice([*dict.fromkeys([*OF_RUN, *OF_GROUPS, *OF_GAME])]),
    help="only this figure; the last three show the game and need no RUN",
)
@click.option(
    "--format",
    "suffix",
    type=click.Choice(FORMATS),
    help="format of the figures; pdf and svg are vector graphics  "
    "[default: that of --out, else png]",
)
@baseline_option
@click.option(
    "--width",
    type=FiniteRange(3, 12),
    metavar="INCHES",
    help="make figures for paper: of this width, with type of 6 to 9 points. A column has about "
    "3.35 inches, a page 6.9",
)
@click.option("--each", is_flag=True, help="of several seeds, draw the figures of each run, too")
@force_option
def explore_command(
    runs: list[Path],
    out: Path | None,
    opens: bool,
    figures: bool,
    figure: str | None,
    suffix: str | None,
    baselines: Mapping[str, Path],
    width: float | None,
    each: bool,
    force: bool,
) -> None:
    """Write one page that shows runs and plays their matches, and open it; or draw figures.

    RUN is the directory of a job or of a run. The page is a single file that needs no network and
    no installation. It holds the genomes and the engine: a click on a cell of the payoff matrix
    plays that very match. Of many runs, the page shows the first seeds of each group.

    With --figures the figures of each run go into its directory. Races of one seed are also drawn
    side by side; of several seeds all are drawn together, and single runs only with --each.

    Without RUN, --figure draws the game: its rules (the variants as a table), conflicts (what the
    engine makes of the same moves under each outcome) and interaction (who acts together).
    """
    given = {"--format": suffix, "--baseline": baselines, "--width": width, "--each": each}
    if figures or figure:
        suffix = _format(out, suffix)
        selection = Selection(figure, suffix, open_baselines(baselines), each, width)
        _draw(runs, selection, out, force)
        return
    for option, value in given.items():
        if value:
            raise click.UsageError(f"{option}: expected --figures or --figure beside it")
    if not runs:
        raise click.UsageError("expected RUN...")
    groups = groups_of(runs)
    page = out or place_of(runs) / PAGE
    refuse_existing(page, force=force)
    write_explorer(groups, page)
    say(page)
    if opens:
        open_page(page)


def write_explorer(groups: Sequence[Group], page: Path) -> None:
    """Write the page of finished runs, of the first ones if there are many, and say which."""
    shown = first_seeds([group.runs for group in groups], MOST_RUNS)
    count, left_out = sum(len(group.runs) for group in groups), ""
    if len(shown) < count:
        left_out = (
            f"The page shows {len(shown)} of {count} runs, the first seeds of each group; "
            "matrixworld explore RUN... makes one of others."
        )
        print_wrapped(left_out)
    # A group of one run is judged already, or will be: the page need not do it again.
    alone = [group for group in groups if len(group.runs) == 1 and group.is_race]
    judgements = {group.runs[0].path: group.judgement for group in alone}
    saved = [open_run(run.path) for run in shown]
    html = explorer_page(saved, judgements=judgements, note=left_out)
    write_page(page, html)


def first_seeds(groups: Iterable[Sequence[Run]], most: int) -> list[Run]:
    """Return at most so many runs, in their order: of each group the first seeds, in turn."""
    runs = [*groups]
    turns = zip_longest(*runs)
    chosen = [run for turn in turns for run in turn if run is not None][:most]
    return [run for group in runs for run in group if run in chosen]


# Figures:


def _format(out: Path | None, suffix: str | None) -> str:
    """Return the format of the files; click.UsageError if the options contradict each other."""
    if out is None:
        return suffix or "png"
    found = out.suffix.lower().removeprefix(".")
    if found not in FORMATS:
        names = ", ".join(f".{each}" for each in FORMATS)
        raise click.UsageError(f"--out: expected a name that ends in {names}, got {out}")
    if suffix not in (None, found):
        raise click.UsageError(f"--format {suffix}: expected the format of --out {out}")
    return found


def _draw(runs: Sequence[Path], selection: Selection, out: Path | None, force: bool) -> None:
    if selection.name in OF_GAME:
        if runs:
            raise click.UsageError(f"--figure {selection.name}: expected no RUN, got {runs[0]}")
        file = Path(f"{selection.name}.{selection.suffix}")
        files: dict[Path, Draw] = {file: partial(game_figure, selection.name)}
    elif runs:
        groups = groups_of(runs)
        _check_races(groups, selection)
        root = place_of(runs)
        files = planned([group.inside(root) for group in groups], root, selection)
    else:
        raise click.UsageError(f"expected RUN..., or --figure {' or '.join(OF_GAME)}")
    if out is not None:
        if selection.name is None or len(files) != 1:
            got = f"{len(files)} figures" if selection.name else "no --figure"
            raise click.UsageError(f"--out: expected one --figure of one run, got {got}")
        files = dict.fromkeys([out], *files.values())
    # All files are checked before the first is drawn.
    refuse_existing(*files, force=force)
    for file, figure in files.items():
        draw({file: figure}, selection.width)
        say(file)


def _check_races(groups: Sequence[Group], selection: Selection) -> None:
    if selection.name in (None, "training"):
        return
    for run in [run for group in groups for run in group.runs]:
        if not run.settings.is_race:
            raise click.UsageError(
                f"--figure {selection.name}: expected a race, got a run of one team: {run.path}"
            )
        if selection.name == "spinning_top" and run.payoff.capture_rates.shape[2] < 2:
            raise click.UsageError(
                f"--figure spinning_top: expected at least 2 episodes of a pair, got 1: {run.path}"
            )
    races = sum(len(group.runs) for group in groups)
    if selection.name == "comparison" and races < 2:
        raise click.UsageError(f"--figure comparison: expected at least two races, got {races}")


# The playground:


@click.command("playground", short_help="Play conflicts by hand on a page.")
@out_option("the page", default=Path(PLAYGROUND), show_default=True)
@open_option
@force_option
def playground_command(out: Path, opens: bool, force: bool) -> None:
    """Write the playground, one page that plays conflicts by hand, and open it.

    Choose a variant or rules of your own, place agents and obstacles, give each agent a move or a
    script, and read every conflict of a step in words. The page is a single file that needs no
    network and no installation; it holds the engine.
    """
    html = Playground().html()
    # A file that is this very page already need not be replaced.
    if not (out.is_file() and out.read_bytes() == html.encode()):
        refuse_existing(out, force=force)
        write_page(out, html)
    say(out)
    if opens:
        open_page(out)
