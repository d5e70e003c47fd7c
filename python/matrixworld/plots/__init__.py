"""Figures of a race: functions from arrays to a Matplotlib ``Figure``.

They need no display and do not touch the state of ``pyplot``. Save a figure with
``plots.save_figure(figure, path)``, as pixels or as vector graphics, or show it as the last
expression of a notebook cell after ``%matplotlib inline``. Arguments that are not as a docstring
describes them, and mappings without an entry, raise a ValueError.
"""

from __future__ import annotations

from matrixworld.plots.concepts import learning_concepts
from matrixworld.plots.conflicts import (
    SITUATIONS,
    Resolution,
    Situation,
    conflict_outcomes,
    resolve,
)
from matrixworld.plots.generalization import generalization_curves, generalization_over_seeds
from matrixworld.plots.payoffs import (
    COLORMAP,
    FEWEST_CELLS,
    ciao_triangles,
    comparison,
    lag_profile_curve,
    payoff_heatmap,
)
from matrixworld.plots.rules import interaction_models, rules_table, turns_of
from matrixworld.plots.runs import run_curves, run_dots, seed_scores
from matrixworld.plots.seeds import seed_bands, verdict_strip
from matrixworld.plots.style import DPI, FORMATS, format_of, save_figure
from matrixworld.plots.training import collision_rates, training_curve

__all__ = [
    "COLORMAP",
    "DPI",
    "FEWEST_CELLS",
    "FORMATS",
    "SITUATIONS",
    "Resolution",
    "Situation",
    "ciao_triangles",
    "collision_rates",
    "comparison",
    "conflict_outcomes",
    "format_of",
    "generalization_curves",
    "generalization_over_seeds",
    "interaction_models",
    "lag_profile_curve",
    "learning_concepts",
    "payoff_heatmap",
    "resolve",
    "rules_table",
    "run_curves",
    "run_dots",
    "save_figure",
    "seed_bands",
    "seed_scores",
    "training_curve",
    "turns_of",
    "verdict_strip",
]
