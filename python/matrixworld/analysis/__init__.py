"""Analysis of co-evolutionary races from plain arrays; no world is needed.

All functions take a *payoff matrix* M of shape (n, m): ``M[g, h]`` is the capture rate, in [0, 1],
of the pursuers of generation g against the evaders of generation h. The payoff of the evaders is
``1 - M``. NumPy and SciPy are the only dependencies. Functions import SciPy when they need it,
because it takes longer to load than the rest of the package.

>>> from matrixworld import analysis
>>> print(analysis.headline(analysis.judge(scores, per_episode=True)))  # doctest: +SKIP
>>> print(analysis.analyze("payoff.csv"))  # doctest: +SKIP

==================  ================================================================================
payoff.py           validate a matrix, take its last half, swap the teams, logits
generalization.py   generalization; local, historical and global progress
lags.py             lag profile, capture rates after team phases, swing
ciao.py             CIAO: current individuals against ancestral opponents; stripes and fading
dominance.py        dominance tournament: generations that were significantly better than all before
cycles.py           transitive and cyclic parts, transitive share, checkerboards
ratings.py          Elo and multidimensional Elo
nash.py             Nash averaging: the maximum-entropy equilibrium and payoffs against it
exploitability.py   gains of best responses: within the matrix, or evolved separately
alpha_rank.py       alpha-Rank of two populations
engagement.py       disengagement: one team wins nearly all matches
intervals.py        intervals over training runs
episode_intervals   intervals over the episodes of one run
run_scores.py       interquartile mean and performance profile of scores of several runs
race_bands.py       mean curves of several runs, with intervals
summary.py          headline numbers of a matrix
wording.py          judgements and summaries in words
measures.py         named measures, for comparison between runs
single_run.py       all measures of one run
analyze.py          all measures of one run or several, with intervals
judgement.py        arms race, cycling, forgetting, disengagement, stagnation: what is present
verdicts.py         the rules of the judgement: from its numbers to its verdicts
evidence.py         the numbers behind a judgement, of one run in one window
measurement.py      a number of one run with its interval, and over several runs
strength.py         change of a team's strength over a window
intransitivity.py   deviation of capture rates from every order of strength
forgetting.py       drop below the best ancestors, with and without selection bias
sources.py          payoffs from arrays and files
tables.py           payoffs in CSV files
plain_values.py     results as plain values for JSON
==================  ================================================================================
"""

from __future__ import annotations

from matrixworld.analysis.alpha_rank import AlphaRank, alpha_rank, fixation_probability
from matrixworld.analysis.analyze import Analysis, analyze
from matrixworld.analysis.ciao import Ciao, Triangle, autocorrelation, ciao
from matrixworld.analysis.cycles import (
    Checkerboard,
    Checkerboards,
    TwoWayParts,
    checkerboards,
    strongest_checkerboards,
    transitive_share,
    two_way_parts,
)
from matrixworld.analysis.dominance import (
    Dominance,
    Ladder,
    dominance_of_counts,
    dominance_tournament,
)
from matrixworld.analysis.engagement import (
    Disengagement,
    Undecided,
    disengagements,
    fitness_variance,
    undecided_opponents,
)
from matrixworld.analysis.episode_intervals import (
    difference_over_episodes,
    generalization_over_episodes,
    linear_over_episodes,
    mean_over_episodes,
    transitive_share_over_episodes,
)
from matrixworld.analysis.exploitability import (
    Exploitability,
    ResponseGain,
    exploitability,
    response_gain,
)
from matrixworld.analysis.forgetting import Forgetting, forgetting, held_out_forgetting
from matrixworld.analysis.generalization import (
    Generalization,
    Progress,
    TeamProgress,
    generalization,
    global_progress,
    historical_progress,
    local_progress,
)
from matrixworld.analysis.intervals import (
    Band,
    Estimate,
    band_over_runs,
    difference_of_runs,
    interval_over_runs,
)
from matrixworld.analysis.intransitivity import (
    NoiseReference,
    cyclic_amplitude,
    noise_reference,
    transitive_fit,
)
from matrixworld.analysis.judgement import Finding, Judgement, WindowJudgement, judge
from matrixworld.analysis.lags import (
    LagProfile,
    lag_profile,
    lag_rise,
    swing,
    team_phase_rates,
)
from matrixworld.analysis.measurement import Measurement
from matrixworld.analysis.measures import MEASURES, Measure, measure_over_episodes
from matrixworld.analysis.nash import Nash, game_value, nash_averaging
from matrixworld.analysis.payoff import (
    check_payoff,
    check_rates,
    check_runs,
    last_half,
    logits,
    swap_teams,
)
from matrixworld.analysis.race_bands import RaceBands, race_bands
from matrixworld.analysis.ratings import ELO_POINTS, Elo, MultiElo, elo, log_loss, multi_elo
from matrixworld.analysis.run_scores import (
    PerformanceProfile,
    fewest_runs,
    interquartile_mean,
    performance_profile,
    probability_of_improvement,
)
from matrixworld.analysis.single_run import RunAnalysis, analyze_run
from matrixworld.analysis.sources import Payoffs, read_payoffs
from matrixworld.analysis.strength import strength_change, strength_gain
from matrixworld.analysis.summary import PartSummary, Summary, TeamSummary, summarize
from matrixworld.analysis.verdicts import CONDITIONS
from matrixworld.analysis.wording import describe, explain, headline, judgement_table

__all__ = [
    "CONDITIONS",
    "ELO_POINTS",
    "MEASURES",
    "AlphaRank",
    "Analysis",
    "Band",
    "Checkerboard",
    "Checkerboards",
    "Ciao",
    "Disengagement",
    "Dominance",
    "Elo",
    "Estimate",
    "Exploitability",
    "Finding",
    "Forgetting",
    "Generalization",
    "Judgement",
    "Ladder",
    "LagProfile",
    "Measure",
    "Measurement",
    "MultiElo",
    "Nash",
    "NoiseReference",
    "PartSummary",
    "Payoffs",
    "PerformanceProfile",
    "Progress",
    "RaceBands",
    "ResponseGain",
    "RunAnalysis",
    "Summary",
    "TeamProgress",
    "TeamSummary",
    "Triangle",
    "TwoWayParts",
    "Undecided",
    "WindowJudgement",
    "alpha_rank",
    "analyze",
    "analyze_run",
    "autocorrelation",
    "band_over_runs",
    "check_payoff",
    "check_rates",
    "check_runs",
    "checkerboards",
    "ciao",
    "cyclic_amplitude",
    "describe",
    "difference_of_runs",
    "difference_over_episodes",
    "disengagements",
    "dominance_of_counts",
    "dominance_tournament",
    "elo",
    "explain",
    "exploitability",
    "fewest_runs",
    "fitness_variance",
    "fixation_probability",
    "forgetting",
    "game_value",
    "generalization",
    "generalization_over_episodes",
    "global_progress",
    "headline",
    "held_out_forgetting",
    "historical_progress",
    "interquartile_mean",
    "interval_over_runs",
    "judge",
    "judgement_table",
    "lag_profile",
    "lag_rise",
    "last_half",
    "linear_over_episodes",
    "local_progress",
    "log_loss",
    "logits",
    "mean_over_episodes",
    "measure_over_episodes",
    "multi_elo",
    "nash_averaging",
    "noise_reference",
    "performance_profile",
    "probability_of_improvement",
    "race_bands",
    "read_payoffs",
    "response_gain",
    "strength_change",
    "strength_gain",
    "strongest_checkerboards",
    "summarize",
    "swap_teams",
    "swing",
    "team_phase_rates",
    "transitive_fit",
    "transitive_share",
    "transitive_share_over_episodes",
    "two_way_parts",
    "undecided_opponents",
]
