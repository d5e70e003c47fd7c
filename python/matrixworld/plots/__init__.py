"""Figures of a race: functions from arrays to a Matplotlib ``Figure``.

They need no display and do not touch the state of ``pyplot``. Save a figure with
``plots.save_figure(figure, path)``, as pixels or as vector graphics, or show it as the last
expression of a notebook cell after ``%matplotlib inline``.

=========================  =======================================================================
payoff_heatmap             every pursuer generation against every evader generation
generalization_curves      mean score of each generation against all opponents, beside baselines
generalization_over_seeds  the same of several seeds, with intervals
lag_profile_curve          mean capture rate by how much later the pursuers are than the evaders
training_curve             capture rate while pursuers and evaders learn in turn
collision_rates            collisions by team and kind over generations
comparison                 several races side by side, with their judgements and numbers
seed_bands                 bands over seeds: generalisation, strength and lag profile
verdict_strip              verdicts on each seed, and on all together
seed_scores                performance profiles and interquartile means of scores of several seeds
rules_table                variants of the game as rows of a table
conflict_outcomes          what the engine makes of the same moves under each outcome
interaction_models         which agents observe and act together in a round
=========================  =======================================================================
"""

from __future__ import annotations

from matrixworld.plots.conflicts import (
    SITUATIONS,
    Resolution,
    Situation,
    conflict_outcomes,
    resolve,
)
from matrixworld.plots.generalization import generalization_over_seeds
from matrixworld.plots.interaction import interaction_models, turns_of
from matrixworld.plots.payoffs import (
    COLORMAP,
    FEWEST_CELLS,
    comparison,
    generalization_curves,
    lag_profile_curve,
    payoff_heatmap,
)
from matrixworld.plots.rules_table import rules_table
from matrixworld.plots.saving import FORMATS, format_of, save_figure
from matrixworld.plots.seed_scores import seed_scores
from matrixworld.plots.seeds import seed_bands
from matrixworld.plots.style import DPI
from matrixworld.plots.training import collision_rates, training_curve
from matrixworld.plots.verdicts import verdict_strip

__all__ = [
    "COLORMAP",
    "DPI",
    "FEWEST_CELLS",
    "FORMATS",
    "SITUATIONS",
    "Resolution",
    "Situation",
    "collision_rates",
    "comparison",
    "conflict_outcomes",
    "format_of",
    "generalization_curves",
    "generalization_over_seeds",
    "interaction_models",
    "lag_profile_curve",
    "payoff_heatmap",
    "resolve",
    "rules_table",
    "save_figure",
    "seed_bands",
    "seed_scores",
    "training_curve",
    "turns_of",
    "verdict_strip",
]
