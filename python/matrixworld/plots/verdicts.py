"""Figure of verdicts: a strip with a column for each seed, and one for all together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch, Rectangle

from matrixworld import analysis
from matrixworld._util import colors
from matrixworld.analysis import CONDITIONS, Judgement
from matrixworld.analysis.judge import ABSENT, CANNOT_TELL, PRESENT
from matrixworld.plots.style import fitting, legend_below, new_figure

NOT_FINISHED = "not finished"
LOOKS: dict[str, dict[str, Any]] = {
    PRESENT: {"facecolor": colors.BLUE, "edgecolor": colors.PAPER},
    ABSENT: {"facecolor": colors.GRID, "edgecolor": colors.PAPER},
    CANNOT_TELL: {"facecolor": colors.PAPER, "edgecolor": colors.MUTED, "linewidth": 0.6},
    NOT_FINISHED: {"facecolor": colors.PAPER, "edgecolor": colors.FREE, "hatch": "/////"},
}
"""How a verdict is drawn: dark, light, empty, or hatched, so that colours are not needed."""
SIGNS = {PRESENT: "yes", ABSENT: "no", CANNOT_TELL: "?", NOT_FINISHED: ""}
"""Words in the cells, if they are wide enough."""
WORDED = 15  # most seeds whose cells have words


def verdict_strip(
    judgements: Mapping[str, Judgement],
    seeds: Mapping[str, Sequence[int]],
    missing: Mapping[str, Sequence[int]] | None = None,
    *,
    title: str = "Verdict on each seed, and on all together",
) -> Figure:
    """Draw the verdicts on each seed and on all together: a block for each group of runs.

    Parameters
    ----------
    judgements : mapping of str to Judgement
        Result of :func:`matrixworld.analysis.judge` over the seeds, by the name of the group.
    seeds : mapping of str to sequence of int
        Seeds of the runs that were judged, in their order.
    missing : mapping of str to sequence of int, optional
        Seeds that are not finished; they have an empty column.
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        The figure.

    Raises
    ------
    ValueError
        If there is no group, or it has another number of seeds than of judged runs.
    """
    if not judgements:
        raise ValueError("expected at least one group of runs to draw, got none")
    for name, judgement in judgements.items():
        if len(seeds[name]) != judgement.runs:
            raise ValueError(f"seeds: expected {judgement.runs} of {name}, got {len(seeds[name])}")
    absent = missing or {}
    most = max(len(seeds[name]) + len(absent.get(name, ())) for name in judgements)
    figure = new_figure(max(6.4, min(16.0, 3.6 + 0.42 * most)), 1.1 + 2.15 * len(judgements))
    panels = figure.subplots(len(judgements), 1, squeeze=False)[:, 0]
    for axes, (name, judgement) in zip(panels, judgements.items(), strict=True):
        columns = _columns(judgement, seeds[name], absent.get(name, ()))
        _draw_verdicts(axes, columns, judgement, most)
        axes.set_title(f"{name}: {analysis.headline(judgement)}", size="medium", loc="left")
    panels[-1].set_xlabel("seed", loc="left")
    legend_below(figure, [Patch(**look) for look in LOOKS.values()], [*LOOKS], columns=4)
    figure.suptitle(fitting(figure, title))
    return figure


def _columns(
    judgement: Judgement, seeds: Sequence[int], missing: Sequence[int]
) -> dict[int, dict[str, str]]:
    """Return the verdicts of each seed by condition, in the order of the seeds."""
    found = judgement.headline
    columns = {
        seed: {name: found[name].by_run[run] for name in CONDITIONS}
        for run, seed in enumerate(seeds)
    }
    columns |= {seed: dict.fromkeys(CONDITIONS, NOT_FINISHED) for seed in missing}
    return dict(sorted(columns.items()))


def _draw_verdicts(
    axes: Axes, columns: Mapping[int, Mapping[str, str]], judgement: Judgement, most: int
) -> None:
    for place, verdicts in enumerate(columns.values()):
        for row, name in enumerate(CONDITIONS):
            _draw_cell(axes, place, row, 1.0, verdicts[name], worded=most <= WORDED)
    # The verdict on all seeds is apart from the single ones, and always in words.
    width = max(2.4, 0.13 * most)
    for row, name in enumerate(CONDITIONS):
        verdict = judgement.headline[name].verdict
        _draw_cell(axes, most + 0.5, row, width, verdict, worded=True, word=verdict)
    every = -(-most // 30)
    places = [*range(0, len(columns), every)]
    axes.set_xticks(
        [*(place + 0.5 for place in places), most + 0.5 + width / 2],
        [*(str([*columns][place]) for place in places), "all together"],
    )
    axes.set_yticks(np.arange(len(CONDITIONS)) + 0.5, CONDITIONS)
    axes.set(xlim=(-0.05, most + 0.55 + width), ylim=(len(CONDITIONS) + 0.05, -0.05))
    axes.tick_params(length=0, labelsize="small")
    axes.spines[:].set_visible(False)


def _draw_cell(
    axes: Axes, x: float, y: float, width: float, verdict: str, *, worded: bool, word: str = ""
) -> None:
    inset = 0.05
    look = LOOKS[verdict]
    axes.add_patch(Rectangle((x + inset, y + inset), width - 2 * inset, 1 - 2 * inset, **look))
    if worded:
        axes.text(
            x + width / 2, y + 0.5, word or SIGNS[verdict], ha="center", va="center", size="small",
            color=colors.PAPER if verdict == PRESENT else colors.INK,
        )  # fmt: skip
