"""Figures of a race, and of races side by side: payoffs, lags, generalization, training."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.patheffects import Normal, Stroke
from numpy.typing import ArrayLike, NDArray

from matrixworld import analysis
from matrixworld._util import colors
from matrixworld._util.checks import check_integer
from matrixworld._util.teams import BOTH
from matrixworld.analysis.intervals import UNIT, mean_over_opponents
from matrixworld.analysis.payoffs import Payoffs, Rates, Source, check_payoff
from matrixworld.plots import style
from matrixworld.world.rules import COLLISION_KINDS

COLORMAP = "viridis"
"""Perceptually uniform and safe for colour-blind readers; dark is escape, light is capture."""
FEWEST_CELLS = 5  # a lag whose mean rests on fewer cells is drawn faintly
COLUMNS = 3  # the most races beside each other in `comparison`; further ones are in rows below
SMALL = 0.83  # size of judgements above heat maps, as a multiple of the type
ROUND = tuple(step * 10**power for power in range(7) for step in (1, 2, 5))  # distances of ticks
_SHADES = ("#FCF0E8", "#CFE4F3")  # behind epochs in which a team learns; different in grey, too
_MARKED = 100  # curves with up to this many points have a marker at each
_LINE = 1.4  # height of a line above a heat map, as a multiple of the type


def payoff_heatmap(
    payoff: ArrayLike,
    *,
    teams: Sequence[str] = BOTH,
    title: str | None = None,
    general: bool = False,
) -> Figure:
    """Draw a payoff matrix as a heat map; two thin lines enclose opponents of the same generation.

    Parameters
    ----------
    payoff : array_like, shape (n, m)
        Capture rates in [0, 1].
    teams : sequence of str, optional
        Names of the team of the rows and of that of the columns.
    title : str, optional
        Text above the figure.
    general : bool, optional
        Whether both teams have scores of their own. The default is False.

    Returns
    -------
    Figure
        To be shown or saved, see `save_figure`.
    """
    rows, columns = check_payoff(payoff).shape
    words = style.words_of(teams, general=general)
    title = words.begin(", all against all") if title is None else title
    figure, axes = style.single(min(12.0, max(4.0, 1.7 + 4.1 * columns / rows)), 5.0, title)
    figure.colorbar(_draw_heatmap(axes, payoff, words), ax=axes, label=words.scale, shrink=0.9)
    return figure


def ciao_triangles(
    payoff: ArrayLike,
    *,
    every: int = 1,
    teams: Sequence[str] = BOTH,
    title: str = "CIAO: current individuals against ancestral opponents",
) -> Figure:
    """Draw the CIAO plots of both teams: current individuals against ancestral opponents.

    A row is a generation of the team, a column an opponent. Light cells are wins of the team. The
    slanted edge of a triangle is the current opponent; the further left, the older the opponent.
    See :func:`matrixworld.analysis.ciao`. Of `payoff` (n, m), whose rows and columns are `every` so
    many generations, with a `title` and names of the `teams`.
    """
    triangles, names = analysis.ciao(payoff), style.words_of(teams).teams
    check_integer("every", every, 1)
    figure = style.new_figure(7.4, 3.8)
    panels = figure.subplots(1, 2)
    for axes, triangle, name, other, color in zip(
        panels, triangles, names, names[::-1], colors.TEAMS, strict=True
    ):
        rows, columns = triangle.payoff.shape
        extent = every * (np.array([0, columns, 0, rows]) - 0.5)
        image = _draw_cells(
            axes, triangle.payoff, interpolation="nearest", aspect="auto", extent=extent
        )
        axes.set(xlabel=f"generation of {other}", ylabel=f"generation of {name}")
        axes.set_title(f"score of {name}", color=color, size="medium")
        axes.spines[["top", "right"]].set_visible(False)
    figure.colorbar(
        image, ax=list(panels), label="score (0 loses, 1 wins)", location="bottom", shrink=0.6,
        aspect=30,
    )  # fmt: skip
    figure.suptitle(style.fitting(figure, title))
    return figure


def comparison(
    payoffs: Mapping[str, Source],
    judgements: Mapping[str, analysis.Judgement] | None = None,
    *,
    teams: Sequence[str] = BOTH,
) -> Figure:
    """Draw races side by side, on the same scales, at most 3 in a row.

    Each race has the heat map of its mean payoff, its lag profile and its generalization curves, in
    a column below its name and its judgement. Bands are 95% intervals over its runs, or over the
    episodes of a single one; thin lines are single runs, if at most 10.

    Parameters
    ----------
    payoffs : mapping of str to array_like, path or Payoffs
        Payoffs of one run or several, as :func:`matrixworld.analysis.read_payoffs` takes them, by
        the name of the race.
    judgements : mapping of str to Judgement, optional
        Judgements by the name of the race.
    teams : sequence of str, optional
        Names of both teams.

    Returns
    -------
    Figure
        To be shown or saved, see `save_figure`.
    """
    style.check_some(payoffs, "race")
    races = {name: analysis.read_payoffs(source) for name, source in payoffs.items()}
    words = style.words_of(teams, general=all(race.general for race in races.values()))
    lines = -(-len(payoffs) // COLUMNS)
    columns = -(-len(payoffs) // lines)  # as many in each line, but the last
    size, heights = (1.2 + 2.7 * columns, 0.6 + 7.1 * lines), (1.7, 0.8, 0.8)
    figure = style.new_figure(*size, panels=columns)
    grid = figure.subplots(3 * lines, columns, squeeze=False, height_ratios=heights * lines)
    panels = [grid[3 * line : 3 * line + 3, k] for line, k in np.ndindex(lines, columns)]
    for axes in np.ravel(panels[len(payoffs) :]):
        axes.remove()
    panels = panels[: len(payoffs)]
    heads: dict[str, list[str]] = {}
    known = style.by_name("judgements", judgements)
    width = style.room(figure, columns + 0.3)
    for (heatmap, lags, scores), (name, race) in zip(panels, races.items(), strict=True):
        _draw_heatmap(heatmap, race.matrices.mean(axis=0), words)
        if race.general:
            _draw_joint_scores(lags, race)
        else:
            _draw_lag_profile(lags, race.matrices, words)
        _draw_generalization(scores, race, words)
        judged = analysis.sentence(known[name]) if name in known else ""
        heads[name] = textwrap.wrap(judged, int(width / SMALL))
    _write_heads([heatmap for heatmap, *_ in panels], heads, width)
    for first in range(0, len(panels), columns):
        row = panels[first : first + columns]
        # The bar of a shorter row would be in the middle, and push the other rows apart.
        if len(row) == columns:
            heatmaps = [column[0] for column in row]
            figure.colorbar(heatmaps[0].images[0], ax=heatmaps, label=words.scale, shrink=0.9)
        # The scales are shared, so one label per row is enough.
        for axes in [axes for column in row[1:] for axes in column]:
            axes.set_ylabel("")
    curves = [axes for _, lags, scores in panels for axes in (scores, lags)]
    style.legend_below(figure, style.labelled(*curves), columns=min(columns, 3))
    # A first pass of the layout: one alone leaves the names of three races above the edge.
    layout = figure.get_layout_engine()
    if layout is not None:
        layout.execute(figure)
    return figure


def _write_heads(heatmaps: Sequence[Axes], heads: Mapping[str, list[str]], width: int) -> None:
    """Write name and judgement of each race above its heat map."""
    # The names of all races are at the same height.
    pad = 5 + SMALL * _LINE * mpl.rcParams["font.size"] * max(map(len, heads.values()))
    for axes, (name, lines) in zip(heatmaps, heads.items(), strict=True):
        # Bold, and larger than the lines below it.
        named = style.wrapped(name, int(width / style.LARGE / 1.1))
        axes.set_title(named, fontweight="bold", pad=pad)
        axes.annotate(
            "\n".join(lines), (0.5, 1.0), xytext=(0, 5), xycoords="axes fraction",
            textcoords="offset points", ha="center", va="bottom", in_layout=False, size="small",
        )  # fmt: skip


def _draw_heatmap(axes: Axes, payoff: ArrayLike, words: style.Words) -> AxesImage:
    matrix = check_payoff(payoff)
    image = _draw_cells(axes, matrix)
    # A line above and a line below the cells of equal generations, which stay visible.
    corners = np.arange(min(matrix.shape) + 1) - 0.5
    early, late = np.repeat(corners, 2)[:-1], np.repeat(corners, 2)[1:]
    width = min(0.7, 25 / min(matrix.shape))  # points; thinner where cells are small
    outline = [Stroke(linewidth=1.9 * width, foreground=colors.INK), Normal()]
    for x, y in ((early, late), (late, early)):
        axes.plot(x, y, color=colors.PAPER, linewidth=width, path_effects=outline)
    axes.set(xlabel=words.generations[1], ylabel=words.generations[0])
    axes.set(xlim=(-0.5, matrix.shape[1] - 0.5), ylim=(-0.5, matrix.shape[0] - 0.5))
    return image


def _draw_cells(axes: Axes, cells: Rates, **look: Any) -> AxesImage:
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(style.whole_numbers())
    return axes.imshow(cells, origin="lower", vmin=0.0, vmax=1.0, cmap=COLORMAP, **look)


def _draw_lag_profile(axes: Axes, matrices: Rates, words: style.Words) -> None:
    profiles = [analysis.lag_profile(matrix) for matrix in matrices]
    lags, counts = profiles[0].lags, profiles[0].cells
    # In a small matrix no lag has FEWEST_CELLS cells; the middle half of its lags is solid then.
    cells = min(FEWEST_CELLS, (counts.max() + 1) // 2)
    means = [profile.means for profile in profiles]
    band = analysis.band_over_runs(means, places=lags, bounds=UNIT)
    faint = f"lags with fewer than {cells} cells"
    axes.plot(lags, band.mean, color=colors.INK, alpha=0.3, linewidth=1.8, label=faint)
    solid = counts >= cells
    axes.plot(lags[solid], band.mean[solid], color=colors.INK, linewidth=1.8)
    style.draw_runs(axes, band, means, colors.INK)
    axes.axvline(0, color=colors.MUTED, linestyle="--", linewidth=1.0, zorder=1)
    axes.set(xlabel=words.lag, ylabel=f"mean {words.score}")
    axes.set_title("lag profile", size="medium")
    style.generation_axis(axes)
    style.unit_axis(axes)
    aside: dict[str, Any] = {"color": colors.MUTED, "size": "small", "transform": axes.transAxes}
    axes.text(0.02, 0.97, f"later {words.teams[1]}", ha="left", va="top", **aside)
    axes.text(0.98, 0.03, f"later {words.teams[0]}", ha="right", va="bottom", **aside)


def _draw_generalization(axes: Axes, race: Payoffs, words: style.Words) -> None:
    """Draw the mean scores of both teams, with bands over seeds, or over episodes of one run."""
    interval = "95% interval of the mean over seeds"
    looks = [*zip(BOTH, colors.TEAMS, ("-", style.EVADERS), words.scores, strict=True)]
    for team, color, line, label in looks[:1] if race.one_population else looks:
        side = race.side(team)
        curves = side.matrices.mean(axis=2)
        band = analysis.band_over_runs(curves, bounds=UNIT)
        if len(race) == 1 and side.scores is not None and race.has_episodes:
            band = mean_over_opponents(side.scores[0])
            interval = "95% interval over episodes"
        axes.plot(band.places, band.mean, color=color, linestyle=line, linewidth=1.7, label=label)
        style.draw_runs(axes, band, curves, color)
    if band.low is not None:
        # An empty band for the legend, whose entry is of both teams.
        axes.fill_between([], [], [], color=colors.MUTED, alpha=0.22, linewidth=0, label=interval)
    style.label_runs(axes, [len(race)])
    axes.set(xlabel="generation", ylabel="mean score")
    axes.set_title("generalization", size="medium")
    style.generation_axis(axes)
    style.unit_axis(axes)


def _draw_joint_scores(axes: Axes, race: Payoffs) -> None:
    """Draw the mean of both teams' scores against contemporaries."""
    band = analysis.joint_scores(race)
    axes.plot(band.places, band.mean, color=colors.INK, linewidth=1.8)
    style.draw_runs(axes, band, band.mean[np.newaxis], colors.INK)
    axes.set(xlabel="generation", ylabel="mean of both scores")
    axes.set_title("both sides, against contemporaries", size="medium")
    style.generation_axis(axes)
    style.unit_axis(axes)


# ---- While it learns ---------------------------------------------------------------------------


def training_curve(
    rates: NDArray[np.float64],
    learners: NDArray[Any] | None,
    *,
    generations: NDArray[Any] | None = None,
    window: int = 1,
    teams: Sequence[str] = BOTH,
    title: str = "",
) -> Figure:
    """Draw the score (T,) over epochs, shaded by the team that learns, with its moving average.

    `learners` (T,) are 0 and 1, or None if both learn; `generations` (T,) are on a second axis.
    """
    words = style.words_of(teams)
    figure, axes = style.single(8.0, 3.8, title)
    place, marker = np.arange(1, len(rates) + 1), "o" if len(rates) <= _MARKED else ""
    if window > 1:
        axes.plot(place, rates, color=colors.INK, alpha=0.25, linewidth=0.6)
    smooth = _moving_average(rates, window)
    axes.plot(place, smooth, color=colors.INK, linewidth=1.6, marker=marker, markersize=4)
    for team, name, shade in zip((0, 1), words.teams, _SHADES, strict=True):
        if learners is not None and team in learners:
            axes.fill_between(
                place, 0, 1, where=learners == team, color=shade, linewidth=0, zorder=0, step="mid",
                transform=axes.get_xaxis_transform(), label=f"{name} learn",
            )  # fmt: skip
    axes.set(xlabel="epoch", xlim=(0.5, len(rates) + 0.5))
    axes.set_ylabel(f"{words.score}, mean of {window} epochs" if window > 1 else words.score)
    axes.xaxis.set_major_locator(style.whole_numbers())
    style.unit_axis(axes)
    if generations is not None:
        _generation_axis(axes, generations)
    if learners is not None:
        style.legend_below(figure, style.labelled(axes), columns=4)
    return figure


def collision_rates(rates: NDArray[np.float64], *, title: str) -> Figure:
    """Draw collisions per 1000 agent-steps (G, 2, 3) by generation, team and kind."""
    columns = style.beside(2)
    figure = style.new_figure(8.4, 3.8 if columns == 2 else 4.6)
    panels = figure.subplots(2 // columns, columns, sharex=True, sharey=True, squeeze=False).ravel()
    marker = "o" if len(rates) <= _MARKED else ""
    for team, axes in enumerate(panels):
        for kind, curve in enumerate(rates[:, team].T):
            axes.plot(
                curve, label=f"with {COLLISION_KINDS[kind]}", color=colors.CONFLICTS[kind],
                linestyle=("-", *style.DASHES)[kind], marker=marker, markersize=3,
            )  # fmt: skip
        axes.set_title(BOTH[team], color=colors.TEAMS[team])
        axes.xaxis.set_major_locator(style.whole_numbers())
        style.plain_axis(axes)
    for axes in panels[-columns:]:
        axes.set_xlabel("generation")
    for axes in panels[::columns]:
        axes.set_ylabel("collisions per 1000\nagent-steps")
    panels[0].set_ylim(bottom=0.0)
    return style.finished(figure, style.labelled(panels[0]), title, columns=3)


def _moving_average(values: NDArray[np.float64], window: int) -> NDArray[np.float64]:
    """Return the centred mean of `window` points, and of fewer at both ends."""
    window = min(window, len(values))
    kernel = np.ones(window)
    # Dividing by the points inside the window keeps both ends from being drawn towards 0.
    counts = np.convolve(np.ones(len(values)), kernel, mode="same")
    average: NDArray[np.float64] = np.convolve(values, kernel, mode="same") / counts
    return average


def _generation_axis(axes: Axes, generations: NDArray[Any]) -> None:
    """Add a second axis on top that shows where each generation begins."""
    names, starts = np.unique(generations, return_index=True)
    every = next(each for each in ROUND if len(names) <= 10 * each)
    shown = names % every == 0
    top = axes.secondary_xaxis("top")
    top.set_xticks(starts[shown] + 1, [f"{name:.0f}" for name in names[shown]])
    top.set_xlabel("generation")
