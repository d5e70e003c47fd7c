"""The numbers behind a judgement: one run, one window of its generations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from matrixworld.analysis.cycles import checkerboards
from matrixworld.analysis.engagement import one_sidedness
from matrixworld.analysis.forgetting import mean_forgetting
from matrixworld.analysis.intervals import Estimate
from matrixworld.analysis.intransitivity import cyclic_amplitude, thinned
from matrixworld.analysis.lags import team_phase_rates
from matrixworld.analysis.measurement import Measurement, over_runs
from matrixworld.analysis.payoff import Rates, swap_teams
from matrixworld.analysis.strength import strength_change, strength_gain
from matrixworld.analysis.summary import MARGIN

FEWEST_GENERATIONS = 6
"""Fewest generations of each team in a window that is judged."""
FEWEST_EPISODES = 4
"""Fewest episodes of each cell that show their noise: two in each half."""

PURSUER_GAIN, EVADER_GAIN = "gain of the pursuers", "gain of the evaders"
PURSUER_CHANGE, EVADER_CHANGE = "change of the pursuers", "change of the evaders"
CYCLIC, CHECKERBOARDS = "squared cyclic amplitude", "checkerboards"
PURSUERS_FORGET, EVADERS_FORGET = "forgetting of the pursuers", "forgetting of the evaders"
ONE_SIDEDNESS = "payoff of the winning team"

Course = tuple[Rates, Rates]
"""Mean payoffs (k,) of a team's generations against all opponents, and the variance of each."""


@dataclass(frozen=True)
class Evidence:
    """The numbers of one run in one window.

    Parameters
    ----------
    numbers : dict of str to Measurement
        By name; all of them only if single episodes are known.
    courses : dict of str to Course
        Strengths of the teams by the names of their gains.
    """

    numbers: dict[str, Measurement]
    courses: dict[str, Course]


@dataclass(frozen=True)
class Window:
    """A part of a race, by generations of each team.

    Parameters
    ----------
    name : str
        ``"whole"``, ``"first half"`` or ``"last half"``.
    pursuers, evaders : tuple of int
        First generation of each team, and the one after the last.
    """

    name: str
    pursuers: tuple[int, int]
    evaders: tuple[int, int]

    @property
    def generations(self) -> int:
        """Generations of the team that has fewer in the window."""
        return min(stop - start for start, stop in (self.pursuers, self.evaders))

    @property
    def cells(self) -> tuple[slice, slice]:
        """The part of the payoff matrix."""
        return slice(*self.pursuers), slice(*self.evaders)


def windows_of(n: int, m: int) -> tuple[Window, ...]:
    """Return whole, first half and last half of a race of n pursuer and m evader generations."""
    # Of an odd number of generations the middle one belongs to the last half.
    return (
        Window("whole", (0, n), (0, m)),
        Window("first half", (0, n // 2), (0, m // 2)),
        Window("last half", (n // 2, n), (m // 2, m)),
    )


class RunEvidence:
    """A run's payoffs with the noise of its episodes, from which the numbers of windows come.

    Parameters
    ----------
    matrix : ndarray of float64, shape (n, m)
        Payoff matrix.
    scores : ndarray of float64, shape (n, m, episodes), or None
        Capture rate of each episode, if it is known.
    episodes : int or None
        Number of episodes of each cell, if it is known.
    level : float
        Level of the intervals.
    """

    def __init__(
        self,
        matrix: Rates,
        scores: Rates | None,
        episodes: int | None,
        level: float,
    ) -> None:
        self._matrix, self._scores, self._level = matrix, scores, level
        self._episodes = 0 if episodes is None else episodes
        self._noise = _noise(matrix, scores, self._episodes)

    def of(self, window: Window) -> Evidence:
        """Return the numbers of a window of at least `FEWEST_GENERATIONS` generations."""
        courses = {
            PURSUER_GAIN: self._course(window.cells[0], axis=1),
            EVADER_GAIN: self._course(window.cells[1], axis=0),
        }
        numbers = {
            **{name: strength_gain(*one, level=self._level) for name, one in courses.items()},
            PURSUER_CHANGE: strength_change(*courses[PURSUER_GAIN], level=self._level),
            EVADER_CHANGE: strength_change(*courses[EVADER_GAIN], level=self._level),
        }
        # Without its noise a matrix cannot be told from one that noise has made.
        if self._episodes >= FEWEST_EPISODES:
            numbers |= self._beyond_noise(window)
        return Evidence(numbers, courses)

    def _course(self, generations: slice, axis: int) -> Course:
        """Return a team's mean payoffs against all opponents of the race, and their noise."""
        means = self._matrix.mean(axis=axis)[generations]
        noise = (self._noise.mean(axis=axis) / self._matrix.shape[axis])[generations]
        return (means if axis else 1.0 - means), noise

    def _beyond_noise(self, window: Window) -> dict[str, Measurement]:
        # Later generations of the longer side have no opponent of their own generation.
        start, stop = min(window.pursuers, window.evaders, key=lambda span: span[1])
        # Row k - 1 of the team phase rates belongs to generation k; generation 0 has none.
        current = team_phase_rates(self._matrix)[max(0, start - 1) : stop - 1]
        episodes = self._effective_episodes(window.cells)
        numbers = {
            CYCLIC: self._cyclic(window.cells),
            CHECKERBOARDS: _checkerboards(self._matrix[window.cells]),
            ONE_SIDEDNESS: one_sidedness(current, episodes, level=self._level),
        }
        return numbers if self._scores is None else numbers | self._forgetting(window, self._scores)

    def _cyclic(self, cells: tuple[slice, slice]) -> Measurement:
        matrix, noise = self._matrix[cells], self._noise[cells]
        found = cyclic_amplitude(matrix, noise, level=self._level)
        if self._scores is not None:
            return found
        # The noise of means is known up to a bound, and may be 0: all of the rest may be a cycle.
        most = cyclic_amplitude(matrix, np.zeros_like(noise), level=self._level)
        return replace(found, high=most.high, over=most.over)

    def _forgetting(self, window: Window, scores: Rates) -> dict[str, Measurement]:
        # Episodes without a partner are left out, so that both halves are equally noisy.
        even = scores.shape[2] // 2 * 2
        one, other = (scores[..., start:even:2].mean(axis=2) for start in (0, 1))
        pursuers, evaders = (_later_half(each) for each in window.cells)
        swapped = swap_teams(one), swap_teams(other)
        return {
            PURSUERS_FORGET: mean_forgetting(
                (one, other), self._noise, pursuers, level=self._level
            ),
            EVADERS_FORGET: mean_forgetting(swapped, self._noise.T, evaders, level=self._level),
        }

    def _effective_episodes(self, cells: tuple[slice, slice]) -> float:
        """Return how many wins and losses of each cell would have the noise of its episodes."""
        rates = self._matrix[cells]
        wins_and_losses = float((rates * (1.0 - rates)).sum()) / (self._episodes - 1)
        noise = float(self._noise[cells].sum())
        # Episodes without variation show none of their noise.
        return self._episodes * max(1.0, wins_and_losses / noise if noise else 1.0)


def estimates_of(evidence: Sequence[Evidence], level: float) -> dict[str, Estimate]:
    """Return each number of a run, or its mean over several with an interval over runs.

    Parameters
    ----------
    evidence : sequence of Evidence
        Of each run, at least one, all in the same window.
    level : float
        Level of the intervals.

    Returns
    -------
    dict of str to Estimate
        By name. The interval of a gain over several runs also contains that of the mean course: a
        jump in the same generation of all runs is no trend.
    """
    trends = {name: _trend_of_runs(evidence, name, level) for name in evidence[0].courses}
    return {
        name: over_runs([one.numbers[name] for one in evidence], level, trends.get(name))
        for name in evidence[0].numbers
    }


def _trend_of_runs(evidence: Sequence[Evidence], name: str, level: float) -> Measurement:
    """Return the gain of the mean course of the runs."""
    courses = [one.courses[name] for one in evidence]
    scores, noise = (np.mean([course[part] for course in courses], axis=0) for part in (0, 1))
    return strength_gain(scores, noise / len(evidence), level=level)


def _checkerboards(matrix: Rates) -> Measurement:
    """Return the share of checkerboards, which has no interval."""
    share = checkerboards(thinned(matrix), margin=MARGIN, level=None).share
    return Measurement(share, share, share)


def _later_half(generations: slice) -> slice:
    # Early generations of a window have few ancestors, so they have little to forget.
    return slice((generations.start + generations.stop) // 2, generations.stop)


def _noise(matrix: Rates, scores: Rates | None, episodes: int) -> Rates:
    """Return the variance of each cell: an estimate, of means a bound; zeros if it is unknown."""
    if episodes < 2:
        return np.zeros_like(matrix)
    if scores is not None:
        sampled: Rates = scores.var(axis=2, ddof=1) / episodes
        return sampled
    # Scores in [0, 1] vary at most as much as wins and losses with the same mean.
    return matrix * (1.0 - matrix) / (episodes - 1)
