"""The figures of finished runs."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import headline
from matrixworld.coevolution.opponents.registry import HALL_OF_FAME
from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.coevolution.types import TEAMS
from matrixworld.files import replacing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from matrixworld.cli.jobs import Result
    from matrixworld.coevolution.payoff import Payoff

WINDOWS = 4
"""Windows of the moving average of a training curve in the shorter team phase of a generation."""
LONGEST = 100
"""Windows of the moving average in the run of one team alone."""


def figure_files(run: Result) -> list[Path]:
    """Return the files that `draw_run` writes."""
    return [run.path / f"{name}.png" for name in _figures(run)]


def draw_run(run: Result) -> Sequence[Path]:
    """Draw all figures of a finished run into its directory; returns their files."""
    for name, draw in _figures(run).items():
        save_figure(draw(), run.path / f"{name}.png")
    return figure_files(run)


def draw_comparison(races: Mapping[str, Result], path: Path) -> Path:
    """Draw races side by side, each under its name and its judgement; returns the file."""
    from matrixworld import plots

    named = {f"{name}, seed {race.settings.seed}": race for name, race in races.items()}
    payoffs = {name: race.payoff.capture_rates for name, race in named.items()}
    judgements = {name: race.judgement for name, race in named.items()}
    return save_figure(plots.comparison(payoffs, judgements, per_episode=True), path)


def run_title(path: Path, settings: RaceSettings | SingleSettings) -> str:
    """Return the name of a run in figures: its directory, its schedule and its seed."""
    name = path.absolute().name
    if isinstance(settings, RaceSettings) and settings.schedule != name:
        name = f"{name} ({settings.schedule})"
    return f"{name}, seed {settings.seed}"


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
    matrix, of_episodes = run.payoff.capture_rate, run.payoff.capture_rates
    return training | {
        "payoff": lambda: plots.payoff_heatmap(matrix, title=_title(run, headline(run.judgement))),
        "generalization": lambda: plots.generalization_curves(
            of_episodes, per_episode=True, title=_title(run, "Mean score against all opponents")
        ),
        "lag_profile": lambda: plots.lag_profile_curve(matrix, title=_title(run, "Lag profile")),
        "collisions": lambda: plots.collision_rates(
            collisions_per_1000(run.payoff), title=_title(run, "Collisions per 1000 agent-steps")
        ),
    }


def _title(run: Result, shown: str) -> str:
    """Return the title of a figure: which run, and what the figure shows."""
    return f"{run_title(run.path, run.settings)}\n{shown}"


def _training(run: Result) -> Figure:
    from matrixworld import plots

    log, settings = run.files.log(), run.settings
    rates, learners = log["capture_rate"], log["team"] == "evader"
    if isinstance(settings, SingleSettings):
        title = _title(run, f"Capture rate while {settings.team}s learn")
        window = max(1, settings.epochs // LONGEST)
        return plots.training_curve(rates, learners, window=window, title=title)
    # The same window for both teams, so it must fit into the shorter team phase.
    window = max(1, min(settings.epochs(team) for team in TEAMS) // WINDOWS)
    generations = log["generation"]
    if settings.schedule == HALL_OF_FAME:
        # Both teams learn from the same matches there, and each logs a row of them: keep one.
        once = ~learners
        return plots.training_curve(
            rates[once],
            None,
            generations=generations[once],
            window=window,
            title=_title(run, "Capture rate while both teams learn"),
        )
    title = _title(run, "Capture rate while pursuers and evaders learn in turn")
    return plots.training_curve(
        rates, learners, generations=generations, window=window, title=title
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
