"""Parts that learners share: a table of normal numbers, and steps of gradient ascent."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from matrixworld._util.checks import check_integer, check_number, shown
from matrixworld.coevolution.types import BoolArray, Genome, Saved

VECTORS_PER_TABLE = 256
MOST_EXTRA_NUMBERS = 2**24
"""Bound of the table's memory: 64 MiB beyond one noise vector."""

BETA1, BETA2 = 0.9, 0.999
"""Decay of Adam's moving averages of the gradient and of its square."""
EPSILON = 1e-8
"""Added to the denominator of Adam."""


class NoiseTable:
    """Noise vectors as windows of one long row of normal numbers.

    To draw a normal number for each gene of each candidate costs more time than all other work of a
    learner. A window at a random place of a long shared table serves as well and costs nothing.

    Parameters
    ----------
    size : int
        Length of a noise vector (genes), at least 1.
    rng : numpy.random.Generator
        Generator that fills the table.
    sigma : float
        Standard deviation of the numbers, in units of the genes, above 0.
    fixed : ndarray of bool, shape (size,), optional
        Genes without noise. By default none.

    References
    ----------
    Salimans et al. 2017, "Evolution strategies as a scalable alternative to reinforcement
    learning", arXiv:1703.03864, section 2.1. For genetic algorithms: Such et al. 2017, "Deep
    neuroevolution", arXiv:1712.06567.
    """

    def __init__(
        self,
        size: int,
        rng: np.random.Generator,
        *,
        sigma: float,
        fixed: BoolArray | None = None,
    ) -> None:
        check_integer("size", size, 1)
        check_number("sigma", sigma, least=0.0, positive=True)
        self.size: int = size
        self.sigma: float = sigma
        self._fixed = fixed
        numbers = size + min(VECTORS_PER_TABLE * size, MOST_EXTRA_NUMBERS)
        self._numbers = rng.standard_normal(numbers, dtype=np.float32)
        self._numbers *= np.float32(sigma)
        # Views of the table leave this class, so nothing may write to it.
        self._numbers.flags.writeable = False

    def draw(self, count: int, rng: np.random.Generator) -> list[Genome]:
        """Return `count` noise vectors (size,) float32, not to be written to."""
        # The last window may end with the table, hence the endpoint.
        starts = rng.integers(0, len(self._numbers) - self.size, size=count, endpoint=True)
        windows = [self._numbers[start : start + self.size] for start in starts]
        if self._fixed is None:
            return windows
        return [np.where(self._fixed, np.float32(0.0), window) for window in windows]


class Adam(Saved):
    """Steps of Adam, in ascent (Kingma & Ba 2015, algorithm 1)."""

    saved: ClassVar[tuple[str, ...]] = ("mean", "square", "updates")

    def __init__(self, size: int) -> None:
        self.mean: Genome = np.zeros(size, dtype=np.float32)
        self.square: Genome = np.zeros(size, dtype=np.float32)
        self.updates = 0

    def step(self, gradient: Genome, rate: float) -> Genome:
        """Return the change (size,) float32 for one `gradient` at learning rate `rate`."""
        self.updates += 1
        # In place, and in float32 throughout: both averages are as long as the genome.
        self.mean += (1 - BETA1) * (gradient - self.mean)
        self.square += (1 - BETA2) * (gradient * gradient - self.square)
        # Both averages start at zero; the divisions correct their bias in the first steps.
        mean = self.mean / (1 - BETA1**self.updates)
        square = self.square / (1 - BETA2**self.updates)
        change: Genome = rate * mean / (np.sqrt(square) + EPSILON)
        return change


class Momentum(Saved):
    """Steps of classical momentum, in ascent: ``v = momentum * v + rate * gradient``.

    Unlike with Adam, the length of a step follows that of the gradient. Polyak 1964; as written by
    Sutskever et al. 2013, "On the importance of initialization and momentum in deep learning".
    """

    saved: ClassVar[tuple[str, ...]] = ("velocity", "updates")

    def __init__(self, size: int, momentum: float) -> None:
        check_momentum(momentum)
        self.momentum = momentum
        self.velocity: Genome = np.zeros(size, dtype=np.float32)
        self.updates = 0

    def step(self, gradient: Genome, rate: float) -> Genome:
        """Return the change (size,) float32 for one `gradient` at learning rate `rate`."""
        self.updates += 1
        self.velocity *= np.float32(self.momentum)
        self.velocity += np.float32(rate) * gradient
        # A copy: the next step changes the velocity in place.
        change: Genome = self.velocity.copy()
        return change


def check_momentum(momentum: Any) -> None:
    """Raise ValueError unless the share of the last step that is kept is in [0, 1)."""
    if check_number("momentum", momentum, least=0.0) >= 1.0:
        raise ValueError(f"momentum: expected a number below 1, got {shown(momentum)}")
