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
>>> print(analysis.report("payoff.csv"))  # doctest: +SKIP
"""

from __future__ import annotations

from matrixworld.analysis.cycles import (
    checkerboards,
    spinning_top,
    transitive_share,
    transitive_share_over_episodes,
    two_way_parts,
)
from matrixworld.analysis.dynamics import replicator_dynamics
from matrixworld.analysis.engagement import disengagements
from matrixworld.analysis.games import (
    alpha_rank,
    effective_diversity,
    exploitability,
    nash_averaging,
    response_gain,
)
from matrixworld.analysis.intervals import (
    Band,
    Estimate,
    band_over_runs,
    difference_of_runs,
    difference_over_episodes,
    generalization_over_episodes,
    interval_over_runs,
    linear_over_episodes,
    mean_over_episodes,
)
from matrixworld.analysis.judge import CONDITIONS, Judgement, judge
from matrixworld.analysis.measures import MEASURES, Measure, measure_all
from matrixworld.analysis.meta_strategies import (
    META_SOLVERS,
    projected_replicator_dynamics,
    rectified_nash,
)
from matrixworld.analysis.payoffs import check_payoff, last_half, read_payoffs
from matrixworld.analysis.progress import (
    ciao,
    dominance_tournament,
    generalization,
    global_progress,
    historical_progress,
    lag_profile,
    local_progress,
    team_phase_rates,
)
from matrixworld.analysis.ratings import ELO_POINTS, elo, elo_over_episodes, log_loss
from matrixworld.analysis.report import (
    all_results,
    explain,
    headline,
    judgement_table,
    report,
)
from matrixworld.analysis.runs import (
    fewest_runs,
    interquartile_mean,
    performance_profile,
    probability_of_improvement,
    race_bands,
)
from matrixworld.analysis.strength import forgetting

__all__ = [
    "CONDITIONS",
    "ELO_POINTS",
    "MEASURES",
    "META_SOLVERS",
    "Band",
    "Estimate",
    "Judgement",
    "Measure",
    "all_results",
    "alpha_rank",
    "band_over_runs",
    "check_payoff",
    "checkerboards",
    "ciao",
    "difference_of_runs",
    "difference_over_episodes",
    "disengagements",
    "dominance_tournament",
    "effective_diversity",
    "elo",
    "elo_over_episodes",
    "explain",
    "exploitability",
    "fewest_runs",
    "forgetting",
    "generalization",
    "generalization_over_episodes",
    "global_progress",
    "headline",
    "historical_progress",
    "interquartile_mean",
    "interval_over_runs",
    "judge",
    "judgement_table",
    "lag_profile",
    "last_half",
    "linear_over_episodes",
    "local_progress",
    "log_loss",
    "mean_over_episodes",
    "measure_all",
    "nash_averaging",
    "performance_profile",
    "probability_of_improvement",
    "projected_replicator_dynamics",
    "race_bands",
    "read_payoffs",
    "rectified_nash",
    "replicator_dynamics",
    "report",
    "response_gain",
    "spinning_top",
    "team_phase_rates",
    "transitive_share",
    "transitive_share_over_episodes",
    "two_way_parts",
]
