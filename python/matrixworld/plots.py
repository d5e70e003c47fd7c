"""Figures of a race: functions from arrays to a Matplotlib ``Figure``.

They need no display and do not touch the state of ``pyplot``. Save a figure with
``figure.savefig(path)``, or show it as the last expression of a notebook cell after
``%matplotlib inline``.

=======================  ==========================================================================
payoff_heatmap           every pursuer generation against every evader generation
generalization_curves    mean score of each generation against all opponents, beside baselines
lag_profile_curve        mean capture rate by how much later the pursuers are than the evaders
training_curve           capture rate while pursuers and evaders learn in turn
collision_rates          collisions by team and kind over generations
comparison               several races side by side, with their verdicts in numbers
=======================  ==========================================================================
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.lines import Line2D
from matplotlib.patheffects import Normal, Stroke
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike, NDArray

from matrixworld import analysis, colors

COLORMAP = "viridis"
"""Perceptually uniform and safe for colour-blind readers; dark is escape, light is capture."""
DPI = 150
"""Resolution of saved figures."""
FEWEST_CELLS = 5
"""A lag whose mean rests on fewer cells is drawn faintly."""
_SCALE = "capture rate (0 all escape, 1 all caught)"
_KINDS = ("obstacle", "teammate", "adversary")
_TEAMS = ("pursuers", "evaders")
_DASHES = ("--", ":", "-.")
_MARKED = 100  # curves with up to this many points have a marker at each


def payoff_heatmap(payoff: ArrayLike, *, title: str = "Capture rate, all against all") -> Figure:
    """Draw a payoff matrix as a heat map.

    The dashed line marks opponents of the same generation.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Mean capture rate of each pursuer generation against each evader generation.
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
    """
    rows, columns = analysis.check_payoff(payoff).shape
    figure = _figure(min(12.0, max(4.0, 1.7 + 4.1 * columns / rows)), 5.0)
    axes = figure.add_subplot()
    image = _draw_heatmap(axes, payoff)
    axes.set_title(title)
    figure.colorbar(image, ax=axes, label=_SCALE, shrink=0.9)
    return figure


def generalization_curves(
    payoff: ArrayLike,
    *,
    pursuer_baselines: Mapping[str, float] | None = None,
    evader_baselines: Mapping[str, float] | None = None,
    title: str = "Generalisation: mean score against all opponents",
) -> Figure:
    """Draw the mean score of each generation against all opponents.

    The score of pursuers is the capture rate, that of evaders is 1 minus the capture rate.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Mean capture rate of each pursuer generation against each evader generation.
    pursuer_baselines, evader_baselines : mapping of str to float, optional
        Mean scores in [0, 1] of teams that were trained in another way, against the same opponents.
        Each is drawn as a level line with its name.
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure.

    Raises
    ------
    ValueError
        If a baseline is outside [0, 1], or as :func:`matrixworld.analysis.check_payoff` does.
    """
    figure = _figure(6.4, 4.2)
    axes = figure.add_subplot()
    _draw_generalization(axes, payoff)
    for team, baselines in enumerate((pursuer_baselines or {}, evader_baselines or {})):
        _draw_baselines(axes, baselines, colors.TEAMS[team])
    axes.set_title(title)
    _legend_below(figure, *axes.get_legend_handles_labels())
    return figure


def lag_profile_curve(payoff: ArrayLike, *, title: str = "Lag profile") -> Figure:
    """Draw the lag profile: the mean over k of ``payoff[k + d, k]`` for each lag d.

    A flat curve with a notch at 0 means specialists, which win against their own opponents only. A
    rising curve means that later generations win against earlier and later opponents as well.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Mean capture rate of each pursuer generation against each evader generation.
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure. Lags with fewer than `FEWEST_CELLS` cells are faint.

    Raises
    ------
    ValueError, TypeError
        As :func:`matrixworld.analysis.check_payoff` does.
    """
    figure = _figure(6.4, 4.2)
    axes = figure.add_subplot()
    _draw_lag_profile(axes, payoff)
    axes.set_title(title)
    return figure


def training_curve(
    rates: ArrayLike,
    learners: ArrayLike | None,
    *,
    generations: ArrayLike | None = None,
    window: int = 1,
    unit: str = "epoch",
    title: str = "Capture rate while pursuers and evaders learn in turn",
) -> Figure:
    """Draw the capture rate over training, coloured by the team that learns.

    Parameters
    ----------
    rates : array_like of float, shape (T,)
        Capture rate at each `unit`.
    learners : array_like of int, shape (T,), or None
        0 where the pursuers learn, 1 where the evaders learn. None if both learn all the time.
    generations : array_like of int, shape (T,), optional
        Generation of each point, for a second axis on top.
    window : int, optional
        Points of a centred moving average (the paper's figure uses 30). With more than 1 the raw
        curve is drawn thin behind the mean.
    unit : str, optional
        Label of the axis, such as "epoch" or "team phase".
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure.

    Raises
    ------
    ValueError
        If a rate is outside [0, 1], a learner is neither 0 nor 1, the lengths differ, or `window`
        is below 1.
    """
    values = analysis.check_rates(rates, ndim=1, what="training capture rates")
    shades = _shades(learners, len(values))
    figure = _figure(8.0, 3.8)
    axes = figure.add_subplot()
    if window > 1:
        axes.add_collection(_in_pieces(values, shades, alpha=0.25, linewidth=0.6))
    smooth = _moving_average(values, window)
    axes.add_collection(_in_pieces(smooth, shades, linewidth=1.6))
    if len(values) <= _MARKED:
        place = np.arange(1, len(values) + 1)
        axes.scatter(place, smooth, s=14, c=shades, zorder=3)
    axes.set(title=title, xlabel=unit, ylabel="capture rate", xlim=(0.5, len(values) + 0.5))
    axes.xaxis.set_major_locator(_whole_numbers(10))
    _unit_axis(axes)
    if generations is not None:
        _generation_axis(axes, np.asarray(generations), len(values))
    learning = {f"{t} learn": c for t, c in zip(_TEAMS, colors.TEAMS, strict=True) if c in shades}
    if learning:
        _legend_below(figure, [Line2D([], [], color=c) for c in learning.values()], [*learning])
    return figure


def collision_rates(
    rates: ArrayLike, *, title: str = "Collisions per 1000 agent-steps, by kind"
) -> Figure:
    """Draw collisions over generations, one panel per team.

    Parameters
    ----------
    rates : array_like of float, shape (G, 2, 3)
        Collisions per 1000 agent-steps of the generations 0, 1 and so on, by team (pursuers,
        evaders) and kind (obstacle, teammate, adversary).
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure.

    Raises
    ------
    ValueError
        If the shape is another, or a rate is negative or infinite.
    """
    values = np.asarray(rates, dtype=np.float64)
    if values.ndim != 3 or values.shape[1:] != (2, 3) or not len(values):
        raise ValueError(f"expected collision rates of shape (G, 2, 3), got {values.shape}")
    bad = values[~(np.isfinite(values) & (values >= 0))]
    if len(bad):
        raise ValueError(f"expected finite collision rates of at least 0, got {bad[0]}")
    figure = _figure(8.4, 3.8)
    panels = figure.subplots(1, 2, sharey=True)
    for team, axes in enumerate(panels):
        _draw_collisions(axes, values[:, team], _TEAMS[team], colors.TEAMS[team])
    panels[0].set_ylabel("collisions per 1000 agent-steps")
    panels[0].set_ylim(bottom=0.0)
    _legend_below(figure, *panels[0].get_legend_handles_labels(), columns=3)
    figure.suptitle(title)
    return figure


def comparison(payoffs: Mapping[str, ArrayLike], *, title: str | None = None) -> Figure:
    """Draw several races side by side, on the same scales.

    Each column is a race: its heat map, its lag profile and its generalisation curves, below its
    name and the verdict of :func:`matrixworld.analysis.summarize`.

    Parameters
    ----------
    payoffs : mapping of str to array_like of float
        Payoff matrices of at least 2 x 2, by the name of the race.
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure.

    Raises
    ------
    ValueError
        If there are no races, or as :func:`matrixworld.analysis.check_payoff` does.
    """
    if not payoffs:
        raise ValueError("expected at least one race to draw, got none")
    figure = _figure(1.2 + 4.0 * len(payoffs), 10.0)
    grid = figure.subplots(3, len(payoffs), squeeze=False, height_ratios=(1.7, 1.0, 1.0))
    images = [
        _draw_race(column, name, payoff)
        for (name, payoff), column in zip(payoffs.items(), grid.T, strict=True)
    ]
    figure.colorbar(images[0], ax=list(grid[0]), label=_SCALE, shrink=0.9)
    _legend_below(figure, *grid[2, 0].get_legend_handles_labels())
    for axes in grid[:, 1:].flat:
        axes.set_ylabel("")
    if title:
        figure.suptitle(title)
    return figure


def _figure(width: float, height: float) -> Figure:
    layout = ConstrainedLayoutEngine(w_pad=0.06, h_pad=0.06)
    return Figure(figsize=(width, height), dpi=DPI, layout=layout)


def _legend_below(
    figure: Figure, handles: Sequence[Artist], labels: Sequence[str], *, columns: int = 2
) -> None:
    figure.legend(handles, labels, loc="outside lower center", ncols=columns, frameon=False)


def _draw_race(column: NDArray[np.object_], name: str, payoff: ArrayLike) -> AxesImage:
    image = _draw_heatmap(column[0], payoff)
    column[0].set_title(name, fontweight="bold", pad=34)
    column[0].annotate(
        _verdict(payoff), (0.5, 1.0), xytext=(0, 5), xycoords="axes fraction",
        textcoords="offset points", ha="center", va="bottom", size="small",
    )  # fmt: skip
    _draw_lag_profile(column[1], payoff)
    _draw_generalization(column[2], payoff)
    for axes, title in zip(column[1:], ("lag profile", "generalisation"), strict=True):
        axes.set_title(title, size="medium")
    return image


def _verdict(payoff: ArrayLike) -> str:
    summary = analysis.summarize(payoff)
    late = summary.last_half
    numbers: list[str] = []
    if late.transitive_share is not None:
        numbers.append(f"transitive share {late.transitive_share:.2f}")
    if late.checkerboard_share is not None:
        numbers.append(f"checkerboards {late.checkerboard_share:.1%}")
    verdict = summary.verdict
    looks = verdict if verdict == "undecided" else f"looks like {verdict}"
    return f"{looks}\nlast half: {', '.join(numbers) or 'no variance'}"


def _draw_heatmap(axes: Axes, payoff: ArrayLike) -> AxesImage:
    matrix = analysis.check_payoff(payoff)
    image = axes.imshow(matrix, origin="lower", vmin=0.0, vmax=1.0, cmap=COLORMAP)
    end = min(matrix.shape) - 0.5
    # The light outline keeps the line visible on dark cells.
    axes.plot(
        (-0.5, end), (-0.5, end), color=colors.INK, linestyle="--", linewidth=1.2,
        path_effects=[Stroke(linewidth=2.6, foreground=colors.PAPER), Normal()],
    )  # fmt: skip
    axes.set(xlabel="evader generation", ylabel="pursuer generation")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(_whole_numbers(6))
    axes.set(xlim=(-0.5, matrix.shape[1] - 0.5), ylim=(-0.5, matrix.shape[0] - 0.5))
    return image


def _draw_generalization(axes: Axes, payoff: ArrayLike) -> None:
    scores = analysis.generalization(payoff)
    labels = ("pursuers: capture rate", "evaders: 1 - capture rate")
    for curve, label, color in zip(scores, labels, colors.TEAMS, strict=True):
        axes.plot(curve, color=color, label=label, linewidth=1.8)
    axes.set(xlabel="generation", ylabel="mean score")
    axes.xaxis.set_major_locator(_whole_numbers(6))
    axes.margins(x=0.02)
    _unit_axis(axes)


def _draw_baselines(axes: Axes, baselines: Mapping[str, float], color: str) -> None:
    for index, (name, score) in enumerate(baselines.items()):
        level = float(analysis.check_rates([score], ndim=1, what=f"baseline {name!r}")[0])
        dashes = _DASHES[index % len(_DASHES)]
        axes.axhline(level, color=color, linestyle=dashes, linewidth=1.3, label=name)


def _draw_lag_profile(axes: Axes, payoff: ArrayLike) -> None:
    profile = analysis.lag_profile(payoff)
    # In a small matrix no lag has FEWEST_CELLS cells; the middle half of its lags is solid then.
    solid = profile.cells >= min(FEWEST_CELLS, (profile.cells.max() + 1) // 2)
    axes.plot(profile.lags, profile.means, color=colors.INK, alpha=0.3, linewidth=1.0)
    axes.plot(profile.lags[solid], profile.means[solid], color=colors.INK, linewidth=1.8)
    axes.axvline(0, color=colors.MUTED, linestyle="--", linewidth=1.0, zorder=1)
    axes.set(xlabel="lag: pursuer minus evader generation", ylabel="mean capture rate")
    axes.xaxis.set_major_locator(_whole_numbers(8))
    axes.margins(x=0.02)
    _unit_axis(axes)
    aside: dict[str, Any] = {"color": colors.MUTED, "size": "small", "transform": axes.transAxes}
    axes.text(0.02, 0.97, "evaders are later", ha="left", va="top", **aside)
    axes.text(0.98, 0.03, "pursuers are later", ha="right", va="bottom", **aside)


def _draw_collisions(axes: Axes, rates: NDArray[np.float64], team: str, color: str) -> None:
    marker = "o" if len(rates) <= _MARKED else ""
    for kind, curve in enumerate(rates.T):
        axes.plot(
            curve, label=f"with {_KINDS[kind]}", color=colors.CONFLICTS[kind],
            linestyle=("-", *_DASHES)[kind], marker=marker, markersize=3,
        )  # fmt: skip
    axes.set_title(team, color=color)
    axes.set_xlabel("generation")
    axes.xaxis.set_major_locator(_whole_numbers(6))
    _plain_axis(axes)


def _learners(learners: ArrayLike, length: int) -> NDArray[np.int64]:
    teams = np.asarray(learners)
    if teams.shape != (length,) or not np.isin(teams, (0, 1)).all():
        raise ValueError(
            f"expected learners of shape ({length},), 0 for pursuers and 1 for evaders, "
            f"got shape {teams.shape} with values {np.unique(teams)[:5].tolist()}"
        )
    return teams.astype(np.int64)


def _shades(learners: ArrayLike | None, length: int) -> list[str]:
    """Return the colour of each point: that of the team that learns."""
    if learners is None:
        return [colors.INK] * length
    return [colors.TEAMS[team] for team in _learners(learners, length)]


def _in_pieces(values: NDArray[np.float64], shades: list[str], **style: Any) -> LineCollection:
    """Return the curve, each piece in the colour of the point that it leads to."""
    points = np.column_stack([np.arange(1, len(values) + 1), values])
    pieces = np.stack([points[:-1], points[1:]], axis=1)
    return LineCollection(list(pieces), colors=shades[1:], capstyle="round", **style)


def _moving_average(values: NDArray[np.float64], window: int) -> NDArray[np.float64]:
    """Return the centred mean of `window` points, and of fewer at both ends."""
    if window < 1:
        raise ValueError(f"expected a window of at least 1 point, got {window}")
    window = min(window, len(values))
    kernel = np.ones(window)
    counts = np.convolve(np.ones(len(values)), kernel, mode="same")
    average: NDArray[np.float64] = np.convolve(values, kernel, mode="same") / counts
    return average


def _generation_axis(axes: Axes, generations: NDArray[np.int64], length: int) -> None:
    """Add a second axis on top that shows where each generation begins."""
    if generations.shape != (length,):
        raise ValueError(f"expected generations of shape ({length},), got {generations.shape}")
    names, starts = np.unique(generations, return_index=True)
    every = max(1, round(len(names) / 10))
    top = axes.secondary_xaxis("top")
    top.set_xticks(starts[::every] + 1, [str(name) for name in names[::every]])
    top.set_xlabel("generation")


def _unit_axis(axes: Axes) -> None:
    axes.set_ylim(-0.02, 1.02)
    axes.set_yticks(np.linspace(0.0, 1.0, 6))
    _plain_axis(axes)


def _plain_axis(axes: Axes) -> None:
    axes.grid(color=colors.GRID, linewidth=0.8)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def _whole_numbers(at_most: int) -> MaxNLocator:
    return MaxNLocator(nbins=at_most, steps=[1, 2, 5, 10], integer=True)
