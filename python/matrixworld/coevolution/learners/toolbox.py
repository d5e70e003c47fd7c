"""A learner as a DEAP toolbox, as `deap.algorithms.eaGenerateUpdate` takes it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from deap import base
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.types import Genomes


class Maximize(base.Fitness):  # type: ignore[misc]
    """DEAP fitness of one value; higher is better."""

    weights: tuple[float, ...] = (1.0,)

    def __init__(self) -> None:
        # DEAP's own constructor checks the weights for each new fitness, which takes longer than
        # all other work of making an individual.
        pass


class Individual:
    """A DEAP individual: a genome, such as (genes,), and its fitness."""

    __slots__ = ("fitness", "genome")

    def __init__(self, genome: NDArray[Any]) -> None:
        self.genome: NDArray[Any] = genome
        self.fitness: Maximize = Maximize()


def generate_update_toolbox(
    learner: Learner,
    evaluate: Callable[[Genomes], ArrayLike],
    generators: Iterator[np.random.Generator],
) -> base.Toolbox:
    """Return a toolbox with which `deap.algorithms.eaGenerateUpdate` drives a learner.

    It has `generate`, `evaluate`, `map` and `update`.

    Parameters
    ----------
    learner : Learner
        The learner.
    evaluate : callable
        Scores all candidates in one call: genomes (n, genes) float32 -> fitness (n,).
    generators : iterator of numpy.random.Generator
        Yields the generator of each epoch in turn.
    """

    def generate() -> list[Individual]:
        return [Individual(genome) for genome in learner.ask(next(generators))]

    def evaluate_all(score: Callable[..., ArrayLike], population: list[Individual]) -> list[Any]:
        # Called as DEAP's `map`: matches are played in bulk.
        genomes = np.stack([individual.genome for individual in population])
        return [(float(value),) for value in np.asarray(score(genomes))]

    def update(population: list[Any]) -> None:
        learner.tell([individual.fitness.values[0] for individual in population])

    toolbox = base.Toolbox()
    toolbox.register("generate", generate)
    toolbox.register("update", update)
    toolbox.register("evaluate", evaluate)
    toolbox.register("map", evaluate_all)
    return toolbox
