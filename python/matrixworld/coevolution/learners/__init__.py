"""Learners: algorithms that improve the genome of one team from the fitness of its candidates.

`learner` has the interface, `Learner`; each other file an algorithm with its settings. To add one
to the package, write a class with that interface and a subclass of `LearnerSettings` in a file of
its own, and name the settings in `BuiltInLearner`. Everywhere here, a value out of range or of
another shape raises a ValueError that names it.
"""

from __future__ import annotations

from typing import TypeAlias

from matrixworld.coevolution.learners.actor_critic import ActorCriticSettings
from matrixworld.coevolution.learners.cma_es import CmaEsSettings
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategySettings
from matrixworld.coevolution.learners.genetic_algorithm import GeneticAlgorithmSettings

BuiltInLearner: TypeAlias = (
    EvolutionStrategySettings | GeneticAlgorithmSettings | CmaEsSettings | ActorCriticSettings
)
"""The learners of the package, by their settings."""
