"""A genetic algorithm whose operators, select, mate and mutate, are in a DEAP toolbox.

DEAP's own operators draw from Python's global `random` and take one or two individuals. These take
an explicit generator and arrays of genomes, so DEAP's own do not fit in their place. As in DEAP,
mating and mutation change their argument and return it.
"""

from __future__ import annotations

from typing import ClassVar, NamedTuple

import numpy as np
from deap import base
from numpy.typing import NDArray

from matrixworld._util.constraints import Range, Whole
from matrixworld._util.sections import SettingError, section, setting
from matrixworld.coevolution.games.game import clipped
from matrixworld.coevolution.learners import learner
from matrixworld.coevolution.learners.generational import Generational, unscored
from matrixworld.coevolution.learners.noise import Noise, draw_windows, noise_of
from matrixworld.coevolution.learners.selection import fittest, select_tournament
from matrixworld.coevolution.types import FloatArray, Genomes, Indices, Rng

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
        first = genomes[mixed]
        second = population[mates[mixed]]
        from_second = rng.random(first.shape, dtype=np.float32) < 0.5
        genomes[mixed] = np.where(from_second, second, first)
    return genomes


def mutate(genomes: Genomes, rng: Rng, *, noise: Noise, sigma: float) -> Genomes:
    """Add Gaussian noise to genomes, in place, and return them."""
    # Row by row: no array holds the noise of all of them.
    genes = genomes.shape[1]
    windows = draw_windows(len(genomes), genes, rng)
    changes = noise_of(noise, windows, genes, sigma)
    for genome, change in zip(genomes, changes, strict=True):
        np.add(genome, change, out=genome)
    return genomes


class State(NamedTuple):
    """A population and its fitness; that of a new one is empty."""

    population: Genomes
    fitness: FloatArray
    champion: NDArray[np.intp]
    noise: Noise
    bounds: learner.Bounds | None
    candidates: Genomes | None = None


@section("ga")
class GeneticAlgorithm(Generational):
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

    keeps_mask: ClassVar[bool] = True
    steps: ClassVar[tuple[str, ...]] = ("mutation",)

    mutation: float = setting(
        learner.MUTATION, "standard deviation of a mutation", Range(open=True)
    )
    crossover: float = setting(0.0, "probability that a child has two parents", Range(most=1.0))
    tournament: int | None = setting(
        None, f"individuals in a tournament that selects a parent; default: {TOURNAMENT}", Whole(1)
    )
    truncation: float | None = setting(
        None,
        "share of the population that parents are drawn from; default: tournaments instead",
        Range(most=1.0, open=True),
    )

    def check(self) -> None:
        """Raise SettingError for two ways to select, or too many elites."""
        super().check()
        if self.tournament is not None and self.truncation is not None:
            raise SettingError("tournament", "no value beside truncation", str(self.tournament))

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
        return State(**unscored(population), noise=task.noise(), bounds=task.bounds())

    @np.errstate(over="ignore", invalid="ignore")  # a run reports genes that are not finite
    def offspring(self, state: State, rng: Rng) -> Genomes:
        """Return the next population: the elites unchanged, and then children."""
        population = state.population
        fitness = state.fitness
        toolbox = self.toolbox
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
        mutants = toolbox.mutate(mated, rng, noise=state.noise)
        if mutants is not children:  # another operator in the toolbox
            children[:] = mutants
        return clipped(offspring, state.bounds)
