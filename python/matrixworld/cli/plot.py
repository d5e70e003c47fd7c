"""Figures of finished runs, and ``matrixworld plot``, which draws them again."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np
from numpy.typing import NDArray

from matrixworld.cli.arguments import all_of, failures, find_runs
from matrixworld.cli.jobs import Result, open_result
from matrixworld.cli.options import force_option, refuse_existing
from matrixworld.coevolution import HALL_OF_FAME, TEAMS, Payoff, SingleSettings
from matrixworld.files import replacing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

WINDOWS = 4
"""Windows of the moving average of a training curve in the shorter team phase of a generation."""
LONGEST = 100
"""Windows of the moving average in the run of one team alone."""


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


def figure_files(run: Result) -> list[Path]:
    """Return the files that `draw_run` writes."""
    return [run.path / f"{name}.png" for name in _figures(run)]


def draw_run(run: Result) -> Sequence[Path]:
    """Draw all figures of a finished run into its directory; returns their files."""
    for name, draw in _figures(run).items():
        save_figure(draw(), run.path / f"{name}.png")
    return figure_files(run)


def draw_comparison(races: Mapping[str, Result], path: Path) -> Path:
    """Draw races side by side, each under its name; returns the file."""
    from matrixworld import plots

    payoffs = {name: race.payoff.capture_rate for name, race in races.items()}
    return save_figure(plots.comparison(payoffs), path)


def save_figure(figure: Figure, path: Path) -> Path:
    """Write a figure as PNG, complete or not at all; returns the file."""
    with replacing(path) as file:
        figure.savefig(file, format="png")
    return path


def _figures(run: Result) -> dict[str, Callable[[], Figure]]:
    """Return functions that draw a run's figures, by the names of the files."""
    # Matplotlib takes half a second to import, which commands without figures need not wait for.
    from matrixworld import plots

    training: dict[str, Callable[[], Figure]] = {"training": partial(_training, run)}
    if isinstance(run.settings, SingleSettings):
        return training
    matrix, title = run.payoff.capture_rate, run.settings.schedule
    return training | {
        "payoff": partial(plots.payoff_heatmap, matrix, title=title),
        "generalization": partial(plots.generalization_curves, matrix),
        "lag_profile": partial(plots.lag_profile_curve, matrix),
        "collisions": lambda: plots.collision_rates(collisions_per_1000(run.payoff)),
    }


def _training(run: Result) -> Figure:
    from matrixworld import plots

    log, settings = run.files.log(), run.settings
    rates, learners = log["capture_rate"], log["team"] == "evader"
    if isinstance(settings, SingleSettings):
        title = f"Capture rate while {settings.team}s learn"
        window = max(1, settings.epochs // LONGEST)
        return plots.training_curve(rates, learners, window=window, title=title)
    # The same window for both teams, so it must fit into the shorter team phase.
    window = max(1, min(settings.epochs(team) for team in TEAMS) // WINDOWS)
    generations = log["generation"]
    if settings.schedule != HALL_OF_FAME:
        return plots.training_curve(rates, learners, generations=generations, window=window)
    # Both teams learn from the same matches there, and each logs a row of them: keep one.
    once = ~learners
    title = "Capture rate while both teams learn"
    return plots.training_curve(
        rates[once], None, generations=generations[once], window=window, title=title
    )


def collisions_per_1000(payoff: Payoff) -> NDArray[np.float64]:
    """Return how often the agents of each generation collide, against all opponents.

    Parameters
    ----------
    payoff : Payoff
        Of G generations of each team.

    Returns
    -------
    ndarray of float64, shape (G, 2, 3)
        Agent-steps in collision in 1000 agent-steps, by team and kind.
    """
    collisions, steps = payoff.collisions, payoff.agent_steps[..., np.newaxis]
    # A pursuer generation is a row of the payoff, an evader generation a column.
    pursuers = collisions[:, :, 0].sum(axis=1) / steps[:, :, 0].sum(axis=1)
    evaders = collisions[:, :, 1].sum(axis=0) / steps[:, :, 1].sum(axis=0)
    return 1000 * np.stack([pursuers, evaders], axis=1)
