"""A genetic algorithm, its operators shaped as DEAP's: select, mate, mutate.

DEAP's own operators draw from Python's global `random` and walk over genes one by one. These
take an explicit generator and work on whole arrays; they are registered in a DEAP toolbox the
same way.
"""

from __future__ import annotations

import numpy as np
from deap import base
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution.learners.learner import checked_fitness
from matrixworld.coevolution.learners.noise import NoiseTable
from matrixworld.coevolution.types import Genome, Genomes, State


def select_tournament(
    fitness: NDArray[np.float64], k: int, rng: np.random.Generator, *, size: int
) -> NDArray[np.intp]:
    """Return `k` indices, each the fittest of `size` individuals drawn with replacement.

    Parameters
    ----------
    fitness : (n,) floats, higher is better.
    k : how many to select.
    size : individuals in a tournament; 1 is selection at random.
    """
    entrants = rng.integers(0, len(fitness), size=(k, size))
    winners = np.argmax(fitness[entrants], axis=1)
    selected: NDArray[np.intp] = entrants[np.arange(k), winners]
    return selected


def select_truncation(
    fitness: NDArray[np.float64], k: int, rng: np.random.Generator, *, fraction: float
) -> NDArray[np.intp]:
    """Return `k` indices drawn evenly from the fittest `fraction` of the individuals."""
    best_first = np.argsort(-fitness, kind="stable")
    survivors = best_first[: max(1, round(fraction * len(fitness)))]
    return survivors[rng.integers(0, len(survivors), size=k)]


def mate_uniform(
    first: Genomes, second: Genomes, rng: np.random.Generator, *, probability: float
) -> Genomes:
    """Return children (n, genes): with `probability` a uniform mix of both parents.

    The other children are copies of their first parent. `first` and `second` are (n, genes).
    """
    mixed = rng.random(len(first)) < probability
    children: Genomes = first.copy()
    if mixed.any():
        from_second = rng.random((int(mixed.sum()), first.shape[1]), dtype=np.float32) < 0.5
        children[mixed] = np.where(from_second, second[mixed], first[mixed])
    return children


def mutate_gaussian(
    genomes: Genomes, rng: np.random.Generator, *, sigma: float, probability: float
) -> Genomes:
    """Return mutants (n, genes): each gene moved by N(0, sigma) with `probability`."""
    mutants = rng.standard_normal(genomes.shape, dtype=np.float32)
    mutants *= np.float32(sigma)
    if probability < 1.0:
        mutants *= rng.random(genomes.shape, dtype=np.float32) < probability
    mutants += genomes
    return mutants


def mutate_from_table(
    genomes: Genomes, rng: np.random.Generator, *, noise: NoiseTable, probability: float
) -> Genomes:
    """As `mutate_gaussian`, the numbers and their `sigma` those of a table: many times as fast."""
    mutants = np.empty_like(genomes)
    for mutant, genome, change in zip(mutants, genomes, noise.draw(len(genomes), rng), strict=True):
        if probability < 1.0:
            change = change * (rng.random(noise.size, dtype=np.float32) < probability)
        np.add(genome, change, out=mutant)
    return mutants


class GeneticAlgorithm:
    """A generational genetic algorithm with elitism, its operators in a DEAP toolbox.

    ::

        ask:   at first the given population; later the elites unchanged, and children:
               select parents, mate, mutate
        tell:  the candidates become the population

    Elites are scored anew each epoch, since opponents change. All candidates of an epoch are
    scored on the same match seed.

    Parameters
    ----------
    population : (n, genes) float32; row 0 is the champion until the first `tell`.
    noise : table of the same number of genes; its `sigma` is the deviation of a mutation.
    selection : "tournament" or "truncation".
    tournament : individuals in a tournament.
    truncation : share of the population that truncation lets breed.
    elites : fittest individuals kept unchanged, fewer than n.
    crossover : probability that a child mixes two parents.
    mutation : probability that a gene mutates.
    """

    def __init__(
        self,
        population: ArrayLike,
        noise: NoiseTable,
        *,
        selection: str = "tournament",
        tournament: int = 5,
        truncation: float = 0.25,
        elites: int = 2,
        crossover: float = 0.0,
        mutation: float = 1.0,
    ) -> None:
        self._population = np.array(population, dtype=np.float32)
        if self._population.ndim != 2 or not 0 <= elites < len(self._population):
            raise ValueError(
                f"population: expected (n, genes) with n above {elites} elites, "
                f"got shape {self._population.shape}"
            )
        genes = self._population.shape[1]
        if noise.size != genes:
            raise ValueError(f"noise: expected a table for {genes} genes, got one for {noise.size}")
        self._fitness: NDArray[np.float64] | None = None
        self._candidates: Genomes | None = None
        self.elites = elites
        self.toolbox = base.Toolbox()
        if selection == "tournament":
            self.toolbox.register("select", select_tournament, size=tournament)
        elif selection == "truncation":
            self.toolbox.register("select", select_truncation, fraction=truncation)
        else:
            raise ValueError(f"selection: expected tournament or truncation, got {selection!r}")
        self.toolbox.register("mate", mate_uniform, probability=crossover)
        self.toolbox.register("mutate", mutate_from_table, noise=noise, probability=mutation)

    @property
    def genome(self) -> Genome:
        """The champion of the last scored population."""
        champion = 0 if self._fitness is None else int(np.argmax(self._fitness))
        genome: Genome = self._population[champion].copy()
        return genome

    @property
    def match_of_candidate(self) -> NDArray[np.intp]:
        """One match for all."""
        return np.zeros(len(self._population), dtype=np.intp)

    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return the next population: at first as given, later elites and then children."""
        if self._fitness is None:
            self._candidates = self._population
        else:
            self._candidates = self._offspring(self._fitness, rng)
        return self._candidates

    def _offspring(self, fitness: NDArray[np.float64], rng: np.random.Generator) -> Genomes:
        n_children = len(self._population) - self.elites
        fathers = self._population[self.toolbox.select(fitness, n_children, rng)]
        mothers = self._population[self.toolbox.select(fitness, n_children, rng)]
        children = self.toolbox.mutate(self.toolbox.mate(fathers, mothers, rng), rng)
        best_first = np.argsort(-fitness, kind="stable")
        return np.concatenate([self._population[best_first[: self.elites]], children])

    def tell(self, fitness: ArrayLike) -> None:
        """Let the candidates be the population."""
        if self._candidates is None:
            raise RuntimeError("tell: expected after ask, got no candidates to be told of")
        self._fitness = checked_fitness(fitness, len(self._candidates))
        self._population, self._candidates = self._candidates, None

    def state(self) -> State:
        """Return the population and its fitness (empty before the first `tell`)."""
        scored = np.zeros(0) if self._fitness is None else self._fitness
        return {"population": self._population, "fitness": scored}

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""
        self._population = state["population"].astype(np.float32)
        scored = state["fitness"].astype(np.float64)
        self._fitness = scored if len(scored) else None
        self._candidates = None
