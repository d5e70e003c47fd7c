"""``matrixworld plot``: draw figures of finished runs, and of the game itself."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

import click

from matrixworld.cli.arguments import all_of, failures, find_runs
from matrixworld.cli.baselines import baseline_option, open_baselines
from matrixworld.cli.figures import (
    FORMATS,
    OF_GAME,
    OF_RACE,
    Selection,
    draw_comparison,
    draw_of_game,
    draw_one,
    draw_run,
    figure_files,
    format_of,
)
from matrixworld.cli.held_out import held_out_scores
from matrixworld.cli.jobs import Result
from matrixworld.cli.options import force_option, refuse_existing
from matrixworld.cli.race_groups import Group, run_groups
from matrixworld.cli.run_groups import Unfinished, finished_runs, of_several_seeds, root_of
from matrixworld.cli.seed_figures import (
    draw_generalization,
    draw_seeds,
    generalization_file,
    seed_figure_files,
)


@click.command("plot")
@click.argument(
    "runs",
    nargs=-1,
    metavar="[RUN...]",
    callback=all_of(find_runs, "directories that hold runs"),
)
@click.option(
    "--figure",
    type=click.Choice([*OF_RACE, *OF_GAME]),
    help="only this figure; the last three show the game and need no RUN",
)
@click.option(
    "--output",
    "-o",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="file of the one --figure  [default: named after it, in RUN or in the current directory]",
)
@click.option(
    "--format",
    "suffix",
    type=click.Choice(FORMATS),
    help="format of the files; pdf and svg are vector graphics  "
    "[default: that of --output, else png]",
)
@baseline_option
@click.option(
    "--comparison",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="figure of several races side by side  "
    "[default: comparison.png in the directory that holds them all]",
)
@click.option("--each", is_flag=True, help="of several seeds, draw the figures of each run, too")
@force_option
def plot_command(
    runs: list[Path],
    figure: str | None,
    output: Path | None,
    suffix: str | None,
    baselines: Mapping[str, Path],
    comparison: Path | None,
    each: bool,
    force: bool,
) -> None:
    """Draw figures of finished runs, or of the game.

    RUN is a run directory, or a directory of several. Each run's figures go into its directory.
    Two or more races are also drawn side by side. Of a job of several seeds (evolve --seeds) the
    groups of seeds are drawn, with their spread, and single runs only with --each.

    Without RUN, --figure draws the game: its rules (the variants as a table), conflicts (what the
    engine makes of the same moves under each outcome) and interaction (who acts together).
    """
    with failures():
        kind = _format(output, suffix)
        if figure in OF_GAME:
            _draw_game(figure, runs, output or Path(f"{figure}.{kind}"), force)
            return
        if not runs:
            raise click.UsageError(
                f"expected RUN..., or --figure {' or '.join(OF_GAME)}, which need none"
            )
        selection = Selection(figure, kind, open_baselines(baselines))
        results, unfinished = finished_runs(runs)
        if output is not None:
            _draw_file(results, selection, output, force)
        else:
            _draw_all(results, unfinished, selection, comparison, each=each, force=force)


def _format(output: Path | None, suffix: str | None) -> str:
    """Return the format of the files; click.UsageError if the options contradict each other."""
    if output is None:
        return suffix or "png"
    found = _format_of("--output", output)
    if suffix not in (None, found):
        raise click.UsageError(f"--format {suffix}: expected the format of --output {output}")
    return found


def _format_of(option: str, file: Path) -> str:
    try:
        return format_of(file)
    except ValueError as error:
        raise click.UsageError(f"{option}: {error}") from error


def _draw_game(figure: str, runs: Sequence[Path], file: Path, force: bool) -> None:
    if runs:
        raise click.UsageError(f"--figure {figure}: expected no RUN, got {runs[0]}")
    refuse_existing(file, force=force)
    _print_all([draw_of_game(figure, file)])


def _draw_file(results: Sequence[Result], selection: Selection, file: Path, force: bool) -> None:
    if selection.name is None or len(results) != 1:
        got = f"{len(results)} runs" if selection.name else "no --figure"
        raise click.UsageError(f"--output: expected one --figure of one run, got {got}")
    _check_drawn(results, selection)
    refuse_existing(file, force=force)
    _print_all([draw_one(results[0], selection, file)])


def _check_drawn(results: Sequence[Result], selection: Selection) -> None:
    for run in results:
        if not figure_files(run, selection):
            raise click.UsageError(
                f"--figure {selection.name}: expected a race, got a run of one team: {run.path}"
            )


Task = tuple[Sequence[Path], Callable[[], Sequence[Path]]]
"""Files, and the function that draws them."""


def _draw_all(
    results: Sequence[Result],
    unfinished: Unfinished,
    selection: Selection,
    comparison: Path | None,
    *,
    each: bool,
    force: bool,
) -> None:
    races = [run for run in results if run.is_race]
    if comparison is not None and len(races) < 2:
        raise click.UsageError(f"--comparison: expected at least two races, got {len(races)}")
    seeds = of_several_seeds([run.path for run in results]) and len(races) > 1
    # The figures of several seeds stand for those of the single runs.
    together = seeds and selection.name in (None, "generalization")
    singles = results if each or not together else []
    _check_drawn(singles, selection)
    tasks: list[Task] = [
        (figure_files(run, selection), partial(draw_run, run, selection)) for run in singles
    ]
    if comparison is not None or (len(races) > 1 and not seeds and selection.name is None):
        root = Path(os.path.commonpath([run.path.absolute() for run in results]))
        tasks.append(_side_by_side(races, root, comparison, selection))
    if seeds:
        tasks += _over_seeds(run_groups(races, unfinished), races, root_of(results), selection)
    # All files are checked before the first is drawn.
    refuse_existing(*(file for files, _ in tasks for file in files), force=force)
    for _, draw in tasks:
        _print_all(draw())


def _side_by_side(
    races: Sequence[Result], root: Path, comparison: Path | None, selection: Selection
) -> Task:
    file = comparison or root / f"comparison.{selection.suffix}"
    _format_of("--comparison", file)
    # Relative paths: runs of different jobs often have the same name.
    named = {str(run.path.absolute().relative_to(root)): run for run in races}
    return [file], lambda: [draw_comparison(named, file)]


def _over_seeds(
    groups: Sequence[Group], races: Sequence[Result], root: Path, selection: Selection
) -> list[Task]:
    suffix, tasks = selection.suffix, list[Task]()
    if selection.name is None:
        files = seed_figure_files(root, suffix)
        tasks.append(
            (files, lambda: draw_seeds(groups, held_out_scores(races, None), root, suffix))
        )
    if selection.name == "generalization" or selection.baselines:
        file = generalization_file(root, suffix)
        tasks.append(([file], lambda: [draw_generalization(groups, selection.baselines, file)]))
    return tasks


def _print_all(files: Sequence[Path]) -> None:
    for file in files:
        click.echo(file)
