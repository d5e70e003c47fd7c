"""Learners: algorithms that improve the genome of one team from the fitness of its candidates.

`learner` has the interface, `Learner`; each other file an algorithm with its settings. To add one
to the package, write a class with that interface and a subclass of `LearnerSettings` in a file of
its own, and name the settings in the type of `RaceSettings.learner`.
"""

from __future__ import annotations

from matrixworld.coevolution.learners.actor_critic import ActorCritic, ActorCriticSettings
from matrixworld.coevolution.learners.cma_es import CmaEs, CmaEsSettings
from matrixworld.coevolution.learners.evolution_strategy import (
    EvolutionStrategy,
    EvolutionStrategySettings,
    centred_ranks,
)
from matrixworld.coevolution.learners.genetic_algorithm import (
    GeneticAlgorithm,
    GeneticAlgorithmSettings,
    mate_uniform,
    mutate_from_table,
    mutate_gaussian,
    select_tournament,
    select_truncation,
)
from matrixworld.coevolution.learners.learner import GradientLearner, Learner, LearnerSettings
from matrixworld.coevolution.learners.noise import NoiseTable
from matrixworld.coevolution.learners.optimizers import Adam, Momentum, Optimizer
from matrixworld.coevolution.learners.toolbox import (
    Candidates,
    Individual,
    generate_update_toolbox,
)

__all__ = [
    "ActorCritic",
    "ActorCriticSettings",
    "Adam",
    "Candidates",
    "CmaEs",
    "CmaEsSettings",
    "EvolutionStrategy",
    "EvolutionStrategySettings",
    "GeneticAlgorithm",
    "GeneticAlgorithmSettings",
    "GradientLearner",
    "Individual",
    "Learner",
    "LearnerSettings",
    "Momentum",
    "NoiseTable",
    "Optimizer",
    "centred_ranks",
    "generate_update_toolbox",
    "mate_uniform",
    "mutate_from_table",
    "mutate_gaussian",
    "select_tournament",
    "select_truncation",
]
