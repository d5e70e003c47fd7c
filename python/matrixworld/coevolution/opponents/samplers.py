"""Opponent samplers: the interface, the rules that need no scores, and those by scores."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_integer, check_number
from matrixworld.coevolution.types import FloatArray, Indices, Saved, Stateful


class OpponentSampler(Stateful, Protocol):
    """The interface of opponent samplers: choose the opponents of each epoch.

    Opponents are numbered from the oldest, 0, in the order of their archive. A sampler returns
    numbers; the genomes stay with the caller, who asks once an epoch and then tells the scores::

        opponents = sampler.sample(available, epoch, rng)    # (c,) numbers below `available`
        scores = ...                                         # (n, c): n candidates against each
        sampler.tell(opponents, scores)

    A sampler serves one team and does not know which: if the teams are swapped, so is the result.
    Random numbers come only from the generator passed to `sample`. A sampler restored from `state`
    therefore continues as if it had never stopped.

    A class with these methods is named in the settings as ``module:object`` (see `own_code`), and
    `check_sampler` checks it. It is made with the keyword argument `count`, the largest number of
    opponents in an epoch, if its signature names it; all other arguments are settings of its own.
    """

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the opponents (c,) of an epoch, all below `available`, without repetition.

        At least 1, at most `count` of them. `available` never falls during a run; `epoch` counts
        from 0 in each generation.
        """

    def tell(self, opponents: Indices, scores: ArrayLike) -> None:
        """Record the scores (n, c), in [0, 1], of n candidates against the opponents (c,)."""


class Stateless(Saved):
    """Base of the samplers that do not use scores: nothing changes, so no arrays are saved."""

    def tell(self, opponents: Indices, scores: ArrayLike) -> None:
        """Ignore the scores."""


@dataclass(frozen=True)
class Counted(Stateless):
    """Base of the samplers whose one setting is the number of opponents.

    Parameters
    ----------
    count : int, optional
        Opponents an epoch; all, if fewer are available.
    """

    count: int = 1

    def __post_init__(self) -> None:
        check_integer("count", self.count, 1)


class Latest(Counted):
    """The newest opponents, at most `count`: ``available - 1, available - 2, ...``."""

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the newest opponents, the newest first."""
        check_available(available)
        return np.arange(available)[::-1][: self.count]


@dataclass(frozen=True)
class Uniform(Stateless):
    """Opponents drawn evenly without replacement.

    Parameters
    ----------
    count : int or None, optional
        Opponents an epoch; all, if fewer are available. None: always all. A best response to all
        past opponents, each with the same weight, is fictitious play.

    References
    ----------
    Brown 1951, "Iterative solution of games by fictitious play".
    """

    count: int | None = 1

    def __post_init__(self) -> None:
        if self.count is not None:
            check_integer("count", self.count, 1)

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return opponents in random order, or all of them in their own order."""
        check_available(available)
        # Nothing is drawn, so all opponents keep their order.
        if self.count is None:
            return np.arange(available)
        return rng.choice(available, size=min(self.count, available), replace=False)


class RoundRobin(Counted):
    """All opponents in turn, `count` an epoch: ``epoch mod available``, as the paper's generalists.

    References
    ----------
    Sun et al. 2023, "MatrixWorld", arXiv:2307.14854, algorithms 2 and 3.
    """

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the next opponents in the cycle."""
        check_available(available)
        # No more than are available, or an opponent would come twice in an epoch.
        turns = np.arange(min(self.count, available))
        return np.asarray((epoch * self.count + turns) % available)


@dataclass(frozen=True)
class HallOfFame(Stateless):
    """The newest opponents, and older ones drawn evenly.

    Parameters
    ----------
    newest : int, optional
        Number of the newest opponents.
    sampled : int, optional
        Number of older opponents. `newest` and `sampled` are at least 0, their sum at least 1.

    References
    ----------
    Rosin & Belew 1997, "New methods for competitive coevolution", Evolutionary Computation 5(1).
    """

    newest: int = 1
    sampled: int = 1

    def __post_init__(self) -> None:
        check_integer("newest", self.newest, 0)
        check_integer("sampled", self.sampled, 0)
        check_integer("newest + sampled", self.newest + self.sampled, 1)

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the newest opponents, the newest first, and then the older ones."""
        check_available(available)
        # Opponents 0 .. older - 1 are the older ones.
        older = max(0, available - self.newest)
        newest = np.arange(older, available)[::-1]
        return np.append(newest, rng.choice(older, size=min(self.sampled, older), replace=False))


def check_available(available: int) -> None:
    """Raise ValueError if there is no opponent."""
    check_integer("available", available, 1)


def checked_scores(opponents: ArrayLike, scores: ArrayLike) -> tuple[Indices, FloatArray]:
    """Return opponents (c,) and scores (n, c); ValueError unless they fit and are in [0, 1]."""
    index, values = np.asarray(opponents, dtype=np.intp), np.asarray(scores, dtype=np.float64)
    if values.ndim != 2 or index.shape != values.shape[1:] or not values.size:
        raise ValueError(
            f"scores: expected shape (n, {index.size}), at least one each, got {values.shape}"
        )
    if not ((values >= 0.0) & (values <= 1.0)).all():
        raise ValueError(f"scores: expected numbers in [0, 1], got {values}")
    return index, values


# By the scores against each opponent:

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
    """
    check_number("power", power, least=0.0, positive=True)
    return partial(_hard, power=power)


# Not inside `hard`: samplers are pickled, and a function inside another one cannot be.
def _hard(x: FloatArray, *, power: float) -> FloatArray:
    return np.asarray((1.0 - x) ** power)


def even(x: FloatArray) -> FloatArray:
    """Return the weights (m,) ``x (1 - x)``: most on opponents that are beaten half of the time.

    Parameters
    ----------
    x : ndarray of float64, shape (m,)
        Win rates of the learning team.
    """
    return x * (1.0 - x)


class Prioritized(Saved):
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

    References
    ----------
    Vinyals et al. 2019, "Grandmaster level in StarCraft II using multi-agent reinforcement
    learning", Nature 575, "prioritized fictitious self-play".
    """

    saved: ClassVar[tuple[str, ...]] = ("wins", "games")

    def __init__(
        self, weighting: Weighting | None = None, *, count: int = 1, decay: float = 0.99
    ) -> None:
        check_integer("count", count, 1)
        check_number("decay", decay, least=0.0, most=1.0, positive=True)
        self.weighting: Weighting = hard() if weighting is None else weighting
        self.count: int = count
        self.decay: float = decay
        self.wins, self.games = np.zeros(0), np.zeros(0)

    def win_rates(self, available: int) -> FloatArray:
        """Return the learning team's recent win rate against each opponent, (available,)."""
        wins, games = _padded(self.wins, available), _padded(self.games, available)
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
        self.wins, self.games = _padded(self.wins, size), _padded(self.games, size)
        self.wins[index] = self.decay * self.wins[index] + values.mean(axis=0)
        self.games[index] = self.decay * self.games[index] + 1.0


def _padded(values: FloatArray, size: int) -> FloatArray:
    return np.pad(values, (0, max(0, size - len(values))))


def shared_sample(beats: ArrayLike, count: int, rng: np.random.Generator) -> Indices:
    """Return a greedy sample of opponents, each of which beats what few others in it beat.

    ::

        covered[k] = 0 for every individual k
        repeat count times:
            choose the j not yet chosen with the most  sum_k beats[j, k] / (1 + covered[k]);
            decide ties at random
            covered[k] += beats[j, k]

    `beats` (m, n) says how surely opponent j beats individual k of the last epoch, in [0, 1].

    Rosin & Belew 1997, "New methods for competitive coevolution", Evolutionary Computation 5(1).
    """
    matrix = np.asarray(beats, dtype=np.float64)
    # argmax takes the first of equals, so a random order of the rows decides ties at random.
    order = rng.permutation(len(matrix))
    shuffled, covered = matrix[order], np.zeros(matrix.shape[1])
    chosen: list[int] = []
    for _ in range(min(count, len(matrix))):
        value = (shuffled / (1.0 + covered)).sum(axis=1)
        # Below every value, so that no opponent is chosen twice.
        value[chosen] = -1.0
        chosen.append(int(np.argmax(value)))
        covered += shuffled[chosen[-1]]
    return np.asarray(order[chosen], dtype=np.intp)


class SharedSampling(Saved):
    """A sampler of strong and different opponents, by the last scores against each.

    The rule is that of `shared_sample`. An opponent without scores counts as beating every
    candidate, so that it is soon sampled. If the number of candidates changes, all scores are
    forgotten.

    Parameters
    ----------
    count : int, optional
        Opponents an epoch; all, if fewer are available.
    """

    saved: ClassVar[tuple[str, ...]] = ("last",)

    def __init__(self, count: int = 1) -> None:
        check_integer("count", count, 1)
        self.count = count
        self.last = np.ones((0, 1))

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the sample, the strongest first."""
        check_available(available)
        return shared_sample(self.beats(available), self.count, rng)

    def beats(self, available: int) -> FloatArray:
        """Return how surely each opponent beats each candidate, (available, n)."""
        unknown = max(0, available - len(self.last))
        return np.pad(self.last[:available], ((0, unknown), (0, 0)), constant_values=1.0)

    def tell(self, opponents: Indices, scores: ArrayLike) -> None:
        """Record one minus the scores (n, c) for each opponent."""
        index, values = checked_scores(opponents, scores)
        # Columns are candidates; with another number of them old scores fit none.
        if self.last.shape[1] != len(values):
            self.last = np.ones((0, len(values)))
        self.last = self.beats(max(len(self.last), int(index.max()) + 1))
        self.last[index] = 1.0 - values.T
