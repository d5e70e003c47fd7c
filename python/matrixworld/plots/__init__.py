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
comparison               several races side by side, with their judgements and numbers
seed_bands               bands over seeds: generalisation, Elo rating and lag profile
verdict_strip            verdicts on each seed, and on all together
seed_scores              performance profiles and interquartile means of scores of several seeds
=======================  ==========================================================================
"""

from __future__ import annotations

from matrixworld.plots.payoffs import (
    COLORMAP,
    FEWEST_CELLS,
    comparison,
    generalization_curves,
    lag_profile_curve,
    payoff_heatmap,
)
from matrixworld.plots.seed_scores import seed_scores
from matrixworld.plots.seeds import seed_bands
from matrixworld.plots.style import DPI
from matrixworld.plots.training import collision_rates, training_curve
from matrixworld.plots.verdicts import verdict_strip

__all__ = [
    "COLORMAP",
    "DPI",
    "FEWEST_CELLS",
    "collision_rates",
    "comparison",
    "generalization_curves",
    "lag_profile_curve",
    "payoff_heatmap",
    "seed_bands",
    "seed_scores",
    "training_curve",
    "verdict_strip",
]
