"""Evolution with an adapted covariance matrix: DEAP's CMA-ES (Hansen & Ostermeier 2001)."""

from __future__ import annotations

from functools import cache
from typing import Any, ClassVar

import numpy as np
from deap import cma
from threadpoolctl import ThreadpoolController

from matrixworld.coevolution.game import Game
from matrixworld.coevolution.learners import learner
from matrixworld.coevolution.sections import section, setting
from matrixworld.coevolution.types import TEAMS, Genome, Genomes, Rng, State

MOST_GENES = 1000
"""Largest number of genes: each update decomposes the covariance matrix, in 0.15 s for so many."""
SAVED = ("centroid", "sigma", "pc", "ps", "C", "B", "diagD", "update_count")
blas = cache(ThreadpoolController)  # to search the loaded libraries takes milliseconds


class Sample(np.ndarray[Any, np.dtype[np.float64]]):
    """An individual as `deap.cma.Strategy` takes it: (genes,) float64 with a `fitness`."""

    fitness: float


@section
class CmaEs(learner.Learner):
    """Evolution strategy with covariance matrix adaptation: `deap.cma.Strategy`, asked and told.

    ::

        ask:   z_i ~ N(0, I);  candidates  m + s B D z_i,  with  C = B D^2 B^T
        tell:  m = weighted mean of the better half;  adapt the step size s and the covariance C

    LAPACK decomposes C in one thread, so that a run continues bit for bit with any number of
    threads on one machine; another processor or LAPACK may round differently.
    """

    kind: ClassVar[str] = "cma"
    steps: ClassVar[tuple[str, ...]] = ("sigma",)

    sigma: float = setting(0.8, "standard deviation of the first samples", positive=True)

    def check_fits(self, path: str, game: Game) -> None:
        """Raise ValueError if a team has too many genes."""
        genes = max(map(game.genome_size, TEAMS))
        if genes > MOST_GENES:
            raise ValueError(
                f"{path}: expected at most {MOST_GENES} genes for the full covariance matrix of "
                f"cma, got {genes}; a smaller view (fov) or hidden layer (or none) "
                f"has fewer, and es and ga take any number"
            )

    def start(self, task: learner.Task) -> State:
        """Return the state of a new strategy."""
        mean = task.genomes(1)[0].astype(np.float64)
        strategy = _adapted(cma.Strategy, mean, self.sigma, lambda_=self.population)
        return {**strategy, **task.bounds()}

    def genome(self, state: State) -> Genome:
        """Return the mean of the distribution."""
        with np.errstate(over="ignore"):  # a run reports genes that are not finite
            return learner.inside_bounds(state, state["centroid"].astype(np.float32))

    def ask(self, state: State, rng: Rng) -> tuple[Genomes, State]:
        """Return the samples."""
        with blas().limit(limits=1, user_api="blas"), np.errstate(all="ignore"):
            # Column by column, as LAPACK returned it: BLAS rounds differently in another order.
            scaled = np.asfortranarray(state["B"]) * state["diagD"]
            normal = rng.standard_normal((self.population, len(scaled)))
            samples = state["centroid"] + state["sigma"] * np.dot(normal, scaled.T)
            # In float64: C adapts to the samples as drawn, not as rounded for the match.
            played = learner.inside_bounds(state, samples.astype(np.float32))
            return played, {**state, "samples": samples}

    def tell(self, state: State, results: learner.Results) -> State:
        """Adapt mean, step size and covariance to the better samples."""
        fitness = learner.checked_fitness(results.fitness, self.population)
        # DEAP reads an attribute `fitness`, which a view has room for and a plain array has not.
        population = list(state["samples"].view(Sample))
        for sample, value in zip(population, fitness, strict=True):
            sample.fitness = float(value)

        def updated() -> cma.Strategy:
            strategy = cma.Strategy(state["centroid"], 1.0, lambda_=self.population)
            for name in SAVED:
                setattr(strategy, name, state[name].copy(order="A")[()])
            strategy.B = np.asfortranarray(strategy.B)
            strategy.update(population)
            return strategy

        try:
            bounds: State = {name: state[name] for name in ("low", "high") if name in state}
            return {**_adapted(updated), **bounds}
        except np.linalg.LinAlgError as error:
            raise self.diverged("learner") from error


def _adapted(make: Any, *args: Any, **options: Any) -> State:
    """Return the state of a strategy, which decomposes its covariance matrix when it is made."""
    with blas().limit(limits=1, user_api="blas"), np.errstate(all="ignore"):
        strategy = make(*args, **options)
    return {name: np.array(getattr(strategy, name)) for name in SAVED}
