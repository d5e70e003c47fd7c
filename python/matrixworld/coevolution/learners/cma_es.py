"""Evolution with an adapted covariance matrix: DEAP's CMA-ES (Hansen & Ostermeier 2001)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any, ClassVar

import numpy as np
from deap import cma
from threadpoolctl import ThreadpoolController

from matrixworld.coevolution.learners.learner import (
    DivergedError,
    Learner,
    Results,
    Task,
    checked_fitness,
)
from matrixworld.coevolution.sections import documented, setting
from matrixworld.coevolution.types import Genome, Genomes, State
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network

MOST_GENES = 1000
"""Largest number of genes: each update decomposes the full covariance matrix, in 0.15 s for so
many, and to learn the matrix takes about genes^2 / population updates."""
SAVED = ("centroid", "sigma", "pc", "ps", "C", "B", "diagD", "update_count")
# Once for all calls: to search the loaded libraries takes milliseconds.
blas = cache(ThreadpoolController)


class Sample(np.ndarray[Any, np.dtype[np.float64]]):
    """An individual as `deap.cma.Strategy` takes it: (genes,) float64 with a `fitness`."""

    fitness: float


@documented
@dataclass(frozen=True)
class CmaEs(Learner):
    """Evolution strategy with covariance matrix adaptation: `deap.cma.Strategy`, asked and told.

    ::

        ask:   z_i ~ N(0, I);  candidates  m + s B D z_i,  with  C = B D^2 B^T
        tell:  m = weighted mean of the better half;  adapt the step size s and the covariance C

    LAPACK decomposes C in one thread, so that a run continues bit for bit with any number of
    threads on one machine; another processor or LAPACK may round differently.

    References
    ----------
    Hansen & Ostermeier 2001, "Completely derandomized self-adaptation in evolution strategies",
    Evolutionary Computation 9(2).
    """

    kind: ClassVar[str] = "cma"

    sigma: float = setting(0.8, "standard deviation of the first samples", positive=True)

    def check_fits(self, path: str, world: WorldConfig, network: Network) -> None:
        """Raise ValueError if the network has too many genes."""
        if network.genome_size > MOST_GENES:
            raise ValueError(
                f"{path}: expected at most {MOST_GENES} genes for the full covariance matrix of "
                f"cma, got {network.genome_size}; a smaller view (fov) or hidden layer (or none) "
                f"has fewer, and es and ga take any number"
            )

    def start(self, task: Task) -> State:
        """Return the state of a new strategy."""
        mean = task.genomes(1)[0].astype(np.float64)
        with blas().limit(limits=1, user_api="blas"):
            strategy = cma.Strategy(mean, self.sigma, lambda_=self.population)
        return {name: np.array(getattr(strategy, name)) for name in SAVED}

    def genome(self, state: State) -> Genome:
        """Return the mean of the distribution."""
        genome: Genome = state["centroid"].astype(np.float32)
        return genome

    def ask(self, state: State, rng: np.random.Generator) -> tuple[Genomes, State]:
        """Return the samples; DivergedError if they exceed the range of float32."""
        with blas().limit(limits=1, user_api="blas"), np.errstate(over="ignore"):
            # Column by column, as LAPACK returned it: BLAS rounds differently in another order.
            scaled = np.asfortranarray(state["B"]) * state["diagD"]
            normal = rng.standard_normal((self.population, len(scaled)))
            samples = state["centroid"] + state["sigma"] * np.dot(normal, scaled.T)
            candidates: Genomes = samples.astype(np.float32)
        if not np.isfinite(candidates).all():
            raise self._diverged(state)
        # In float64: the covariance adapts to the samples as drawn, not as rounded for the match.
        return candidates, {**state, "samples": samples}

    def tell(self, state: State, results: Results) -> State:
        """Adapt mean, step size and covariance to the better samples."""
        values = checked_fitness(results.fitness, self.population)
        # DEAP reads an attribute `fitness`, which a view has room for and a plain array has not.
        population = list(state["samples"].view(Sample))
        for sample, value in zip(population, values, strict=True):
            sample.fitness = float(value)
        # The next `ask` reports a matrix that overflows or is no longer positive.
        with blas().limit(limits=1, user_api="blas"), np.errstate(all="ignore"):
            strategy = cma.Strategy(state["centroid"], 1.0, lambda_=self.population)
            for name in SAVED:
                value = state[name]
                setattr(strategy, name, value.copy() if value.ndim else value.item())
            strategy.B = np.asfortranarray(strategy.B)
            try:
                strategy.update(population)
            except np.linalg.LinAlgError as error:
                raise self._diverged(state) from error
        return {name: np.array(getattr(strategy, name)) for name in SAVED}

    def _diverged(self, state: State) -> DivergedError:
        # The largest deviation of a sample: where it is small, squares of the step size are 0.
        sigma, axes = float(state["sigma"]), state["diagD"]
        other = "larger" if sigma * axes[-1] < 1.0 else "smaller"
        return DivergedError(
            f"candidates: expected finite genes, got a step size of {sigma:g} and deviations along "
            f"the axes from {axes[0]:g} to {axes[-1]:g}; start with a {other} sigma, or stop "
            f"earlier"
        )
