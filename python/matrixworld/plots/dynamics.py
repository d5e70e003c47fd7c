"""Figures of games between generations: replicator dynamics, and the spinning top of a race."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from matrixworld import analysis
from matrixworld._util import colors
from matrixworld.analysis.dynamics import TIME, ReplicatorPath
from matrixworld.analysis.games import Nash
from matrixworld.analysis.judge import LEAST_INTRANSITIVITY
from matrixworld.analysis.payoffs import Rates, require
from matrixworld.plots import style
from matrixworld.plots.payoffs import COLORMAP

CORNERS = np.array([[0.0, 0.0], [1.0, 0.0], [0.5, 0.75**0.5]])
"""Where the three strategies of a triangle are."""


def replicator_trajectories(
    payoff: ArrayLike,
    starts: Sequence[tuple[ArrayLike, ArrayLike]] = (),
    *,
    time: float = TIME,
    title: str = "Replicator dynamics",
) -> Figure:
    """Draw how the shares of all strategies change, and their distance from the Nash equilibrium.

    A team of three strategies has a triangle with a path from each start, which is a dot, and a
    cross in the equilibrium. Other teams have stacked shares over time, of the first start. Noise
    of the capture rates moves shares, too: which generation remains may be chance. See
    :func:`matrixworld.analysis.replicator_dynamics`.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Capture rates.
    starts : sequence of pairs of array_like of float, shapes (n,) and (m,), optional
        Shares of pursuers and evaders at the begin, at most 20. The default is equal shares.
    time : float, optional
        Duration, above 0.
    title : str, optional
    """
    nash = analysis.nash_averaging(payoff)
    require(len(starts) <= len(style.LINES), f"at most {len(style.LINES)} starts", len(starts))
    pairs: Sequence[Any] = starts or [(None, None)]
    paths = [
        analysis.replicator_dynamics(payoff, pursuers=p, evaders=q, time=time, points=1001)
        for p, q in pairs
    ]
    columns = style.beside(3, inches=3.0)
    figure = style.new_figure(11.0, 3.8 * -(-3 // columns))
    panels = figure.subplots(-(-3 // columns), columns, squeeze=False).flat
    for axes, team, color in zip(panels, ("pursuers", "evaders"), colors.TEAMS, strict=False):
        _draw_shares(axes, [getattr(path, team) for path in paths], paths[0], getattr(nash, team))
        axes.set_title(team, color=color, size="medium")
    _draw_divergence(panels[2], paths, nash)
    for axes in panels[3:]:
        axes.remove()
    figure.suptitle(style.fitting(figure, title))
    return figure


def _draw_shares(axes: Axes, shares: Sequence[Rates], path: ReplicatorPath, nash: Rates) -> None:
    if len(nash) == 3:
        _draw_triangle(axes, shares, nash)
        return
    norm = Normalize(0, max(1, len(nash) - 1))
    shades = [*mpl.colormaps[COLORMAP](norm(np.arange(len(nash))))]
    axes.stackplot(path.times, shares[0].T, colors=shades, linewidth=0)
    axes.set(xlabel="time", ylabel="share", xlim=(0, path.times[-1]), ylim=(0, 1))
    figure = axes.figure
    figure.colorbar(
        ScalarMappable(norm, COLORMAP), ax=axes, label="generation", ticks=style.whole_numbers()
    )


def _draw_triangle(axes: Axes, shares: Sequence[Rates], nash: Rates) -> None:
    axes.plot(*CORNERS[[0, 1, 2, 0]].T, color=colors.MUTED, linewidth=0.8)
    for number, (corner, shift) in enumerate(zip(CORNERS, (-0.07, -0.07, 0.07), strict=True)):
        axes.text(corner[0], corner[1] + shift, str(number), ha="center", va="center")
    for each, (color, line) in zip(shares, style.LINES, strict=False):
        places = (each @ CORNERS).T
        axes.plot(*places, color=color, linestyle=line, linewidth=1.2)
        axes.plot(*places[:, 0], color=color, marker="o", markersize=5)
    axes.plot(*nash @ CORNERS, color=colors.INK, marker="+", markersize=9)
    axes.set(aspect="equal", ylim=(-0.13, 1.0))
    axes.set_axis_off()


def _draw_divergence(axes: Axes, paths: Sequence[ReplicatorPath], nash: Nash) -> None:
    for path, (color, line) in zip(paths, style.LINES, strict=False):
        away = path.divergence(nash.pursuers, nash.evaders)
        axes.plot(path.times, away, color=color, linestyle=line, linewidth=1.5)
    axes.set(xlabel="time", ylabel="divergence, nats")
    axes.set_ylim(0, 1.1 * axes.get_ylim()[1])
    axes.set_title("distance from equilibrium", size="medium")
    style.plain_axis(axes)


def spinning_top(
    scores: ArrayLike, *, title: str = "Strength and cycles of the generations"
) -> Figure:
    """Draw the intransitivity of each generation at its strength: pursuers left, evaders right.

    Thin lines are 95 % intervals over episodes, of each generation by itself. Beyond the dotted
    lines a generation deviates by more than the margin of the judgement. See
    :func:`matrixworld.analysis.spinning_top`.

    Parameters
    ----------
    scores : array_like of float, shape (n, m, episodes)
        Capture rates of single episodes, at least two of each cell.
    title : str, optional
    """
    figure = style.new_figure(6.4, 4.6)
    axes = figure.add_subplot()
    tops = analysis.spinning_top(scores)
    sides = (("pursuers", -1), ("evaders", 1))
    for (team, side), top, color in zip(sides, tops, colors.TEAMS, strict=True):
        places = side * top.intransitivity
        axes.hlines(top.strength, side * top.low, side * top.high, color=color, linewidth=0.8)
        axes.plot(places, top.strength, "o", markersize=5, color=color, label=team)
        axes.barh(top.strength, places, height=0.012, color=color, alpha=0.3, linewidth=0)
        axes.axvline(side * LEAST_INTRANSITIVITY, color=colors.MUTED, linestyle=":", linewidth=1.0)
    most = 1.05 * max(LEAST_INTRANSITIVITY, *(float(top.high.max()) for top in tops))
    axes.set(xlim=(-most, most), xlabel="intransitivity", ylabel="strength (mean payoff)")
    axes.xaxis.set_major_formatter(lambda value, _: f"{abs(value):g}")
    style.unit_axis(axes)
    axes.set_title(style.fitting(figure, title))
    style.legend_below(figure, style.labelled(axes))
    return figure
