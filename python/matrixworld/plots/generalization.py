"""Figure of generalisation over seeds, beside teams that were trained in another way."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from matrixworld import analysis
from matrixworld._util import colors
from matrixworld.analysis.payoffs import check_rates
from matrixworld.plots.style import (
    DASHES,
    draw_band,
    fitting,
    legend_below,
    new_figure,
    unit_axis,
    whole_numbers,
    wrapped,
)

Baselines = Mapping[str, Mapping[str, ArrayLike]]
"""Scores (seeds,) of teams that were trained in another way, by race and by their name."""

NAME = 28
"""Characters of a line of a race's name."""


def generalization_over_seeds(
    payoffs: Mapping[str, Iterable[ArrayLike]],
    *,
    pursuer_baselines: Baselines | None = None,
    evader_baselines: Baselines | None = None,
    title: str = "Generalisation: mean score against all opponents",
) -> Figure:
    """Draw the mean score of each generation against all opponents, with intervals over seeds.

    The score of pursuers is the capture rate, that of evaders is 1 minus the capture rate.

    Parameters
    ----------
    payoffs : mapping of str to iterable of array_like of float, shape (n, m)
        Payoff matrix of each seed, by the name of the race, such as its schedule. Each name has a
        panel.
    pursuer_baselines, evader_baselines : mapping of str to mapping of str to array_like, optional
        For the races named in `payoffs`: mean scores in [0, 1] against the same opponents, one for
        each seed, of teams that were trained in another way, by their name. Each is a level line
        at its mean, and a band for its interval.
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure. Bands are 95% intervals of the mean over seeds.

    Raises
    ------
    ValueError
        If there is no race, a baseline is of none of them or outside [0, 1], or as
        :func:`matrixworld.analysis.race_bands` does.
    """
    if not payoffs:
        raise ValueError("expected at least one race to draw, got none")
    baselines = (pursuer_baselines or {}, evader_baselines or {})
    for name in [name for team in baselines for name in team if name not in payoffs]:
        raise ValueError(f"baselines: expected names of {', '.join(payoffs)}, got {name!r}")
    figure = new_figure(max(5.6, 1.0 + 3.6 * len(payoffs)), 4.4)
    panels = figure.subplots(1, len(payoffs), sharey=True, squeeze=False)[0]
    for axes, (name, matrices) in zip(panels, payoffs.items(), strict=True):
        _draw_race(axes, list(matrices), [team.get(name, {}) for team in baselines])
        axes.set_title(wrapped(name, NAME), size="medium", fontweight="bold")
    panels[0].set_ylabel("mean score (0 to 1)")
    entries = {
        label: handle
        for axes in panels
        for handle, label in zip(*axes.get_legend_handles_labels(), strict=True)
    }
    legend_below(figure, [*entries.values()], [*entries], columns=2)
    figure.suptitle(fitting(figure, title))
    return figure


def _draw_race(
    axes: Axes, matrices: list[ArrayLike], baselines: list[Mapping[str, ArrayLike]]
) -> None:
    bands = analysis.race_bands(matrices)
    teams = (bands.pursuer_generalization, bands.evader_generalization)
    labels = ("pursuers: capture rate", "evaders: 1 - capture rate")
    for band, color, label in zip(teams, colors.TEAMS, labels, strict=True):
        draw_band(axes, np.arange(len(band.mean)), band, color, "-", label=label)
    for color, team in zip(colors.TEAMS, baselines, strict=True):
        for index, (name, scores) in enumerate(team.items()):
            _draw_baseline(axes, name, scores, color, DASHES[index % len(DASHES)])
    if len(matrices) > 1:
        # An empty band for the legend, whose entry is of all curves.
        label = "95% interval of the mean over seeds"
        axes.fill_between([], [], [], color=colors.MUTED, alpha=0.22, linewidth=0, label=label)
    axes.set_xlabel("generation")
    axes.xaxis.set_major_locator(whole_numbers(6))
    axes.margins(x=0.02)
    unit_axis(axes)


def _draw_baseline(axes: Axes, name: str, scores: ArrayLike, color: str, dashes: str) -> None:
    values = check_rates(scores, ndim=1, what=f"baseline {name!r}")
    level = analysis.interval_over_runs(values, bounds=(0.0, 1.0))
    axes.axhline(level.value, color=color, linestyle=dashes, linewidth=1.3, label=name)
    if level.low is not None and level.high is not None:
        axes.axhspan(level.low, level.high, color=color, alpha=0.1, linewidth=0)
