"""TeamPolicy that an archive has kept, by the number of their generation."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from matrixworld.coevolution.opponents.pareto import Members, PayoffFunction
from matrixworld.coevolution.opponents.samplers import (
    HallOfFame,
    Latest,
    RoundRobin,
    Stateless,
    Uniform,
    check_available,
)
from matrixworld.coevolution.types import Indices, State


class Keeper(Protocol):
    """An archive: `MaxSolve`, `IPCA`, `LAPCA` or `Generalist`."""

    @property
    def candidates(self) -> Members:
        """The members of the team that are kept."""

    @property
    def tests(self) -> Members:
        """The opponents that are kept."""

    @property
    def graded(self) -> bool:
        """Whether how clearly a candidate wins makes a difference."""

    @property
    def anew(self) -> bool:
        """Whether it wants all tests each time, not the new ones only."""

    def submit(self, candidates: Members, tests: Members, outcome: PayoffFunction) -> object:
        """Offer new candidates and tests."""

    def state(self) -> State:
        """Return all that changes, as plain arrays."""

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""


class ArchiveSampler(Stateless):
    """A selection among the tests of an archive whose members are numbers of generations.

    The genomes stay where every generation's are kept, and the archive holds their numbers, shape
    (m,). Its owner admits what is new before it chooses::

        selection.admit([generation], [generation], outcome)    # outcome looks up the genomes

    While the archive holds no test, the newest opponent is met.

    Parameters
    ----------
    archive : keeps the numbers of generations; is saved and restored with the selection.
    within : selection among those kept. It takes note of nothing, for places in an archive change
        hands.
    """

    def __init__(self, archive: Keeper, within: Latest | Uniform | RoundRobin | HallOfFame) -> None:
        self.archive, self.within = archive, within

    @property
    def graded(self) -> bool:
        """Whether how clearly a candidate wins makes a difference to the archive."""
        return self.archive.graded

    def admit(self, new: Members, opponents: Members, outcome: PayoffFunction) -> None:
        """Offer the archive new generations (n,) of the team and of its opponents (m,).

        An archive that wants them anew is offered all opponents up to the newest.
        """
        if self.archive.anew and len(opponents):
            opponents = np.arange(opponents.max() + 1)
        self.archive.submit(new, opponents, outcome)

    def most_pairs(self, candidates: int, tests: int) -> int:
        """Return the most pairs that admitting compares, of so many generations on each side.

        One generation is new on each; all tests, where the archive wants them anew.
        """
        if self.archive.anew:
            return (len(self.archive.candidates) + 1) * tests
        return candidates + tests

    def choose(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return opponents that the archive has kept."""
        check_available(available)
        kept = np.unique(self.archive.tests).astype(np.intp)
        if not len(kept):
            return Latest().choose(available, epoch, rng)
        if kept[0] < 0 or kept[-1] >= available:
            raise ValueError(f"archive: expected generations below {available}, got {kept}")
        chosen: Indices = kept[self.within.choose(len(kept), epoch, rng)]
        return chosen

    def state(self) -> State:
        """Return the state of the archive."""
        return self.archive.state()

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""
        self.archive.restore(state)
