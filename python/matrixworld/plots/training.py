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
from numpy.typing import NDArray

from matrixworld._util import colors
from matrixworld.plots import style
from matrixworld.world.rules import COLLISION_KINDS

ROUND = tuple(step * 10**power for power in range(7) for step in (1, 2, 5))  # distances of ticks
_SHADE = "#E4F0F8"  # a pale tone of the evaders, light in grey, too
_MARKED = 100  # curves with up to this many points have a marker at each


def training_curve(
    rates: NDArray[np.float64],
    learners: NDArray[Any] | None,
    *,
    generations: NDArray[Any] | None = None,
    window: int = 1,
    teams: Sequence[str] = style.TEAMS,
    title: str = "",
) -> Figure:
    """Draw the score (T,) over epochs, coloured by the team that learns, with its moving average.

    `learners` (T,) are 0 and 1, or None if both learn; `generations` (T,) are on a second axis.
    """
    words = style.words_of(teams)
    shades = [colors.INK] * len(rates)
    if learners is not None:
        shades = [colors.TEAMS[int(team)] for team in learners]
    figure = style.new_figure(8.0, 3.8)
    axes = figure.add_subplot()
    if window > 1:
        axes.add_collection(_in_pieces(rates, shades, alpha=0.25, linewidth=0.6))
    place = np.arange(1, len(rates) + 1)
    if learners is not None:
        # In grey the curves of both teams have the same tone.
        axes.fill_between(
            place, 0, 1, where=learners == 1, color=_SHADE, linewidth=0, zorder=0, step="mid",
            transform=axes.get_xaxis_transform(),
        )  # fmt: skip
    smooth = _moving_average(rates, window)
    axes.add_collection(_in_pieces(smooth, shades, linewidth=1.6))
    if len(rates) <= _MARKED:
        axes.scatter(place, smooth, s=14, c=shades, zorder=3)
    axes.set_title(style.fitting(figure, title))
    axes.set(xlabel="epoch", xlim=(0.5, len(rates) + 0.5))
    axes.set_ylabel(f"{words.score}, mean of {window} epochs" if window > 1 else words.score)
    axes.xaxis.set_major_locator(style.whole_numbers())
    style.unit_axis(axes)
    if generations is not None:
        _generation_axis(axes, generations)
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


def collision_rates(rates: NDArray[np.float64], *, title: str) -> Figure:
    """Draw collisions per 1000 agent-steps (G, 2, 3) by generation, team and kind."""
    figure = style.new_figure(8.4, 3.8)
    panels = figure.subplots(1, 2, sharey=True)
    for team, axes in enumerate(panels):
        _draw_collisions(axes, rates[:, team], style.TEAMS[team], colors.TEAMS[team])
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


def _generation_axis(axes: Axes, generations: NDArray[Any]) -> None:
    """Add a second axis on top that shows where each generation begins."""
    names, starts = np.unique(generations, return_index=True)
    every = next(each for each in ROUND if len(names) <= 10 * each)
    shown = names % every == 0
    top = axes.secondary_xaxis("top")
    top.set_xticks(starts[shown] + 1, [f"{name:.0f}" for name in names[shown]])
    top.set_xlabel("generation")
