"""A number of one run with its interval, and the same number over several runs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from matrixworld.analysis.intervals import Estimate


@dataclass(frozen=True)
class Measurement:
    """A number of one run, with an interval and with values that err to a known side.

    Parameters
    ----------
    value : float
        The number.
    low, high : float
        Ends of its interval.
    under : float, optional
        A value that is not too high on average. The default is `value`.
    over : float, optional
        A value that is not too low on average. The default is `value`.
    """

    value: float
    low: float
    high: float
    under: float = math.nan
    over: float = math.nan

    def __post_init__(self) -> None:
        for side in ("under", "over"):
            if math.isnan(getattr(self, side)):
                object.__setattr__(self, side, self.value)


def over_runs(
    measured: Sequence[Measurement], level: float, together: Measurement | None = None
) -> Estimate:
    """Return a single run's number with its interval, or the mean over runs with theirs.

    Parameters
    ----------
    measured : sequence of Measurement
        The number of each run, at least one.
    level : float
        Confidence level, in (0, 1).
    together : Measurement, optional
        The number of all runs together, whose interval that over runs must contain.

    Returns
    -------
    Estimate
        Over runs: the mean, the lower end of Student's t interval of the values `under`, and the
        upper end of that of the values `over`.
    """
    if len(measured) == 1:
        one = measured[0]
        return Estimate(one.value, one.low, one.high, "episodes", 1)
    low = _t_end([one.under for one in measured], (1.0 - level) / 2.0)
    high = _t_end([one.over for one in measured], (1.0 + level) / 2.0)
    if together is not None:
        low, high = min(low, together.low), max(high, together.high)
    mean = float(np.mean([one.value for one in measured]))
    return Estimate(mean, low, high, "runs", len(measured))


def _t_end(values: Sequence[float], probability: float) -> float:
    from scipy.special import stdtrit

    error = float(np.std(values, ddof=1)) / math.sqrt(len(values))
    return float(np.mean(values)) + float(stdtrit(len(values) - 1, probability)) * error
