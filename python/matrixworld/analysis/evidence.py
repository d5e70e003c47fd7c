"""The numbers behind a judgement: one run, one window of its generations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from matrixworld.analysis.cycles import two_way_parts
from matrixworld.analysis.engagement import one_sidedness
from matrixworld.analysis.forgetting import mean_forgetting
from matrixworld.analysis.intransitivity import cyclic_amplitude
from matrixworld.analysis.lags import team_phase_rates
from matrixworld.analysis.measurement import Measurement
from matrixworld.analysis.payoff import Rates
from matrixworld.analysis.strength import strength_change, strength_gain

FEWEST_GENERATIONS = 6
"""Fewest generations of each team in a window that is judged."""
FEWEST_EPISODES = 4
"""Fewest episodes of each cell that show their noise: two in each half."""

PURSUER_GAIN, EVADER_GAIN = "gain of the pursuers", "gain of the evaders"
PURSUER_CHANGE, EVADER_CHANGE = "change of the pursuers", "change of the evaders"
CYCLIC = "squared cyclic amplitude"
PURSUERS_FORGET, EVADERS_FORGET = "forgetting of the pursuers", "forgetting of the evaders"
ONE_SIDEDNESS = "payoff of the winning team"

Evidence = dict[str, Measurement]
"""Numbers by name; without known episodes only gains and changes."""


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
    rng : numpy.random.Generator
        Splits means into halves where the episodes are not known.
    """

    def __init__(
        self,
        matrix: Rates,
        scores: Rates | None,
        episodes: int | None,
        level: float,
        rng: np.random.Generator,
    ) -> None:
        self._matrix, self._level = matrix, level
        self._episodes = 0 if episodes is None else episodes
        self._noise = _noise(matrix, scores, self._episodes)
        self._halves = _halves(matrix, scores, self._episodes, rng)

    def of(self, window: Window) -> Evidence:
        """Return the numbers of a window of at least `FEWEST_GENERATIONS` generations."""
        pursuers = self._strengths(window.cells[0], axis=1)
        evaders = self._strengths(window.cells[1], axis=0)
        strengths = {
            PURSUER_GAIN: strength_gain(*pursuers, level=self._level),
            EVADER_GAIN: strength_gain(*evaders, level=self._level),
            PURSUER_CHANGE: strength_change(*pursuers, level=self._level),
            EVADER_CHANGE: strength_change(*evaders, level=self._level),
        }
        # Without its noise a matrix cannot be told from one that noise has made.
        if self._episodes < FEWEST_EPISODES:
            return strengths
        return strengths | self._beyond_noise(window)

    def _strengths(self, generations: slice, axis: int) -> tuple[Rates, Rates]:
        """Return a team's mean payoffs against all opponents of the race, and their noise."""
        means = self._matrix.mean(axis=axis)[generations]
        noise = (self._noise.mean(axis=axis) / self._matrix.shape[axis])[generations]
        return (means if axis else 1.0 - means), noise

    def _beyond_noise(self, window: Window) -> Evidence:
        cells, level = window.cells, self._level
        one, other = self._halves
        swapped = 1.0 - one.T, 1.0 - other.T
        first = max(1, window.pursuers[0], window.evaders[0])
        last = min(window.pursuers[1], window.evaders[1])
        # Row k - 1 of the team phase rates belongs to generation k.
        current = team_phase_rates(self._matrix)[first - 1 : last - 1]
        return {
            CYCLIC: cyclic_amplitude(self._matrix[cells], self._noise[cells], level=level),
            PURSUERS_FORGET: mean_forgetting(
                (one, other), self._noise, _later_half(cells[0]), level=level
            ),
            EVADERS_FORGET: mean_forgetting(
                swapped, self._noise.T, _later_half(cells[1]), level=level
            ),
            ONE_SIDEDNESS: one_sidedness(current, self._effective_episodes(cells), level=level),
        }

    def _effective_episodes(self, cells: tuple[slice, slice]) -> float:
        """Return how many wins and losses of each cell would have the noise of its episodes."""
        rates = self._matrix[cells]
        wins_and_losses = float((rates * (1.0 - rates)).sum()) / (self._episodes - 1)
        noise = float(self._noise[cells].sum())
        # Episodes without variation show none of their noise.
        return self._episodes * max(1.0, wins_and_losses / noise if noise else 1.0)


def _later_half(generations: slice) -> slice:
    # Early generations of a window have few ancestors, so they have little to forget.
    return slice((generations.start + generations.stop) // 2, generations.stop)


def _noise(matrix: Rates, scores: Rates | None, episodes: int) -> Rates:
    """Return an unbiased estimate of the variance of each cell; zeros if it is unknown."""
    if episodes < 2:
        return np.zeros_like(matrix)
    if scores is not None:
        sampled: Rates = scores.var(axis=2, ddof=1) / episodes
        return sampled
    # Scores in [0, 1] vary at most as much as wins and losses with the same mean.
    return matrix * (1.0 - matrix) / (episodes - 1)


def _halves(
    matrix: Rates, scores: Rates | None, episodes: int, rng: np.random.Generator
) -> tuple[Rates, Rates]:
    """Return the payoff matrix in two independent sets of episodes."""
    if scores is not None and scores.shape[2] >= 2:
        even = scores.shape[2] // 2 * 2
        return scores[..., :even:2].mean(axis=2), scores[..., 1:even:2].mean(axis=2)
    # Gaussian data thinning (Neufeld et al. 2024): the sum and the difference with other noise of
    # the same variance are independent, as halves are. The variance must not come from the cell
    # itself, whose luck it would share.
    parts = two_way_parts(matrix)
    expected = np.clip(matrix - parts.cyclic, 0.0, 1.0)
    variance = expected * (1.0 - expected) / max(1, episodes - 1)
    shift = rng.normal(size=matrix.shape) * np.sqrt(variance)
    return matrix + shift, matrix - shift
