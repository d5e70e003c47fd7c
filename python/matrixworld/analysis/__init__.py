"""What happened in a race: numbers from plain arrays, no world needed.

Everything here takes a *payoff matrix* ``M`` of shape ``(n, m)``: ``M[g, h]`` is the capture rate,
in [0, 1], of the pursuers of generation ``g`` against the evaders of generation ``h``. The evaders'
payoff is ``1 - M``. NumPy and SciPy are the only dependencies; SciPy is imported by the functions
that need it, because it takes longer to load than everything else.

>>> from matrixworld import analysis
>>> print(analysis.describe(analysis.summarize(payoff)))  # doctest: +SKIP
>>> print(analysis.analyze("payoff.csv"))  # doctest: +SKIP

==================  ================================================================================
payoff.py           check a matrix, take its last half, swap the teams, logits
progress.py         generalisation, forgetting; local, historical and global progress
lags.py             lag profile, team phases and their swing
ciao.py             CIAO: the current individual against ancestral opponents, stripes and fading
dominance.py        dominance tournament: the generations that were significant steps up
cycles.py           transitive and cyclic parts, transitive share, checkerboards
ratings.py          Elo and multidimensional Elo
nash.py             Nash averaging: the maximum-entropy equilibrium and averages against it
exploitability.py   what best responses gain: within the matrix, or evolved afresh
alpha_rank.py       alpha-Rank of two populations
engagement.py       disengagement: when one team wins everything and neither has anything to learn
bootstrap.py        intervals over training runs and over episodes
summary.py          the headline numbers of a matrix, and whether they look like cycling or progress
wording.py          the same in sentences
measures.py         the numbers that are compared between runs, by name
single_run.py       everything above for one run
analyze.py          everything for one run or several, with intervals
evidence.py         rises, forgetting without the luck of the best; numbers behind a diagnosis
calibration.py      what such numbers meant in toy races whose truth is known
diagnosis.py        arms race, cycling, disengagement, forgetting, stagnation: which is it?
advice.py           a diagnosis in words
sources.py          what `analyze` and `diagnose` read: arrays and files
tables.py           CSV files
==================  ================================================================================
"""

from __future__ import annotations

from matrixworld.analysis.alpha_rank import AlphaRank, alpha_rank, fixation_probability
from matrixworld.analysis.analyze import Analysis, analyze
from matrixworld.analysis.bootstrap import (
    Band,
    Estimate,
    bootstrap_band,
    bootstrap_difference,
    bootstrap_episodes,
    bootstrap_runs,
)
from matrixworld.analysis.calibration import CONDITIONS
from matrixworld.analysis.ciao import Ciao, Triangle, autocorrelation, ciao
from matrixworld.analysis.cycles import (
    Checkerboards,
    TwoWayParts,
    checkerboards,
    transitive_share,
    two_way_parts,
)
from matrixworld.analysis.diagnosis import Diagnosis, Finding, diagnose
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
from matrixworld.analysis.evidence import Rises, held_out_forgetting, rises
from matrixworld.analysis.exploitability import (
    Exploitability,
    ResponseGain,
    exploitability,
    response_gain,
)
from matrixworld.analysis.lags import LagProfile, half_steps, lag_profile, lag_rise, swing
from matrixworld.analysis.measures import MEASURES, Measure
from matrixworld.analysis.nash import Nash, game_value, nash_averaging
from matrixworld.analysis.payoff import (
    check_payoff,
    check_rates,
    check_runs,
    last_half,
    logits,
    swap_teams,
)
from matrixworld.analysis.progress import (
    Forgetting,
    Generalization,
    Progress,
    TeamProgress,
    forgetting,
    generalization,
    global_progress,
    historical_progress,
    local_progress,
)
from matrixworld.analysis.ratings import ELO_POINTS, Elo, MultiElo, elo, log_loss, multi_elo
from matrixworld.analysis.single_run import RunAnalysis, analyze_run
from matrixworld.analysis.sources import Payoffs, read_payoffs
from matrixworld.analysis.summary import PartSummary, Summary, TeamSummary, summarize
from matrixworld.analysis.wording import describe

__all__ = [
    "CONDITIONS",
    "ELO_POINTS",
    "MEASURES",
    "AlphaRank",
    "Analysis",
    "Band",
    "Checkerboards",
    "Ciao",
    "Diagnosis",
    "Disengagement",
    "Dominance",
    "Elo",
    "Estimate",
    "Exploitability",
    "Finding",
    "Forgetting",
    "Generalization",
    "Ladder",
    "LagProfile",
    "Measure",
    "MultiElo",
    "Nash",
    "PartSummary",
    "Payoffs",
    "Progress",
    "ResponseGain",
    "Rises",
    "RunAnalysis",
    "Summary",
    "TeamProgress",
    "TeamSummary",
    "Triangle",
    "TwoWayParts",
    "Undecided",
    "alpha_rank",
    "analyze",
    "analyze_run",
    "autocorrelation",
    "bootstrap_band",
    "bootstrap_difference",
    "bootstrap_episodes",
    "bootstrap_runs",
    "check_payoff",
    "check_rates",
    "check_runs",
    "checkerboards",
    "ciao",
    "describe",
    "diagnose",
    "disengagements",
    "dominance_of_counts",
    "dominance_tournament",
    "elo",
    "exploitability",
    "fitness_variance",
    "fixation_probability",
    "forgetting",
    "game_value",
    "generalization",
    "global_progress",
    "half_steps",
    "held_out_forgetting",
    "historical_progress",
    "lag_profile",
    "lag_rise",
    "last_half",
    "local_progress",
    "log_loss",
    "logits",
    "multi_elo",
    "nash_averaging",
    "read_payoffs",
    "response_gain",
    "rises",
    "summarize",
    "swap_teams",
    "swing",
    "transitive_share",
    "two_way_parts",
    "undecided_opponents",
]
