"""The look that all figures share: size, legend, axes."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from matrixworld._util import colors
from matrixworld.analysis import Band

DPI = 150
"""Resolution of saved figures."""

TITLE_CHARACTERS = 9
"""Characters of a title for each inch of the width of a figure."""

DASHES = ("--", ":", "-.")
"""Line styles beside the solid one."""


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure; sizes are in inches."""
    layout = ConstrainedLayoutEngine(w_pad=0.06, h_pad=0.06)
    return Figure(figsize=(width, height), dpi=DPI, layout=layout)


def wrapped(text: str, width: int) -> str:
    """Return text in lines of at most `width` characters; paths may break after a slash."""
    lines = [textwrap.wrap(line.replace("/", "/ "), width) for line in text.splitlines()]
    return "\n".join(part.replace("/ ", "/") for line in lines for part in line)


def fitting(figure: Figure, title: str) -> str:
    """Return a title in as many lines as it needs in a figure."""
    return wrapped(title, int(TITLE_CHARACTERS * figure.get_figwidth()))


def legend_below(
    figure: Figure, handles: Sequence[Artist], labels: Sequence[str], *, columns: int = 2
) -> None:
    """Add a legend below all axes of a figure."""
    figure.legend(handles, labels, loc="outside lower center", ncols=columns, frameon=False)


def unit_axis(axes: Axes) -> None:
    """Let the vertical axis show rates from 0 to 1, with room for lines at both ends."""
    axes.set_ylim(-0.02, 1.02)
    axes.set_yticks(np.linspace(0.0, 1.0, 6))
    plain_axis(axes)


def plain_axis(axes: Axes) -> None:
    """Draw a light grid below the curves, and no frame above and on the right."""
    axes.grid(color=colors.GRID, linewidth=0.8)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def whole_numbers(at_most: int) -> MaxNLocator:
    """Return a locator of ticks at whole numbers, for generations and epochs."""
    return MaxNLocator(nbins=at_most, steps=[1, 2, 5, 10], integer=True)


def draw_band(
    axes: Axes, places: ArrayLike, band: Band, color: str, line: str, *, label: str = ""
) -> None:
    """Draw a mean curve, and its interval as a band if it has one."""
    axes.plot(places, band.mean, color=color, linestyle=line, linewidth=1.7, label=label or None)
    if band.low is not None and band.high is not None:
        axes.fill_between(places, band.low, band.high, color=color, alpha=0.22, linewidth=0)
