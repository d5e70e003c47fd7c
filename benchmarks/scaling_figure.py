"""Figure of cost against size: one panel for each kind of size, both axes logarithmic."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from matrixworld._util import colors

PALETTE = (colors.BLUE, colors.VERMILLION, colors.GREEN, colors.PURPLE)
MARKERS = ("o", "s", "^", "D")


@dataclass(frozen=True)
class Curve:
    """Seconds by size.

    Parameters
    ----------
    label : str
        Label in the legend.
    sizes : sequence of int
        The sizes.
    seconds : sequence of float
        Seconds at each size.
    """

    label: str
    sizes: Sequence[int]
    seconds: Sequence[float]

    @property
    def upper(self) -> slice:
        """Upper half of the sizes, including the middle one."""
        return slice((len(self.sizes) - 1) // 2, None)

    @property
    def exponent(self) -> float:
        """Slope of log seconds over log size in the upper half, by least squares."""
        # Small sizes are dominated by constant cost.
        sizes, seconds = self.sizes[self.upper], self.seconds[self.upper]
        if len(sizes) < 2:
            return float("nan")
        return float(np.polyfit(np.log(sizes), np.log(seconds), 1)[0])


def draw(panels: Mapping[tuple[str, str, str], Sequence[Curve]], path: str) -> None:
    """Draw the panels, (title, x label, y label) -> curves, side by side and save the figure."""
    figure = Figure(figsize=(12, 4.3), dpi=150, layout="constrained")
    for axes, (labels, curves) in zip(figure.subplots(1, len(panels)), panels.items(), strict=True):
        _draw_panel(axes, curves)
        axes.set_title(labels[0], loc="left", fontweight="bold")
        axes.set(xlabel=labels[1], ylabel=labels[2])
    figure.savefig(path)


def _draw_panel(axes: Axes, curves: Sequence[Curve]) -> None:
    axes.set(xscale="log", yscale="log")
    for curve, color, marker in zip(curves, PALETTE, MARKERS, strict=False):
        label = f"{curve.label}: {curve.exponent:.2f}"
        axes.plot(curve.sizes, curve.seconds, color=color, marker=marker, markersize=5, label=label)
    _draw_reference(axes, curves)
    axes.grid(color=colors.GRID, linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(
        title="fitted exponent", loc="upper left", frameon=False, fontsize="small",
        title_fontsize="small", alignment="left",
    )  # fmt: skip


def _draw_reference(axes: Axes, curves: Sequence[Curve]) -> None:
    """Draw a dashed line of slope 1 below all curves."""
    first, last = curves[0].sizes[0], max(curve.sizes[-1] for curve in curves)
    ratio = min(
        second / size
        for curve in curves
        for size, second in zip(curve.sizes, curve.seconds, strict=True)
    )
    ends = np.array([first, last], float)
    axes.plot(ends, ends * ratio / 3, color=colors.MUTED, linestyle="--", linewidth=1)
    # The geometric mean is the middle of a logarithmic axis.
    middle = np.sqrt(ends.prod())
    axes.annotate(
        "slope 1", (middle, middle * ratio / 3), xytext=(6, -3), textcoords="offset points",
        color=colors.MUTED, fontsize="small", ha="left", va="top",
    )  # fmt: skip
