"""A genetic algorithm for genomes that are objects: a game mutates and mates them itself."""

from __future__ import annotations

from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.constraints import Range, Whole
from matrixworld._util.sections import section, setting
from matrixworld.coevolution.games.operators import as_genomes
from matrixworld.coevolution.learners import learner
from matrixworld.coevolution.learners.generational import Generational, unscored
from matrixworld.coevolution.learners.selection import fittest, select_tournament
from matrixworld.coevolution.types import FloatArray, Genomes, Rng


class State(NamedTuple):
    """A population of texts and its fitness; that of a new one is empty."""

    population: Genomes
    fitness: FloatArray
    champion: NDArray[np.intp]
    candidates: Genomes | None = None


@section("breeding")
class Breeding(Generational):
    """A generational genetic algorithm with elitism; `mutate` and `mate` are those of the game.

    ::

        ask:   at first the given population; later the elites unchanged, and children:
               select parents by tournaments, mate, mutate
        tell:  the candidates become the population

    A child of one parent always mutates, and so do all children of a game that does not mate.
    Elites are scored again in each epoch, since opponents change. All candidates of an epoch are
    scored on the same match seed. The champion is the fittest candidate of one epoch.
    """

    texts: ClassVar[bool] = True
    policies: ClassVar[tuple[str, ...]] = ()

    tournament: int = setting(4, "individuals in a tournament that selects a parent", Whole(1))
    crossover: float = setting(
        0.5, "probability that a child has two parents, in a game that mates", Range(most=1.0)
    )
    mutation: float = setting(
        0.5, "probability that a child of two parents mutates; others always do", Range(most=1.0)
    )

    def start(self, task: learner.Task) -> State:
        """Return a population that nobody has scored yet."""
        return State(**unscored(task.genomes(self.population)))

    def offspring(self, state: State, rng: Rng) -> Genomes:
        """Return the next population: the elites unchanged, and then children."""
        population = state.population
        n = len(population) - self.elites
        elites = fittest(state.fitness, self.elites)
        # Both parents are selected independently, so that they may be the same individual.
        parents = select_tournament(state.fitness, 2 * n, rng, size=self.tournament).reshape(n, 2)
        two = rng.random(n) < self.crossover
        mutates = rng.random(n) < self.mutation
        children = [
            self.operators.child(population[pair if both else pair[:1]], rng, mutates=bool(also))
            for pair, both, also in zip(parents, two, mutates, strict=True)
        ]
        return np.concatenate([population[elites], as_genomes(children)])
