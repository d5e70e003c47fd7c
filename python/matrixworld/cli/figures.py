"""The figures of a finished run, drawn into its directory."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution import HALL_OF_FAME, TEAMS, Payoff, SavedRun, SingleSettings, open_run
from matrixworld.files import replacing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

WINDOWS = 4
"""Moving averages of a training curve that fit into the shorter half of a generation."""
LONGEST = 100
"""Moving averages that fit into the run of one team alone."""


def draw_run(path: Path) -> list[Path]:
    """Draw all figures of a finished run; returns their files."""
    drawn = []
    for name, figure in _figures(open_run(path)):
        drawn.append(save_figure(figure, path / f"{name}.png"))
    return drawn


def draw_comparison(payoffs: Mapping[str, NDArray[np.float64]], path: Path) -> Path:
    """Draw races side by side, by name."""
    from matrixworld import plots

    return save_figure(plots.comparison(payoffs), path)


def save_figure(figure: Figure, path: Path) -> Path:
    """Write a figure as PNG, complete or not at all."""
    with replacing(path) as file:
        figure.savefig(file, format="png")
    return path


def _figures(run: SavedRun) -> Iterator[tuple[str, Figure]]:
    from matrixworld import plots

    yield "training", _training(run)
    if isinstance(run.settings, SingleSettings):
        return
    payoff, title = run.payoff(), run.settings.schedule
    yield "payoff", plots.payoff_heatmap(payoff.capture_rate, title=title)
    yield "generalization", plots.generalization_curves(payoff.capture_rate)
    yield "lag_profile", plots.lag_profile_curve(payoff.capture_rate)
    yield "collisions", plots.collision_rates(collisions_per_1000(payoff))


def _training(run: SavedRun) -> Figure:
    from matrixworld import plots

    log, settings = run.files.log(), run.settings
    rates, learners = log["capture_rate"], log["team"] == "evader"
    if isinstance(settings, SingleSettings):
        title = f"Capture rate while {settings.team}s learn"
        window = max(1, settings.epochs // LONGEST)
        return plots.training_curve(rates, learners, window=window, title=title)
    window = max(1, min(settings.epochs(team) for team in TEAMS) // WINDOWS)
    generations = log["generation"]
    if settings.schedule != HALL_OF_FAME:
        return plots.training_curve(rates, learners, generations=generations, window=window)
    once = ~learners  # both teams have a row of one and the same matches
    title = "Capture rate while both teams learn"
    return plots.training_curve(
        rates[once], None, generations=generations[once], window=window, title=title
    )


def collisions_per_1000(payoff: Payoff) -> NDArray[np.float64]:
    """Collisions of each generation, ``(G, 2, 3)``, against all opponents of a (G, G) payoff.

    Agent-steps in collision, by team and kind, of 1000 steps of agents that are alive.
    """
    collisions, steps = payoff.collisions, payoff.agent_steps[..., np.newaxis]
    pursuers = collisions[:, :, 0].sum(axis=1) / steps[:, :, 0].sum(axis=1)
    evaders = collisions[:, :, 1].sum(axis=0) / steps[:, :, 1].sum(axis=0)
    return 1000 * np.stack([pursuers, evaders], axis=1)
