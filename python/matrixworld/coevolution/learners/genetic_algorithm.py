"""A genetic algorithm with operators in the shape of DEAP's: select, mate, mutate.

DEAP's own operators draw from Python's global `random` and visit genes one by one. These take an
explicit generator and work on whole arrays; a DEAP toolbox registers them in the same way. As in
DEAP, mating and mutation change their argument and return it.
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np
from deap import base

from matrixworld.coevolution.learners import learner
from matrixworld.coevolution.learners.learner import fittest, select_tournament
from matrixworld.coevolution.sections import by_race, section, setting
from matrixworld.coevolution.types import FloatArray, Genomes, Indices, Rng, State

TOURNAMENT = 5  # individuals in a tournament, unless another number is given


def select_truncation(fitness: FloatArray, k: int, rng: Rng, *, fraction: float) -> Indices:
    """Return k parents drawn evenly from the fittest `fraction` of the population, in (0, 1]."""
    survivors = fittest(fitness, max(1, round(fraction * len(fitness))))
    return survivors[rng.integers(0, len(survivors), size=k)]


def mate_uniform(
    genomes: Genomes, population: Genomes, mates: Indices, rng: Rng, *, probability: float
) -> Genomes:
    """Mix genomes (n, genes) in place with their `mates` in a population; return them.

    With that probability each gene is that of its row, or of its mate.
    """
    mixed = rng.random(len(genomes)) < probability
    # Without crossover, the default, no random number for each gene is drawn.
    if mixed.any():
        first, second = genomes[mixed], population[mates[mixed]]
        from_second = rng.random(first.shape, dtype=np.float32) < 0.5
        genomes[mixed] = np.where(from_second, second, first)
    return genomes


def mutate(genomes: Genomes, rng: Rng, *, state: State, sigma: float) -> Genomes:
    """Add Gaussian noise to genomes, in place, and return them."""
    # Row by row: no array holds the noise of all of them.
    genes = genomes.shape[1]
    noise = learner.noise_of(state, learner.draw_windows(len(genomes), genes, rng), genes, sigma)
    for genome, change in zip(genomes, noise, strict=True):
        np.add(genome, change, out=genome)
    return genomes


@section
class GeneticAlgorithm(learner.Generational):
    """A generational genetic algorithm with elitism, its operators in a DEAP toolbox.

    ::

        ask:   at first the given population; later the elites unchanged, and children:
               select parents, mate, mutate
        tell:  the candidates become the population

    Elites are scored again in each epoch, since opponents change. All candidates of an epoch are
    scored on the same match seed. The champion is the fittest candidate of one epoch. Its fitness
    is a maximum of noisy values, so it overestimates the champion (winner's curse).

    Such et al. 2017, "Deep neuroevolution", arXiv:1712.06567, for mutation alone and truncation.
    """

    kind: ClassVar[str] = "ga"
    steps: ClassVar[tuple[str, ...]] = ("mutation",)

    mutation: float = by_race(learner.MUTATION, "standard deviation of a mutation", positive=True)
    crossover: float = setting(0.0, "probability that a child has two parents", most=1.0)
    tournament: int | None = setting(
        None, "individuals in a tournament that selects a parent; default: 5", least=1
    )
    truncation: float | None = setting(
        None,
        "share of the population that parents are drawn from; default: tournaments instead",
        most=1.0,
        positive=True,
    )

    elites: int = setting(2, "fittest individuals kept unchanged")

    def check(self) -> None:
        """Raise ValueError if two ways to select are given, or too many elites."""
        if self.tournament is not None and self.truncation is not None:
            expected = "no value beside truncation"
            raise ValueError(f"tournament: expected {expected}, got {self.tournament}")
        super().check()

    @property
    def toolbox(self) -> base.Toolbox:
        """The operators `select`, `mate` and `mutate`; a subclass may register others."""
        toolbox = base.Toolbox()
        if self.truncation is None:
            toolbox.register("select", select_tournament, size=self.tournament or TOURNAMENT)
        else:
            toolbox.register("select", select_truncation, fraction=self.truncation)
        toolbox.register("mate", mate_uniform, probability=self.crossover)
        toolbox.register("mutate", mutate, sigma=self.mutation)
        return toolbox

    def start(self, task: learner.Task) -> State:
        """Return a population that nobody has scored yet."""
        population = task.genomes(self.population, self.mutation)
        return {**learner.unscored(population), **task.noise_state()}

    @np.errstate(over="ignore", invalid="ignore")  # a run reports genes that are not finite
    def offspring(self, state: State, rng: Rng) -> Genomes:
        """Return the next population: the elites unchanged, and then children."""
        population, fitness, toolbox = state["population"], state["fitness"], self.toolbox
        n_children = len(population) - self.elites
        # Both parents are selected independently, so that they may be the same individual.
        fathers = toolbox.select(fitness, n_children, rng)
        mothers = toolbox.select(fitness, n_children, rng)
        # One copy of the whole population, which children change in place: at this size every
        # further array leaves the caches.
        elite = fittest(fitness, self.elites)
        offspring: Genomes = population[np.concatenate([elite, fathers])]
        children = offspring[self.elites :]
        mated = toolbox.mate(children, population, mothers, rng)
        mutants = toolbox.mutate(mated, rng, state=state)
        if mutants is not children:  # another operator in the toolbox
            children[:] = mutants
        return learner.inside_bounds(state, offspring)
