"""CIAO plots: current individuals against ancestral opponents, a triangle for each team."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from matrixworld import analysis
from matrixworld._util import colors
from matrixworld.plots.payoffs import COLORMAP
from matrixworld.plots.style import fitting, new_figure, whole_numbers


def ciao_triangles(
    payoff: ArrayLike,
    *,
    names: tuple[str, str] = ("pursuers", "evaders"),
    title: str = "Current individuals against ancestral opponents",
) -> Figure:
    """Draw the CIAO plots of both teams.

    Light cells are wins of the team. The upper edge of a triangle is the current opponent; the
    further down, the older the opponent.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.
    names : tuple of str, optional
        Names of the teams: that of the rows, then that of the columns.
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure.

    Raises
    ------
    ValueError, TypeError
        As :func:`matrixworld.analysis.check_payoff` does.

    References
    ----------
    Cliff and Miller (1995), "Tracking the Red Queen: measurements of adaptive progress in
    co-evolutionary simulations".
    """
    triangles = analysis.ciao(payoff)
    figure = new_figure(7.4, 3.8)
    panels = figure.subplots(1, 2)
    for axes, triangle, name, other, color in zip(
        panels, triangles, names, names[::-1], colors.TEAMS, strict=True
    ):
        image = axes.imshow(
            triangle.payoff.T,
            origin="lower",
            vmin=0,
            vmax=1,
            cmap=COLORMAP,
            aspect="auto",
            interpolation="nearest",
        )
        axes.set_title(f"wins of {name}", color=color)
        _label(axes, f"generation of {name}", f"generation of {other}")
    figure.colorbar(image, ax=list(panels), label="payoff (0 loses, 1 wins)", shrink=0.9)
    figure.suptitle(fitting(figure, title))
    return figure


def _label(axes: Axes, along: str, upwards: str) -> None:
    axes.set(xlabel=along, ylabel=upwards)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(whole_numbers(6))
    axes.spines[["top", "right"]].set_visible(False)
