"""What a strength of evidence has meant where the truth was known: counts over toy races.

``calibration.json`` holds how many toy races of each strength of evidence had a condition, and how
many had not. ``evolution/diagnosis_on_toys.py --calibrate`` writes it; the races, and how the truth
of each is known, are in `matrixworld.toys.labelled_races`.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np

from matrixworld.analysis.bootstrap import Estimate

PRESENT, ABSENT, CANNOT_TELL = "present", "absent", "cannot tell"

STRENGTHS: Mapping[str, str] = {
    "arms race": "least_rise",
    "cycling": "checkerboards",
    "disengagement": "one_sided",
    "forgetting": "most_forgetting",
    "stagnation": "greatest_rise",
}
"""The number, of those of `evidence.numbers_of`, that measures each condition: the more the
likelier; of stagnation its size, and the less the likelier."""
CONDITIONS = tuple(STRENGTHS)

SURE = 0.8
"""Share of the toy races of a strength that must have had a condition, or not, for a verdict."""

Interval = tuple[float, float]


@dataclass(frozen=True)
class Bins:
    """Toy races by strength of evidence: bin i lies between edges i - 1 and i, the last ones open.

    An edge belongs to the bin above it.
    """

    edges: tuple[float, ...]
    present: tuple[int, ...]
    """Races that had the condition; one number more than edges."""
    absent: tuple[int, ...]
    """Races that had not."""

    def shares(self, interval: Interval) -> Interval:
        """Least and greatest share of races with the condition in the bins of an interval.

        ``(present + 1) / (present + absent + 2)``, Laplace's rule: 1/2 where there were no races.
        """
        first, last = np.searchsorted(self.edges, interval, side="right")
        shares = [
            (yes + 1) / (yes + no + 2)
            for yes, no in zip(
                self.present[first : last + 1], self.absent[first : last + 1], strict=True
            )
        ]
        return min(shares), max(shares)

    def judge(self, interval: Interval) -> tuple[str, float]:
        """Verdict and confidence: what races in *all* bins of the interval had in common.

        The confidence is the least share of races for which the verdict is true; 0 without one.
        """
        low, high = self.shares(interval)
        if low >= SURE:
            return PRESENT, low
        if high <= 1.0 - SURE:
            return ABSENT, 1.0 - high
        return CANNOT_TELL, 0.0


@dataclass(frozen=True)
class Calibration:
    """Bins of each condition, for matrices whose episodes are known and for those of means only."""

    source: str
    episodes: Mapping[str, Bins]
    means: Mapping[str, Bins]
    slack: Mapping[str, float]
    """Half an interval over episodes, which nine of ten toy races stay below; taken for that of
    matrices whose episodes are not known."""

    def to_json(self) -> dict[str, Any]:
        """Plain values, as in ``calibration.json``."""
        return {
            "source": self.source,
            "slack": dict(self.slack),
            **{
                table: {name: vars(bins) for name, bins in getattr(self, table).items()}
                for table in ("episodes", "means")
            },
        }


@cache
def calibration() -> Calibration:
    """The one that `diagnose` goes by, read from ``calibration.json``."""
    text = files("matrixworld.analysis").joinpath("calibration.json").read_text(encoding="utf-8")
    values = json.loads(text)
    episodes, means = (
        {
            name: Bins(*(tuple(bins[key]) for key in ("edges", "present", "absent")))
            for name, bins in values[table].items()
        }
        for table in ("episodes", "means")
    )
    return Calibration(values["source"], episodes, means, values["slack"])


def tally(edges: tuple[float, ...], races: Iterable[tuple[float, bool]]) -> Bins:
    """Count races, each a strength and whether it had the condition."""
    counts = np.zeros((2, len(edges) + 1), dtype=np.int64)
    for strength, had_it in races:
        counts[int(not had_it), np.searchsorted(edges, strength, side="right")] += 1
    return Bins(edges, tuple(counts[0].tolist()), tuple(counts[1].tolist()))


def strength(condition: str, numbers: Mapping[str, Estimate]) -> float:
    """The strength of the evidence for a condition."""
    value = numbers[STRENGTHS[condition]].value
    return abs(value) if condition == "stagnation" else value


def strengths(condition: str, numbers: Mapping[str, Estimate], slack: float) -> Interval:
    """The interval that it lies in: over runs or episodes, else as wide as `slack` either way."""
    one = numbers[STRENGTHS[condition]]
    low = one.value - slack if one.low is None else min(one.low, one.value)
    high = one.value + slack if one.high is None else max(one.high, one.value)
    if condition != "stagnation":
        return low, high
    sizes = abs(low), abs(high)
    return (0.0 if low <= 0.0 <= high else min(sizes)), max(sizes)
