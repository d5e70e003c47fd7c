"""Figures of payoff matrices: heat maps, lag profiles, CIAO plots, and races side by side."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping, Sequence
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.patheffects import Normal, Stroke
from numpy.typing import ArrayLike

from matrixworld import analysis
from matrixworld._util import colors
from matrixworld.analysis.payoffs import Rates, check_payoff
from matrixworld.plots import style
from matrixworld.plots.generalization import draw_generalization, mean_of

COLORMAP = "viridis"
"""Perceptually uniform and safe for colour-blind readers; dark is escape, light is capture."""

FEWEST_CELLS = 5
"""A lag whose mean rests on fewer cells is drawn faintly."""

COLUMNS = 3
"""The most races beside each other in `comparison`; further ones are in rows below."""
_LINE = 1.4  # height of a line above a heat map, as a multiple of the type

_SCALE = "capture rate\n(0 all escape, 1 all caught)"
_LAG = "lag: pursuer minus evader generation"


def payoff_heatmap(payoff: ArrayLike, *, title: str = "Capture rate, all against all") -> Figure:
    """Draw a payoff matrix as a heat map; two thin lines enclose opponents of the same generation.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
    title : str, optional
    """
    rows, columns = check_payoff(payoff).shape
    figure = style.new_figure(min(12.0, max(4.0, 1.7 + 4.1 * columns / rows)), 5.0)
    axes = figure.add_subplot()
    image = _draw_heatmap(axes, payoff)
    axes.set_title(style.fitting(figure, title))
    figure.colorbar(image, ax=axes, label=_SCALE, shrink=0.9)
    return figure


def lag_profile_curve(payoff: ArrayLike, *, title: str = "Lag profile") -> Figure:
    """Draw the lag profile: the mean over k of ``payoff[k + d, k]`` for each lag d.

    A flat curve with a notch at 0 means specialists, which win against their own opponents only. A
    rising curve means that later generations win against earlier and later opponents as well.
    Lags with fewer than `FEWEST_CELLS` cells are faint.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
    title : str, optional
    """
    figure = style.new_figure(6.4, 4.2)
    axes = figure.add_subplot()
    _draw_lag_profile(axes, payoff)
    axes.set_title(style.fitting(figure, title))
    style.legend_below(figure, style.labelled(axes))
    return figure


def ciao_triangles(
    payoff: ArrayLike,
    *,
    names: tuple[str, str] = ("pursuers", "evaders"),
    title: str = "CIAO: current individuals against ancestral opponents",
) -> Figure:
    """Draw the CIAO plots of both teams: current individuals against ancestral opponents.

    Light cells are wins of the team. The upper edge of a triangle is the current opponent; the
    further down, the older the opponent. See :func:`matrixworld.analysis.ciao`.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
    names : tuple of str, optional
        Names of the teams: that of the rows, then that of the columns.
    title : str, optional
    """
    triangles = analysis.ciao(payoff)
    figure = style.new_figure(7.4, 3.8)
    panels = figure.subplots(1, 2)
    for axes, triangle, name, other, color in zip(
        panels, triangles, names, names[::-1], colors.TEAMS, strict=True
    ):
        image = _draw_cells(axes, triangle.payoff.T, interpolation="nearest", aspect="auto")
        axes.set(xlabel=f"generation of {name}", ylabel=f"generation of {other}")
        axes.set_title(f"score of {name}", color=color, size="medium")
        axes.spines[["top", "right"]].set_visible(False)
    figure.colorbar(
        image, ax=list(panels), label="score (0 loses, 1 wins)", location="bottom", shrink=0.6,
        aspect=30,
    )  # fmt: skip
    figure.suptitle(style.fitting(figure, title))
    return figure


def comparison(
    payoffs: Mapping[str, ArrayLike],
    judgements: Mapping[str, analysis.Judgement] | None = None,
    *,
    per_episode: bool = False,
    measures: bool = True,
    title: str | None = None,
) -> Figure:
    """Draw several races side by side, on the same scales, at most `COLUMNS` in a row.

    Each race has its heat map, its lag profile and its generalization curves, in a column below its
    name, its judgement and two of its measures.

    Parameters
    ----------
    payoffs : mapping of str to array_like of float
        Payoff matrices of at least 2 x 2, by the name of the race.
    judgements : mapping of str to Judgement, optional
        Results of :func:`matrixworld.analysis.judge`; a race without one has numbers only.
    per_episode : bool, optional
        Whether the payoffs are capture rates of single episodes, as in `generalization_curves`.
    measures : bool, optional
        Whether two measures stand below the names.
    title : str, optional
    """
    style.check_some(payoffs, "race")
    lines, columns = style.rows_of(len(payoffs), style.beside(COLUMNS))
    figure = style.new_figure(1.2 + 2.7 * columns, 0.6 + 7.1 * lines)
    panels = style.columns_of_three(figure, len(payoffs), (lines, columns), heights=(1.7, 0.8, 0.8))
    for column, payoff in zip(panels, payoffs.values(), strict=True):
        _draw_race(column, payoff, per_episode)
    means = {name: mean_of(payoff, per_episode) for name, payoff in payoffs.items()}
    numbers = {name: _numbers(mean) if measures else "" for name, mean in means.items()}
    width = style.room(figure, columns + 0.3)
    _write_heads([column[0] for column in panels], numbers, judgements or {}, width)
    _share_legends(figure, panels, columns)
    if title:
        figure.suptitle(style.fitting(figure, title))
    # A first pass of the layout: one alone leaves the names of three races above the edge.
    layout = figure.get_layout_engine()
    if layout is not None:
        layout.execute(figure)
    return figure


def _share_legends(figure: Figure, panels: Sequence[Sequence[Axes]], columns: int) -> None:
    """Draw a colour bar for each full row of heat maps, one legend, and labels on the left only."""
    for first in range(0, len(panels), columns):
        row = panels[first : first + columns]
        # The bar of a shorter row would be in the middle, and push the other rows apart.
        if len(row) == columns:
            heatmaps = [column[0] for column in row]
            figure.colorbar(heatmaps[0].images[0], ax=heatmaps, label=_SCALE, shrink=0.9)
        # The scales are shared, so one label per row is enough.
        for axes in [axes for column in row[1:] for axes in column]:
            axes.set_ylabel("")
    style.legend_below(figure, style.labelled(panels[0][2], panels[0][1]), columns=min(columns, 3))


def _draw_race(column: Sequence[Axes], payoff: ArrayLike, per_episode: bool) -> None:
    matrix = mean_of(payoff, per_episode)
    _draw_heatmap(column[0], matrix)
    _draw_lag_profile(column[1], matrix)
    draw_generalization(column[2], payoff, per_episode)
    for axes, title in zip(column[1:], ("lag profile", "generalization"), strict=True):
        axes.set_title(title, size="medium")
    column[1].set_xlabel("lag: pursuer minus\nevader generation")


def _write_heads(
    heatmaps: Sequence[Axes],
    numbers: Mapping[str, str],
    judgements: Mapping[str, analysis.Judgement],
    width: int,
) -> None:
    """Write name, judgement and numbers of each race above its heat map, so wide."""
    heads = {
        name: textwrap.wrap(
            analysis.headline(judgements[name]) if name in judgements else "", width
        )
        + textwrap.wrap(text, width)
        for name, text in numbers.items()
    }
    # The names of all races are at the same height.
    pad = 5 + _LINE * mpl.rcParams["font.size"] * max(map(len, heads.values()))
    for axes, (name, lines) in zip(heatmaps, heads.items(), strict=True):
        # Bold, and larger than the lines below it.
        named = style.wrapped(name, int(width / style.LARGE / 1.1))
        axes.set_title(named, fontweight="bold", pad=pad)
        axes.annotate(
            "\n".join(lines), (0.5, 1.0), xytext=(0, 5), xycoords="axes fraction",
            textcoords="offset points", ha="center", va="bottom", in_layout=False,
        )  # fmt: skip


def _numbers(payoff: ArrayLike) -> str:
    """Return what stands above a heat map, and the window that it is about."""
    payoffs = analysis.read_payoffs(payoff)
    share, boards = (
        analysis.MEASURES[name].of(payoffs).value for name in ("transitive_share", "checkerboards")
    )
    numbers = [] if math.isnan(share) else [f"transitive share {share:.2f}"]
    return f"{payoffs.late.name}: {', '.join([*numbers, f'checkerboards {boards:.1%}'])}"


def _draw_heatmap(axes: Axes, payoff: ArrayLike) -> AxesImage:
    matrix = check_payoff(payoff)
    image = _draw_cells(axes, matrix)
    _enclose_diagonal(axes, min(matrix.shape))
    axes.set(xlabel="evader generation", ylabel="pursuer generation")
    axes.set(xlim=(-0.5, matrix.shape[1] - 0.5), ylim=(-0.5, matrix.shape[0] - 0.5))
    return image


def _draw_cells(axes: Axes, cells: Rates, **look: Any) -> AxesImage:
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(style.whole_numbers())
    return axes.imshow(cells, origin="lower", vmin=0.0, vmax=1.0, cmap=COLORMAP, **look)


def _enclose_diagonal(axes: Axes, cells: int) -> None:
    """Draw a line above and a line below the cells of equal generations, which stay visible."""
    corners = np.arange(cells + 1) - 0.5
    early, late = np.repeat(corners, 2)[:-1], np.repeat(corners, 2)[1:]
    width = min(0.7, 25 / cells)  # points; thinner where cells are small
    outline = [Stroke(linewidth=1.9 * width, foreground=colors.INK), Normal()]
    for x, y in ((early, late), (late, early)):
        axes.plot(x, y, color=colors.PAPER, linewidth=width, path_effects=outline)


def _draw_lag_profile(axes: Axes, payoff: ArrayLike) -> None:
    profile = analysis.lag_profile(payoff)
    # In a small matrix no lag has FEWEST_CELLS cells; the middle half of its lags is solid then.
    cells = min(FEWEST_CELLS, (profile.cells.max() + 1) // 2)
    solid = profile.cells >= cells
    faint = f"lags with fewer than {cells} cells"
    axes.plot(profile.lags, profile.means, color=colors.INK, alpha=0.3, linewidth=1.0, label=faint)
    axes.plot(profile.lags[solid], profile.means[solid], color=colors.INK, linewidth=1.8)
    axes.axvline(0, color=colors.MUTED, linestyle="--", linewidth=1.0, zorder=1)
    axes.set(xlabel=_LAG, ylabel="mean capture rate")
    axes.xaxis.set_major_locator(style.whole_numbers())
    axes.margins(x=0.02)
    style.unit_axis(axes)
    aside: dict[str, Any] = {"color": colors.MUTED, "size": "small", "transform": axes.transAxes}
    axes.text(0.02, 0.97, "later evaders", ha="left", va="top", **aside)
    axes.text(0.98, 0.03, "later pursuers", ha="right", va="bottom", **aside)
