"""All measures of one run."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.short_repr import short_repr
from matrixworld.analysis.alpha_rank import AlphaRank, alpha_rank
from matrixworld.analysis.ciao import Ciao, ciao
from matrixworld.analysis.dominance import Dominance, dominance_tournament
from matrixworld.analysis.forgetting import Forgetting, forgetting
from matrixworld.analysis.generalization import (
    Generalization,
    Progress,
    generalization,
    historical_progress,
    local_progress,
)
from matrixworld.analysis.lags import LagProfile, lag_profile
from matrixworld.analysis.measures import MEASURES
from matrixworld.analysis.nash import Nash, nash_averaging
from matrixworld.analysis.payoff import Rates, check_payoff, check_rates, require
from matrixworld.analysis.ratings import MultiElo, log_loss, multi_elo
from matrixworld.analysis.summary import Summary, summarize

RANKED_PAIRS = 1024
"""Most pairs for alpha-Rank here, which keeps it under a second; longer runs are thinned out."""


@dataclass(frozen=True, eq=False)
class RankedGenerations:
    """alpha-Rank of all generations, or of every k-th one counted back from the last.

    Parameters
    ----------
    pursuers : tuple of int
        Ranked pursuer generations.
    evaders : tuple of int
        Ranked evader generations.
    ranks : AlphaRank
        Shares of these generations.
    """

    pursuers: tuple[int, ...]
    evaders: tuple[int, ...]
    ranks: AlphaRank

    __repr__ = short_repr


@dataclass(frozen=True, eq=False)
class RunAnalysis:
    """All measures of one run.

    Parameters
    ----------
    payoff : ndarray of float64, shape (n, m)
        Payoff matrix.
    numbers : dict of str to float
        Headline numbers by their names in `MEASURES`, and the log losses of the ratings.
    summary : Summary
        Headline numbers with a verdict.
    generalization : Generalization
        Mean payoff of each generation.
    forgetting : Forgetting
        Drop of each generation below its ancestors.
    local_progress : Progress
        Progress against current opponents.
    historical_progress : Progress
        Progress against all opponents so far.
    lag_profile : LagProfile
        Capture rate by lag.
    ciao : Ciao
        Current individuals against ancestral opponents.
    ratings : MultiElo
        Elo ratings, and one cycle (k = 1).
    nash : Nash
        Maximum-entropy equilibrium.
    alpha_rank : RankedGenerations
        alpha-Rank of some or all generations.
    dominance : Dominance or None
        Dominant generations; None without at least two episodes of each cell, since a dominant
        generation has to be significantly better.
    """

    payoff: Rates
    numbers: dict[str, float]
    summary: Summary
    generalization: Generalization
    forgetting: Forgetting
    local_progress: Progress
    historical_progress: Progress
    lag_profile: LagProfile
    ciao: Ciao
    ratings: MultiElo
    nash: Nash
    alpha_rank: RankedGenerations
    dominance: Dominance | None

    __repr__ = short_repr


def analyze_run(payoff: ArrayLike, scores: ArrayLike | None = None) -> RunAnalysis:
    """Compute all measures of one run.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix of at least 2 x 2 generations.
    scores : array_like of float, shape (n, m, episodes), optional
        Capture rate of each episode, for the dominance tournament.

    Returns
    -------
    RunAnalysis
        The measures.

    Raises
    ------
    ValueError
        If the matrix is smaller, scores have another shape, or rates are outside [0, 1].
    """
    matrix = check_payoff(payoff)
    require(min(matrix.shape) >= 2, "at least 2 x 2 generations", matrix.shape)
    # The Elo part of the result is what `elo` returns, so one fit serves both log losses.
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
    # The smallest k for which every k-th generation of both teams is few enough pairs.
    while -(-rows // step) * -(-columns // step) > RANKED_PAIRS:
        step += 1
    # Counted back from the last generation, which matters most.
    g, h = (np.arange((size - 1) % step, size, step) for size in matrix.shape)
    return RankedGenerations(tuple(g.tolist()), tuple(h.tolist()), alpha_rank(matrix[np.ix_(g, h)]))


def _dominance(matrix: Rates, scores: ArrayLike | None) -> Dominance | None:
    if scores is None:
        return None
    array = check_rates(scores, ndim=3, what="scores (n, m, episodes)")
    require(array.shape[:2] == matrix.shape, f"scores of {matrix.shape} cells", array.shape)
    return dominance_tournament(array) if array.shape[2] >= 2 else None
