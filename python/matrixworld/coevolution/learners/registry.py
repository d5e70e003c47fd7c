"""What a run starts from: untrained genomes and new learners."""

from __future__ import annotations

import numpy as np

from matrixworld.coevolution.learners.cma_es import CmaEs
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategy
from matrixworld.coevolution.learners.genetic_algorithm import GeneticAlgorithm
from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.learners.noise import NoiseTable
from matrixworld.coevolution.seeding import Purpose, keyed_generator
from matrixworld.coevolution.settings import RaceSettings, SingleSettings
from matrixworld.coevolution.types import TEAMS, Genomes, Team


def untrained(settings: RaceSettings | SingleSettings, team: Team, count: int) -> Genomes:
    """Return the first `count` untrained genomes (count, genes) of a team of a run."""
    rng = keyed_generator(settings.seed, Purpose.INITIAL, TEAMS.index(team))
    weight, head = settings.initial_weight, settings.initial_head
    return np.stack([settings.network.initial(rng, weight=weight, head=head) for _ in range(count)])


def new_learner(
    settings: RaceSettings | SingleSettings, team: Team, population: Genomes
) -> Learner:
    """Return the learner of the settings, starting from `population` (or from its first row)."""
    if settings.learner_name == "cma":
        return CmaEs(population[0], sigma=settings.sigma, samples=settings.population)
    genetic = settings.learner_name == "ga"
    rng = keyed_generator(settings.seed, Purpose.NOISE, TEAMS.index(team))
    sigma = settings.mutation if genetic else settings.sigma
    noise = NoiseTable(population.shape[1], rng, sigma=sigma)
    if genetic:
        return GeneticAlgorithm(
            population,
            noise,
            selection=settings.selection,
            tournament=settings.tournament,
            truncation=settings.truncation,
            elites=settings.elites,
            crossover=settings.crossover,
        )
    return EvolutionStrategy(
        population[0],
        noise,
        samples=settings.population,
        learning_rate=settings.learning_rate,
        anneal_over=settings.total_epochs(team) if settings.anneal else None,
        optimizer=settings.optimizer,
        momentum=settings.momentum,
    )
