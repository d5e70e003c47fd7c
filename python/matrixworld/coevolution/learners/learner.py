"""The interface of learners, and the base of their settings."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.sections import Section, setting
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, Stateful, Team

if TYPE_CHECKING:  # both import this module
    from matrixworld.coevolution.learners.actor_critic import Experience
    from matrixworld.coevolution.settings import RaceSettings


class Learner(Stateful, Protocol):
    """The interface of learners: ask for candidates, tell their fitness.

    A learner improves the genome of one team. A run asks it for candidates, plays their matches,
    and tells it their fitness (higher is better)::

        candidates = learner.ask(rng)        # (n, genes) float32
        learner.tell(fitness)                # (n,)
        learner.genome                       # genome that enters the archive

    Random numbers come only from the generator passed to `ask`, and `tell` is deterministic. A
    learner restored from `state` therefore continues as if it had never stopped.

    A class with these methods is named in the settings as ``module:object`` (see `own_code`), and
    `check_learner` checks it. It is made with those of the following keyword arguments that its
    signature names; all others are settings of its own:

    ===========  =======================================================================
    `genome`     (genes,) float32: where to start
    `genomes`    (samples, genes) float32: a population to start from
    `samples`    int: candidates per epoch, the n of this interface
    `epochs`     int: epochs of the whole run in which the team learns
    `rng`        generator for what is drawn once, such as a table of noise; it gives the
                 same numbers when a run continues
    ===========  =======================================================================
    """

    @property
    def genome(self) -> Genome:
        """The genome (genes,) float32 that represents the team: champion or mean."""

    @property
    def seed_groups(self) -> Indices:
        """Group of each candidate, (n,) ints from 0: one group is scored on the same match seed.

        All groups have the same size, and they are the same in all epochs. Zeros score all
        candidates on one seed.
        """

    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return the candidates (n, genes) float32, all finite, to be scored."""

    def tell(self, fitness: ArrayLike) -> None:
        """Learn from the fitness (n,) float64 of the candidates that the last `ask` returned."""


@runtime_checkable
class GradientLearner(Protocol):
    """What learners have besides `Learner` that learn from transitions instead of fitness.

    After the matches of an epoch a run collects what the agents of the team experienced in them::

        candidates = learner.ask(rng)        # (n, genes), n times the genome
        learner.learn(experience)            # transitions of all agents of the team
        learner.tell(fitness)
    """

    @property
    def sees_states(self) -> bool:
        """Whether the experience must have the states of the worlds."""

    def learn(self, experience: Experience) -> None:
        """Learn from the transitions of an epoch."""


@dataclass(frozen=True)
class LearnerSettings(Section):
    """Base of the settings of a learner; each has a class in the file of its learner.

    `new` returns the learner of a team, from genomes (n, genes) with n as `starting_genomes` says,
    and a generator for tables of noise.

    Parameters
    ----------
    population : int, optional
        Candidates per epoch.
    """

    by_gradients: ClassVar[bool] = False
    """Whether the learner learns from transitions (`GradientLearner`) instead of fitness."""
    rounds_by_processor: ClassVar[bool] = False
    """Whether results depend on the kind of processor, which workers of a cluster then share."""
    keeps_fixed_genes: ClassVar[bool] = False
    """Whether the learner leaves genes as they are, such as those of a mask."""

    population: int = setting(
        48, "candidates per epoch", by={"hall-of-fame": 24, "against": 128}, least=2
    )

    @property
    def starting_genomes(self) -> int:
        """Number of genomes from which the learner starts."""
        return 1

    @property
    def elite_matches(self) -> int:
        """New matches against each opponent at the end of a generation, to choose a champion."""
        return 0

    def check_run(self, run: RaceSettings) -> None:
        """Raise ValueError if the learner cannot work with the other settings of a run."""

    @abstractmethod
    def new(
        self, run: RaceSettings, team: Team, genomes: Genomes, rng: np.random.Generator
    ) -> Learner:
        """Return a new learner of a team."""


def checked_fitness(fitness: ArrayLike, n: int) -> FloatArray:
    """Return `fitness` as (n,) float64; ValueError if it has another shape or is not finite."""
    values = np.asarray(fitness, dtype=np.float64)
    if values.shape != (n,):
        raise ValueError(f"fitness: expected shape ({n},), got {values.shape}")
    # One NaN would spread to the whole genome, or be taken for the best.
    if not np.isfinite(values).all():
        raise ValueError(f"fitness: expected finite numbers, got {values}")
    return values
