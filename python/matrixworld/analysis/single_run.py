"""Every measure of one run."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.alpha_rank import AlphaRank, alpha_rank
from matrixworld.analysis.ciao import Ciao, ciao
from matrixworld.analysis.dominance import Dominance, dominance_tournament
from matrixworld.analysis.lags import LagProfile, lag_profile
from matrixworld.analysis.measures import MEASURES
from matrixworld.analysis.nash import Nash, nash_averaging
from matrixworld.analysis.payoff import Rates, check_payoff, check_rates, require
from matrixworld.analysis.progress import (
    Forgetting,
    Generalization,
    Progress,
    forgetting,
    generalization,
    historical_progress,
    local_progress,
)
from matrixworld.analysis.ratings import MultiElo, log_loss, multi_elo
from matrixworld.analysis.summary import Summary, summarize

RANKED_PAIRS = 1024
"""Most pairs that alpha-Rank is given here, under a second; longer runs: every k-th generation."""


@dataclass(frozen=True, eq=False)
class RankedGenerations:
    """alpha-Rank, and the generations that it ranks: all, or every k-th back from the last."""

    pursuers: tuple[int, ...]
    evaders: tuple[int, ...]
    ranks: AlphaRank


@dataclass(frozen=True, eq=False)
class RunAnalysis:
    """One run by every measure of this package."""

    payoff: Rates
    """Shape ``(n, m)``."""
    numbers: dict[str, float]
    """The headline numbers by the names of `MEASURES`, and log losses of the ratings."""
    summary: Summary
    generalization: Generalization
    forgetting: Forgetting
    local_progress: Progress
    historical_progress: Progress
    lag_profile: LagProfile
    ciao: Ciao
    ratings: MultiElo
    """Elo and one cycle (k = 1) beside it."""
    nash: Nash
    alpha_rank: RankedGenerations
    dominance: Dominance | None
    """None without at least two episodes a cell: a step up has to be significant."""


def analyze_run(payoff: ArrayLike, scores: ArrayLike | None = None) -> RunAnalysis:
    """Every measure of a payoff matrix of at least 2 x 2 generations.

    ``scores``, shape ``(n, m, episodes)``: capture rate of each episode, for the dominance
    tournament. Raises ValueError for a smaller matrix, scores of another shape, rates outside
    [0, 1].
    """
    matrix = check_payoff(payoff)
    require(min(matrix.shape) >= 2, "at least 2 x 2 generations", matrix.shape)
    ratings = multi_elo(matrix)
    return RunAnalysis(
        payoff=matrix,
        numbers={name: measure.of(matrix) for name, measure in MEASURES.items()}
        | {
            "elo_log_loss": log_loss(matrix, ratings.elo.predict()),
            "multi_elo_log_loss": log_loss(matrix, ratings.predict()),
        },
        summary=summarize(matrix),
        generalization=generalization(matrix),
        forgetting=forgetting(matrix),
        local_progress=local_progress(matrix),
        historical_progress=historical_progress(matrix),
        lag_profile=lag_profile(matrix),
        ciao=ciao(matrix),
        ratings=ratings,
        nash=nash_averaging(matrix),
        alpha_rank=_ranked(matrix),
        dominance=_dominance(matrix, scores),
    )


def _ranked(matrix: Rates) -> RankedGenerations:
    rows, columns = matrix.shape
    step = 1
    while -(-rows // step) * -(-columns // step) > RANKED_PAIRS:
        step += 1
    g, h = (np.arange((size - 1) % step, size, step) for size in matrix.shape)
    return RankedGenerations(tuple(g.tolist()), tuple(h.tolist()), alpha_rank(matrix[np.ix_(g, h)]))


def _dominance(matrix: Rates, scores: ArrayLike | None) -> Dominance | None:
    if scores is None:
        return None
    array = check_rates(scores, ndim=3, what="scores (n, m, episodes)")
    require(array.shape[:2] == matrix.shape, f"scores of {matrix.shape} cells", array.shape)
    return dominance_tournament(array) if array.shape[2] >= 2 else None
