"""Types that every room of the package shares."""

from __future__ import annotations

from typing import Any, Literal, Protocol

import numpy as np
from numpy.typing import NDArray

Team = Literal["pursuer", "evader"]
TEAMS: tuple[Team, Team] = ("pursuer", "evader")

Genome = NDArray[np.float32]
Genomes = NDArray[np.float32]
Seeds = NDArray[np.uint64]
Indices = NDArray[np.intp]
FloatArray = NDArray[np.float64]
State = dict[str, NDArray[Any]]


class Stateful(Protocol):
    """A part of a run that a checkpoint saves and restores: a learner or an opponent sampler."""

    def state(self) -> State:
        """Return everything that changes during a run, as plain arrays by name."""

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""


def other(team: Team) -> Team:
    """Return the opposing team."""
    return "evader" if team == "pursuer" else "pursuer"
