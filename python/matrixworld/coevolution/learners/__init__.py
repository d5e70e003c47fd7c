"""Learners: algorithms that improve the genome of one team from the fitness of its candidates.

`learner` has their base, `Learner`, and parts that several share; each other file an algorithm. To
add one to the package, write a dataclass with that base in a file of its own, and name it in
`BuiltInLearner`.
"""

from __future__ import annotations

from typing import ClassVar, TypeAlias

from matrixworld.coevolution.learners.actor_critic import ActorCritic as ActorCritic
from matrixworld.coevolution.learners.cma_es import CmaEs
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategy
from matrixworld.coevolution.learners.genetic_algorithm import GeneticAlgorithm
from matrixworld.coevolution.learners.genetic_programming import GeneticProgramming
from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.sections import OwnCode, Section, section

BuiltInLearner: TypeAlias = (
    EvolutionStrategy | GeneticAlgorithm | CmaEs | GeneticProgramming | ActorCritic
)
"""The learners of the package."""


@section
class OwnLearner(OwnCode):
    """A learner of your own (see `Learner`)."""

    base: ClassVar[type[Section]] = Learner
