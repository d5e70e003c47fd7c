"""Analysis of co-evolutionary races from plain arrays; no world is needed.

All functions take a *payoff matrix* M of shape (n, m): ``M[g, h]`` is the capture rate, in [0, 1],
of the pursuers of generation g against the evaders of generation h. The payoff of the evaders is
``1 - M``. NumPy and SciPy are the only dependencies. Functions import SciPy when they need it,
because it takes longer to load than the rest of the package.

Arguments that are not as a docstring describes them raise an error that says what was expected and
what came: ValueError for shapes, ranges and values that are not finite, TypeError for what holds no
real numbers, FileNotFoundError for a file that does not exist.

>>> from matrixworld import analysis
>>> print(analysis.sentence(analysis.judge(scores, per_episode=True)))  # doctest: +SKIP
>>> print(analysis.measure_table("payoff.csv"))  # doctest: +SKIP
"""

from __future__ import annotations

from matrixworld.analysis.cycles import checkerboards, transitive_share
from matrixworld.analysis.games import exploitability, nash_averaging
from matrixworld.analysis.intervals import (
    Estimate,
    band_over_runs,
    difference_of_runs,
    interquartile_mean,
    interval_over_runs,
    mean_over_episodes,
)
from matrixworld.analysis.judge import judge
from matrixworld.analysis.judgement import CONDITIONS, Judgement, explain, judgement_table, sentence
from matrixworld.analysis.measures import MEASURES, joint_scores, measure_all, measure_table
from matrixworld.analysis.payoffs import last_half, read_payoffs
from matrixworld.analysis.progress import (
    ciao,
    disengagements,
    generalization,
    lag_profile,
    team_phase_rates,
)
from matrixworld.analysis.ratings import elo, elo_over_episodes
from matrixworld.analysis.strength import forgetting

__all__ = [
    "CONDITIONS",
    "MEASURES",
    "Estimate",
    "Judgement",
    "band_over_runs",
    "checkerboards",
    "ciao",
    "difference_of_runs",
    "disengagements",
    "elo",
    "elo_over_episodes",
    "explain",
    "exploitability",
    "forgetting",
    "generalization",
    "interquartile_mean",
    "interval_over_runs",
    "joint_scores",
    "judge",
    "judgement_table",
    "lag_profile",
    "last_half",
    "mean_over_episodes",
    "measure_all",
    "measure_table",
    "nash_averaging",
    "read_payoffs",
    "sentence",
    "team_phase_rates",
    "transitive_share",
]
