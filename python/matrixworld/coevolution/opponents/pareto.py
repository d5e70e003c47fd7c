"""Archives: what is kept of candidates, and of the tests that tell them apart.

To a team its own members are the candidates and its opponents the tests. Members are rows of
arrays of any dtype: genomes, or numbers that stand for them, such as generations
(`ArchiveSampler`).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution.types import FloatArray, Indices, State

Members = NDArray[Any]
PayoffFunction = Callable[[Members, Members], ArrayLike]
"""(candidates (n, ...), tests (m, ...)) -> payoffs (n, m) of the candidates, in [0, 1].

A pure function: the same pair has the same payoff whenever it is asked for.
"""


def swapped(outcome: PayoffFunction) -> PayoffFunction:
    """Return the outcome as the other team sees it: ``1 - outcome``, transposed."""
    return lambda candidates, tests: 1.0 - np.asarray(outcome(tests, candidates)).T


def protected(rows: ArrayLike) -> Members:
    """Return a copy that nobody can write to."""
    members = np.array(rows)
    if members.ndim == 0:
        raise ValueError("members: expected an array of rows, got a single number")
    members.flags.writeable = False
    return members


def payoffs(outcome: PayoffFunction, candidates: Members, tests: Members) -> FloatArray:
    """Return the payoffs (n, m) of candidates on tests; nothing is asked where there are none."""
    shape = (len(candidates), len(tests))
    if 0 in shape:
        return np.zeros(shape)
    values = np.asarray(outcome(candidates, tests), dtype=np.float64)
    if values.shape != shape:
        raise ValueError(f"outcome: expected payoffs of shape {shape}, got {values.shape}")
    if not np.isfinite(values).all():
        raise ValueError(f"outcome: expected finite numbers, got {values}")
    return values


class Archive(ABC):
    """Candidates and tests, and the payoffs of all against all.

    ::

        submit:  candidates = archived and new ones;  tests = archived and new ones
                 outcomes = payoffs of all these candidates on all these tests
                 keep some of both, by what the subclass says of the outcomes alone

    New candidates are judged on archived and new tests together, and members are compared by
    their outcomes, never by what they are. A payoff that is known is not asked for again.

    Attributes
    ----------
    candidates, tests : (n, ...) and (m, ...), copies that cannot be written to, oldest first.
    outcomes : (n, m) float64 payoffs of the candidates, read-only.
    graded : whether how clearly a candidate wins makes a difference. To these it should not where
        payoffs are noisy: then hardly any two are equal, and hardly any dominates another.
    anew : whether all tests are to be submitted each time, not the new ones only.
    """

    graded = False
    anew = False

    def __init__(self) -> None:
        self.candidates: Members = protected([])
        self.tests: Members = protected([])
        self.outcomes: FloatArray = protected(np.zeros((0, 0)))

    @abstractmethod
    def select(self, outcomes: FloatArray, archived: tuple[int, int]) -> tuple[Indices, Indices]:
        """Return the candidates and the tests to keep, in ascending order.

        Parameters
        ----------
        outcomes : (n, m) payoffs of archived and new candidates on archived and new tests.
        archived : how many of the first rows, and of the first columns, are archived.
        """

    def submit(self, candidates: ArrayLike, tests: ArrayLike, outcome: PayoffFunction) -> None:
        """Offer new candidates (n, ...) and new tests (m, ...); either may be empty."""
        new_candidates, new_tests = protected(candidates), protected(tests)
        known, archived = self.outcomes, self.outcomes.shape
        all_candidates = _joined(self.candidates, new_candidates)
        all_tests = _joined(self.tests, new_tests)
        beside = payoffs(outcome, self.candidates, new_tests)
        below = payoffs(outcome, new_candidates, all_tests)
        union = np.concatenate([np.concatenate([known, beside], axis=1), below])
        rows, columns = self.select(union, (archived[0], archived[1]))
        self.candidates = protected(all_candidates[rows])
        self.tests = protected(all_tests[columns])
        self.outcomes = protected(union[np.ix_(rows, columns)])

    def state(self) -> State:
        """Return candidates, tests and outcomes."""
        return {"candidates": self.candidates, "tests": self.tests, "outcomes": self.outcomes}

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""
        self.candidates = protected(state["candidates"])
        self.tests = protected(state["tests"])
        self.outcomes = protected(state["outcomes"])


def _joined(archived: Members, new: Members) -> Members:
    if not len(archived) or not len(new):
        return archived if len(archived) else new
    if archived.shape[1:] != new.shape[1:]:
        raise ValueError(f"members: expected rows {archived.shape[1:]}, got {new.shape[1:]}")
    return protected(np.concatenate([archived, new]))
