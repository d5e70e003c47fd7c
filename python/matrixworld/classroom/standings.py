"""Scores of a class tournament with intervals, and ranks that say when nothing can be told."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import Estimate, difference_over_episodes, linear_over_episodes
from matrixworld.analysis.intervals import UNIT
from matrixworld.classroom.submissions import Entry
from matrixworld.classroom.tournament import ClassResult
from matrixworld.coevolution.types import Team

ERROR = 0.05
"""Chance that the range of an entry's rank misses its true rank."""


@dataclass(frozen=True)
class Standing:
    """The place of one entry among those of its team.

    Parameters
    ----------
    entry : Entry
        What played.
    number : int
        Its row of the matrix, or its column.
    score : Estimate
        Mean payoff against all opponents, with a 95 % interval over episodes: the capture rate of
        pursuers, one minus it of evaders.
    ranks : tuple of int, or None
        The best and the worst rank that it may have among the students; None for a script.
    best, worst : int
        The opponents against which its payoff is highest and lowest.
    """

    entry: Entry
    number: int
    score: Estimate
    ranks: tuple[int, int] | None
    best: int
    worst: int

    @property
    def rank(self) -> str:
        """The rank as text, such as "3" or "2 to 5"; empty for a script."""
        if self.ranks is None:
            return ""
        first, last = self.ranks
        return str(first) if first == last else f"{first} to {last}"


def standings(result: ClassResult, team: Team) -> list[Standing]:
    """Return the standings of a team's students and scripts, the highest score first.

    Entries with equal scores are in the order of the submissions.

    Parameters
    ----------
    result : ClassResult
        The tournament.
    team : {"pursuer", "evader"}
        The team.
    """
    payoffs = payoffs_of(result, team)
    entries, means = result.entries[team], payoffs.mean(axis=2)
    students = [number for number, entry in enumerate(entries) if entry.kind != "script"]
    ranks = dict(zip(students, rank_ranges(payoffs[students]), strict=True))
    found = [
        Standing(
            entry,
            number,
            score=linear_over_episodes(
                payoffs[number : number + 1], lambda means: float(means.mean()), bounds=UNIT
            ),
            ranks=ranks.get(number),
            best=int(means[number].argmax()),
            worst=int(means[number].argmin()),
        )
        for number, entry in enumerate(entries)
    ]
    return sorted(found, key=lambda each: -each.score.value)


def payoffs_of(result: ClassResult, team: Team) -> NDArray[np.float64]:
    """Return the payoffs of a team, (entries, opponents, episodes)."""
    rates = result.capture_rates
    return rates if team == "pursuer" else 1.0 - rates.transpose(1, 0, 2)


def rank_ranges(payoffs: NDArray[np.float64]) -> list[tuple[int, int]]:
    """Return the best and the worst rank that each of n entries may have.

    Payoffs are (n, opponents, episodes) in [0, 1]; episode e of all cells has the same start. The
    best rank is 1 + the number of entries that are surely better, the worst one n minus the number
    of those that are surely worse: the interval of the difference does not include 0.

    Mogstad, Romano, Shaikh and Wilhelm (2024), "Inference for ranks with applications to mobility
    across neighbourhoods and academic achievement across countries": each of the n - 1 differences
    of an entry has an interval of level ``1 - ERROR / (n - 1)``, so that all of them hold at once
    with a probability of at least 0.95; then so does the range.
    """
    n = len(payoffs)
    worse_than, better_than = np.zeros(n, int), np.zeros(n, int)
    for one, other in combinations(range(n), 2):
        sign = _surely(payoffs[one], payoffs[other], 1.0 - ERROR / (n - 1))
        if sign:
            better, worse = (one, other) if sign > 0 else (other, one)
            better_than[better] += 1
            worse_than[worse] += 1
    return [(1 + int(up), n - int(down)) for up, down in zip(worse_than, better_than, strict=True)]


def _surely(one: NDArray[np.float64], other: NDArray[np.float64], level: float) -> int:
    """Return 1 if one entry is surely better than another, -1 if worse, 0 if nobody can tell."""
    found = linear_over_episodes(
        np.stack([one, other]), lambda means: float(means[0].mean() - means[1].mean()), level=level
    )
    if found.low is None:
        # Equal differences in all episodes have no t interval; this one needs no variation.
        found = difference_over_episodes(one.mean(axis=0), other.mean(axis=0), level=level)
    return found.sign
