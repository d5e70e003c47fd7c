"""Figure of one number of several seeds: a dot for each seed, and the interval of the mean."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from matrixworld import analysis, colors
from matrixworld.plots.style import fitting, new_figure, plain_axis


def seed_strip(values: Mapping[str, ArrayLike], label: str, *, title: str = "") -> Figure:
    """Draw one number of each seed as a dot, in a row for each group of runs.

    Parameters
    ----------
    values : mapping of str to array_like of float, shape (seeds,)
        The number of each seed, by the name of the group.
    label : str
        What the number is, with its unit.
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure. An upright line is the mean over the seeds, a thick bar its 95% interval (see
        :func:`matrixworld.analysis.interval_over_runs`).

    Raises
    ------
    ValueError
        If there is no group, or as `interval_over_runs` does.
    """
    if not values:
        raise ValueError("values: expected at least one group of runs to draw, got none")
    figure = new_figure(6.8, 0.8 + 0.36 * len(values) + 0.3 * bool(title))
    axes = figure.add_subplot()
    for row, each in enumerate(values.values()):
        numbers = np.asarray(each, dtype=np.float64)
        mean = analysis.interval_over_runs(numbers)
        axes.plot(numbers, np.full(len(numbers), row), "o", color=colors.BLUE, alpha=0.35)
        if mean.low is not None and mean.high is not None:
            axes.plot([mean.low, mean.high], [row, row], color=colors.INK, linewidth=3.0)
        axes.plot(mean.value, row, "|", color=colors.INK, markersize=14, markeredgewidth=2.0)
    axes.set_yticks(range(len(values)), [*values])
    axes.set(xlabel=label, ylim=(len(values) - 0.5, -0.5))
    plain_axis(axes)
    if title:
        axes.set_title(fitting(figure, title))
    return figure
