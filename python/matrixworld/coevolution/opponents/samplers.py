"""Opponent samplers: the interface, and the rules that use only the number of opponents."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_integer
from matrixworld.coevolution.types import FloatArray, Indices, State


class OpponentSampler(Protocol):
    """The interface of opponent samplers: choose the opponents of each epoch.

    Opponents are numbered from the oldest, 0, in the order of their archive. A sampler returns
    numbers; the genomes stay with the caller, who asks once an epoch and then tells the scores::

        opponents = sampler.sample(available, epoch, rng)    # (c,) numbers below `available`
        scores = ...                                         # (n, c): n candidates against each
        sampler.tell(opponents, scores)

    A sampler serves one team and does not know which: if the teams are swapped, so is the result.
    Random numbers come only from the generator passed to `sample`. A sampler restored from `state`
    therefore continues as if it had never stopped.

    A class with these methods is named in the settings as ``module:object`` (see `plugins`), and
    `check_sampler` checks it. It is made with the keyword argument `count`, the largest number of
    opponents in an epoch, if its signature names it; all other arguments are settings of its own
    (`pursuers_meet_settings`, `evaders_meet_settings`).
    """

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the opponents (c,) of an epoch, all below `available`, without repetition.

        At least 1, at most `count` of them. `available` never falls during a run; `epoch` counts
        from 0 in each generation.
        """

    def tell(self, opponents: Indices, scores: ArrayLike) -> None:
        """Record the scores (n, c), in [0, 1], of n candidates against the opponents (c,)."""

    def state(self) -> State:
        """Return all that changes, as arrays of numbers or text; names are identifiers."""

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`, of this or of an equal sampler."""


class Stateless:
    """Base of the samplers that do not use scores."""

    def tell(self, opponents: Indices, scores: ArrayLike) -> None:
        """Ignore the scores."""

    def state(self) -> State:
        """Return no arrays: nothing changes."""
        return {}

    def restore(self, state: State) -> None:
        """Do nothing: there is no state."""


@dataclass(frozen=True)
class Latest(Stateless):
    """The newest opponents: ``available - 1, available - 2, ...``.

    Parameters
    ----------
    count : int, optional
        Opponents an epoch; all, if fewer are available.
    """

    count: int = 1

    def __post_init__(self) -> None:
        check_count("count", self.count)

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
            check_count("count", self.count)

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return opponents in random order, or all of them in their own order."""
        check_available(available)
        # Nothing is drawn, so all opponents keep their order.
        if self.count is None:
            return np.arange(available)
        return rng.choice(available, size=min(self.count, available), replace=False)


@dataclass(frozen=True)
class RoundRobin(Stateless):
    """All opponents in turn: ``epoch mod available``, the rule of the paper's generalists.

    Parameters
    ----------
    count : int, optional
        Opponents an epoch; all, if fewer are available.

    References
    ----------
    Sun et al. 2023, "MatrixWorld", arXiv:2307.14854, algorithms 2 and 3.
    """

    count: int = 1

    def __post_init__(self) -> None:
        check_count("count", self.count)

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
        check_count("newest", self.newest, least=0)
        check_count("sampled", self.sampled, least=0)
        check_count("newest + sampled", self.newest + self.sampled)

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the newest opponents, the newest first, and then the older ones."""
        check_available(available)
        # Opponents 0 .. older - 1 are the older ones.
        older = max(0, available - self.newest)
        newest = np.arange(older, available)[::-1]
        return np.append(newest, rng.choice(older, size=min(self.sampled, older), replace=False))


def check_count(name: str, value: int, *, least: int = 1) -> None:
    """Raise ValueError if a number is below `least`, TypeError if it is not an integer."""
    check_integer(name, value, least)


def check_available(available: int) -> None:
    """Raise ValueError if there is no opponent."""
    check_count("available", available)


def checked_scores(opponents: ArrayLike, scores: ArrayLike) -> tuple[Indices, FloatArray]:
    """Return opponents (c,) and scores (n, c) as arrays.

    Raises
    ------
    ValueError
        If the shapes do not fit, there is no score, or a score lies outside [0, 1].
    """
    index, values = np.asarray(opponents, dtype=np.intp), np.asarray(scores, dtype=np.float64)
    if values.ndim != 2 or index.shape != values.shape[1:] or not values.size:
        raise ValueError(
            f"scores: expected shape (n, {index.size}), at least one each, got {values.shape}"
        )
    if not ((values >= 0.0) & (values <= 1.0)).all():
        raise ValueError(f"scores: expected numbers in [0, 1], got {values}")
    return index, values
