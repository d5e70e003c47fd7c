"""Steps of gradient ascent: Adam, momentum, and learning rates that fall."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.types import Genome

ANNEALED = 0.1  # share of a learning rate that is left after annealing


def annealed(updates: int, over: int) -> float:
    """Return the share of a rate after some updates, if it falls linearly `over` so many."""
    return 1.0 - (1.0 - ANNEALED) * min(1.0, updates / over)


class Adam(NamedTuple):
    """The averages of Adam (Kingma & Ba 2015): of gradients and their squares, and its steps."""

    mean: Genome
    square: Genome
    updates: NDArray[np.int64]

    @classmethod
    def start(cls, genes: int) -> Adam:
        """Return the averages before the first step."""
        zeros = np.zeros(genes, dtype=np.float32)
        return cls(zeros, zeros, np.array(0))

    def step(self, gradient: Genome, rate: float) -> tuple[Genome, Adam]:
        """Return the change (genes,) for a gradient, in ascent, and the averages after it."""
        beta1 = 0.9
        beta2 = 0.999
        epsilon = 1e-8
        updates = int(self.updates) + 1
        mean = self.mean + (1 - beta1) * (gradient - self.mean)
        square = self.square + (1 - beta2) * (gradient * gradient - self.square)
        # Both averages start at zero; the divisions correct their bias in the first steps.
        unbiased = mean / (1 - beta1**updates)
        spread = square / (1 - beta2**updates)
        change: Genome = np.float32(rate) * unbiased / (np.sqrt(spread) + epsilon)
        return change, Adam(mean, square, np.array(updates))


class Momentum(NamedTuple):
    """The velocity of classical momentum (Polyak 1964), and its steps."""

    velocity: Genome
    updates: NDArray[np.int64]

    @classmethod
    def start(cls, genes: int) -> Momentum:
        """Return no velocity."""
        return cls(np.zeros(genes, dtype=np.float32), np.array(0))

    def step(self, gradient: Genome, rate: float, momentum: float) -> tuple[Genome, Momentum]:
        """Return the change (genes,) for a gradient, in ascent, and the velocity after it."""
        velocity: Genome = np.float32(momentum) * self.velocity + np.float32(rate) * gradient
        return velocity, Momentum(velocity, np.array(int(self.updates) + 1))
