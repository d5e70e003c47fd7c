"""The evolution strategy of Salimans et al. 2017.

"Evolution strategies as a scalable alternative to reinforcement learning", arXiv:1703.03864.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution.learners.learner import checked_fitness
from matrixworld.coevolution.learners.noise import NoiseTable
from matrixworld.coevolution.learners.optimizers import new_optimizer
from matrixworld.coevolution.types import Genome, Genomes, State

ANNEALED_RATE = 0.1
"""What a learning rate that is annealed has fallen to at the end, as a share of its start."""


def centred_ranks(fitness: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the ranks of `fitness` (n,), scaled to [-0.5, 0.5] (Salimans et al. 2017).

    Equal fitness gets an equal rank, the mean of those that it spans; all equal gives zeros.
    """
    n = len(fitness)
    if n < 2:
        return np.zeros(n)
    in_order = np.sort(fitness)
    below = np.searchsorted(in_order, fitness, side="left")
    not_above = np.searchsorted(in_order, fitness, side="right")
    return (below + not_above - 1) / (2 * (n - 1)) - 0.5


class EvolutionStrategy:
    """An evolution strategy with mirrored samples and ranks (Salimans et al. 2017).

    ::

        ask:   for each pair i: e_i ~ N(0, 1);  candidates  m + s e_i  and  m - s e_i
        tell:  u = centred ranks of the fitness
               m = m + step( sum_i (u_i+ - u_i-) e_i / (n s) )

    Both of a pair are scored on the same match seed, so that luck of the draw cancels out.
    The table's s serves all genes; there is no weight decay. The step is Adam's or momentum's (see
    `optimizers`).

    Parameters
    ----------
    genome : (genes,) float32, where the mean starts.
    noise : table of the same number of genes; its `sigma` is the deviation of the samples (s).
    samples : candidates per epoch (n), even.
    learning_rate : of the step.
    anneal_over : number of updates over which the rate falls linearly to a tenth; None: constant.
    optimizer : "adam" or "momentum".
    momentum : share of its last step that momentum keeps, in [0, 1); not used by Adam.
    """

    def __init__(
        self,
        genome: ArrayLike,
        noise: NoiseTable,
        *,
        samples: int = 64,
        learning_rate: float = 0.02,
        anneal_over: int | None = None,
        optimizer: str = "adam",
        momentum: float = 0.9,
    ) -> None:
        if samples < 2 or samples % 2:
            raise ValueError(f"samples: expected an even number of at least 2, got {samples}")
        self.genome = np.array(genome, dtype=np.float32)
        if self.genome.shape != (noise.size,):
            raise ValueError(f"genome: expected shape ({noise.size},), got {self.genome.shape}")
        self.samples = samples
        self.learning_rate, self.anneal_over = learning_rate, anneal_over
        self._optimizer = new_optimizer(optimizer, noise.size, momentum=momentum)
        self._table = noise
        self._noise: list[Genome] = []

    @property
    def match_of_candidate(self) -> NDArray[np.intp]:
        """The pair of each candidate."""
        return np.tile(np.arange(self.samples // 2), 2)

    @property
    def rate(self) -> float:
        """The learning rate of the next update."""
        if self.anneal_over is None:
            return self.learning_rate
        done = min(1.0, self._optimizer.updates / self.anneal_over)
        return self.learning_rate * (1.0 - (1.0 - ANNEALED_RATE) * done)

    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return the samples: the first half, and their mirror images in the same order."""
        pairs = self.samples // 2
        self._noise = self._table.draw(pairs, rng)
        candidates = np.empty((2, pairs, self._table.size), dtype=np.float32)
        plus, minus = candidates
        for i, noise in enumerate(self._noise):
            np.add(self.genome, noise, out=plus[i])
            np.subtract(self.genome, noise, out=minus[i])
        return candidates.reshape(self.samples, -1)

    def tell(self, fitness: ArrayLike) -> None:
        """Move the mean towards the better samples."""
        if not self._noise:
            raise RuntimeError("tell: expected after ask, got no candidates to be told of")
        gradient = self._gradient(centred_ranks(checked_fitness(fitness, self.samples)))
        self.genome = self.genome + self._optimizer.step(gradient, self.rate)
        self._noise = []

    def _gradient(self, utility: NDArray[np.float64]) -> Genome:
        plus, minus = utility.reshape(2, -1)
        # The noise is s e_i already.
        weights = ((plus - minus) / (self.samples * self._table.sigma**2)).astype(np.float32)
        gradient = np.zeros(self._table.size, dtype=np.float32)
        # Term by term, not as a matrix product: BLAS adds in an order that depends on the machine.
        for weight, noise in zip(weights, self._noise, strict=True):
            gradient += weight * noise
        return gradient

    def state(self) -> State:
        """Return the mean, and the state of the optimizer."""
        return {"genome": self.genome, **self._optimizer.state()}

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""
        self.genome = state["genome"].astype(np.float32)
        self._optimizer.restore(state)
        self._noise = []
