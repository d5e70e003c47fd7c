"""Evaluation: what trained genomes score, against each other and against held-out opponents.

=================  ===============================================================================
module             contents
=================  ===============================================================================
tournament         `tournament`: the payoff matrix of two archives
held_out           `held_out`: opponents that no run trains against
held_out_scores    `score`: the teams of a run against held-out opponents
policy_scores      `score_policy`: any policy against held-out opponents
=================  ===============================================================================
"""

from __future__ import annotations

from matrixworld.coevolution.evaluation.held_out_opponents import (
    fitting_opponents,
    held_out,
    held_out_genomes,
    held_out_scripts,
)
from matrixworld.coevolution.evaluation.held_out_scores import (
    HeldOutScores,
    score,
    score_population,
)
from matrixworld.coevolution.evaluation.policy_scores import score_policy
from matrixworld.coevolution.evaluation.tournament import tournament

__all__ = [
    "HeldOutScores",
    "fitting_opponents",
    "held_out",
    "held_out_genomes",
    "held_out_scripts",
    "score",
    "score_policy",
    "score_population",
    "tournament",
]
