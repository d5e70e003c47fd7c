"""A learner as a DEAP toolbox, in the shape of `deap.algorithms.eaGenerateUpdate`."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from deap import base
from numpy.typing import ArrayLike

from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.types import Genome, Genomes


class Maximize(base.Fitness):  # type: ignore[misc]
    """DEAP fitness of one value, the more the better."""

    weights = (1.0,)

    def __init__(self, values: tuple[float, ...] = ()) -> None:
        # DEAP's own looks at the weights of each new fitness again, which takes longer than the
        # rest of making an individual.
        if values:
            self.values = values


class Individual:
    """A DEAP individual: a genome (genes,) float32 and its fitness."""

    __slots__ = ("fitness", "genome")

    def __init__(self, genome: Genome) -> None:
        self.genome = genome
        self.fitness = Maximize()


class Candidates(list[Individual]):
    """A DEAP population whose individuals are the rows of one array, `genomes` (n, genes)."""

    def __init__(self, genomes: Genomes) -> None:
        super().__init__(Individual(genome) for genome in genomes)
        self.genomes = genomes


Evaluate = Callable[[Candidates], ArrayLike]
"""EpisodeStatistics all candidates at once: returns their fitness, (n,)."""


def evaluate_all(evaluate: Evaluate, population: Candidates) -> list[tuple[float]]:
    """DEAP's `map`, in one call: matches are played in bulk, not individual by individual."""
    return [(float(value),) for value in np.asarray(evaluate(population))]


def learner_toolbox(learner: Learner, generators: Iterator[np.random.Generator]) -> base.Toolbox:
    """Return a DEAP toolbox with `generate` and `update`.

    Parameters
    ----------
    learner : is asked by `generate` and told by `update`.
    generators : yields the generator of each epoch in turn.
    """

    def generate() -> Candidates:
        return Candidates(learner.ask(next(generators)))

    def update(population: list[Any]) -> None:
        learner.tell([individual.fitness.values[0] for individual in population])

    toolbox = base.Toolbox()
    toolbox.register("generate", generate)
    toolbox.register("update", update)
    return toolbox


def generate_update_toolbox(
    learner: Learner, evaluate: Evaluate, generators: Iterator[np.random.Generator]
) -> base.Toolbox:
    """Return all that `deap.algorithms.eaGenerateUpdate` needs to drive a learner.

    As `learner_toolbox`, with `evaluate`, which scores all candidates at once, and the `map` that
    calls it.
    """
    toolbox = learner_toolbox(learner, generators)
    toolbox.register("evaluate", evaluate)
    toolbox.register("map", evaluate_all)
    return toolbox
