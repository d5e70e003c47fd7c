"""Analysis of co-evolutionary races from plain arrays; no world is needed.

All functions take a *payoff matrix* M of shape (n, m): ``M[g, h]`` is the capture rate, in [0, 1],
of the pursuers of generation g against the evaders of generation h. The payoff of the evaders is
``1 - M``. NumPy and SciPy are the only dependencies. Functions import SciPy when they need it,
because it takes longer to load than the rest of the package.

Arguments that are not as a docstring describes them raise an error that says what was expected and
what came: ValueError for shapes, ranges and values that are not finite, TypeError for what holds no
real numbers, FileNotFoundError for a file that does not exist.

>>> from matrixworld import analysis
>>> print(analysis.headline(analysis.judge(scores, per_episode=True)))  # doctest: +SKIP
>>> print(analysis.measure_table("payoff.csv"))  # doctest: +SKIP
"""

from __future__ import annotations

from matrixworld.analysis.cycles import (
    checkerboards,
    spinning_top,
    transitive_share,
    transitive_share_over_episodes,
    two_way_parts,
)
from matrixworld.analysis.dynamics import alpha_rank, replicator_dynamics
from matrixworld.analysis.games import (
    effective_diversity,
    exploitability,
    nash_averaging,
)
from matrixworld.analysis.intervals import (
    Estimate,
    band_over_runs,
    difference_of_runs,
    interval_over_runs,
    mean_over_episodes,
)
from matrixworld.analysis.judge import CONDITIONS, Judgement, judge
from matrixworld.analysis.measures import MEASURES, measure_all
from matrixworld.analysis.payoffs import last_half, read_payoffs
from matrixworld.analysis.progress import (
    ciao,
    disengagements,
    dominance_tournament,
    generalization,
    global_progress,
    historical_progress,
    lag_profile,
    local_progress,
    team_phase_rates,
)
from matrixworld.analysis.ratings import elo, elo_over_episodes, log_loss
from matrixworld.analysis.runs import (
    interquartile_mean,
    performance_profile,
    probability_of_improvement,
)
from matrixworld.analysis.strength import forgetting
from matrixworld.analysis.words import (
    explain,
    headline,
    judgement_table,
    measure_table,
    sentence,
)

__all__ = [
    "CONDITIONS",
    "MEASURES",
    "Estimate",
    "Judgement",
    "alpha_rank",
    "band_over_runs",
    "checkerboards",
    "ciao",
    "difference_of_runs",
    "disengagements",
    "dominance_tournament",
    "effective_diversity",
    "elo",
    "elo_over_episodes",
    "explain",
    "exploitability",
    "forgetting",
    "generalization",
    "global_progress",
    "headline",
    "historical_progress",
    "interquartile_mean",
    "interval_over_runs",
    "judge",
    "judgement_table",
    "lag_profile",
    "last_half",
    "local_progress",
    "log_loss",
    "mean_over_episodes",
    "measure_all",
    "measure_table",
    "nash_averaging",
    "performance_profile",
    "probability_of_improvement",
    "read_payoffs",
    "replicator_dynamics",
    "sentence",
    "spinning_top",
    "team_phase_rates",
    "transitive_share",
    "transitive_share_over_episodes",
    "two_way_parts",
]
