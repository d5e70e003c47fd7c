"""Learners whose candidates are a population, each made of the one before."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any

import numpy as np

from matrixworld._util.sections import SettingError, section, setting
from matrixworld.coevolution.learners.learner import (
    Evolutionary,
    Results,
    checked_fitness,
    not_asked,
)
from matrixworld.coevolution.states import State
from matrixworld.coevolution.types import Genome, Genomes, Rng


@section()
class Generational(Evolutionary):
    """Base of learners whose candidates are a population, of which the next one is made.

    Their states have the fields of `unscored`, `candidates`, and perhaps others.
    """

    elites: int = setting(2, "fittest individuals kept unchanged")

    def check(self) -> None:
        """Raise SettingError for too many elites."""
        super().check()
        if self.elites >= self.population:
            raise SettingError("elites", f"fewer than {self.population}", str(self.elites))

    @abstractmethod
    def offspring(self, state: State, rng: Rng) -> Genomes:
        """Return the population after a scored one: its elites unchanged, and then children."""

    def genome(self, state: State) -> Genome:
        """Return the champion of the last scored population."""
        genome: Genome = state.population[int(state.champion)]
        return genome

    def ask(self, state: State, rng: Rng) -> tuple[Genomes, State]:
        """Return the next population: at first as given, later elites and children."""
        genomes = self.offspring(state, rng) if len(state.fitness) else state.population
        return genomes, state._replace(candidates=genomes)

    def tell(self, state: State, results: Results) -> State:
        """Make the candidates the population, with this fitness."""
        if state.candidates is None:
            raise not_asked()
        fitness = checked_fitness(results.fitness, len(state.candidates))
        champion = np.array(np.argmax(fitness))
        return state._replace(
            population=state.candidates, fitness=fitness, champion=champion, candidates=None
        )


def unscored(population: Genomes) -> dict[str, Any]:
    """Return the fields that every state of a `Generational` learner has, before any match."""
    return {"population": population, "fitness": np.zeros(0), "champion": np.array(0)}
