"""Headline numbers of one race, and whether they look like cycling or progress."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.cycles import checkerboards, transitive_share
from matrixworld.analysis.engagement import Disengagement, disengagements
from matrixworld.analysis.generalization import forgetting, generalization
from matrixworld.analysis.lags import (
    default_rise_lag,
    default_swing_start,
    lag_profile,
    lag_rise,
    swing,
    team_phase_rates,
)
from matrixworld.analysis.payoff import Rates, check_payoff, last_half
from matrixworld.analysis.plain_values import plain_values

# The thresholds lie between the values of trial races of 30 generations, in the last half of their
# matrix (Pursuit-Evasion-O, 8 against 30; four seeds of each schedule of the paper):
#
#                            specialist/specialist   generalist/specialist   generalist/generalist
#   transitive share         .18 .59 .48 .31         .78 .76 .72 .80         .94 .96 .84 .92
#   checkerboards, per cent  8.8 3.5 5.0 14.5        0 .15 .4 0              0 0 0 0
#   lag profile, -10 to +15  .40 to .60              .23 to .88              .33 to .98
MARGIN = 0.15
"""Margin of a checkerboard: an additive matrix with the noise of those races has none above it."""
CYCLING_SHARE = 0.65
"""Cycling: transitive share below this, half-way from .59 (specialists) to .72 (mixed)."""
PROGRESS_SHARE = 0.82
"""Progress: transitive share above this, half-way from .80 (mixed) to .84 (generalists)."""
CYCLING_CHECKERBOARDS = 0.02
"""Cycling: share of checkerboards above this, half-way from .4 % (mixed) to 3.5 % (specialists)."""
PROGRESS_CHECKERBOARDS = 0.005
"""Progress: share of checkerboards below this, just above .4 %, the most with a generalist."""
PROGRESS_RISE = 0.2
"""Progress: lag rise above this, the largest one in races that only cycled."""
FEWEST_GENERATIONS = 12
"""No verdict with fewer: the last half has less than 6 x 6 cells, where one generation decides."""

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
    verdict : str
        ``"cycling"``, ``"progress"`` or ``"undecided"``.
    reason : str
        Reason of the verdict, as a clause after "because".
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
    verdict: str
    reason: str

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
    """Compute all headline numbers of a payoff matrix, and a verdict.

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
    if min(matrix.shape) < 2:
        raise ValueError(f"expected at least 2 x 2 generations, got {matrix.shape}")
    rows, columns = matrix.shape
    late = _part(last_half(matrix), (rows // 2, columns // 2))
    scores, drops = generalization(matrix), forgetting(matrix)
    # A short race does not contain all headline lags.
    profile, rise = lag_profile(matrix), lag_rise(matrix)
    lags = [d for d in HEADLINE_LAGS if profile.lags[0] <= d <= profile.lags[-1]]
    inside = np.searchsorted(profile.lags, lags)
    stretches = disengagements(team_phase_rates(matrix))
    verdict, reason = _judge(matrix, late, rise, stretches)
    return Summary(
        pursuers=_team(scores.pursuers, drops.pursuers),
        evaders=_team(scores.evaders, drops.evaders),
        whole=_part(matrix, (0, 0)),
        last_half=late,
        swing=swing(matrix),
        swing_start=default_swing_start(min(rows, columns)),
        lags=tuple(lags),
        lag_means=tuple(profile.means[inside].tolist()),
        lag_cells=tuple(profile.cells[inside].tolist()),
        lag_rise=rise,
        rise_lag=default_rise_lag(min(rows, columns)),
        disengagements=stretches,
        verdict=verdict,
        reason=reason,
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


def _judge(
    matrix: Rates, late: PartSummary, rise: float, stretches: tuple[Disengagement, ...]
) -> tuple[str, str]:
    """Return verdict and reason; cycling and progress each need all of their evidence."""
    shortest = min(matrix.shape)
    if shortest < FEWEST_GENERATIONS:
        return "undecided", (
            f"a verdict needs at least {FEWEST_GENERATIONS} generations and there are {shortest}"
        )
    # A disengaged race has a constant matrix, which would pass for one without cycles.
    if _mostly_disengaged(stretches, shortest):
        return "undecided", ("one team won nearly all matches in most generations of the last half")
    # The last half only: untrained early generations make any race look transitive.
    share, boards = late.transitive_share, late.checkerboard_share
    if share is None or boards is None:
        return "undecided", "the capture rate never changes in the last half"
    if share < CYCLING_SHARE and boards > CYCLING_CHECKERBOARDS:
        return "cycling", (
            f"its transitive share is below {CYCLING_SHARE} and its checkerboards are above "
            f"{CYCLING_CHECKERBOARDS:.1%}"
        )
    # An order of strength is not yet progress: later generations have to be the stronger ones.
    if share > PROGRESS_SHARE and boards < PROGRESS_CHECKERBOARDS and rise > PROGRESS_RISE:
        return "progress", (
            f"its transitive share is above {PROGRESS_SHARE}, its checkerboards are below "
            f"{PROGRESS_CHECKERBOARDS:.1%}, and later pursuers capture more than earlier ones by "
            f"more than {PROGRESS_RISE}"
        )
    return "undecided", _why_undecided(share, boards, rise)


def _why_undecided(share: float, boards: float, rise: float) -> str:
    if share > PROGRESS_SHARE and boards < PROGRESS_CHECKERBOARDS:
        return (
            f"the generations differ in strength, but not in the order of time: later pursuers "
            f"capture more than earlier ones by {rise:.2f} only, not by more than {PROGRESS_RISE}"
        )
    return (
        f"cycling requires a transitive share below {CYCLING_SHARE} and checkerboards above "
        f"{CYCLING_CHECKERBOARDS:.1%}, progress requires a share above {PROGRESS_SHARE} and "
        f"checkerboards below {PROGRESS_CHECKERBOARDS:.1%}, and this race lies between them"
    )


def _mostly_disengaged(stretches: tuple[Disengagement, ...], generations: int) -> bool:
    # Stretches count team phases of generations from 1 on, in the same numbering.
    half = range(generations // 2, generations)
    # Half of the last half decides, since a disengaged race may engage again.
    idle = sum(1 for k in half if any(s.first <= k <= s.last for s in stretches))
    return 2 * idle > len(half)


def _defined(value: float) -> float | None:
    return None if math.isnan(value) else value
