"""The headline numbers of one race, and whether they look like cycling or progress."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.cycles import checkerboards, transitive_share
from matrixworld.analysis.engagement import Disengagement, disengagements
from matrixworld.analysis.lags import (
    default_rise_lag,
    default_swing_start,
    half_steps,
    lag_profile,
    lag_rise,
    swing,
)
from matrixworld.analysis.payoff import Rates, check_payoff, last_half
from matrixworld.analysis.progress import forgetting, generalization

# The thresholds lie between what trial races of 30 generations showed in the last half of their
# matrix (Pursuit-Evasion-O, 8 against 30; four seeds of each of the paper's schedules):
#
#                            specialist/specialist   generalist/specialist   generalist/generalist
#   transitive share         .18 .59 .48 .31         .78 .76 .72 .80         .94 .96 .84 .92
#   checkerboards, per cent  8.8 3.5 5.0 14.5        0 .15 .4 0              0 0 0 0
#   lag profile, -10 to +15  .40 to .60              .23 to .88              .33 to .98
MARGIN = 0.15
"""Margin of a checkerboard: an additive matrix with the noise of those races has none above it."""
CYCLING_SHARE = 0.65
"""Cycling below it: half-way from the specialists' best (.59) to the nearest other (.72)."""
PROGRESS_SHARE = 0.82
"""Progress above it: half-way from the mixed schedule's best (.80) to generalists' worst (.84)."""
CYCLING_CHECKERBOARDS = 0.02
"""Cycling above it: half-way from the mixed schedule's most (.4 %) to the specialists' least."""
PROGRESS_CHECKERBOARDS = 0.005
"""Progress below it: just above the most of any schedule with a generalist (.4 %)."""
PROGRESS_RISE = 0.2
"""Progress above it: what later pursuers gained over earlier ones where races only cycled."""
FEWEST_GENERATIONS = 12
"""No verdict below it: the last half is then 6 x 6, where one odd generation decides."""

HEADLINE_LAGS = (-10, -5, -1, 0, 1, 5, 10)


@dataclass(frozen=True)
class PartSummary:
    """A matrix or a part of it. None: not defined (no variance; fewer than two rows or columns)."""

    first_pursuers: int
    """Pursuer generation of the first row."""
    first_evaders: int
    """Evader generation of the first column."""
    mean: float
    """Mean capture rate."""
    transitive_share: float | None
    transitive_share_logits: float | None
    checkerboards: int
    """Checkerboards by :data:`MARGIN`, whatever the level."""
    quadruples: int
    """The possible checkerboards."""
    checkerboard_share: float | None


@dataclass(frozen=True)
class TeamSummary:
    """One team over its generations, from its own point of view: higher scores are better."""

    generations: int
    generalization_first: float
    generalization_last: float
    generalization_best: float
    best_generation: int
    forgetting: float
    """Mean over the last half of the generations of the drop below the best so far."""


@dataclass(frozen=True)
class Summary:
    """Headline numbers of one race; plain Python values throughout."""

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
    """Lag profile at ``+rise_lag`` less at ``-rise_lag``."""
    rise_lag: int
    disengagements: tuple[Disengagement, ...]
    verdict: str
    """``"cycling"``, ``"progress"`` or ``"undecided"``."""
    reason: str
    """Why, as a clause to follow "because"."""

    def to_dict(self) -> dict[str, Any]:
        """Nested dictionaries, lists, numbers, strings and None, ready for ``json.dumps``."""
        plain: dict[str, Any] = _listed(asdict(self))
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
    """Every headline number of a payoff matrix of at least 2 x 2 generations, and a verdict.

    Row and column 0 are generation 0. Generations past the shorter side have no opponent of their
    own generation and enter neither swing nor disengagement.

    Raises ValueError for a smaller matrix, and as :func:`check_payoff` does.
    """
    matrix = check_payoff(payoff)
    if min(matrix.shape) < 2:
        raise ValueError(f"expected at least 2 x 2 generations, got {matrix.shape}")
    rows, columns = matrix.shape
    late = _part(last_half(matrix), (rows // 2, columns // 2))
    scores, drops = generalization(matrix), forgetting(matrix)
    profile, rise = lag_profile(matrix), lag_rise(matrix)
    lags = [d for d in HEADLINE_LAGS if profile.lags[0] <= d <= profile.lags[-1]]
    inside = np.searchsorted(profile.lags, lags)
    stretches = disengagements(half_steps(matrix))
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
        forgetting=float(drops[len(drops) // 2 :].mean()),
    )


def _judge(
    matrix: Rates, late: PartSummary, rise: float, stretches: tuple[Disengagement, ...]
) -> tuple[str, str]:
    """Verdict and reason; each verdict needs all of its evidence."""
    shortest = min(matrix.shape)
    if shortest < FEWEST_GENERATIONS:
        return "undecided", (
            f"a verdict needs at least {FEWEST_GENERATIONS} generations and there are {shortest}"
        )
    if _mostly_disengaged(stretches, shortest):
        return "undecided", "one team won nearly everything in most of the last half"
    share, boards = late.transitive_share, late.checkerboard_share
    if share is None or boards is None:
        return "undecided", "the capture rate never changes in the last half"
    if share < CYCLING_SHARE and boards > CYCLING_CHECKERBOARDS:
        return "cycling", (
            f"its transitive share is below {CYCLING_SHARE} and its checkerboards are above "
            f"{CYCLING_CHECKERBOARDS:.1%}"
        )
    if share > PROGRESS_SHARE and boards < PROGRESS_CHECKERBOARDS and rise > PROGRESS_RISE:
        return "progress", (
            f"its transitive share is above {PROGRESS_SHARE}, its checkerboards are below "
            f"{PROGRESS_CHECKERBOARDS:.1%}, and later pursuers do better by more than "
            f"{PROGRESS_RISE}"
        )
    return "undecided", _why_undecided(share, boards, rise)


def _why_undecided(share: float, boards: float, rise: float) -> str:
    if share > PROGRESS_SHARE and boards < PROGRESS_CHECKERBOARDS:
        return (
            f"there is an order of strength, but it does not follow time: later pursuers do "
            f"better by {rise:.2f} only, less than {PROGRESS_RISE}"
        )
    return (
        f"cycling takes a transitive share below {CYCLING_SHARE} with checkerboards above "
        f"{CYCLING_CHECKERBOARDS:.1%}, progress a share above {PROGRESS_SHARE} with checkerboards "
        f"below {PROGRESS_CHECKERBOARDS:.1%}, and this race lies between"
    )


def _mostly_disengaged(stretches: tuple[Disengagement, ...], generations: int) -> bool:
    half = range(generations // 2, generations)
    idle = sum(1 for k in half if any(s.first <= k <= s.last for s in stretches))
    return 2 * idle > len(half)


def _defined(value: float) -> float | None:
    return None if math.isnan(value) else value


def _listed(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _listed(item) for key, item in value.items()}
    return [_listed(item) for item in value] if isinstance(value, (list, tuple)) else value
