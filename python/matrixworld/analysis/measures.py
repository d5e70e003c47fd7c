"""Named measures of a payoff matrix, for comparison between runs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

from numpy.typing import ArrayLike

from matrixworld.analysis.ciao import ciao
from matrixworld.analysis.cycles import checkerboards, transitive_share
from matrixworld.analysis.episode_intervals import (
    BIASED,
    linear_over_episodes,
    transitive_share_over_episodes,
)
from matrixworld.analysis.forgetting import forgetting
from matrixworld.analysis.generalization import (
    generalization,
    historical_progress,
    local_progress,
)
from matrixworld.analysis.intervals import LEVEL, Estimate, without_interval
from matrixworld.analysis.lags import lag_rise, swing
from matrixworld.analysis.nash import game_value
from matrixworld.analysis.payoff import Rates, check_rates, last_half
from matrixworld.analysis.summary import MARGIN

Noise = Literal["linear", "transitive share", "bias"]
"""Effects of episode noise on a measure."""


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
    noise : {"linear", "transitive share", "bias"}
        What episode noise does to the number, which decides about the interval over episodes. A
        linear number is not shifted. Noise can be subtracted from a transitive share. All other
        numbers are biased and have no such interval.
    """

    name: str
    label: str
    low: float
    high: float
    of: Callable[[Rates], float]
    noise: Noise

    def __reduce__(self) -> str | tuple[Any, ...]:
        """Pickle a row of `MEASURES` by its name, because its function may be a lambda."""
        if MEASURES.get(self.name) is self:
            return _row_named, (self.name,)
        return super().__reduce__()


# Early generations have few ancestors, so they have little to forget.
def _late_forgetting(drops: Rates) -> float:
    return float(drops[len(drops) // 2 :].mean())


# Without a level: races cycle at low capture rates, too, where no cell crosses one half.
def _checkerboard_share(matrix: Rates) -> float:
    return checkerboards(last_half(matrix), margin=MARGIN, level=None).share


def _row_named(name: str) -> Measure:
    return MEASURES[name]


Row = tuple[str, str, float, float, Callable[[Rates], float], Noise]


def _measures(*rows: Row) -> dict[str, Measure]:
    return {row[0]: Measure(*row) for row in rows}


MEASURES = _measures(
    ("capture_rate", "mean capture rate", 0, 1, lambda m: float(m.mean()), "linear"),
    (
        "transitive_share", "transitive share, last half", 0, 1,
        lambda m: transitive_share(last_half(m)), "transitive share",
    ),
    (
        "transitive_share_logits", "transitive share on logits, last half", 0, 1,
        lambda m: transitive_share(last_half(m), logits=True), "bias",
    ),
    ("checkerboards", "checkerboard share, last half", 0, 1, _checkerboard_share, "bias"),
    ("swing", "swing between team phases", 0, 1, swing, "bias"),
    ("lag_rise", "gain of later over earlier pursuers", -1, 1, lag_rise, "linear"),
    (
        "pursuer_generalization", "last pursuers against all evaders, capture", 0, 1,
        lambda m: float(generalization(m).pursuers[-1]), "linear",
    ),
    (
        "evader_generalization", "last evaders against all pursuers, escape", 0, 1,
        lambda m: float(generalization(m).evaders[-1]), "linear",
    ),
    (
        "pursuer_forgetting", "forgetting of the pursuers, last half", 0, 1,
        lambda m: _late_forgetting(forgetting(m).pursuers), "bias",
    ),
    (
        "evader_forgetting", "forgetting of the evaders, last half", 0, 1,
        lambda m: _late_forgetting(forgetting(m).evaders), "bias",
    ),
    (
        "pursuer_local_gain", "local progress of the pursuers per generation", -1, 1,
        lambda m: local_progress(m).pursuers.mean_gain, "linear",
    ),
    (
        "evader_local_gain", "local progress of the evaders per generation", -1, 1,
        lambda m: local_progress(m).evaders.mean_gain, "linear",
    ),
    (
        "pursuer_historical_gain", "historical progress of the pursuers per generation", -1, 1,
        lambda m: historical_progress(m).pursuers.mean_gain, "linear",
    ),
    (
        "evader_historical_gain", "historical progress of the evaders per generation", -1, 1,
        lambda m: historical_progress(m).evaders.mean_gain, "linear",
    ),
    (
        "pursuer_fading", "CIAO, fading of the pursuers", -1, 1,
        lambda m: ciao(m).pursuers.fading, "linear",
    ),
    (
        "evader_fading", "CIAO, fading of the evaders", -1, 1,
        lambda m: ciao(m).evaders.fading, "linear",
    ),
    (
        "pursuer_stripes", "CIAO, stripes of the pursuers", 0, 1,
        lambda m: ciao(m).pursuers.stripes, "bias",
    ),
    (
        "evader_stripes", "CIAO, stripes of the evaders", 0, 1,
        lambda m: ciao(m).evaders.stripes, "bias",
    ),
    ("game_value", "capture rate in the Nash equilibrium", 0, 1, game_value, "bias"),
)  # fmt: skip
"""All measures by name, in the order in which `analyze` prints them."""


def measure_over_episodes(measure: Measure, scores: ArrayLike, *, level: float = LEVEL) -> Estimate:
    """Return a measure of one run with the interval over episodes that its noise allows.

    Parameters
    ----------
    measure : Measure
        One of `MEASURES`.
    scores : array_like of float, shape (n, m, episodes)
        Capture rates of independent episodes, at least two of each cell.
    level : float, optional
        Confidence level, in (0, 1).

    Returns
    -------
    Estimate
        See `linear_over_episodes` and `transitive_share_over_episodes`. Other measures have a note
        instead of an interval.

    Raises
    ------
    ValueError
        If the shape is another one, there are fewer than two episodes, or scores are outside
        [0, 1].
    """
    array = check_rates(scores, ndim=3, what="scores (n, m, episodes)")
    if measure.noise == "linear":
        bounds = (measure.low, measure.high)
        return linear_over_episodes(array, measure.of, level=level, bounds=bounds)
    if measure.noise == "transitive share":
        rows, columns = (size // 2 for size in array.shape[:2])
        return transitive_share_over_episodes(array[rows:, columns:], level=level)
    return without_interval(float(measure.of(array.mean(axis=2))), array.shape[2], BIASED)
