"""Evolution with an adapted covariance matrix: DEAP's CMA-ES (Hansen & Ostermeier 2001)."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any, ClassVar, NamedTuple

import numpy as np
from deap import cma
from numpy.typing import NDArray
from threadpoolctl import ThreadpoolController

from matrixworld._util.constraints import Range
from matrixworld._util.sections import SettingError, section, setting
from matrixworld.coevolution.games.game import Game, clipped
from matrixworld.coevolution.learners import learner
from matrixworld.coevolution.types import TEAMS, FloatArray, Genome, Genomes, Rng

MOST_GENES = 1000
"""Largest number of genes: each update decomposes the covariance matrix, in 0.15 s for so many."""
blas = cache(ThreadpoolController)  # to search the loaded libraries takes milliseconds


@contextmanager
def one_thread() -> Iterator[None]:
    """Let LAPACK and BLAS compute in one thread, on whose number the rounding depends.

    Without warnings: a run reports genes that are not finite.
    """
    with blas().limit(limits=1, user_api="blas"), np.errstate(all="ignore"):
        yield


class State(NamedTuple):
    """The attributes of a `deap.cma.Strategy`, by their names there, and an epoch's samples."""

    centroid: FloatArray
    sigma: NDArray[np.float64]
    pc: FloatArray
    ps: FloatArray
    C: FloatArray
    B: FloatArray
    diagD: FloatArray  # noqa: N815, as DEAP calls it
    update_count: NDArray[np.int64]
    bounds: learner.Bounds | None
    samples: FloatArray | None = None


ATTRIBUTES = State._fields[: State._fields.index("bounds")]
"""The attributes of a strategy that change."""


class Sample(np.ndarray[Any, np.dtype[np.float64]]):
    """An individual as `deap.cma.Strategy` takes it: (genes,) float64 with a `fitness`."""

    fitness: float


@section("cma")
class CmaEs(learner.Evolutionary):
    """Evolution strategy with covariance matrix adaptation: `deap.cma.Strategy`, asked and told.

    ::

        ask:   z_i ~ N(0, I);  candidates  m + s B D z_i,  with  C = B D^2 B^T
        tell:  m = weighted mean of the better half;  adapt the step size s and the covariance C

    LAPACK decomposes C in one thread, so that a run continues bit for bit with any number of
    threads on one machine; another processor or LAPACK may round differently.
    """

    steps: ClassVar[tuple[str, ...]] = ("sigma",)

    sigma: float = setting(0.8, "standard deviation of the first samples", Range(open=True))

    def check_fits(self, path: str, game: Game) -> None:
        """Raise SettingError if a team has too many genes."""
        genes = max(map(game.genome_size, TEAMS))
        if genes > MOST_GENES:
            raise SettingError(
                path,
                f"at most {MOST_GENES} genes for the full covariance matrix of cma",
                f"{genes}; a smaller view (fov) or hidden layer (or none) has fewer, and es and ga "
                f"take any number",
            )

    def start(self, task: learner.Task) -> State:
        """Return the state of a new strategy."""
        mean = task.genomes(1)[0].astype(np.float64)
        with one_thread():
            strategy = cma.Strategy(mean, self.sigma, lambda_=self.population)
        return _state_of(strategy, task.bounds())

    def genome(self, state: State) -> Genome:
        """Return the mean of the distribution."""
        with np.errstate(over="ignore"):  # a run reports genes that are not finite
            return clipped(state.centroid.astype(np.float32), state.bounds)

    def ask(self, state: State, rng: Rng) -> tuple[Genomes, State]:
        """Return the samples."""
        with one_thread():
            # Column by column, as LAPACK returned it: BLAS rounds differently in another order.
            scaled = np.asfortranarray(state.B) * state.diagD
            normal = rng.standard_normal((self.population, len(scaled)))
            samples = state.centroid + state.sigma * np.dot(normal, scaled.T)
            # In float64: C adapts to the samples as drawn, not as rounded for the match.
            played = clipped(samples.astype(np.float32), state.bounds)
            return played, state._replace(samples=samples)

    def tell(self, state: State, results: learner.Results) -> State:
        """Adapt mean, step size and covariance to the better samples."""
        if state.samples is None:
            raise learner.not_asked()
        fitness = learner.checked_fitness(results.fitness, self.population)
        # DEAP reads an attribute `fitness`, which a view has room for and a plain array has not.
        population = list(state.samples.view(Sample))
        for sample, value in zip(population, fitness, strict=True):
            sample.fitness = float(value)
        with one_thread():
            strategy = self._strategy(state)
            try:
                strategy.update(population)
            except np.linalg.LinAlgError:
                # C is not finite. A run reports a genome of NaN, with the path of this learner.
                nowhere = np.full_like(state.centroid, np.nan)
                return state._replace(centroid=nowhere, samples=None)
        return _state_of(strategy, state.bounds)

    def _strategy(self, state: State) -> cma.Strategy:
        """Return the strategy of a state, which it does not change."""
        strategy = cma.Strategy(state.centroid, 1.0, lambda_=self.population)
        for name in ATTRIBUTES:
            # A copy in the same order of memory, on which the rounding depends; [()] makes a number
            # of an array without dimensions.
            setattr(strategy, name, getattr(state, name).copy(order="A")[()])
        strategy.B = np.asfortranarray(strategy.B)
        return strategy


def _state_of(strategy: cma.Strategy, bounds: learner.Bounds | None) -> State:
    """Return the state of a strategy, between the epochs."""
    attributes = {name: np.array(getattr(strategy, name)) for name in ATTRIBUTES}
    return State(**attributes, bounds=bounds)
