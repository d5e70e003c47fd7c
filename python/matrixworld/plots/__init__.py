"""Figures of a race: functions from arrays to a Matplotlib ``Figure``.

They need no display and do not touch the state of ``pyplot``. Save a figure with
``plots.save_figure(figure, path)``, as pixels or as vector graphics, or show it as the last
expression of a notebook cell after ``%matplotlib inline``. Arguments that are not as a docstring
describes them, and mappings without an entry, raise a ValueError.
"""

from __future__ import annotations

from matrixworld.plots.race import ciao_triangles, comparison, payoff_heatmap
from matrixworld.plots.runs import differences, run_curves, run_dots, verdict_strip
from matrixworld.plots.style import save_figure

__all__ = [
    "ciao_triangles",
    "comparison",
    "differences",
    "payoff_heatmap",
    "run_curves",
    "run_dots",
    "save_figure",
    "verdict_strip",
]
