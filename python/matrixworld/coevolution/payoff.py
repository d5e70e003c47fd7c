"""Payoffs: results of the genomes of two archives against each other."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Payoff:
    """Results of G pursuers against H evaders, in n episodes of each pair.

    Row g is pursuer g, column h evader h.

    Parameters
    ----------
    capture_rates : ndarray of float32, shape (G, H, n)
        Share of evaders captured in each episode.
    lengths : ndarray of int32, shape (G, H, n)
        Steps of each episode.
    collisions, faults : ndarray of float64, shape (G, H, 2, 3)
        Mean agent-steps per episode in which an agent was involved in a collision, or at fault; by
        team (pursuers, evaders) and kind (obstacle, teammate, adversary).
    agent_steps : ndarray of float64, shape (G, H, 2)
        Mean steps per episode of living agents, by team.
    pursuer_survivors, evader_survivors : ndarray of float64, shape (G, H)
        Mean number of agents that are alive at the end of an episode.
    """

    capture_rates: NDArray[np.float32]
    lengths: NDArray[np.int32]
    collisions: NDArray[np.float64]
    faults: NDArray[np.float64]
    agent_steps: NDArray[np.float64]
    pursuer_survivors: NDArray[np.float64]
    evader_survivors: NDArray[np.float64]

    @property
    def capture_rate(self) -> NDArray[np.float64]:
        """The payoff matrix (G, H): mean capture rate. The evaders' payoff is 1 minus it."""
        return np.asarray(self.capture_rates.mean(axis=2, dtype=np.float64))

    @property
    def capture_rate_std(self) -> NDArray[np.float64]:
        """Standard deviation (G, H) of the capture rate over episodes."""
        return np.asarray(self.capture_rates.std(axis=2, dtype=np.float64))

    @property
    def length(self) -> NDArray[np.float64]:
        """Mean steps (G, H) of an episode."""
        return np.asarray(self.lengths.mean(axis=2))

    @property
    def length_std(self) -> NDArray[np.float64]:
        """Standard deviation (G, H) of the steps over episodes."""
        return np.asarray(self.lengths.std(axis=2))

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Return fields, means and deviations by name, as payoff.npz holds them."""
        derived = ("capture_rate", "capture_rate_std", "length", "length_std")
        return {name: getattr(self, name) for name in (*(f.name for f in fields(self)), *derived)}

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, NDArray[Any]]) -> Payoff:
        """Return the payoff whose `arrays()` are given."""
        return cls(**{item.name: arrays[item.name] for item in fields(cls)})
