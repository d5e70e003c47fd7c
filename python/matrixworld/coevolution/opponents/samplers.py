"""Whom to meet: the interface, and the rules that look at nothing but the number of opponents."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution.types import Indices, State


class OpponentSampler(Protocol):
    """Names the opponents of one epoch among those that there are.

    TeamPolicy are numbered from the oldest, 0, as they lie in an archive; a selection never sees
    them. Whoever plays the matches asks once an epoch, so that an opponent is one throughout an
    episode, and tells what came of it::

        met = selection.choose(available, epoch, rng)     # (c,) numbers below `available`
        scores = ...                                      # (n, c): n candidates against each
        selection.tell(met, scores)

    One selection serves one team. It does not know which, so that swapping the teams swaps the
    result. Random numbers come from the generator given to `choose` and from nothing else: a
    selection restored from `state` goes on as if it had never stopped.
    """

    def choose(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the opponents (c,) of an epoch, all below `available`; none comes twice."""

    def tell(self, met: Indices, scores: ArrayLike) -> None:
        """Take note of the scores (n, c) in [0, 1] of the candidates against the opponents met."""

    def state(self) -> State:
        """Return all that changes, as plain arrays."""

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""


class Stateless:
    """What the samplers share that take note of nothing."""

    def tell(self, met: Indices, scores: ArrayLike) -> None:
        """Take note of nothing."""

    def state(self) -> State:
        """Return no arrays: nothing changes."""
        return {}

    def restore(self, state: State) -> None:
        """Have nothing to take up."""


@dataclass(frozen=True)
class Latest(Stateless):
    """The `count` newest opponents, or all where there are fewer: ``available - 1, ...``."""

    count: int = 1

    def __post_init__(self) -> None:
        check_count("count", self.count)

    def choose(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the newest opponents, the newest first."""
        check_available(available)
        return np.arange(available)[::-1][: self.count]


@dataclass(frozen=True)
class Uniform(Stateless):
    """`count` opponents drawn evenly without replacement, or all; None: always all.

    A best response to all of the past, each with the same weight, is fictitious play (Brown 1951).
    """

    count: int | None = 1

    def __post_init__(self) -> None:
        if self.count is not None:
            check_count("count", self.count)

    def choose(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return opponents drawn evenly, in random order; all of them in their own order."""
        check_available(available)
        if self.count is None:
            return np.arange(available)
        return rng.choice(available, size=min(self.count, available), replace=False)


@dataclass(frozen=True)
class RoundRobin(Stateless):
    """All opponents in turn: ``epoch mod available``, the generalists' rule of the paper.

    Sun et al. 2023, "MatrixWorld", arXiv:2307.14854, algorithms 2 and 3. With a `count` above 1
    that many at a time, or all where there are fewer.
    """

    count: int = 1

    def __post_init__(self) -> None:
        check_count("count", self.count)

    def choose(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the opponents whose turn it is."""
        check_available(available)
        turns = np.arange(min(self.count, available))
        return np.asarray((epoch * self.count + turns) % available)


@dataclass(frozen=True)
class HallOfFame(Stateless):
    """The `newest` opponents, and `sampled` older ones drawn evenly (Rosin & Belew 1997).

    "New methods for competitive coevolution", Evolutionary Computation 5(1).
    """

    newest: int = 1
    sampled: int = 1

    def __post_init__(self) -> None:
        check_count("newest", self.newest, least=0)
        check_count("sampled", self.sampled, least=0)
        check_count("newest + sampled", self.newest + self.sampled)

    def choose(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the newest opponents, the newest first, and then the sample."""
        check_available(available)
        older = max(0, available - self.newest)
        newest = np.arange(older, available)[::-1]
        return np.append(newest, rng.choice(older, size=min(self.sampled, older), replace=False))


def check_count(name: str, value: int, *, least: int = 1) -> None:
    """ValueError if a number is below `least`."""
    if value < least:
        raise ValueError(f"{name}: expected at least {least}, got {value}")


def check_available(available: int) -> None:
    """ValueError if there is nobody to meet."""
    check_count("available", available)


def checked_scores(met: ArrayLike, scores: ArrayLike) -> tuple[Indices, NDArray[np.float64]]:
    """Return opponents (c,) and scores (n, c); ValueError if shapes or values do not fit."""
    index, values = np.asarray(met, dtype=np.intp), np.asarray(scores, dtype=np.float64)
    if values.ndim != 2 or index.shape != values.shape[1:] or not values.size:
        raise ValueError(
            f"scores: expected shape (n, {index.size}), at least one each, got {values.shape}"
        )
    if not ((values >= 0.0) & (values <= 1.0)).all():
        raise ValueError(f"scores: expected numbers in [0, 1], got {values}")
    return index, values
