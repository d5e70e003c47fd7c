"""Types that the modules of co-evolution share: teams, genomes, arrays by dtype, and payoffs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from matrixworld._util.readable import Parts, Readable, matrix_table
from matrixworld.world.policy import TEAMS as TEAMS
from matrixworld.world.policy import Team as Team


def other(team: Team) -> Team:
    """Return the opposing team."""
    return "evader" if team == "pursuer" else "pursuer"


SCORE = {"pursuer": "capture rate", "evader": "escape rate"}
"""What the score of a team is called."""

Genome = NDArray[np.float32]
"""Weights of one policy network, shape (genes,)."""
Genomes = NDArray[np.float32]
"""One genome a row, shape (n, genes)."""
Seeds = NDArray[np.uint64]
"""Seeds of matches."""
State = dict[str, NDArray[Any]]
"""All that changes in a learner or sampler, as plain arrays by name."""
Rng = np.random.Generator
"""What all random numbers are drawn from."""

SEVERAL = -1
"""Value of `opponent` in the log of an epoch with several opponents."""

Indices = NDArray[np.intp]
FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]
IntArray = NDArray[np.int64]


@dataclass(frozen=True, repr=False)
class Payoff(Readable):
    """Results of G pursuers against H evaders, in n episodes a pair.

    Row g is pursuer g, column h evader h. In arrays by team, pursuers come first; in arrays by kind
    of collision, the order is obstacle, teammate, adversary.

    Parameters
    ----------
    capture_rates : ndarray of float32, shape (G, H, n)
        Share of evaders captured in each episode.
    lengths : ndarray of int32, shape (G, H, n)
        Steps of each episode.
    collisions, faults : ndarray of float64, shape (G, H, 2, 3)
        Mean agent-steps an episode in which an agent was involved, or at fault, in a collision; by
        team and kind.
    agent_steps : ndarray of float64, shape (G, H, 2)
        Mean steps an episode by agents that were alive, by team.
    pursuer_survivors, evader_survivors : ndarray of float64, shape (G, H)
        Mean number of agents alive at the end.
    """

    capture_rates: NDArray[np.float32]
    lengths: NDArray[np.int32]
    collisions: FloatArray
    faults: FloatArray
    agent_steps: FloatArray
    pursuer_survivors: FloatArray
    evader_survivors: FloatArray

    def _parts(self) -> Parts:
        episodes = self.capture_rates.shape[2]
        head = f"Capture rates of pursuers (rows) against evaders, {episodes} episodes a pair:"
        return [head, matrix_table(self.capture_rate)]

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """Return the payoff matrix, so that figures and measures take the results as they are."""
        return np.array(self.capture_rate, dtype)

    @property
    def capture_rate(self) -> FloatArray:
        """Payoff matrix (G, H): mean capture rate. The evaders' payoff is one minus it."""
        # In float64: the sum of many float32 rates would round.
        return np.asarray(self.capture_rates.mean(axis=2, dtype=np.float64))

    @property
    def capture_rate_std(self) -> FloatArray:
        """Standard deviation (G, H) of the capture rate over episodes."""
        return np.asarray(self.capture_rates.std(axis=2, dtype=np.float64))

    @property
    def length(self) -> FloatArray:
        """Mean steps (G, H) of an episode."""
        return np.asarray(self.lengths.mean(axis=2))

    @property
    def length_std(self) -> FloatArray:
        """Standard deviation (G, H) of the steps over episodes."""
        return np.asarray(self.lengths.std(axis=2))

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Return fields, means and standard deviations by name, as payoff.npz holds them."""
        derived = ("capture_rate", "capture_rate_std", "length", "length_std")
        return {name: getattr(self, name) for name in (*(f.name for f in fields(self)), *derived)}

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, NDArray[Any]]) -> Payoff:
        """Return the payoff whose `arrays()` are given."""
        return cls(**{item.name: arrays[item.name] for item in fields(cls)})
