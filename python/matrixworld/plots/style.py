"""What all figures share: size, title, legend, axes, and files: pixels or vector graphics."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.ticker import MaxNLocator

from matrixworld._util import colors
from matrixworld._util.files import replacing
from matrixworld.analysis import Band
from matrixworld.analysis.payoffs import require

DPI = 150
"""Resolution of saved figures."""

TITLE_CHARACTERS = 9
"""Characters of a title for each inch of the width of a figure."""

DASHES = ("--", ":", "-.")
"""Line styles beside the solid one."""
LINES: tuple[tuple[str, Any], ...] = tuple(
    (color, style)
    for style in ("-", *DASHES)
    for color in (colors.BLUE, colors.VERMILLION, colors.GREEN, colors.PURPLE, colors.ORANGE)
)
"""Colour and dashes of each group of runs, in their order."""
MOST_LINES = 10
"""With more runs the single ones are not drawn: their lines would hide the band."""


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


def check_some(groups: Mapping[str, object], what: str = "group of runs") -> None:
    """Raise ValueError if there is nothing to draw."""
    require(bool(groups), f"at least one {what} to draw", "none")


def rows_of(count: int, most: int) -> tuple[int, int]:
    """Return lines and columns of panels, so that lines are equally long: 5 of 4 are 3 and 2."""
    lines = -(-count // most)
    return lines, -(-count // lines)


def columns_of_three(
    figure: Figure, count: int, shape: tuple[int, int], *, heights: tuple[float, ...]
) -> list[list[Axes]]:
    """Return three panels below each other for each of `count` things, line by line."""
    lines, columns = shape
    grid = figure.subplots(3 * lines, columns, squeeze=False, height_ratios=heights * lines)
    panels = [[*grid[3 * line : 3 * line + 3, k]] for line, k in np.ndindex(lines, columns)]
    for axes in (axes for column in panels[count:] for axes in column):
        axes.remove()
    return panels[:count]


def labelled(*panels: Axes) -> dict[str, Artist]:
    """Return what is labelled in some panels, each label once, for a legend."""
    found = (axes.get_legend_handles_labels() for axes in panels)
    return {label: handle for each in found for handle, label in zip(*each, strict=True)}


def legend_below(figure: Figure, entries: Mapping[str, Artist], *, columns: int = 2) -> None:
    """Add a legend below all axes of a figure."""
    figure.legend(
        [*entries.values()], [*entries], loc="outside lower center", ncols=columns, frameon=False
    )


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


def draw_band(axes: Axes, band: Band, color: str, line: str, *, label: str = "") -> None:
    """Draw a mean curve, and its interval as a band if it has one."""
    look: dict[str, Any] = {"color": color, "linestyle": line, "linewidth": 1.7}
    axes.plot(band.places, band.mean, label=label or None, **look)
    if band.low is not None and band.high is not None:
        axes.fill_between(band.places, band.low, band.high, color=color, alpha=0.22, linewidth=0)


# ---- Files ---------------------------------------------------------------------------------------

FORMATS = ("png", "pdf", "svg")
"""Formats of figures, which are the suffixes of their files; pdf and svg are vector graphics."""

# TrueType fonts: journals refuse the other kind that Matplotlib writes. No date and no random names
# of parts, so that files under version control change with the figure only.
_LOOK: dict[Any, Any] = {"pdf.fonttype": 42, "svg.hashsalt": "matrixworld"}
_METADATA: dict[str, dict[str, Any]] = {
    "png": {"Software": "matrixworld"},
    "pdf": {"Creator": "matrixworld", "CreationDate": None},
    "svg": {"Creator": "matrixworld", "Date": None},
}


def format_of(path: Path) -> str:
    """Return the format of a figure's file by its suffix, or raise a ValueError."""
    suffix = path.suffix.lower().removeprefix(".")
    if suffix not in FORMATS:
        expected = ", ".join(f".{each}" for each in FORMATS)
        raise ValueError(f"{path}: expected a name that ends in {expected}, got {path.name!r}")
    return suffix


def save_figure(figure: Figure, path: Path) -> Path:
    """Write a figure, complete or not at all, in the format of the file's suffix; return the file.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
    path : Path
        The file: ``.png``, ``.pdf`` or ``.svg``. An older file is replaced.
    """
    kind = format_of(path)
    with mpl.rc_context(_LOOK), replacing(path) as file:
        figure.savefig(file, format=kind, metadata=_METADATA[kind])
    return path
