"""Opponents that an archive has kept, by the number of their generation."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from matrixworld.coevolution.opponents.archive import Members
from matrixworld.coevolution.opponents.selection import (
    HallOfFame,
    Indices,
    Latest,
    RoundRobin,
    State,
    Stateless,
    Uniform,
    check_available,
)


class Keeper(Protocol):
    """An archive: `MaxSolve`, `IPCA`, `LAPCA` or `Generalist`."""

    @property
    def tests(self) -> Members:
        """The opponents that are kept."""

    def state(self) -> State:
        """Return all that changes, as plain arrays."""

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""


class FromArchive(Stateless):
    """A selection among the tests of an archive whose members are numbers of generations.

    The genomes stay where every generation's are kept, and the archive holds their numbers, shape
    (m,). After each generation its owner submits the new one::

        archive.submit([generation], [generation], outcome)    # outcome looks up the genomes

    While the archive holds no test, the newest opponent is met.

    Parameters
    ----------
    archive : keeps the numbers of generations; is saved and restored with the selection.
    within : selection among those kept. It takes note of nothing, for places in an archive change
        hands.
    """

    def __init__(self, archive: Keeper, within: Latest | Uniform | RoundRobin | HallOfFame) -> None:
        self.archive, self.within = archive, within

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
