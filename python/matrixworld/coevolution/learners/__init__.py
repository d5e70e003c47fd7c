"""Learners: algorithms that improve the genome of one team from the fitness of its candidates.

====================  ============================================================================
learner               the interface: `Learner` (ask, tell), and `LearnerEntry`
registry              `LEARNERS`: name -> settings, checks and factory; untrained genomes
own                   learners from outside the package, with checked results
evolution_strategy    `EvolutionStrategy`: mirrored samples and ranks (Salimans et al. 2017)
genetic_algorithm     `GeneticAlgorithm`: select, mate, mutate, with elitism; the operators
cma_es                `CmaEs`: covariance matrix adaptation, for small networks
optimizers            `Adam`, `Momentum`: steps of gradient ascent
noise                 `NoiseTable`: normal numbers, drawn once and shared
toolbox               learners as DEAP toolboxes
====================  ============================================================================
"""

from __future__ import annotations

from matrixworld.coevolution.learners.cma_es import CmaEs
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategy, centred_ranks
from matrixworld.coevolution.learners.genetic_algorithm import (
    GeneticAlgorithm,
    mate_uniform,
    mutate_from_table,
    mutate_gaussian,
    select_tournament,
    select_truncation,
)
from matrixworld.coevolution.learners.learner import Learner, LearnerEntry
from matrixworld.coevolution.learners.noise import NoiseTable
from matrixworld.coevolution.learners.optimizers import Adam, Momentum, Optimizer
from matrixworld.coevolution.learners.registry import LEARNERS, new_learner, untrained
from matrixworld.coevolution.learners.toolbox import (
    Candidates,
    Individual,
    generate_update_toolbox,
)

__all__ = [
    "LEARNERS",
    "Adam",
    "Candidates",
    "CmaEs",
    "EvolutionStrategy",
    "GeneticAlgorithm",
    "Individual",
    "Learner",
    "LearnerEntry",
    "Momentum",
    "NoiseTable",
    "Optimizer",
    "centred_ranks",
    "generate_update_toolbox",
    "mate_uniform",
    "mutate_from_table",
    "mutate_gaussian",
    "new_learner",
    "select_tournament",
    "select_truncation",
    "untrained",
]
