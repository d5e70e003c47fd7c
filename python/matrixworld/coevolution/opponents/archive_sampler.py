"""A sampler of the opponents that an archive has kept, by the number of their generation."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from matrixworld.coevolution.opponents.pareto import Archive, PayoffFunction
from matrixworld.coevolution.opponents.samplers import (
    HallOfFame,
    Latest,
    RoundRobin,
    Stateless,
    Uniform,
    check_available,
)
from matrixworld.coevolution.types import Indices, Members, State

if TYPE_CHECKING:
    from matrixworld.coevolution.opponents.generalist import Generalist


class ArchiveSampler(Stateless):
    """A sampler among the tests of an archive whose members are numbers of generations.

    The archive holds numbers, shape (m,); the genomes of all generations stay with the caller, who
    updates the archive before the next sample::

        sampler.update([generation], [generation], payoff)    # `payoff` looks up the genomes

    While the archive holds no test, the sample is the newest opponent.

    Parameters
    ----------
    archive : Archive or Generalist
        Keeps numbers of generations; saved and restored with the sampler.
    sampler : Latest, Uniform, RoundRobin or HallOfFame
        Samples among the kept tests. It must be stateless: the place of an opponent in the archive
        changes.
    """

    def __init__(
        self, archive: Archive | Generalist, sampler: Latest | Uniform | RoundRobin | HallOfFame
    ) -> None:
        self.archive, self.sampler = archive, sampler

    @property
    def graded(self) -> bool:
        """Whether the archive should get graded payoffs, instead of win, draw or loss."""
        return self.archive.graded

    def update(self, new: Members, opponents: Members, payoff: PayoffFunction) -> None:
        """Submit new generations to the archive.

        Parameters
        ----------
        new, opponents : ndarray of int, shape (n,) and (m,)
            New generations of the team and of its opponents. An archive that needs all tests gets
            all opponents up to the newest one.
        payoff : callable
            See `PayoffFunction`.
        """
        if self.archive.needs_all_tests and len(opponents):
            # Generations are numbered without gaps.
            opponents = np.arange(opponents.max() + 1)
        self.archive.submit(new, opponents, payoff)

    def max_pairs(self, candidates: int, tests: int) -> int:
        """Return the largest number of pairs that an update compares.

        One generation of each team is new.

        Parameters
        ----------
        candidates, tests : int
            Generations of the team and of its opponents, the new ones included.
        """
        if self.archive.needs_all_tests:
            # Generalist computes all payoffs again: of its team and of the new generation.
            return (len(self.archive.candidates) + 1) * tests
        # A Pareto archive computes the new row and the new column, at most of all generations.
        return candidates + tests

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return opponents that the archive has kept."""
        check_available(available)
        # Sorted, so that the sample does not depend on the order inside the archive.
        kept = np.unique(self.archive.tests).astype(np.intp)
        # MaxSolve and LAPCA may drop all tests.
        if not len(kept):
            return Latest().sample(available, epoch, rng)
        if kept[0] < 0 or kept[-1] >= available:
            raise ValueError(f"archive: expected generations below {available}, got {kept}")
        chosen: Indices = kept[self.sampler.sample(len(kept), epoch, rng)]
        return chosen

    def state(self) -> State:
        """Return the state of the archive."""
        return self.archive.state()

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        self.archive.restore(state)
