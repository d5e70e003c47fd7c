"""What happened in a race: numbers from plain arrays, no world needed.

Everything here takes a *payoff matrix* ``M`` of shape ``(n, m)``: ``M[g, h]`` is the capture rate,
in [0, 1], of the pursuers of generation ``g`` against the evaders of generation ``h``. The evaders'
payoff is ``1 - M``. NumPy is the only dependency.

>>> from matrixworld import analysis
>>> print(analysis.describe(analysis.summarize(payoff)))  # doctest: +SKIP

==================  ================================================================================
payoff.py           check a matrix, take its last half, swap the teams
progress.py         generalisation, lag profile, half-steps and their swing, forgetting
cycles.py           transitive share and checkerboards
engagement.py       disengagement: when one team wins everything and neither has anything to learn
summary.py          the headline numbers of a matrix, and whether they look like cycling or progress
wording.py          the same in sentences
==================  ================================================================================
"""

from __future__ import annotations

from matrixworld.analysis.cycles import Checkerboards, checkerboards, transitive_share
from matrixworld.analysis.engagement import Disengagement, disengagements
from matrixworld.analysis.payoff import check_payoff, check_rates, last_half, swap_teams
from matrixworld.analysis.progress import (
    Forgetting,
    Generalization,
    LagProfile,
    forgetting,
    generalization,
    half_steps,
    lag_profile,
    lag_rise,
    swing,
)
from matrixworld.analysis.summary import PartSummary, Summary, TeamSummary, summarize
from matrixworld.analysis.wording import describe

__all__ = [
    "Checkerboards",
    "Disengagement",
    "Forgetting",
    "Generalization",
    "LagProfile",
    "PartSummary",
    "Summary",
    "TeamSummary",
    "check_payoff",
    "check_rates",
    "checkerboards",
    "describe",
    "disengagements",
    "forgetting",
    "generalization",
    "half_steps",
    "lag_profile",
    "lag_rise",
    "last_half",
    "summarize",
    "swap_teams",
    "swing",
    "transitive_share",
]
