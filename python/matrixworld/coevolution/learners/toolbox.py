"""A learner as a DEAP toolbox, as `deap.algorithms.eaGenerateUpdate` takes it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from deap import base
from numpy.typing import ArrayLike

from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.types import Genome, Genomes


class Maximize(base.Fitness):  # type: ignore[misc]
    """DEAP fitness of one value; higher is better."""

    weights: tuple[float, ...] = (1.0,)

    def __init__(self) -> None:
        # DEAP's own constructor checks the weights for each new fitness, which takes longer than
        # all other work of making an individual.
        pass


class Individual:
    """A DEAP individual: a genome (genes,) and its fitness."""

    __slots__ = ("fitness", "genome")

    def __init__(self, genome: Genome) -> None:
        self.genome: Genome = genome
        self.fitness: Maximize = Maximize()


class Candidates(list[Individual]):
    """A DEAP population; its attribute `genomes` (n, genes) is one array, to be scored in bulk."""

    def __init__(self, genomes: Genomes) -> None:
        # The genome of an individual is a view of its row, so both always agree.
        super().__init__(Individual(genome) for genome in genomes)
        self.genomes = genomes


def generate_update_toolbox(
    learner: Learner,
    evaluate: Callable[[Candidates], ArrayLike],
    generators: Iterator[np.random.Generator],
) -> base.Toolbox:
    """Return a toolbox with which `deap.algorithms.eaGenerateUpdate` drives a learner.

    It has `generate`, `evaluate`, `map` and `update`.

    Parameters
    ----------
    learner : Learner
        The learner.
    evaluate : callable
        Scores all candidates in one call: takes a DEAP population whose attribute `genomes` is
        an array (n, genes), and returns the fitness (n,).
    generators : iterator of numpy.random.Generator
        Yields the generator of each epoch in turn.
    """

    def generate() -> Candidates:
        return Candidates(learner.ask(next(generators)))

    def evaluate_all(score: Callable[..., ArrayLike], population: Candidates) -> list[Any]:
        # Called as DEAP's `map`: matches are played in bulk.
        return [(float(value),) for value in np.asarray(score(population))]

    def update(population: list[Any]) -> None:
        learner.tell([individual.fitness.values[0] for individual in population])

    toolbox = base.Toolbox()
    toolbox.register("generate", generate)
    toolbox.register("update", update)
    toolbox.register("evaluate", evaluate)
    toolbox.register("map", evaluate_all)
    return toolbox
