"""Evolution with an adapted covariance matrix: DEAP's CMA-ES (Hansen & Ostermeier 2001)."""

from __future__ import annotations

from typing import Any

import numpy as np
from deap import cma
from numpy.typing import ArrayLike, NDArray
from threadpoolctl import ThreadpoolController

from matrixworld.checks import check_integer, check_number
from matrixworld.coevolution.learners.learner import checked_fitness
from matrixworld.coevolution.types import Genome, Genomes, State

MOST_GENES = 1000
"""Genes that a full covariance matrix is kept for.

Each update decomposes the matrix in time with the cube of the genes: 0.15 s for this many. To learn
the matrix takes about genes^2 / population updates, so that nothing is gained beyond.
"""

ADAPTED = ("centroid", "sigma", "pc", "ps", "C", "B", "diagD", "update_count")
"""What `deap.cma.Strategy` changes, by the names that it gives them."""


class Sample(np.ndarray[Any, np.dtype[np.float64]]):
    """An individual as `deap.cma.Strategy` takes it: (genes,) float64 with a `fitness`."""

    fitness: float


class Strategy(cma.Strategy):  # type: ignore[misc]
    """DEAP's strategy, its random numbers from a generator instead of NumPy's global one."""

    def sample(self, rng: np.random.Generator) -> NDArray[np.float64]:
        """Return what `generate` does, as one array (samples, genes) float64."""
        normal = rng.standard_normal((self.lambda_, self.dim))
        samples: NDArray[np.float64] = self.centroid + self.sigma * np.dot(normal, self.BD.T)
        return samples


class CmaEs:
    """Evolution strategy with covariance matrix adaptation, of `deap.cma.Strategy`.

    ::

        ask:   z_i ~ N(0, I);  candidates  m + s B D z_i,  with  C = B D^2 B^T
        tell:  m = weighted mean of the better half;  adapt the step size s and the covariance C

    Hansen & Ostermeier 2001, "Completely derandomized self-adaptation in evolution strategies",
    Evolutionary Computation 9(2); weights and rates are DEAP's defaults. Only the order of the
    fitness counts. All candidates of an epoch are scored on the same match seed.

    The decomposition of C is LAPACK's, which calculates in one thread here: a state goes on bit
    for bit with any number of threads on one machine and installation of NumPy. Another processor
    or another LAPACK may round otherwise, and the run then takes another course. (NumPy on macOS
    with Apple's Accelerate chooses its threads by itself.)

    Parameters
    ----------
    genome : (genes,) float32, where the mean starts; at most `MOST_GENES`.
    sigma : standard deviation of the first samples, in units of the genes; adapted from then on.
    samples : candidates per epoch, at least 2.
    """

    def __init__(self, genome: ArrayLike, *, sigma: float, samples: int = 48) -> None:
        start = np.array(genome, dtype=np.float64)
        if start.ndim != 1 or not start.size:
            raise ValueError(f"genome: expected shape (genes,), got {start.shape}")
        check_genes(start.size)
        check_number("sigma", sigma, least=0.0, positive=True)
        check_integer("samples", samples, 2)
        self._blas = ThreadpoolController()
        with self._one_thread():
            self._strategy = Strategy(start, sigma, lambda_=samples)
        self._samples: NDArray[np.float64] | None = None

    def _one_thread(self) -> Any:
        """Let BLAS and LAPACK add up in an order that does not depend on the number of threads."""
        return self._blas.limit(limits=1, user_api="blas")

    @property
    def genome(self) -> Genome:
        """The mean."""
        genome: Genome = self._strategy.centroid.astype(np.float32)
        return genome

    @property
    def match_of_candidate(self) -> NDArray[np.intp]:
        """One match for all."""
        return np.zeros(self._strategy.lambda_, dtype=np.intp)

    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return the samples. ArithmeticError when the distribution has left what floats hold."""
        with self._one_thread():
            samples = self._strategy.sample(rng)
        with np.errstate(over="ignore"):
            candidates: Genomes = samples.astype(np.float32)
        if not np.isfinite(candidates).all():
            raise ArithmeticError(
                f"candidates: expected finite genes, got a step size of {self._strategy.sigma:g} "
                f"and deviations along the axes from {self._strategy.diagD[0]:g} to "
                f"{self._strategy.diagD[-1]:g}; start with a smaller sigma, or stop earlier"
            )
        self._samples = samples
        return candidates

    def tell(self, fitness: ArrayLike) -> None:
        """Adapt mean, step size and covariance to the better samples."""
        if self._samples is None:
            raise RuntimeError("tell: expected after ask, got no candidates to be told of")
        values = checked_fitness(fitness, len(self._samples))
        population = list(self._samples.view(Sample))
        for sample, value in zip(population, values, strict=True):
            sample.fitness = float(value)
        # A matrix that is no longer positive, or overflows, is noticed by the next `ask`.
        with self._one_thread(), np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            self._strategy.update(population)
        self._samples = None

    def state(self) -> State:
        """Return what `deap.cma.Strategy` adapts: 2 genes^2 numbers, float64, and a few more."""
        return {name: np.array(getattr(self._strategy, name)) for name in ADAPTED}

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""
        strategy = self._strategy
        for name in ADAPTED:
            value = state[name]
            setattr(strategy, name, value.copy() if value.ndim else value.item())
        # Column by column, as LAPACK returns eigenvectors: BLAS rounds by the order in memory.
        strategy.B = np.asfortranarray(strategy.B)
        strategy.BD = strategy.B * strategy.diagD
        self._samples = None


def check_genes(genes: int) -> None:
    """ValueError above `MOST_GENES`, saying how to have fewer."""
    if genes > MOST_GENES:
        raise ValueError(
            f"learner: expected at most {MOST_GENES} genes for the full covariance matrix of cma, "
            f"got {genes}; a smaller view (fov) or hidden layer (or none) has fewer, and es and ga "
            f"take any number"
        )
