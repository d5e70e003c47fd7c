"""A sampler of the newest opponent and of those that an archive has kept, by generation."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from matrixworld.coevolution.opponents.pareto import Archive, PayoffFunction
from matrixworld.coevolution.opponents.samplers import Stateless, check_available, check_count
from matrixworld.coevolution.types import Indices, Members, State

if TYPE_CHECKING:
    from matrixworld.coevolution.opponents.generalist import Generalist


class ArchiveSampler(Stateless):
    """The newest opponent, beside the tests of an archive.

    ::

        one opponent an epoch:  the newest and a test of the archive in turns
        several:                the newest, and tests of the archive, drawn evenly

    Archives keep tests that tell candidates apart. An opponent that no candidate beats yet tells
    none apart, so MaxSolve and the Pareto archives drop it. A team that played against the archive
    alone would never meet it and could never learn to beat it. In the schemes of de Jong, where
    candidates and tests come from living populations, individuals are evaluated against both the
    living opponents and the archive; here the newest generation stands for the living ones.

    The archive holds numbers, shape (m,); the genomes of all generations stay with the caller, who
    updates the archive before the next sample::

        sampler.update([generation], [generation], payoff)    # `payoff` looks up the genomes

    While the archive holds no other test, the sample is the newest opponent.

    Parameters
    ----------
    archive : Archive or Generalist
        Keeps numbers of generations; saved and restored with the sampler.
    count : int, optional
        Opponents an epoch; fewer, if the archive holds fewer.

    References
    ----------
    de Jong 2007, "A monotonic archive for Pareto-coevolution", Evolutionary Computation 15(1).
    """

    def __init__(self, archive: Archive | Generalist, count: int = 1) -> None:
        check_count("count", count)
        self.archive: Archive | Generalist = archive
        self.count: int = count

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
        """Return the newest opponent and tests of the archive, or one of both."""
        check_available(available)
        # Sorted, so that the sample does not depend on the order inside the archive.
        kept = np.unique(self.archive.tests).astype(np.intp)
        if len(kept) and (kept[0] < 0 or kept[-1] >= available):
            raise ValueError(f"archive: expected generations below {available}, got {kept}")
        newest, older = np.array([available - 1], dtype=np.intp), kept[kept < available - 1]
        # `available` grows by one in each generation: the turns alternate with one epoch, too.
        places = self.count - 1 if self.count > 1 else (epoch + available) % 2
        drawn: Indices = rng.choice(older, size=min(places, len(older)), replace=False)
        alone = self.count == 1 and len(drawn)
        return drawn if alone else np.concatenate([newest, drawn])

    def state(self) -> State:
        """Return the state of the archive."""
        return self.archive.state()

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        self.archive.restore(state)
