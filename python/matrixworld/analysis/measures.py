"""Named measures of a payoff matrix, for comparison between runs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from matrixworld.analysis.ciao import ciao
from matrixworld.analysis.cycles import checkerboards, transitive_share
from matrixworld.analysis.forgetting import forgetting
from matrixworld.analysis.generalization import (
    generalization,
    historical_progress,
    local_progress,
)
from matrixworld.analysis.lags import lag_rise, swing
from matrixworld.analysis.nash import game_value
from matrixworld.analysis.payoff import Rates, last_half
from matrixworld.analysis.summary import MARGIN


@dataclass(frozen=True)
class Measure:
    """A named number of a matrix of at least 2 x 2 generations.

    Parameters
    ----------
    name : str
        Key in `MEASURES`.
    label : str
        Name in words, for tables.
    low : float
        Smallest possible value.
    high : float
        Largest possible value.
    of : callable
        Takes a matrix (n, m) and returns the number; NaN where it is not defined.
    """

    name: str
    label: str
    low: float
    high: float
    of: Callable[[Rates], float]


# Early generations have few ancestors, so they have little to forget.
def _late_forgetting(drops: Rates) -> float:
    return float(drops[len(drops) // 2 :].mean())


# Without a level: races cycle at low capture rates, too, where no cell crosses one half.
def _checkerboard_share(matrix: Rates) -> float:
    return checkerboards(last_half(matrix), margin=MARGIN, level=None).share


def _measures(*rows: tuple[str, str, float, float, Callable[[Rates], float]]) -> dict[str, Measure]:
    return {row[0]: Measure(*row) for row in rows}


MEASURES = _measures(
    ("capture_rate", "mean capture rate", 0, 1, lambda m: float(m.mean())),
    (
        "transitive_share", "transitive share, last half", 0, 1,
        lambda m: transitive_share(last_half(m)),
    ),
    (
        "transitive_share_logits", "transitive share on logits, last half", 0, 1,
        lambda m: transitive_share(last_half(m), logits=True),
    ),
    ("checkerboards", "checkerboard share, last half", 0, 1, _checkerboard_share),
    ("swing", "swing between team phases", 0, 1, swing),
    ("lag_rise", "gain of later over earlier pursuers", -1, 1, lag_rise),
    (
        "pursuer_generalization", "last pursuers against all evaders, capture", 0, 1,
        lambda m: float(generalization(m).pursuers[-1]),
    ),
    (
        "evader_generalization", "last evaders against all pursuers, escape", 0, 1,
        lambda m: float(generalization(m).evaders[-1]),
    ),
    (
        "pursuer_forgetting", "forgetting of the pursuers, last half", 0, 1,
        lambda m: _late_forgetting(forgetting(m).pursuers),
    ),
    (
        "evader_forgetting", "forgetting of the evaders, last half", 0, 1,
        lambda m: _late_forgetting(forgetting(m).evaders),
    ),
    (
        "pursuer_local_gain", "local progress of the pursuers per generation", -1, 1,
        lambda m: local_progress(m).pursuers.mean_gain,
    ),
    (
        "evader_local_gain", "local progress of the evaders per generation", -1, 1,
        lambda m: local_progress(m).evaders.mean_gain,
    ),
    (
        "pursuer_historical_gain", "historical progress of the pursuers per generation", -1, 1,
        lambda m: historical_progress(m).pursuers.mean_gain,
    ),
    (
        "evader_historical_gain", "historical progress of the evaders per generation", -1, 1,
        lambda m: historical_progress(m).evaders.mean_gain,
    ),
    ("pursuer_fading", "CIAO, fading of the pursuers", -1, 1, lambda m: ciao(m).pursuers.fading),
    ("evader_fading", "CIAO, fading of the evaders", -1, 1, lambda m: ciao(m).evaders.fading),
    ("pursuer_stripes", "CIAO, stripes of the pursuers", 0, 1, lambda m: ciao(m).pursuers.stripes),
    ("evader_stripes", "CIAO, stripes of the evaders", 0, 1, lambda m: ciao(m).evaders.stripes),
    ("game_value", "capture rate in the Nash equilibrium", 0, 1, game_value),
)  # fmt: skip
"""All measures by name, in the order in which `analyze` prints them."""
