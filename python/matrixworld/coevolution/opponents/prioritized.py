"""Opponents drawn by how hard they are to beat (Vinyals et al. 2019)."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_number
from matrixworld.coevolution.opponents.samplers import check_available, check_count, checked_scores
from matrixworld.coevolution.types import FloatArray, Indices, State

Weighting = Callable[[FloatArray], FloatArray]
"""Win rates (m,) of the learning team -> weights (m,), none negative."""

UNKNOWN = 0.5
"""Assumed win rate against an opponent without games."""


def hard(power: float = 2.0) -> Weighting:
    """Return the weighting ``(1 - x)^power``: most weight on opponents that are seldom beaten.

    Parameters
    ----------
    power : float, optional
        Above 0; the higher, the more weight on the hardest opponents.

    Returns
    -------
    callable
        The weighting.

    Raises
    ------
    ValueError
        If `power` is out of range.
    """
    check_number("power", power, least=0.0, positive=True)
    return partial(_hard, power=power)


# Not inside `hard`: samplers are pickled, and a function inside another one cannot be.
def _hard(x: FloatArray, *, power: float) -> FloatArray:
    return np.asarray((1.0 - x) ** power)


def even(x: FloatArray) -> FloatArray:
    """Weight ``x (1 - x)``: most weight on opponents that are beaten half of the time.

    Parameters
    ----------
    x : ndarray of float64, shape (m,)
        Win rates of the learning team.

    Returns
    -------
    ndarray of float64, shape (m,)
        Weights.
    """
    return x * (1.0 - x)


class Prioritized:
    """Opponents drawn with probability ~ f(win rate), without replacement.

    ::

        sample:  x[j] = wins[j] / games[j], or 1/2 without games
                 draw `count` opponents with P(j) = f(x[j]) / sum_i f(x[i])
        tell:    games[j] = decay games[j] + 1;  wins[j] = decay wins[j] + mean score against j

    Opponents of weight 0 are drawn, evenly, only if those of positive weight do not suffice.

    Parameters
    ----------
    weighting : callable, optional
        f, such as ``hard(p)`` or `even`. The default is ``hard()``.
    count : int, optional
        Opponents an epoch; all, if fewer are available.
    decay : float, optional
        Factor, in (0, 1], on earlier wins and games against an opponent with each new game.

    Raises
    ------
    ValueError
        If `count` or `decay` is out of range.

    References
    ----------
    Vinyals et al. 2019, "Grandmaster level in StarCraft II using multi-agent reinforcement
    learning", Nature 575, "prioritized fictitious self-play".
    """

    def __init__(
        self, weighting: Weighting | None = None, *, count: int = 1, decay: float = 0.99
    ) -> None:
        check_count("count", count)
        check_number("decay", decay, least=0.0, most=1.0, positive=True)
        self.weighting: Weighting = hard() if weighting is None else weighting
        self.count: int = count
        self.decay: float = decay
        self._wins, self._games = np.zeros(0), np.zeros(0)

    def win_rates(self, available: int) -> FloatArray:
        """Return the learning team's recent win rate against each opponent, (available,)."""
        wins, games = _padded(self._wins, available), _padded(self._games, available)
        rates = np.full(available, UNKNOWN)
        # Where there are no games, `out` keeps the assumed rate.
        np.divide(wins[:available], games[:available], out=rates, where=games[:available] > 0.0)
        return rates

    def probabilities(self, available: int) -> FloatArray:
        """Return the probability (available,) of each opponent; even if all weights are 0."""
        check_available(available)
        weights = np.asarray(self.weighting(self.win_rates(available)), dtype=np.float64)
        if weights.shape != (available,) or not (weights >= 0.0).all():
            raise ValueError(f"weighting: expected {available} weights >= 0, got {weights}")
        total = weights.sum()
        return weights / total if total > 0.0 else np.full(available, 1.0 / available)

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return opponents drawn by their weights, in the order of the draw."""
        probabilities = self.probabilities(available)
        positive = np.flatnonzero(probabilities)
        count = min(self.count, available)
        # `choice` cannot draw more than there are of positive weight; the rest is drawn evenly.
        size = min(count, len(positive))
        chosen = rng.choice(positive, size=size, replace=False, p=probabilities[positive])
        rest = np.flatnonzero(probabilities == 0.0)
        return np.append(chosen, rng.choice(rest, size=count - size, replace=False))

    def tell(self, opponents: Indices, scores: ArrayLike) -> None:
        """Count one game against each opponent, won by the mean of its scores (n, c)."""
        index, values = checked_scores(opponents, scores)
        # The archive grows during a run, and so do the counts.
        size = int(index.max()) + 1
        self._wins, self._games = _padded(self._wins, size), _padded(self._games, size)
        self._wins[index] = self.decay * self._wins[index] + values.mean(axis=0)
        self._games[index] = self.decay * self._games[index] + 1.0

    def state(self) -> State:
        """Return the decayed wins and games against each opponent."""
        return {"wins": self._wins.copy(), "games": self._games.copy()}

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        self._wins = state["wins"].astype(np.float64)
        self._games = state["games"].astype(np.float64)


def _padded(values: FloatArray, size: int) -> FloatArray:
    return np.pad(values, (0, max(0, size - len(values))))
