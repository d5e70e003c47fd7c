"""Evolution with an adapted covariance matrix: DEAP's CMA-ES (Hansen & Ostermeier 2001)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any, ClassVar

import numpy as np
from deap import cma
from numpy.typing import ArrayLike
from threadpoolctl import ThreadpoolController

from matrixworld._util.checks import check_floats, check_integer, check_number
from matrixworld.coevolution.learners.learner import (
    DivergedError,
    LearnerSettings,
    Task,
    checked_fitness,
)
from matrixworld.coevolution.sections import documented, setting
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, Saved, State
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network

MOST_GENES = 1000
"""Largest number of genes.

Each update decomposes the full covariance matrix, which takes time with the cube of the genes:
0.15 s for this many. To learn the matrix takes about genes^2 / population updates, more than a run
has.
"""


class ScoredSample(np.ndarray[Any, np.dtype[np.float64]]):
    """An individual as `deap.cma.Strategy` takes it: (genes,) float64 with a `fitness`."""

    fitness: float


# Once for all calls: to search the loaded libraries takes milliseconds.
blas = cache(ThreadpoolController)


def one_thread() -> Any:
    """Limit BLAS and LAPACK to one thread: the order of their sums depends on the threads."""
    return blas().limit(limits=1, user_api="blas")


class CmaEs(cma.Strategy, Saved):  # type: ignore[misc]
    """Evolution strategy with covariance matrix adaptation: `deap.cma.Strategy`, asked and told.

    ::

        ask:   z_i ~ N(0, I);  candidates  m + s B D z_i,  with  C = B D^2 B^T
        tell:  m = weighted mean of the better half;  adapt the step size s and the covariance C

    Weights and rates are DEAP's defaults; random numbers come from the generator of `ask`, not from
    NumPy's global one. Only the order of the fitness counts. All candidates of an epoch are scored
    on the same match seed.

    Parameters
    ----------
    genome : array_like of float, shape (genes,)
        Mean to start from; at most `MOST_GENES` genes.
    sigma : float
        Standard deviation of the first samples, in units of the genes; adapted from then on.
    samples : int, optional
        Candidates an epoch, at least 2.

    Notes
    -----
    LAPACK decomposes C. It runs in one thread here, so that a restored run continues bit for bit
    with any number of threads on one machine and installation of NumPy. Another processor or
    another LAPACK may round differently, and the run then takes another course. (NumPy on macOS
    with Apple's Accelerate chooses its threads by itself.)

    References
    ----------
    Hansen & Ostermeier 2001, "Completely derandomized self-adaptation in evolution strategies",
    Evolutionary Computation 9(2).
    """

    saved = ("centroid", "sigma", "pc", "ps", "C", "B", "diagD", "update_count")
    B: FloatArray

    def __init__(self, genome: ArrayLike, *, sigma: float, samples: int = 48) -> None:
        start = check_floats("genome", genome, np.float64)
        if start.ndim != 1 or not start.size:
            raise ValueError(f"genome: expected shape (genes,), got {start.shape}")
        check_genes("genome", start.size)
        check_number("sigma", sigma, least=0.0, positive=True)
        check_integer("samples", samples, 2)
        with one_thread():
            super().__init__(start, sigma, lambda_=samples)
        self._samples: FloatArray = np.zeros((0, start.size))

    @property
    def genome(self) -> Genome:
        """Mean of the distribution, (genes,) float32."""
        genome: Genome = self.centroid.astype(np.float32)
        return genome

    @property
    def seed_groups(self) -> Indices:
        """Zeros (samples,): all candidates are scored on one match seed."""
        return np.zeros(self.lambda_, dtype=np.intp)

    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return the samples; DivergedError if they exceed the range of float32."""
        with one_thread():
            normal = rng.standard_normal((self.lambda_, self.dim))
            samples: FloatArray = self.centroid + self.sigma * np.dot(normal, self.BD.T)
        # Numbers too large for float32 become infinite, which is reported with its cause below.
        with np.errstate(over="ignore"):
            candidates: Genomes = samples.astype(np.float32)
        if not np.isfinite(candidates).all():
            raise self._diverged()
        # In float64: the covariance adapts to the samples as drawn, not as rounded for the match.
        self._samples = samples
        return candidates

    def tell(self, fitness: ArrayLike) -> None:
        """Adapt mean, step size and covariance to the better samples."""
        values = checked_fitness(fitness, len(self._samples))
        # DEAP reads an attribute `fitness`, which a view has room for and a plain array has not.
        population = list(self._samples.view(ScoredSample))
        for sample, value in zip(population, values, strict=True):
            sample.fitness = float(value)
        # The next `ask` reports a matrix that overflows or is no longer positive.
        with one_thread(), np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            try:
                self.update(population)
            except np.linalg.LinAlgError as error:
                raise self._diverged() from error
        self._samples = self._samples[:0]

    def _diverged(self) -> DivergedError:
        # The largest deviation of a sample: where it is small, squares of the step size are 0.
        other = "larger" if self.sigma * self.diagD[-1] < 1.0 else "smaller"
        return DivergedError(
            f"candidates: expected finite genes, got a step size of {self.sigma:g} and deviations "
            f"along the axes from {self.diagD[0]:g} to {self.diagD[-1]:g}; start with a {other} "
            f"sigma, or stop earlier"
        )

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`: C and B (genes, genes), and a few vectors."""
        super().restore(state)
        # Column by column, as LAPACK returned it: BLAS rounds differently in another order.
        self.B = np.asfortranarray(self.B)
        self.BD = self.B * self.diagD


def check_genes(name: str, genes: int) -> None:
    """Raise ValueError above `MOST_GENES`, with advice how to have fewer genes."""
    if genes > MOST_GENES:
        raise ValueError(
            f"{name}: expected at most {MOST_GENES} genes for the full covariance matrix of cma, "
            f"got {genes}; a smaller view (fov) or hidden layer (or none) has fewer, and es and ga "
            f"take any number"
        )


@documented
@dataclass(frozen=True)
class CmaEsSettings(LearnerSettings):
    """Settings of `CmaEs`."""

    kind: ClassVar[str] = "cma"

    sigma: float = setting(0.8, "standard deviation of the first samples", positive=True)

    def check_fits(self, path: str, world: WorldConfig, network: Network) -> None:
        """Raise ValueError if the network has too many genes."""
        check_genes(path, network.genome_size)

    def new(self, task: Task) -> CmaEs:
        """Return a new learner of a team."""
        return CmaEs(task.genomes[0], sigma=self.sigma, samples=self.population)
