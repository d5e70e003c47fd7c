"""Figure of rules: variants of the game as rows of a table."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import FancyBboxPatch

from matrixworld._util import colors
from matrixworld.plots.style import fitting, new_figure
from matrixworld.world.rules import (
    CAPTURE_TEXTS,
    INTERACTION_TEXTS,
    OUTCOME_TEXTS,
    VARIANTS,
    Outcome,
    Rules,
)

COLUMNS = {
    "variant": 0.5,
    "agents move": 1.7,
    "obstacle": 3.25,
    "teammate": 4.55,
    "evader": 5.85,
    "pursuer": 7.15,
    "capture by": 8.5,
    "the captured": 9.85,
}
"""Heads of the columns, and the middle of each in tenths of the width."""
GROUPS = {
    "collision with": ("obstacle", "teammate"),
    "collision of adversaries": ("evader", "pursuer"),
}
"""Heads above several columns: the first and the last of them."""
WIDTH = 10.5
ROW = 0.34
"""Height of a row, in inches."""

FILLS = {
    Outcome.DISAPPEAR: (colors.VERMILLION, colors.PAPER),
    Outcome.REACH: (colors.SKY_BLUE, colors.INK),
    Outcome.BOUNCE: (colors.GRID, colors.INK),
}
"""Colours of the outcomes: the ground and the text on it."""


def rules_table(
    rules: Mapping[str, Rules] = VARIANTS, *, title: str = "The rules of the variants"
) -> Figure:
    """Draw rules as a table: which agents move together, what a collision does, what a capture is.

    Parameters
    ----------
    rules : mapping of str to Rules, optional
        The rows, by name. The default is the nine variants.
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure.

    Raises
    ------
    ValueError
        If there are no rules.
    """
    if not rules:
        raise ValueError("rules: expected at least one row, got none")
    figure = new_figure(9.2, 1.15 + ROW * len(rules))
    axes = figure.add_subplot()
    axes.set(xlim=(0, WIDTH), ylim=(len(rules) - 0.5, -2.1))
    axes.set_axis_off()
    _write_heads(axes)
    for row, (name, each) in enumerate(rules.items()):
        _write_row(axes, row, name, each)
    axes.set_title(fitting(figure, title))
    return figure


def _write_heads(axes: Axes) -> None:
    for head, place in COLUMNS.items():
        _write(axes, place, -1.0, head, fontweight="bold")
    for head, (first, last) in GROUPS.items():
        left, right = COLUMNS[first], COLUMNS[last]
        _write(axes, (left + right) / 2, -1.85, head, color=colors.MUTED)
        axes.plot([left - 0.55, right + 0.55], [-1.45] * 2, color=colors.MUTED, linewidth=0.8)
    axes.plot([0, WIDTH], [-0.55] * 2, color=colors.INK, linewidth=1.0)


def _write_row(axes: Axes, row: int, name: str, rules: Rules) -> None:
    if row:
        axes.plot([0, WIDTH], [row - 0.5] * 2, color=colors.GRID, linewidth=0.8)
    _write(axes, COLUMNS["variant"], row, f"-{name}" if name in VARIANTS else name, weight="bold")
    _write(axes, COLUMNS["agents move"], row, INTERACTION_TEXTS[rules.interaction])
    for field in ("obstacle", "teammate", "evader", "pursuer"):
        _write_outcome(axes, COLUMNS[field], row, getattr(rules, field))
    _write(axes, COLUMNS["capture by"], row, CAPTURE_TEXTS[rules.capture])
    fate = ("disappear" if rules.removes_captured else "stay") if rules.captures else "none"
    _write(axes, COLUMNS["the captured"], row, fate)


def _write_outcome(axes: Axes, place: float, row: int, outcome: Outcome) -> None:
    ground, ink = FILLS[outcome]
    axes.add_patch(
        FancyBboxPatch(
            (place - 0.5, row - 0.3), 1.0, 0.6, facecolor=ground, linewidth=0,
            boxstyle="round,pad=0,rounding_size=0.12",
        )
    )  # fmt: skip
    # The first word: reaches, bounces, disappears.
    _write(axes, place, row, OUTCOME_TEXTS[outcome].split()[0], color=ink)


def _write(axes: Axes, x: float, y: float, text: str, **look: Any) -> None:
    axes.text(x, y, text, **{"ha": "center", "va": "center", "size": "small", **look})
