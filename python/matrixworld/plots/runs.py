"""Figures of any number that several runs gave: one dot for each run, or mean curves with bands."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from matrixworld import analysis
from matrixworld._util import colors
from matrixworld.plots.style import (
    DASHES,
    draw_band,
    fitting,
    legend_below,
    new_figure,
    plain_axis,
    whole_numbers,
    wrapped,
)

LINES = tuple(
    (color, style)
    for style in ("-", *DASHES)
    for color in (colors.BLUE, colors.VERMILLION, colors.GREEN, colors.PURPLE, colors.ORANGE)
)
"""Colour and dashes of each group of curves, in their order."""
MOST_LINES = 10
"""With more runs the single ones are not drawn: their lines would hide the band."""
WIDEST = 26
"""Characters of a line of a group's name."""


def run_dots(
    groups: Mapping[str, ArrayLike],
    *,
    label: str,
    levels: Mapping[str, float] | None = None,
    each: str = "one run",
    title: str | None = None,
) -> Figure:
    """Draw one number of each run as a dot, and the mean of each group with its 95% interval.

    Parameters
    ----------
    groups : mapping of str to array_like of float, shape (runs,)
        Numbers by the name of the group. Each group has a row.
    label : str
        What the numbers are.
    levels : mapping of str to float, optional
        Numbers to compare with, by name; each is a vertical line.
    each : str, optional
        What a dot stands for.
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure. The interval is that of :func:`matrixworld.analysis.interval_over_runs`.

    Raises
    ------
    ValueError
        If there is no group, or as `interval_over_runs` does.
    """
    if not groups:
        raise ValueError("expected at least one group of runs to draw, got none")
    figure = new_figure(6.6, 1.5 + 0.5 * len(groups))
    axes = figure.add_subplot()
    for row, values in enumerate(groups.values()):
        _draw_dots(axes, row, analysis.interval_over_runs(values), np.asarray(values))
    for dashes, (name, level) in zip(DASHES * len(groups), (levels or {}).items(), strict=False):
        axes.axvline(level, color=colors.MUTED, linestyle=dashes, linewidth=1.3, label=name)
    axes.scatter([], [], s=16, color=colors.SKY_BLUE, label=each)
    axes.errorbar([], [], xerr=[], fmt="D", color=colors.INK, label="mean, 95% interval")
    axes.set_yticks(range(len(groups)), [wrapped(name, WIDEST) for name in groups])
    axes.set_ylim(len(groups) - 0.5, -0.5)
    axes.set_xlabel(label)
    plain_axis(axes)
    axes.grid(visible=False, axis="y")
    legend_below(figure, *axes.get_legend_handles_labels(), columns=4)
    if title:
        figure.suptitle(fitting(figure, title))
    return figure


def _draw_dots(axes: Axes, row: int, mean: analysis.Estimate, values: np.ndarray) -> None:
    # Equal values lie on top of each other, so the dots are spread over the height of the row.
    heights = row - 0.22 + 0.12 * (np.arange(len(values)) % 3 - 1)
    axes.scatter(values, heights, s=16, color=colors.SKY_BLUE, edgecolor=colors.BLUE, linewidth=0.4)
    if mean.low is not None and mean.high is not None:
        axes.plot([mean.low, mean.high], [row + 0.2] * 2, color=colors.INK, linewidth=1.8)
    axes.plot(mean.value, row + 0.2, "D", color=colors.INK, markersize=5)


def run_curves(
    groups: Mapping[str, ArrayLike],
    *,
    label: str,
    places: ArrayLike | None = None,
    along: str = "generation",
    title: str | None = None,
) -> Figure:
    """Draw mean curves over runs with their 95% bands.

    Thin lines are single runs, if there are at most `MOST_LINES` in the group.

    Parameters
    ----------
    groups : mapping of str to array_like of float, shape (runs, k)
        Curves of the runs by the name of the group.
    label : str
        What the numbers are.
    places : array_like of float, shape (k,), optional
        Where the points lie along the horizontal axis. The default is 0, 1, ...
    along : str, optional
        Label of the horizontal axis.
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure. Bands are those of :func:`matrixworld.analysis.band_over_runs`.

    Raises
    ------
    ValueError
        If there is no group, or as `band_over_runs` does.
    """
    if not groups:
        raise ValueError("expected at least one group of runs to draw, got none")
    figure = new_figure(6.6, 3.6)
    axes = figure.add_subplot()
    for index, (name, curves) in enumerate(groups.items()):
        color, style = LINES[index % len(LINES)]
        band = analysis.band_over_runs(curves)
        where = np.arange(len(band.mean)) if places is None else np.asarray(places)
        if len(np.asarray(curves)) <= MOST_LINES:
            # Smooth edges of many thin lines would make the picture several times as large.
            look: dict[str, Any] = {"alpha": 0.35, "linewidth": 0.6, "antialiased": False}
            axes.plot(where, np.asarray(curves).T, color=color, **look)
        draw_band(axes, where, band, color, style, label=name)
    if min(len(np.asarray(curves)) for curves in groups.values()) <= MOST_LINES:
        axes.plot([], [], color=colors.MUTED, alpha=0.6, linewidth=0.6, label="single run")
    axes.fill_between([], [], [], color=colors.MUTED, alpha=0.3, linewidth=0, label="95% interval")
    axes.set(xlabel=along, ylabel=label)
    axes.xaxis.set_major_locator(whole_numbers(8))
    axes.margins(x=0.02)
    plain_axis(axes)
    handles, labels = axes.get_legend_handles_labels()
    legend_below(figure, handles, labels, columns=4 if len(labels) <= 4 else 3)
    if title:
        figure.suptitle(fitting(figure, title))
    return figure
