"""What two archives score against each other."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Payoff:
    """What G pursuers and H evaders score against each other in `n` episodes a pair.

    Row g is pursuer g, column h evader h.

    Attributes
    ----------
    capture_rates : (G, H, n) float32, share of evaders captured in each episode.
    lengths : (G, H, n) int32, steps of each episode.
    collisions, faults : (G, H, 2, 3) float64, mean agent-steps an episode in which an agent was
        involved, or at fault, in a collision; by team (pursuers, evaders) and kind (obstacle,
        teammate, adversary).
    agent_steps : (G, H, 2) float64, mean steps an episode by agents that were alive, by team.
    pursuer_survivors, evader_survivors : (G, H) float64, mean number alive at the end.
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
        """The payoff matrix (G, H): mean capture rate, the evaders' payoff being one minus it."""
        return np.asarray(self.capture_rates.mean(axis=2, dtype=np.float64))

    @property
    def capture_rate_std(self) -> NDArray[np.float64]:
        """(G, H) standard deviation of the capture rate over episodes."""
        return np.asarray(self.capture_rates.std(axis=2, dtype=np.float64))

    @property
    def length(self) -> NDArray[np.float64]:
        """(G, H) mean steps of an episode."""
        return np.asarray(self.lengths.mean(axis=2))

    @property
    def length_std(self) -> NDArray[np.float64]:
        """(G, H) standard deviation of the steps over episodes."""
        return np.asarray(self.lengths.std(axis=2))

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Return fields, means and deviations by name, as payoff.npz holds them."""
        derived = ("capture_rate", "capture_rate_std", "length", "length_std")
        return {name: getattr(self, name) for name in (*(f.name for f in fields(self)), *derived)}

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, NDArray[Any]]) -> Payoff:
        """Return the payoff that `arrays` came from."""
        return cls(**{item.name: arrays[item.name] for item in fields(cls)})
