"""Figures of a race while it learns: capture rates and collisions over time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import ArrayLike, NDArray

from matrixworld._util import colors
from matrixworld._util.checks import check_integer
from matrixworld.analysis.payoffs import check_finite, check_rates, require
from matrixworld.plots import style
from matrixworld.world.rules import COLLISION_KINDS

ROUND = tuple(step * 10**power for power in range(7) for step in (1, 2, 5))  # distances of ticks
_SHADE = "#E4F0F8"  # a pale tone of the evaders, light in grey, too
_MARKED = 100  # curves with up to this many points have a marker at each


def training_curve(
    rates: ArrayLike,
    learners: ArrayLike | None,
    *,
    generations: ArrayLike | None = None,
    window: int = 1,
    teams: Sequence[str] = style.TEAMS,
    title: str | None = None,
) -> Figure:
    """Draw the score over training, coloured by the team that learns.

    Parameters
    ----------
    rates : array_like of float, shape (T,)
        Score of the first team at each epoch, of pursuit the capture rate.
    learners : array_like of int, shape (T,), or None
        0 where the first team learns, 1 where the second one learns. None if both learn all the
        time.
    generations : array_like of int, shape (T,), optional
        Generation of each point, for a second axis on top.
    window : int, optional
        Points of a centred moving average (the paper's figure uses 30). With more than 1 the raw
        curve is drawn thin behind the mean.
    teams : sequence of str, optional
        Names of the teams: that of the rows, then that of the columns.
    title : str, optional
    """
    words = style.words_of(teams)
    values = check_rates(rates, ndim=1, what="training capture rates")
    window = check_integer("window", window, 1)
    shades = _shades(learners, len(values))
    evaders_learn = [shade == colors.EVADER for shade in shades]
    figure = style.new_figure(8.0, 3.8)
    axes = figure.add_subplot()
    if window > 1:
        axes.add_collection(_in_pieces(values, shades, alpha=0.25, linewidth=0.6))
    place = np.arange(1, len(values) + 1)
    if learners is not None:
        # In grey the curves of both teams have the same tone.
        axes.fill_between(
            place, 0, 1, where=evaders_learn, color=_SHADE, linewidth=0, zorder=0, step="mid",
            transform=axes.get_xaxis_transform(),
        )  # fmt: skip
    smooth = _moving_average(values, window)
    axes.add_collection(_in_pieces(smooth, shades, linewidth=1.6))
    if len(values) <= _MARKED:
        axes.scatter(place, smooth, s=14, c=shades, zorder=3)
    if title is None:
        title = words.begin(f" while {' and '.join(teams)} learn in turn")
    axes.set_title(style.fitting(figure, title))
    axes.set(xlabel="epoch", xlim=(0.5, len(values) + 0.5))
    axes.set_ylabel(f"{words.score}, mean of {window} epochs" if window > 1 else words.score)
    axes.xaxis.set_major_locator(style.whole_numbers())
    style.unit_axis(axes)
    if generations is not None:
        _generation_axis(axes, check_finite(generations, "generations", ndim=1), len(values))
    entries: dict[str, Any] = {
        f"{team} learn": (*behind, Line2D([], [], color=color))
        for team, color, behind in zip(
            words.teams, colors.TEAMS, ((), (Patch(color=_SHADE),)), strict=True
        )
        if color in shades
    }
    if entries:
        style.legend_below(figure, entries, columns=4)
    return figure


def collision_rates(
    rates: ArrayLike, *, title: str = "Collisions per 1000 agent-steps, by kind"
) -> Figure:
    """Draw collisions over generations, one panel per team.

    Parameters
    ----------
    rates : array_like of float, shape (G, 2, 3)
        Collisions per 1000 agent-steps of the generations 0, 1 and so on, by team (pursuers,
        evaders) and kind (obstacle, teammate, adversary).
    title : str, optional
    """
    values = check_finite(rates, "collision rates (G, 2, 3)", ndim=3)
    require(values.shape[1:] == (2, 3), "collision rates of shape (G, 2, 3)", values.shape)
    require(values.min() >= 0.0, "collision rates of at least 0", values.min())
    figure = style.new_figure(8.4, 3.8)
    panels = figure.subplots(1, 2, sharey=True)
    for team, axes in enumerate(panels):
        _draw_collisions(axes, values[:, team], style.TEAMS[team], colors.TEAMS[team])
    panels[0].set_ylabel("collisions per 1000 agent-steps")
    panels[0].set_ylim(bottom=0.0)
    return style.finished(figure, style.labelled(panels[0]), title, columns=3)


def _draw_collisions(axes: Axes, rates: NDArray[np.float64], team: str, color: str) -> None:
    marker = "o" if len(rates) <= _MARKED else ""
    for kind, curve in enumerate(rates.T):
        axes.plot(
            curve, label=f"with {COLLISION_KINDS[kind]}", color=colors.CONFLICTS[kind],
            linestyle=("-", *style.DASHES)[kind], marker=marker, markersize=3,
        )  # fmt: skip
    axes.set_title(team, color=color)
    axes.set_xlabel("generation")
    axes.xaxis.set_major_locator(style.whole_numbers())
    style.plain_axis(axes)


def _shades(learners: ArrayLike | None, length: int) -> list[str]:
    if learners is None:
        return [colors.INK] * length
    teams = check_rates(learners, ndim=1, what="learners, 0 for pursuers and 1 for evaders,")
    require(len(teams) == length, f"{length} learners", len(teams))
    require(bool(np.isin(teams, (0, 1)).all()), "learners 0 or 1", np.unique(teams)[:5])
    return [colors.TEAMS[int(team)] for team in teams]


def _in_pieces(values: NDArray[np.float64], shades: list[str], **style: Any) -> LineCollection:
    """Return the curve, each piece in the colour of the point that it leads to."""
    points = np.column_stack([np.arange(1, len(values) + 1), values])
    pieces = np.stack([points[:-1], points[1:]], axis=1)
    return LineCollection(list(pieces), colors=shades[1:], capstyle="round", **style)


def _moving_average(values: NDArray[np.float64], window: int) -> NDArray[np.float64]:
    """Return the centred mean of `window` points, and of fewer at both ends."""
    window = min(window, len(values))
    kernel = np.ones(window)
    # Dividing by the points inside the window keeps both ends from being drawn towards 0.
    counts = np.convolve(np.ones(len(values)), kernel, mode="same")
    average: NDArray[np.float64] = np.convolve(values, kernel, mode="same") / counts
    return average


def _generation_axis(axes: Axes, generations: NDArray[np.float64], length: int) -> None:
    """Add a second axis on top that shows where each generation begins."""
    require(generations.shape == (length,), f"generations of shape ({length},)", generations.shape)
    names, starts = np.unique(generations, return_index=True)
    every = next(each for each in ROUND if len(names) <= 10 * each)
    shown = names % every == 0
    top = axes.secondary_xaxis("top")
    top.set_xticks(starts[shown] + 1, [f"{name:.0f}" for name in names[shown]])
    top.set_xlabel("generation")
