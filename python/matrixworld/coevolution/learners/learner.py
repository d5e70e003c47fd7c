"""The interface of learners, and what the registry holds of each."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeAlias, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.learners.experience import Experience
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, State, Team

RunSettings: TypeAlias = Any
"""Settings of a run: `RaceSettings` or `SingleSettings`. They import the registry of learners, so
learners cannot import them."""


class Learner(Protocol):
    """The interface of learners: ask for candidates, tell their fitness.

    A learner improves the genome of one team. A run asks it for candidates, plays their matches,
    and tells it their fitness (higher is better)::

        candidates = learner.ask(rng)        # (n, genes) float32
        learner.tell(fitness)                # (n,)
        learner.genome                       # genome that enters the archive

    Random numbers come only from the generator passed to `ask`, and `tell` is deterministic. A
    learner restored from `state` therefore continues as if it had never stopped.

    A class with these methods is named in the settings as ``module:object`` (see `plugins`), and
    `check_learner` checks it. It is made with those of the following keyword arguments that its
    signature names; all others are settings of its own (`learner_settings`):

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
    def match_of_candidate(self) -> Indices:
        """Group of each candidate, (n,) ints from 0: one group is scored on the same match seed.

        All groups have the same size, and they are the same in all epochs. Zeros score all
        candidates on one seed.
        """

    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return the candidates (n, genes) float32, all finite, to be scored."""

    def tell(self, fitness: ArrayLike) -> None:
        """Learn from the fitness (n,) float64 of the candidates that the last `ask` returned."""

    def state(self) -> State:
        """Return all that changes, as arrays of numbers or text; called between `tell` and `ask`.

        Names are identifiers.
        """

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`, of this or of an equal learner.

        The learner may have gone further, and may have been interrupted after `ask`.
        """


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
class LearnerEntry:
    """A learner's settings, their checks, and its factory: a row of the registry `LEARNERS`.

    `own_learner` returns one for a class from outside the package.

    Parameters
    ----------
    title : str
        Full name, for help texts.
    settings : mapping of str to callable
        Fields of `TrainingSettings` that this learner reads besides `population`, and the check of
        each value: ``check(name, value)`` raises ValueError or TypeError. The values are checked
        whichever learner is chosen, so that a bad value is never ignored.
    check : callable
        ``check(settings)`` raises ValueError if the learner cannot work with the settings
        together: population, limit of genes. Called for the chosen learner only.
    new : callable
        ``new(settings, team, genomes, rng)`` returns the learner of a team. `genomes` (n, genes)
        are those to start from; `rng` is a generator for tables of noise.
    starts_from_population : bool, optional
        Whether the learner starts from `settings.population` genomes instead of one. The default
        is False.
    by_gradients : bool, optional
        Whether the learner learns from transitions (see `GradientLearner`) instead of fitness. The
        default is False.
    like_processors : bool, optional
        Whether results depend on the kind of processor, so that all workers of a cluster need the
        same one. The default is False.
    keeps_fixed_genes : bool, optional
        Whether the learner leaves the genes as they are that `settings.fixed_genes(team)` marks,
        such as those of a mask. The default is False.
    defaults : mapping of str to object, optional
        Defaults of settings that are not those of the other learners.
    """

    title: str
    settings: Mapping[str, Callable[[str, Any], object]]
    check: Callable[[RunSettings], None]
    new: Callable[[RunSettings, Team, Genomes, np.random.Generator], Learner]
    starts_from_population: bool = False
    by_gradients: bool = False
    like_processors: bool = False
    keeps_fixed_genes: bool = False
    defaults: Mapping[str, Any] = field(default_factory=dict)


def checked_fitness(fitness: ArrayLike, n: int) -> FloatArray:
    """Return `fitness` as (n,) float64; ValueError if it has another shape or is not finite."""
    values = np.asarray(fitness, dtype=np.float64)
    if values.shape != (n,):
        raise ValueError(f"fitness: expected shape ({n},), got {values.shape}")
    # One NaN would spread to the whole genome, or be taken for the best.
    if not np.isfinite(values).all():
        raise ValueError(f"fitness: expected finite numbers, got {values}")
    return values
