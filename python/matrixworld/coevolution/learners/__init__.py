"""Learners: algorithms that improve the genome of one team from the fitness of its candidates.

`learner` has their base, `Learner`. Parts of learners are in `fitness`, `generational`, `noise`,
`optimizers`, `networks` and `selection`, and checks of learners of your own in `promises`; each
other file is an algorithm. To add one to the package, write a section with that base in a file of
its own, and import it here.
"""

from __future__ import annotations

from typing import ClassVar

from matrixworld._util.own_code import OwnCode
from matrixworld._util.sections import NAMES, OWN, Named, Section, section
from matrixworld.coevolution.learners.actor_critic import ActorCritic as ActorCritic
from matrixworld.coevolution.learners.breeding import Breeding as Breeding
from matrixworld.coevolution.learners.cma_es import CmaEs as CmaEs
from matrixworld.coevolution.learners.evolution_strategy import (
    EvolutionStrategy as EvolutionStrategy,
)
from matrixworld.coevolution.learners.genetic_algorithm import GeneticAlgorithm as GeneticAlgorithm
from matrixworld.coevolution.learners.genetic_programming import (
    GeneticProgramming as GeneticProgramming,
)
from matrixworld.coevolution.learners.learner import Learner


@section()
class OwnLearner(OwnCode):
    """A learner of your own (see `Learner`)."""

    base: ClassVar[type[Section]] = Learner


FIRST = ("es", "ga", "cma", "gp", "actor-critic", "breeding")
"""The names that are listed first; a learner of the package that is none of them comes after."""
NAMES[Learner] = {
    **{name: NAMES[Learner][name] for name in FIRST},
    **NAMES[Learner],
    OWN: Named(OwnLearner),
}
