"""Figures of any number that several runs gave, and of their scores against held-out opponents."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike

from matrixworld import analysis
from matrixworld._util import colors
from matrixworld.analysis.payoffs import Rates, check_rates
from matrixworld.plots.style import (
    DASHES,
    LINES,
    MOST_LINES,
    check_some,
    draw_band,
    fitting,
    legend_below,
    new_figure,
    plain_axis,
    unit_axis,
    whole_numbers,
    wrapped,
)

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
    """
    check_some(groups)
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
    """
    check_some(groups)
    figure = new_figure(6.6, 3.6)
    axes = figure.add_subplot()
    for index, (name, curves) in enumerate(groups.items()):
        color, style = LINES[index % len(LINES)]
        band = analysis.band_over_runs(curves, places=places)
        if len(np.asarray(curves)) <= MOST_LINES:
            # Smooth edges of many thin lines would make the picture several times as large.
            look: dict[str, Any] = {"alpha": 0.35, "linewidth": 0.6, "antialiased": False}
            axes.plot(band.places, np.asarray(curves).T, color=color, **look)
        draw_band(axes, band, color, style, label=name)
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


# ---- Scores against held-out opponents -----------------------------------------------------------

SCORES = {"pursuer": "capture rate", "evader": "escape rate"}
"""What the score of a team is called."""


def seed_scores(
    scores: Mapping[str, Mapping[str, ArrayLike]],
    *,
    title: str = "Scores of the last generation against held-out opponents",
) -> Figure:
    """Draw scores of groups of runs: performance profiles and interquartile means.

    A row for each team. On the left the share of all scores (runs times opponents) above each
    threshold, with its pointwise 95% interval over seeds. On the right the interquartile mean with
    its 95% interval, and the mean score of each seed as a dot.

    Parameters
    ----------
    scores : mapping of str to mapping of str to array_like of float, shape (seeds, opponents)
        Scores in [0, 1] by the name of the group, then by team: ``"pursuer"``, ``"evader"``.
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure. Groups with few seeds have no intervals, see
        :func:`matrixworld.analysis.fewest_runs`.
    """
    check_some(scores)
    arrays = {
        group: {
            team: check_rates(values, ndim=2, what=f"scores of {group}")
            for team, values in of_teams.items()
        }
        for group, of_teams in scores.items()
    }
    teams = [team for team in SCORES if any(team in each for each in arrays.values())]
    figure = new_figure(9.4, 0.9 + max(3.0, 0.55 * len(arrays) + 1.4) * len(teams))
    grid = figure.subplots(len(teams), 2, squeeze=False, width_ratios=(1.25, 1.0))
    for (left, right), team in zip(grid, teams, strict=True):
        of_team = {group: each[team] for group, each in arrays.items() if team in each}
        _draw_profiles(left, of_team, team)
        _draw_middles(right, of_team, team)
    _write_legend(figure, arrays)
    figure.suptitle(fitting(figure, title))
    return figure


def _draw_profiles(axes: Axes, scores: Mapping[str, Rates], team: str) -> None:
    for (color, style), values in zip(LINES, scores.values(), strict=False):
        shares = analysis.performance_profile(values)
        axes.step(
            shares.places, shares.mean, color=color, linestyle=style, linewidth=1.6,
            where="post",
        )  # fmt: skip
        if shares.low is not None and shares.high is not None:
            axes.fill_between(
                shares.places, shares.low, shares.high, color=color, alpha=0.15, linewidth=0,
                step="post",
            )  # fmt: skip
    axes.set(xlabel=f"threshold of the {SCORES[team]}", ylabel="share of scores above it")
    axes.set_title(f"{team}s: performance profile", size="medium")
    axes.set_xlim(-0.01, 1.01)
    unit_axis(axes)


def _draw_middles(axes: Axes, scores: Mapping[str, Rates], team: str) -> None:
    for row, ((color, _), values) in enumerate(zip(LINES, scores.values(), strict=False)):
        middle = analysis.interquartile_mean(values)
        means = values.mean(axis=1)
        # Seeds with equal means lie beside each other.
        spread = np.linspace(-0.16, 0.16, len(means)) if len(means) > 1 else np.zeros(1)
        axes.scatter(means, row + 0.12 + spread, s=12, color=color, alpha=0.45, linewidth=0)
        if middle.low is not None and middle.high is not None:
            axes.plot([middle.low, middle.high], [row - 0.22] * 2, color=color, linewidth=2.2)
        axes.plot(middle.value, row - 0.22, marker="D", markersize=6, color=color)
    names = [f"{wrapped(name, WIDEST)} ({len(values)} seeds)" for name, values in scores.items()]
    axes.set_yticks(np.arange(len(names)), names, size="small")
    axes.set(xlim=(-0.02, 1.02), ylim=(len(names) - 0.5, -0.5), xlabel=SCORES[team])
    axes.set_title(f"{team}s: interquartile mean", size="medium")
    plain_axis(axes)


def _write_legend(figure: Figure, groups: Mapping[str, object]) -> None:
    handles = [
        Line2D([], [], color=color, linestyle=style, linewidth=1.6)
        for (color, style), _ in zip(LINES, groups, strict=False)
    ]
    marks = [
        Line2D([], [], color=colors.MUTED, marker="D", linewidth=2.2),
        Line2D([], [], color=colors.MUTED, marker="o", markersize=4, linewidth=0, alpha=0.6),
    ]
    labels: Sequence[str] = [
        *groups,
        f"interquartile mean, 95% interval from {analysis.fewest_runs()} seeds on",
        "mean of one seed",
    ]
    legend_below(figure, [*handles, *marks], labels, columns=min(3, len(labels)))
