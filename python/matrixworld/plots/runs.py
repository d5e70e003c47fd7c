"""Figures of groups of runs: any number or curve, and verdicts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import ArrayLike

from matrixworld import analysis
from matrixworld._util import checks, colors
from matrixworld.analysis.intervals import UNBOUNDED, Bounds
from matrixworld.analysis.judgement import ABSENT, CANNOT_TELL, PRESENT, Judgement
from matrixworld.plots import style

NAMES_OF_VERDICTS = 20  # characters that they take at the left
NAMES = 3  # share of the width that the names of groups may take: a third


def run_dots(
    groups: Mapping[str, ArrayLike],
    *,
    label: str,
    levels: Mapping[str, float] | None = None,
    each: str = "one run",
    title: str | None = None,
    bounds: Bounds = UNBOUNDED,
) -> Figure:
    """Draw one number of each run as a dot, and the mean of each group with its 95% interval.

    The axis shows all of [0, 1] if the numbers are in it and reach half of it, as scores do.

    Parameters
    ----------
    groups : mapping of str to array_like, shape (runs,)
        Finite numbers by the name of the group, which has a row.
    label : str
        What the numbers are.
    levels : mapping of str to float, optional
        Numbers to compare with, by name: vertical lines.
    each : str, optional
        What a dot stands for.
    title : str, optional
        Text above the figure.
    bounds : tuple of float, optional
        Smallest and largest possible number, to which intervals are clipped.

    Returns
    -------
    Figure
        To be shown or saved, see `save_figure`.
    """
    style.check_some(groups)
    figure, axes = style.single(6.6, 1.5 + 0.5 * len(groups))
    for row, values in enumerate(groups.values()):
        mean = analysis.interval_over_runs(values, bounds=bounds)
        _draw_dots(axes, row, mean, np.asarray(values))
    for index, (name, level) in enumerate(style.by_name("levels", levels).items()):
        dashes = style.DASHES[index % len(style.DASHES)]
        place = checks.check_real(f"level {name}", level)
        axes.axvline(place, color=colors.MUTED, linestyle=dashes, linewidth=1.3, label=name)
    axes.scatter([], [], s=16, color=colors.SKY_BLUE, label=each)
    axes.errorbar([], [], xerr=[], fmt="D", color=colors.INK, label="mean, 95% interval")
    names = [style.wrapped(name, style.room(figure, NAMES)) for name in groups]
    axes.set_yticks(np.arange(len(names)), names)
    axes.set(ylim=(len(names) - 0.5, -0.5), xlabel=style.wrapped(label, style.room(figure, 1.6)))
    low, high = axes.get_xlim()
    numbers = np.concatenate([np.ravel(values) for values in groups.values()])
    if numbers.min() >= 0.0 and 0.5 <= numbers.max() <= 1.0:
        axes.set_xlim(min(low, -0.02), max(high, 1.02))
    style.plain_axis(axes)
    axes.grid(visible=False, axis="y")
    return style.finished(figure, style.labelled(axes), title, columns=4)


def _draw_dots(axes: Axes, row: float, mean: analysis.Estimate, values: np.ndarray) -> None:
    # Equal values lie on top of each other, so the dots are spread over the height of the row.
    heights = row - 0.22 + 0.12 * (np.arange(len(values)) % 3 - 1)
    axes.scatter(values, heights, s=16, color=colors.SKY_BLUE, edgecolor=colors.BLUE, linewidth=0.4)
    if mean.low is not None and mean.high is not None:
        axes.plot([mean.low, mean.high], [row + 0.2] * 2, color=colors.INK, linewidth=1.8)
    axes.plot(mean.value, row + 0.2, "D", color=colors.INK, markersize=5)


def differences(
    panels: Mapping[str, Mapping[str, analysis.Estimate]],
    *,
    label: str,
    singles: Mapping[str, Mapping[str, ArrayLike]] | None = None,
    interval: str = "95% interval",
    title: str | None = None,
) -> Figure:
    """Draw differences of two groups of runs, each with its interval, around a line at 0.

    Parameters
    ----------
    panels : mapping of str to mapping of str to Estimate
        Differences by their names, such as ``"one minus other"``, in a panel for each measure or
        team; those of `matrixworld.compare` are meant.
    label : str
        What the numbers are differences of.
    singles : mapping of str to mapping of str to array_like, shape (runs,), optional
        Differences of pairs of runs, by panel and name: dots.
    interval : str, optional
        What the intervals are.
    title : str, optional
        Text above the figure.

    Returns
    -------
    Figure
        To be shown or saved, see `save_figure`.
    """
    style.check_some(panels, "panel")
    for rows in panels.values():
        style.check_some(rows, "difference")
    counts = [len(rows) for rows in panels.values()]
    figure = style.new_figure(6.6, 1.1 + 0.3 * len(panels) + 0.5 * sum(counts))
    grid = figure.subplots(len(panels), 1, sharex=True, squeeze=False, height_ratios=counts)[:, 0]
    dots = style.by_name("singles", singles)
    for axes, (panel, rows) in zip(grid, panels.items(), strict=True):
        axes.axvline(0.0, color=colors.MUTED, linestyle="--", linewidth=1.2, zorder=1)
        for row, (name, found) in enumerate(rows.items()):
            _draw_dots(axes, row + 0.15, found, np.asarray(dots.get(panel, {}).get(name, ())))
            # Above its numbers: beside them long names would leave no room in a column.
            look: dict[str, Any] = {"facecolor": colors.PAPER, "linewidth": 0, "pad": 0.5}
            place: dict[str, Any] = {"transform": axes.get_yaxis_transform(), "va": "bottom"}
            axes.text(0.0, row - 0.26, name, size="small", bbox=look, **place)
        axes.set(ylim=(len(rows) - 0.5, -0.6), yticks=[])
        axes.set_title(panel, size="medium", loc="left", fontweight="bold")
        style.plain_axis(axes)
        axes.spines["left"].set_visible(False)
        axes.grid(visible=False, axis="y")
    grid[-1].set_xlabel(style.wrapped(label, style.room(figure, 1.2)))
    if any(map(len, dots.values())):
        grid[0].scatter([], [], s=16, color=colors.SKY_BLUE, label="one seed, paired")
    grid[0].errorbar([], [], xerr=[], fmt="D", color=colors.INK, label=f"mean, {interval}")
    return style.finished(figure, style.labelled(grid[0]), title, columns=4)


def run_curves(
    groups: Mapping[str, ArrayLike],
    *,
    label: str,
    places: ArrayLike | None = None,
    along: str = "generation",
    title: str | None = None,
    bounds: Bounds = UNBOUNDED,
) -> Figure:
    """Draw mean curves over runs with their 95% bands; thin lines are single runs, if at most 10.

    Parameters
    ----------
    groups : mapping of str to array_like, shape (runs, k)
        Curves by the name of the group, with the bands of
        :func:`matrixworld.analysis.band_over_runs`.
    label : str
        What the numbers are.
    places : array_like, shape (k,), optional
        Where the points lie. The default is 0, 1, ...
    along : str, optional
        Name of the axis of places.
    title : str, optional
        Text above the figure.
    bounds : tuple of float, optional
        Smallest and largest possible number, to which bands are clipped.

    Returns
    -------
    Figure
        To be shown or saved, see `save_figure`.
    """
    style.check_some(groups)
    figure, axes = style.single(6.6, 3.6)
    for index, (name, curves) in enumerate(groups.items()):
        color, line = style.LINES[index % len(style.LINES)]
        band = analysis.band_over_runs(curves, places=places, bounds=bounds)
        axes.plot(band.places, band.mean, color=color, linestyle=line, linewidth=1.7, label=name)
        style.draw_runs(axes, band, curves, color)
    style.label_runs(axes, (len(np.asarray(curves)) for curves in groups.values()))
    axes.fill_between([], [], [], color=colors.MUTED, alpha=0.3, linewidth=0, label="95% interval")
    axes.set(xlabel=along, ylabel=label)
    style.generation_axis(axes)
    style.plain_axis(axes)
    entries = style.labelled(axes)
    return style.finished(figure, entries, title, columns=4 if len(entries) <= 4 else 3)


NOT_FINISHED = "not finished"
LOOKS = {
    PRESENT: colors.BLUE,
    ABSENT: colors.GRID,
    CANNOT_TELL: colors.PAPER,
    NOT_FINISHED: colors.FREE,
}
"""How a verdict is drawn: tones that differ in grey, too."""


def verdict_strip(
    judgements: Mapping[str, Judgement],
    seeds: Mapping[str, Sequence[int]],
    missing: Mapping[str, Sequence[int]] | None = None,
) -> Figure:
    """Draw the verdicts on each seed, and name those on all together: a block for each group.

    By the names of the groups of runs there are `judgements`, the `seeds` of the runs in their
    order, and those that are `missing`, whose columns say so.
    """
    style.check_some(judgements)
    of_seeds, absent = style.by_name("seeds", seeds), style.by_name("missing", missing)
    columns: dict[str, dict[int, list[str]]] = {}
    for name, judgement in judgements.items():
        checks.check_instance(name, judgement, Judgement)
        finished = _seeds(f"seeds of {name}", of_seeds.get(name, ()))
        if len(finished) != judgement.runs:
            raise ValueError(f"seeds: expected {judgement.runs} of {name}, got {len(finished)}")
        findings = judgement.findings.values()
        verdicts = {seed: [f.by_run[run] for f in findings] for run, seed in enumerate(finished)}
        left = _seeds(f"missing of {name}", absent.get(name, ()))
        verdicts |= dict.fromkeys(left, [NOT_FINISHED] * len(findings))
        columns[name] = dict(sorted(verdicts.items()))
    most = max(map(len, columns.values()))
    figure = style.new_figure(max(6.4, min(16.0, 3.6 + 0.42 * most)), 1.0)
    panels = figure.subplots(len(judgements), 1, squeeze=False)[:, 0]
    room = style.room(figure) - NAMES_OF_VERDICTS
    lines = 0
    for axes, (name, judgement) in zip(panels, judgements.items(), strict=True):
        _draw_verdicts(axes, columns[name], judgement, most, room)
        head = style.wrapped(f"{name}: {analysis.sentence(judgement)}", room)
        axes.set_title(head, size="medium", loc="left")
        lines += len(head.splitlines())
    figure.set_figheight(1.1 + 1.8 * len(judgements) + 0.17 * lines)
    panels[-1].set_xlabel("seed", loc="left")
    entries = {name: Patch(facecolor=look, edgecolor=colors.MUTED) for name, look in LOOKS.items()}
    title = "Verdict on each seed, and on all together"
    return style.finished(figure, entries, title, columns=4)


def _seeds(name: str, given: Sequence[int]) -> list[int]:
    return [
        checks.check_integer(name, seed, 0, checks.SEED_MAX)
        for seed in checks.check_sequence(name, given, "seeds")
    ]


def _draw_verdicts(
    axes: Axes, columns: Mapping[int, list[str]], judgement: Judgement, most: int, room: int
) -> None:
    """Draw verdicts in columns, at `most` so many; a line has room for so many characters."""
    kinds = [*LOOKS]
    cells = np.array([[kinds.index(verdict) for verdict in column] for column in columns.values()])
    look: dict[str, Any] = {"edgecolors": colors.MUTED, "linewidth": 0.6}
    axes.pcolormesh(cells.T, cmap=ListedColormap([*LOOKS.values()]), vmin=0, vmax=3, **look)
    rows = [f"{name}: {finding.verdict}" for name, finding in judgement.findings.items()]
    axes.set_yticks(np.arange(len(rows)) + 0.5, rows)
    longest = max(len(str(seed)) for seed in columns)
    places = range(0, len(columns), -(-most * (longest + 1) // room))
    axes.set_xticks([place + 0.5 for place in places], [str([*columns][place]) for place in places])
    axes.set(xlim=(0, most), ylim=(len(rows), 0))
    axes.tick_params(length=0, labelsize="small")
    axes.spines[:].set_visible(False)
