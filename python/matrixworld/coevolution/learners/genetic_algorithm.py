"""A genetic algorithm with operators in the shape of DEAP's: select, mate, mutate.

DEAP's own operators draw from Python's global `random` and visit genes one by one. These take an
explicit generator and work on whole arrays; a DEAP toolbox registers them in the same way. As in
DEAP, mating and mutation change their argument and return it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from deap import base
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_floats, check_instance, check_integer, check_number
from matrixworld.coevolution.learners.learner import (
    MUTATION,
    LearnerSettings,
    NoiseTable,
    Task,
    checked_fitness,
)
from matrixworld.coevolution.sections import documented, setting
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, Saved

TOURNAMENT = 5
"""Individuals in a tournament, unless another number is given."""


def select_tournament(
    fitness: FloatArray, k: int, rng: np.random.Generator, *, size: int
) -> Indices:
    """Return the parents (k,): each the fittest of `size` random entrants; size 1 is random."""
    entrants = rng.integers(0, len(fitness), size=(k, size))
    # Rows are tournaments; of equal fitness the first entrant wins, and their order is random.
    winners = np.argmax(fitness[entrants], axis=1)
    selected: Indices = entrants[np.arange(k), winners]
    return selected


def select_truncation(
    fitness: FloatArray, k: int, rng: np.random.Generator, *, fraction: float
) -> Indices:
    """Return k parents drawn evenly from the fittest `fraction` of the population, in (0, 1]."""
    survivors = fittest(fitness, max(1, round(fraction * len(fitness))))
    return survivors[rng.integers(0, len(survivors), size=k)]


def fittest(fitness: FloatArray, k: int) -> Indices:
    """Return the k fittest individuals, the fittest first; of equals the first."""
    return np.argsort(-fitness, kind="stable")[:k]


def mate_uniform(
    genomes: Genomes,
    population: Genomes,
    mates: Indices,
    rng: np.random.Generator,
    *,
    probability: float,
) -> Genomes:
    """Turn genomes (n, genes) into children by uniform crossover, in place, and return them.

    A child mixes with that probability: each gene is that of its row, or of its mate in
    `population`, which `mates` (n,) indexes.
    """
    mixed = rng.random(len(genomes)) < probability
    # Without crossover, the default, no random number for each gene is drawn.
    if mixed.any():
        first, second = genomes[mixed], population[mates[mixed]]
        from_second = rng.random(first.shape, dtype=np.float32) < 0.5
        genomes[mixed] = np.where(from_second, second, first)
    return genomes


def mutate_from_table(genomes: Genomes, rng: np.random.Generator, *, noise: NoiseTable) -> Genomes:
    """Add Gaussian noise from a table to genomes, in place, and return them."""
    # Row by row: each window starts at another place, and no array holds all of them.
    for genome, change in zip(genomes, noise.draw(len(genomes), rng), strict=True):
        np.add(genome, change, out=genome)
    return genomes


class GeneticAlgorithm(Saved):
    """A generational genetic algorithm with elitism, its operators in a DEAP toolbox.

    ::

        ask:   at first the given population; later the elites unchanged, and children:
               select parents, mate, mutate
        tell:  the candidates become the population

    Elites are scored again in each epoch, since opponents change. All candidates of an epoch are
    scored on the same match seed.

    The champion is the fittest candidate of one epoch. Its fitness is a maximum of noisy values,
    so it overestimates the champion (winner's curse). A caller that scores the elites again can
    name another champion by `choose_champion`; parent selection does not change.

    Parameters
    ----------
    population : array_like of float, shape (n, genes)
        Genomes to start from; row 0 is the champion until the first `tell`.
    noise : NoiseTable
        Table for the same number of genes; its `sigma` is the standard deviation of a mutation.
    tournament : int, optional
        Individuals in a tournament that selects a parent.
    truncation : float, optional
        Share of the population from which parents are drawn. By default tournaments select them.
    elites : int, optional
        Number of the fittest individuals that are kept unchanged, below n.
    crossover : float, optional
        Probability that a child mixes two parents.

    Attributes
    ----------
    toolbox : deap.base.Toolbox
        The operators `select`, `mate` and `mutate`.

    References
    ----------
    Such et al. 2017, "Deep neuroevolution", arXiv:1712.06567, for mutation alone and truncation.
    """

    saved: ClassVar[tuple[str, ...]] = ("population", "fitness", "champion")

    def __init__(
        self,
        population: ArrayLike,
        noise: NoiseTable,
        *,
        tournament: int = TOURNAMENT,
        truncation: float | None = None,
        elites: int = 2,
        crossover: float = 0.0,
    ) -> None:
        check_integer("tournament", tournament, 1)
        check_integer("elites", elites, 0)
        check_number("crossover", crossover, least=0.0, most=1.0)
        check_instance("noise", noise, NoiseTable)
        self.population: Genomes = check_floats("population", population, np.float32)
        if self.population.ndim != 2 or not 0 <= elites < len(self.population):
            raise ValueError(
                f"population: expected (n, genes) with n above {elites} elites, "
                f"got shape {self.population.shape}"
            )
        genes = self.population.shape[1]
        if noise.size != genes:
            raise ValueError(f"noise: expected a table for {genes} genes, got one for {noise.size}")
        # Empty before the first `tell`: a state holds arrays only, so no None.
        self.fitness: FloatArray = np.zeros(0)
        self.champion = 0
        self.elites = elites
        self._candidates = self.population[:0]
        self.toolbox = base.Toolbox()
        if truncation is None:
            self.toolbox.register("select", select_tournament, size=tournament)
        else:
            check_number("truncation", truncation, least=0.0, most=1.0, positive=True)
            self.toolbox.register("select", select_truncation, fraction=truncation)
        self.toolbox.register("mate", mate_uniform, probability=crossover)
        self.toolbox.register("mutate", mutate_from_table, noise=noise)

    @property
    def genome(self) -> Genome:
        """Champion of the last scored population, (genes,) float32."""
        genome: Genome = self.population[self.champion].copy()
        return genome

    @property
    def elite(self) -> Indices:
        """Indices (elites,) of the fittest of the last scored population, the fittest first."""
        if not len(self.fitness):
            raise RuntimeError("elite: expected a call of tell before it, got none")
        return fittest(self.fitness, self.elites)

    def elite_genomes(self) -> Genomes:
        """Return the genomes (elites, genes) of the elite, the fittest first."""
        return self.population[self.elite]

    def choose_champion(self, fitness: ArrayLike) -> None:
        """Make the best of the elite the champion until the next `tell`, by its new fitness.

        `fitness` (elites,) is in the order of `elite_genomes`; of equals the first wins.
        """
        best = int(np.argmax(checked_fitness(fitness, self.elites)))
        self.champion = int(self.elite[best])

    @property
    def seed_groups(self) -> Indices:
        """Zeros (n,): all candidates are scored on one match seed."""
        return np.zeros(len(self.population), dtype=np.intp)

    @np.errstate(over="ignore", invalid="ignore")  # a run reports genes that are not finite
    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return the next population: at first as given, later elites and then children."""
        if not len(self.fitness):
            self._candidates = self.population
            return self.population
        n_children = len(self.population) - self.elites
        # Both parents are selected independently, so that they may be the same individual.
        fathers = self.toolbox.select(self.fitness, n_children, rng)
        mothers = self.toolbox.select(self.fitness, n_children, rng)
        # One copy of the whole population, which children change in place: at this size every
        # further array leaves the caches.
        offspring: Genomes = self.population[np.concatenate([self.elite, fathers])]
        children = offspring[self.elites :]
        mated = self.toolbox.mate(children, self.population, mothers, rng)
        mutants = self.toolbox.mutate(mated, rng)
        if mutants is not children:  # another operator in the toolbox
            children[:] = mutants
        self._candidates = offspring
        return offspring

    def tell(self, fitness: ArrayLike) -> None:
        """Make the candidates the population, with this fitness."""
        self.fitness = checked_fitness(fitness, len(self._candidates))
        self.champion = int(np.argmax(self.fitness))
        self.population, self._candidates = self._candidates, self._candidates[:0]


@documented
@dataclass(frozen=True)
class GeneticAlgorithmSettings(LearnerSettings):
    """Settings of `GeneticAlgorithm`."""

    kind: ClassVar[str] = "ga"
    keeps_fixed_genes: ClassVar[bool] = True
    keeps_population: ClassVar[bool] = True
    steps: ClassVar[tuple[str, ...]] = ("mutation",)

    mutation: float = setting(
        MUTATION, "standard deviation of a mutation", by={"against": 0.2}, positive=True
    )
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
    elite_episodes: int = setting(
        0,
        "new matches of each elite against each of its last opponents at the end of a "
        "generation, which decide the champion; 0: the fitness of the last epoch decides",
    )

    def check(self) -> None:
        """Raise ValueError if two ways to select are given, or too many or few elites."""
        if self.tournament is not None and self.truncation is not None:
            raise ValueError(
                f"tournament: expected no value beside truncation, got {self.tournament}"
            )
        if self.population is not None and self.elites >= self.population:
            raise ValueError(f"elites: expected fewer than {self.population}, got {self.elites}")
        if self.elite_episodes and self.elites < 2:
            raise ValueError(
                f"elite_episodes: expected 0 with fewer than 2 elites, got {self.elite_episodes}"
            )

    @property
    def first_sigma(self) -> float:
        """Standard deviation of a mutation."""
        return self.mutation

    @property
    def elite_matches(self) -> int:
        """New matches of all elites against one opponent."""
        return self.elites * self.elite_episodes

    def new(self, task: Task) -> GeneticAlgorithm:
        """Return a new learner of a team."""
        genes = task.genomes.shape[1]
        return GeneticAlgorithm(
            task.genomes,
            NoiseTable(genes, task.rng, sigma=self.mutation, fixed=task.fixed),
            tournament=self.tournament or TOURNAMENT,
            truncation=self.truncation,
            elites=self.elites,
            crossover=self.crossover,
        )
