"""A learner as a DEAP toolbox, as `deap.algorithms.eaGenerateUpdate` takes it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from deap import base
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution.learners.learner import Learner, Results
from matrixworld.coevolution.types import Genomes, State


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
    state: State,
    evaluate: Callable[[Genomes], ArrayLike],
    generators: Iterator[np.random.Generator],
) -> base.Toolbox:
    """Return a toolbox with which `deap.algorithms.eaGenerateUpdate` drives a learner.

    It has `generate`, `evaluate`, `map` and `update`, and `genome`, which returns the genome of the
    learner.

    Parameters
    ----------
    learner : Learner
        The learner.
    state : dict of str to ndarray
        Its state, such as ``learner.start(task)``.
    evaluate : callable
        Scores all candidates in one call: genomes (n, genes) float32 -> fitness (n,).
    generators : iterator of numpy.random.Generator
        Yields the generator of each epoch in turn.
    """

    def generate() -> list[Individual]:
        nonlocal state
        candidates, state = learner.ask(state, next(generators))
        return [Individual(genome) for genome in candidates]

    def evaluate_all(score: Callable[..., ArrayLike], population: list[Individual]) -> list[Any]:
        # Called as DEAP's `map`: matches are played in bulk.
        genomes = np.stack([individual.genome for individual in population])
        return [(float(value),) for value in np.asarray(score(genomes))]

    def update(population: list[Any]) -> None:
        nonlocal state
        fitness = np.array([individual.fitness.values[0] for individual in population])
        state = learner.tell(state, Results(fitness))

    toolbox = base.Toolbox()
    toolbox.register("generate", generate)
    toolbox.register("update", update)
    toolbox.register("evaluate", evaluate)
    toolbox.register("map", evaluate_all)
    toolbox.register("genome", lambda: learner.genome(state))
    return toolbox
