"""Figure of held-out scores of several seeds: performance profiles and interquartile means."""

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
    fitting,
    legend_below,
    new_figure,
    plain_axis,
    unit_axis,
    wrapped,
)

LINES: tuple[tuple[str, Any], ...] = tuple(
    (color, style)
    for style in ("-", *DASHES)
    for color in (colors.BLUE, colors.VERMILLION, colors.GREEN, colors.PURPLE, colors.ORANGE)
)
"""Colour and dashes of each group, in their order."""
SCORES = {"pursuer": "capture rate", "evader": "escape rate"}
"""What the score of a team is called."""
WIDEST = 24
"""Characters of a line of a group's name."""


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

    Raises
    ------
    ValueError
        If there is no group, or scores are not as described.
    """
    if not scores:
        raise ValueError("expected at least one group of runs to draw, got none")
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
        profile = analysis.performance_profile(values)
        shares = profile.shares
        axes.step(
            profile.thresholds, shares.mean, color=color, linestyle=style, linewidth=1.6,
            where="post",
        )  # fmt: skip
        if shares.low is not None and shares.high is not None:
            axes.fill_between(
                profile.thresholds, shares.low, shares.high, color=color, alpha=0.15, linewidth=0,
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
