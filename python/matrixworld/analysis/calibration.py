"""Calibration of the diagnosis: from the strength of evidence to a verdict and its confidence.

``calibration.json`` counts calibration races by strength of evidence: how many had a condition, and
how many had not. The races are played in toy games, where the truth is known; see
`matrixworld.toys.labelled_races`. ``evolution/diagnosis_on_toys.py --calibrate`` writes the file.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np

from matrixworld.analysis.intervals import Estimate
from matrixworld.analysis.plain_values import plain_values

PRESENT, ABSENT, CANNOT_TELL = "present", "absent", "cannot tell"

STRENGTHS: Mapping[str, str] = {
    "arms race": "least_rise",
    "cycling": "checkerboards",
    "disengagement": "one_sided",
    "forgetting": "most_forgetting",
    "stagnation": "greatest_rise",
}
"""The number of `evidence.numbers_of` that decides each condition. A higher number makes the
condition likelier; stagnation is likelier the smaller the absolute value is."""
CONDITIONS = tuple(STRENGTHS)
"""Names of the conditions, in the order of a diagnosis."""

SURE = 0.8
"""Share of the calibration races of one strength that must agree for a verdict."""

Numbers = dict[str, Estimate]
"""Numbers of a run by name."""
Interval = tuple[float, float]


@dataclass(frozen=True)
class Bins:
    """Counts of calibration races in bins of the strength of evidence.

    Parameters
    ----------
    edges : tuple of float
        Bin i lies between edges i - 1 and i; the first and the last bin are open. An edge belongs
        to the bin above it.
    present : tuple of int
        Races with the condition in each bin; one more than edges.
    absent : tuple of int
        Races without the condition in each bin.
    """

    edges: tuple[float, ...]
    present: tuple[int, ...]
    absent: tuple[int, ...]

    def shares(self, interval: Interval) -> Interval:
        """Return the least and greatest share of races with the condition over the bins.

        The bins are those that the interval touches. The share is Laplace's rule of succession,
        ``(present + 1) / (present + absent + 2)``: 1/2 in a bin without races.
        """
        # All bins between the ends of the interval: the truth may lie in any of them.
        first, last = np.searchsorted(self.edges, interval, side="right")
        shares = [
            (yes + 1) / (yes + no + 2)
            for yes, no in zip(
                self.present[first : last + 1], self.absent[first : last + 1], strict=True
            )
        ]
        return min(shares), max(shares)

    def judge(self, interval: Interval) -> tuple[str, float]:
        """Return verdict and confidence; the verdict must hold in *all* bins of the interval.

        The confidence is the least share of races for which the verdict is true; 0 if there is no
        verdict.
        """
        # The worst bin decides, for either verdict.
        low, high = self.shares(interval)
        if low >= SURE:
            return PRESENT, low
        if high <= 1.0 - SURE:
            return ABSENT, 1.0 - high
        return CANNOT_TELL, 0.0


@dataclass(frozen=True)
class Calibration:
    """Bins of each condition.

    Parameters
    ----------
    source : str
        The races that were counted.
    slack : mapping of str to float
        By condition, half the width of an interval over episodes: the 90th percentile of the
        calibration races. It serves matrices whose episodes are not known.
    episodes : mapping of str to Bins
        By condition, bins for matrices whose episodes are known.
    means : mapping of str to Bins
        By condition, bins for matrices of means only.
    """

    source: str
    slack: Mapping[str, float]
    episodes: Mapping[str, Bins]
    means: Mapping[str, Bins]

    def to_json(self) -> dict[str, Any]:
        """Return plain values, as in ``calibration.json``."""
        plain: dict[str, Any] = plain_values(self)
        return plain


@cache
def calibration() -> Calibration:
    """Return the calibration that `diagnose` uses, read from ``calibration.json``."""
    text = files("matrixworld.analysis").joinpath("calibration.json").read_text(encoding="utf-8")
    values = json.loads(text)
    episodes, means = (
        {
            name: Bins(*(tuple(bins[key]) for key in ("edges", "present", "absent")))
            for name, bins in values[table].items()
        }
        for table in ("episodes", "means")
    )
    return Calibration(values["source"], values["slack"], episodes, means)


def tally(edges: tuple[float, ...], races: Iterable[tuple[float, bool]]) -> Bins:
    """Count races, each given by its strength and whether it had the condition."""
    # Row 0: races with the condition, row 1: races without.
    counts = np.zeros((2, len(edges) + 1), dtype=np.int64)
    for strength, had_it in races:
        counts[int(not had_it), np.searchsorted(edges, strength, side="right")] += 1
    return Bins(edges, tuple(counts[0].tolist()), tuple(counts[1].tolist()))


def strength(condition: str, numbers: Mapping[str, Estimate]) -> float:
    """Return the strength of the evidence for a condition."""
    value = numbers[STRENGTHS[condition]].value
    return abs(value) if condition == "stagnation" else value


def strength_interval(condition: str, numbers: Mapping[str, Estimate], slack: float) -> Interval:
    """Return the interval of the strength: over runs or episodes, else the value +- `slack`."""
    one = numbers[STRENGTHS[condition]]
    # A basic interval may miss its own value; the interval is widened to contain it.
    low = one.value - slack if one.low is None else min(one.low, one.value)
    high = one.value + slack if one.high is None else max(one.high, one.value)
    if condition != "stagnation":
        return low, high
    # Stagnation goes by the absolute value, which is 0 somewhere if the interval contains 0.
    sizes = abs(low), abs(high)
    return (0.0 if low <= 0.0 <= high else min(sizes)), max(sizes)
