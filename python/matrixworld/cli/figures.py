"""The figures of finished runs."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import headline
from matrixworld.cli.arguments import run_name
from matrixworld.cli.baselines import baseline_scores
from matrixworld.coevolution.opponents.registry import HALL_OF_FAME
from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.coevolution.storage.saved_run import SavedRun
from matrixworld.coevolution.types import TEAMS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from matrixworld.cli.jobs import Result
    from matrixworld.coevolution.payoff import Payoff

WINDOWS = 4
"""Windows of the moving average of a training curve in the shorter team phase of a generation."""
LONGEST = 100
"""Windows of the moving average in the run of one team alone."""


@dataclass(frozen=True)
class Selection:
    """Which figures of a run are drawn, and how.

    Parameters
    ----------
    name : str, optional
        Name of the only figure. By default all are drawn.
    suffix : str, optional
        Format of the files.
    baselines : mapping of str to list of SavedRun, optional
        Other teams for the figure of generalisation, by name.
    """

    name: str | None = None
    suffix: str = "png"
    baselines: Mapping[str, Sequence[SavedRun]] = field(default_factory=dict)


ALL = Selection()

FORMATS = ("png", "pdf", "svg")
"""As in `matrixworld.plots`, whose import takes half a second."""


def format_of(path: Path) -> str:
    """Return the format of a figure's file by its suffix; ValueError for another one."""
    from matrixworld import plots

    return plots.format_of(path)


def figure_files(run: Result, selection: Selection = ALL) -> list[Path]:
    """Return the files that `draw_run` writes."""
    return [run.path / f"{name}.{selection.suffix}" for name in _figures(run, selection)]


def draw_run(run: Result, selection: Selection = ALL) -> Sequence[Path]:
    """Draw figures of a finished run into its directory; returns their files."""
    drawn = _figures(run, selection).values()
    files = figure_files(run, selection)
    return [save_figure(draw(), file) for draw, file in zip(drawn, files, strict=True)]


def draw_one(run: Result, selection: Selection, path: Path) -> Path:
    """Draw the only selected figure of a run to a file; returns it."""
    (draw,) = _figures(run, selection).values()
    return save_figure(draw(), path)


OF_GAME = {
    "rules": "rules_table",
    "conflicts": "conflict_outcomes",
    "interaction": "interaction_models",
}
"""Figures of the game, which need no run: the functions of `matrixworld.plots` that draw them."""
OF_RACE = ("training", "payoff", "generalization", "lag_profile", "collisions")
"""Figures of a race. A run of one team has the first one only."""


def draw_of_game(name: str, path: Path) -> Path:
    """Draw a figure that needs no run to a file; returns it."""
    from matrixworld import plots

    return save_figure(getattr(plots, OF_GAME[name])(), path)


def draw_comparison(races: Mapping[str, Result], path: Path) -> Path:
    """Draw races side by side, each under its name and its judgement; returns the file."""
    from matrixworld import plots

    named = {f"{name}, seed {race.settings.seed}": race for name, race in races.items()}
    payoffs = {name: race.payoff.capture_rates for name, race in named.items()}
    judgements = {name: race.judgement for name, race in named.items()}
    return save_figure(plots.comparison(payoffs, judgements, per_episode=True), path)


def run_title(path: Path, settings: RaceSettings | SingleSettings) -> str:
    """Return the name of a run in figures, with its schedule and its seed."""
    name = run_name(path)
    if isinstance(settings, RaceSettings) and settings.schedule != name:
        name = f"{name} ({settings.schedule})"
    return f"{name}, seed {settings.seed}"


def save_figure(figure: Figure, path: Path) -> Path:
    """Write a figure in the format of its suffix, complete or not at all; returns the file."""
    from matrixworld import plots

    return plots.save_figure(figure, path)


def _figures(run: Result, selection: Selection) -> dict[str, Callable[[], Figure]]:
    """Return functions that draw a run's figures, by the names of the files."""
    figures = {name: partial(draw, run) for name, draw in _DRAWN.items()}
    figures["generalization"] = partial(_generalization, run, selection.baselines)
    has = OF_RACE if run.is_race else OF_RACE[:1]
    return {name: figures[name] for name in has if selection.name in (None, name)}


def _payoff(run: Result) -> Figure:
    from matrixworld import plots

    title = _title(run, headline(run.judgement))
    return plots.payoff_heatmap(run.payoff.capture_rate, title=title)


def _generalization(run: Result, baselines: Mapping[str, Sequence[SavedRun]]) -> Figure:
    from matrixworld import plots

    scores = baseline_scores(run, baselines)
    return plots.generalization_curves(
        run.payoff.capture_rates,
        per_episode=True,
        pursuer_baselines=scores["pursuer"],
        evader_baselines=scores["evader"],
        title=_title(run, "Mean score against all opponents"),
    )


def _lag_profile(run: Result) -> Figure:
    from matrixworld import plots

    return plots.lag_profile_curve(run.payoff.capture_rate, title=_title(run, "Lag profile"))


def _collisions(run: Result) -> Figure:
    from matrixworld import plots

    title = _title(run, "Collisions per 1000 agent-steps")
    return plots.collision_rates(collisions_per_1000(run.payoff), title=title)


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


# Functions that draw one run, by the names of the files. Matplotlib takes half a second to import,
# so each imports it, and commands without figures need not wait.
_DRAWN: dict[str, Callable[[Result], Figure]] = {
    "training": _training,
    "payoff": _payoff,
    "lag_profile": _lag_profile,
    "collisions": _collisions,
}


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
