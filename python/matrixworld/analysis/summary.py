"""Headline numbers of one race. What they mean beyond noise is said by `judge`."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.cycles import checkerboards, transitive_share
from matrixworld.analysis.engagement import Disengagement, disengagements
from matrixworld.analysis.forgetting import forgetting
from matrixworld.analysis.generalization import generalization
from matrixworld.analysis.lags import (
    default_rise_lag,
    default_swing_start,
    lag_profile,
    lag_rise,
    swing,
    team_phase_rates,
)
from matrixworld.analysis.payoff import Rates, check_payoff, last_half, require
from matrixworld.analysis.plain_values import plain_values

MARGIN = 0.15
"""Margin of a checkerboard: an additive matrix with the noise of ten episodes of a default race has
none above it. It does not tell cycles from noise in general; `judge` does."""

HEADLINE_LAGS = (-10, -5, -1, 0, 1, 5, 10)


@dataclass(frozen=True)
class PartSummary:
    """Numbers of a matrix or of a part of it.

    Parameters
    ----------
    first_pursuers : int
        Pursuer generation of the first row.
    first_evaders : int
        Evader generation of the first column.
    mean : float
        Mean capture rate.
    transitive_share : float or None
        Transitive share of the capture rates; None for a constant matrix.
    transitive_share_logits : float or None
        Transitive share on logits; None for a constant matrix.
    checkerboards : int
        Number of checkerboards with margin `MARGIN` and without a level.
    quadruples : int
        Number of possible checkerboards.
    checkerboard_share : float or None
        Their quotient; None with fewer than two rows or columns.
    """

    first_pursuers: int
    first_evaders: int
    mean: float
    transitive_share: float | None
    transitive_share_logits: float | None
    checkerboards: int
    quadruples: int
    checkerboard_share: float | None


@dataclass(frozen=True)
class TeamSummary:
    """Numbers of one team, measured by its own payoff: higher scores are better.

    Parameters
    ----------
    generations : int
        Number of generations.
    generalization_first : float
        Mean payoff of generation 0 against all opponents.
    generalization_last : float
        Mean payoff of the last generation against all opponents.
    generalization_best : float
        Mean payoff of the best generation against all opponents.
    best_generation : int
        The first generation with that payoff.
    forgetting : float
        Drop below the best ancestor, mean over the last half of the generations.
    """

    generations: int
    generalization_first: float
    generalization_last: float
    generalization_best: float
    best_generation: int
    forgetting: float


@dataclass(frozen=True)
class Summary:
    """Headline numbers of one race, all plain Python values.

    Parameters
    ----------
    pursuers : TeamSummary
        Numbers of the pursuers.
    evaders : TeamSummary
        Numbers of the evaders.
    whole : PartSummary
        Numbers of the whole matrix.
    last_half : PartSummary
        Numbers of the last half of the generations.
    swing : float
        Mean change of the capture rate in the evaders' team phase.
    swing_start : int
        First generation of that mean.
    lags : tuple of int
        Lags of `HEADLINE_LAGS` within the matrix: pursuer minus evader generation.
    lag_means : tuple of float
        Mean capture rate at each lag.
    lag_cells : tuple of int
        Number of cells at each lag.
    lag_rise : float
        Lag profile at ``+rise_lag`` minus lag profile at ``-rise_lag``.
    rise_lag : int
        The lag of that difference.
    disengagements : tuple of Disengagement
        Stretches of generations that one team won.
    """

    pursuers: TeamSummary
    evaders: TeamSummary
    whole: PartSummary
    last_half: PartSummary
    swing: float
    swing_start: int
    lags: tuple[int, ...]
    lag_means: tuple[float, ...]
    lag_cells: tuple[int, ...]
    lag_rise: float
    rise_lag: int
    disengagements: tuple[Disengagement, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return nested dictionaries, lists, numbers, strings and None, for ``json.dumps``."""
        plain: dict[str, Any] = plain_values(self)
        return plain

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Summary:
        """Return the summary that `to_dict` made into dictionaries and lists."""
        parts = {
            "pursuers": TeamSummary(**values["pursuers"]),
            "evaders": TeamSummary(**values["evaders"]),
            "whole": PartSummary(**values["whole"]),
            "last_half": PartSummary(**values["last_half"]),
            "disengagements": tuple(Disengagement(**each) for each in values["disengagements"]),
        }
        lags = {name: tuple(values[name]) for name in ("lags", "lag_means", "lag_cells")}
        return cls(**{**values, **parts, **lags})


def summarize(payoff: ArrayLike) -> Summary:
    """Compute all headline numbers of a payoff matrix.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix of at least 2 x 2 generations; row and column 0 are generation 0.

    Returns
    -------
    Summary
        Generations beyond the end of the shorter side have no opponent of their own generation;
        swing and disengagement leave them out.

    Raises
    ------
    ValueError
        If the matrix is smaller or not a payoff matrix; see `check_payoff`.
    """
    matrix = check_payoff(payoff)
    require(min(matrix.shape) >= 2, "at least 2 x 2 generations", matrix.shape)
    rows, columns = matrix.shape
    scores, drops = generalization(matrix), forgetting(matrix)
    # A short race does not contain all headline lags.
    profile, rise = lag_profile(matrix), lag_rise(matrix)
    lags = [d for d in HEADLINE_LAGS if profile.lags[0] <= d <= profile.lags[-1]]
    inside = np.searchsorted(profile.lags, lags)
    return Summary(
        pursuers=_team(scores.pursuers, drops.pursuers),
        evaders=_team(scores.evaders, drops.evaders),
        whole=_part(matrix, (0, 0)),
        last_half=_part(last_half(matrix), (rows // 2, columns // 2)),
        swing=swing(matrix),
        swing_start=default_swing_start(min(rows, columns)),
        lags=tuple(lags),
        lag_means=tuple(profile.means[inside].tolist()),
        lag_cells=tuple(profile.cells[inside].tolist()),
        lag_rise=rise,
        rise_lag=default_rise_lag(min(rows, columns)),
        disengagements=disengagements(team_phase_rates(matrix)),
    )


def _part(matrix: Rates, first: tuple[int, int]) -> PartSummary:
    # Without a level: races cycle at low capture rates, too, where no cell crosses one half.
    boards = checkerboards(matrix, margin=MARGIN, level=None)
    return PartSummary(
        first_pursuers=first[0],
        first_evaders=first[1],
        mean=float(matrix.mean()),
        transitive_share=_defined(transitive_share(matrix)),
        transitive_share_logits=_defined(transitive_share(matrix, logits=True)),
        checkerboards=boards.count,
        quadruples=boards.possible,
        checkerboard_share=_defined(boards.share),
    )


def _team(scores: Rates, drops: Rates) -> TeamSummary:
    return TeamSummary(
        generations=len(scores),
        generalization_first=float(scores[0]),
        generalization_last=float(scores[-1]),
        generalization_best=float(scores.max()),
        best_generation=int(scores.argmax()),
        # Early generations have few ancestors, so they have little to forget.
        forgetting=float(drops[len(drops) // 2 :].mean()),
    )


def _defined(value: float) -> float | None:
    return None if math.isnan(value) else value
