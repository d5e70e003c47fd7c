"""Learners: what improves one team's genome against the opponents handed to it.

A learner is asked for candidates, these are scored by whoever holds the opponents, and the
learner is told their fitness (the more the better)::

    candidates = learner.ask(rng)        # (n, genes) float32
    learner.tell(fitness)                # (n,)
    learner.genome                       # what goes into the archive

Random numbers come from the generator given to `ask` and from nothing else, and `tell` is
deterministic: a learner restored from `state` goes on as if it had never stopped. In `toolbox`
a learner becomes a DEAP toolbox. There are an `evolution_strategy`, a `genetic_algorithm` and, for
small networks, `cma_es`.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution.types import Genome, Genomes, State


class Learner(Protocol):
    """What a run needs of a learner."""

    @property
    def genome(self) -> Genome:
        """The genome (genes,) float32 that stands for the team: champion or mean."""

    @property
    def match_of_candidate(self) -> NDArray[np.intp]:
        """(n,) ints; candidates with the same number are scored on the same match seed."""

    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return the candidates (n, genes) float32 to be scored."""

    def tell(self, fitness: ArrayLike) -> None:
        """Learn from the fitness (n,) of the candidates last asked for."""

    def state(self) -> State:
        """Return all that changes, as plain arrays. Valid between `tell` and `ask`."""

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""


def checked_fitness(fitness: ArrayLike, n: int) -> NDArray[np.float64]:
    """Return `fitness` as (n,) float64; ValueError on another shape or a value not finite."""
    values = np.asarray(fitness, dtype=np.float64)
    if values.shape != (n,):
        raise ValueError(f"fitness: expected shape ({n},), got {values.shape}")
    if not np.isfinite(values).all():
        raise ValueError(f"fitness: expected finite numbers, got {values}")
    return values
