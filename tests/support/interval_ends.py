"""Both ends of an interval, for tests in which it has to exist."""

from __future__ import annotations

from matrixworld.analysis import Estimate


def ends(estimate: Estimate) -> tuple[float, float]:
    """Return both ends of an interval that has to exist."""
    assert estimate.low is not None
    assert estimate.high is not None
    return estimate.low, estimate.high
