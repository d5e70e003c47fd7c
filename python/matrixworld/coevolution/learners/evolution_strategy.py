"""The evolution strategy of Salimans et al. 2017, with mirrored samples and ranks."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_floats, check_instance, check_integer, check_number
from matrixworld.coevolution.learners.learner import (
    Adam,
    LearnerSettings,
    Momentum,
    NoiseTable,
    Task,
    annealed,
    check_momentum,
    checked_fitness,
)
from matrixworld.coevolution.sections import documented, setting
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, State


def centred_ranks(fitness: FloatArray) -> FloatArray:
    """Return the ranks of fitness values (n,), n > 1, scaled to [-0.5, 0.5]; equal ones share one.

    This is the fitness shaping of Salimans et al. 2017, section 2.1.
    """
    in_order = np.sort(fitness)
    below = np.searchsorted(in_order, fitness, side="left")
    not_above = np.searchsorted(in_order, fitness, side="right")
    # Equal values take the places below .. not_above - 1; their rank is the middle of these.
    return (below + not_above - 1) / (2 * (len(fitness) - 1)) - 0.5


class EvolutionStrategy:
    """An evolution strategy with mirrored samples and ranks.

    ::

        ask:   for each pair i: e_i ~ N(0, 1);  candidates  m + s e_i  and  m - s e_i
        tell:  u = centred ranks of the fitness
               m = m + step( sum_i (u_i+ - u_i-) e_i / (n s) )

    The genome is the mean m. Both candidates of a pair are scored on the same match seed, so that
    the luck of the match cancels out. One standard deviation s serves all genes: that of the noise
    table, or a share of the root mean square of m if that is more. In that case, too, steps are
    divided by that of the table. There is no weight decay.

    Parameters
    ----------
    genome : array_like of float, shape (genes,)
        Mean to start from.
    noise : NoiseTable
        Table for the same number of genes; its `sigma` is the standard deviation of the samples.
    samples : int, optional
        Candidates an epoch (n), even.
    learning_rate : float, optional
        Learning rate of the optimizer.
    anneal_over : int, optional
        Number of updates over which the learning rate falls linearly to a tenth. By default it
        is constant.
    momentum : float, optional
        Share of its last step that classical momentum keeps, in [0, 1). By default a gradient
        becomes a step by Adam (Kingma & Ba 2015).
    relative_sigma : float, optional
        This share of the root mean square of m, without fixed genes, is the least s. In a long race
        the genome grows with the root of the updates, mostly by chance; a constant s becomes small
        beside it, and tells less of the candidates than luck does. By default 0.

    References
    ----------
    Salimans et al. 2017, "Evolution strategies as a scalable alternative to reinforcement
    learning", arXiv:1703.03864, algorithm 1 with mirrored sampling.
    """

    def __init__(
        self,
        genome: ArrayLike,
        noise: NoiseTable,
        *,
        samples: int = 64,
        learning_rate: float = 0.02,
        anneal_over: int | None = None,
        momentum: float | None = None,
        relative_sigma: float = 0.0,
    ) -> None:
        if check_integer("samples", samples) < 2 or samples % 2:
            raise ValueError(f"samples: expected an even number of at least 2, got {samples}")
        check_number("learning_rate", learning_rate, least=0.0, positive=True)
        check_number("relative_sigma", relative_sigma, least=0.0)
        if anneal_over is not None:
            check_integer("anneal_over", anneal_over, 1)
        check_instance("noise", noise, NoiseTable)
        self.genome: Genome = check_floats("genome", genome, np.float32)
        if self.genome.shape != (noise.size,):
            raise ValueError(f"genome: expected shape ({noise.size},), got {self.genome.shape}")
        self.samples: int = samples
        self.learning_rate: float = learning_rate
        self.anneal_over: int | None = anneal_over
        self.relative_sigma: float = relative_sigma
        self.seed_groups: Indices = np.tile(np.arange(samples // 2), 2)
        self._optimizer = Adam(noise.size) if momentum is None else Momentum(noise.size, momentum)
        self._table = noise
        self._noise: list[Genome] = []

    @property
    def rate(self) -> float:
        """Learning rate of the next update."""
        return self.learning_rate * annealed(self._optimizer.updates, self.anneal_over)

    @property
    def sigma(self) -> float:
        """Standard deviation s of the next samples."""
        if not self.relative_sigma:
            return self._table.sigma
        # Genes without noise do not count: those of a mask are larger than all others by far.
        free = self.genome if self._table.fixed is None else self.genome[~self._table.fixed]
        length = np.sqrt(np.mean(np.square(free, dtype=np.float64)))
        return max(self._table.sigma, self.relative_sigma * float(length))

    @np.errstate(over="ignore", invalid="ignore")  # a run reports genes that are not finite
    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return the samples: half of them, then their mirror images in the same order."""
        pairs = self.samples // 2
        self._noise = self._table.draw(pairs, rng)
        # Both halves are written into one array, which a rollout takes without another copy.
        candidates = np.empty((2, pairs, self._table.size), dtype=np.float32)
        plus, minus = candidates
        scale = np.float32(self.sigma / self._table.sigma)
        for i, each in enumerate(self._noise):
            noise = each if scale == 1.0 else scale * each
            np.add(self.genome, noise, out=plus[i])
            np.subtract(self.genome, noise, out=minus[i])
        return candidates.reshape(self.samples, -1)

    @np.errstate(over="ignore", invalid="ignore")
    def tell(self, fitness: ArrayLike) -> None:
        """Move the mean towards the better samples."""
        values = checked_fitness(fitness, 2 * len(self._noise))
        plus, minus = centred_ranks(values).reshape(2, -1)
        # The table's numbers are e_i times its sigma, hence the square; with a larger s, too, so
        # that steps of momentum do not shrink as s grows. Those of Adam hardly change with it.
        weights = ((plus - minus) / (self.samples * self._table.sigma**2)).astype(np.float32)
        gradient = np.zeros(self._table.size, dtype=np.float32)
        # Term by term, not as a matrix product: the order in which BLAS adds, and with it the
        # rounding, depends on the machine.
        term = np.empty_like(gradient)
        for weight, noise in zip(weights, self._noise, strict=True):
            np.multiply(weight, noise, out=term)
            gradient += term
        # A new array, not in place: archives keep a reference to the genome of their generation.
        self.genome = self.genome + self._optimizer.step(gradient, self.rate)
        self._noise = []

    def state(self) -> State:
        """Return the mean and the state of the optimizer."""
        # The genome needs no copy, since no step changes it.
        return {"genome": self.genome, **self._optimizer.state()}

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        self.genome = state["genome"].astype(np.float32)
        self._optimizer.restore(state)


# Steps of a team that learns alone. Updates by Adam have about the length of the rate in each gene,
# and mostly random directions: n of them lead a root of n as far as one. So a rate in proportion to
# 1 / root(n) lets a genome go equally far in short runs and in long ones. The factors are chosen by
# trial: docs/coevolution.md, "Steps of a team that learns alone".


def rate_alone(epochs: int) -> float:
    """1.25 / sqrt(epochs)."""
    return 1.25 / math.sqrt(epochs)


def sigma_alone(epochs: int) -> float:
    """sqrt(1.25 / sqrt(epochs) / 2)."""
    return math.sqrt(rate_alone(epochs) / 2.0)


@documented
@dataclass(frozen=True)
class EvolutionStrategySettings(LearnerSettings):
    """Settings of `EvolutionStrategy`."""

    kind: ClassVar[str] = "es"
    keeps_fixed_genes: ClassVar[bool] = True
    steps: ClassVar[tuple[str, ...]] = ("learning_rate", "sigma")

    sigma: float = setting(
        0.1, "standard deviation of the samples", by={"against": sigma_alone}, positive=True
    )
    learning_rate: float = setting(
        0.03, "learning rate of the optimizer", by={"against": rate_alone}, positive=True
    )
    momentum: float | None = setting(
        None, "coefficient of classical momentum, in [0, 1); default: Adam instead", most=1.0
    )
    relative_sigma: float = setting(
        0.4,
        "least standard deviation, as a share of the root mean square of the genome",
        by={"against": 0.0},
    )
    anneal: bool = setting(
        False, "reduce the learning rate linearly to a tenth over the run", by={"against": True}
    )

    def check(self) -> None:
        """Raise ValueError for an odd population or a momentum of 1."""
        if self.population is not None and self.population % 2:
            raise ValueError(f"population: expected an even number for es, got {self.population}")
        if self.momentum is not None:
            check_momentum(self.momentum)

    def new(self, task: Task) -> EvolutionStrategy:
        """Return a new learner of a team."""
        genome = task.genomes[0]
        return EvolutionStrategy(
            genome,
            NoiseTable(genome.size, task.rng, sigma=self.sigma, fixed=task.fixed),
            samples=self.population,
            learning_rate=self.learning_rate,
            anneal_over=task.epochs if self.anneal else None,
            momentum=self.momentum,
            relative_sigma=self.relative_sigma,
        )
