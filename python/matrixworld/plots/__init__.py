"""Figures of a race: functions from arrays to a Matplotlib ``Figure``.

They need no display and do not touch the state of ``pyplot``. Save a figure with
``plots.save_figure(figure, path)``, as pixels or as vector graphics, or show it as the last
expression of a notebook cell after ``%matplotlib inline``. Within ``plots.at_width(3.35)`` they
have that width, and type for it. Arguments that are not as a docstring describes them, and mappings
without an entry, raise a ValueError.
"""

from __future__ import annotations

from matrixworld.plots.game import (
    conflict_outcomes,
    interaction_models,
    learning_concepts,
    paths,
    right_of_way,
    rules_table,
)
from matrixworld.plots.race import (
    ciao_triangles,
    comparison,
    generalization_curves,
    lag_profile_curve,
    payoff_heatmap,
    replicator_trajectories,
    spinning_top,
)
from matrixworld.plots.runs import (
    run_curves,
    run_dots,
    seed_bands,
    seed_scores,
    verdict_strip,
)
from matrixworld.plots.style import at_width, save_figure
from matrixworld.plots.training import collision_rates, training_curve

__all__ = [
    "at_width",
    "ciao_triangles",
    "collision_rates",
    "comparison",
    "conflict_outcomes",
    "generalization_curves",
    "interaction_models",
    "lag_profile_curve",
    "learning_concepts",
    "paths",
    "payoff_heatmap",
    "replicator_trajectories",
    "right_of_way",
    "rules_table",
    "run_curves",
    "run_dots",
    "save_figure",
    "seed_bands",
    "seed_scores",
    "spinning_top",
    "training_curve",
    "verdict_strip",
]
