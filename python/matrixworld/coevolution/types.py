"""Types that the modules of co-evolution share: teams, genomes, and arrays by dtype."""

from __future__ import annotations

from typing import Any, ClassVar, Literal, Protocol

import numpy as np
from numpy.typing import NDArray

Team = Literal["pursuer", "evader"]
TEAMS: tuple[Team, Team] = ("pursuer", "evader")

Genome = NDArray[np.float32]
"""Weights of one policy network, shape (genes,)."""
Genomes = NDArray[np.float32]
"""One genome a row, shape (n, genes)."""
Seeds = NDArray[np.uint64]
"""Seeds of matches."""
Members = NDArray[Any]
"""Members of an archive, shape (n, ...): one row each, of any dtype (genomes or their indices)."""
State = dict[str, NDArray[Any]]
"""All that changes in a learner or sampler, as plain arrays by name."""

Indices = NDArray[np.intp]
FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]
IntArray = NDArray[np.int64]


class Stateful(Protocol):
    """A part of a run that a checkpoint saves and restores: a learner or an opponent sampler."""

    def state(self) -> State:
        """Return all that changes, as arrays of numbers or text; names are identifiers.

        Called at the end of an epoch: of a learner between `tell` and `ask`.
        """

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`, of this or of an equal one.

        It may have gone further, and a learner may have been interrupted after `ask`.
        """


class Saved:
    """Base of parts whose state is the attributes named in `saved`: arrays and plain numbers."""

    saved: ClassVar[tuple[str, ...]] = ()

    def state(self) -> State:
        """Return copies of all that changes, as plain arrays by name."""
        return {name: np.array(getattr(self, name)) for name in self.saved}

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        for name in self.saved:
            value = state[name]
            # Arrays without an axis were plain numbers before they were saved.
            setattr(self, name, value.copy() if value.ndim else value.item())


def other(team: Team) -> Team:
    """Return the opposing team."""
    return "evader" if team == "pursuer" else "pursuer"
