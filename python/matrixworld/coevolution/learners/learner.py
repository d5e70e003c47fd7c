"""The interface of learners, the base of their settings, and parts that several learners share."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import (
    check_floats,
    check_instance,
    check_integer,
    check_number,
    shown,
)
from matrixworld.coevolution.sections import Section, setting
from matrixworld.coevolution.types import (
    BoolArray,
    FloatArray,
    Genome,
    Genomes,
    Indices,
    Saved,
    Stateful,
)
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network

MUTATION = 0.05
"""Standard deviation of a mutation, unless another one is given."""


class DivergedError(ArithmeticError):
    """A learner of the package has left the range of float32; the run holds what was before."""


class Learner(Stateful, Protocol):
    """The interface of learners: ask for candidates, tell their fitness.

    A learner improves the genome of one team. A run asks it for candidates, plays their matches,
    and tells it their fitness (higher is better)::

        candidates = learner.ask(rng)        # (n, genes) float32
        learner.tell(fitness)                # (n,)
        learner.genome                       # genome that enters the archive

    Random numbers come only from the generator passed to `ask`, and `tell` is deterministic. A
    learner restored from `state` therefore continues as if it had never stopped.

    Settings take a class with these methods, itself or as ``module:object`` (see `own_code`), and
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


@dataclass(frozen=True)
class Task:
    """What a run gives to a new learner of a team."""

    genomes: Genomes
    """(n, genes) to start from, with n as `LearnerSettings.starting_genomes` says."""
    rng: np.random.Generator
    """For what is drawn once, such as a table of noise."""
    world: WorldConfig
    network: Network
    epochs: int
    """Epochs of the whole run in which the team learns."""
    fixed: BoolArray | None = None
    """Genes (genes,) that do not change, such as those of a mask."""


@dataclass(frozen=True)
class LearnerSettings(Section):
    """Base of the settings of a learner: what a run has to know of it, and how it is made.

    Parameters
    ----------
    population : int, optional
        Candidates per epoch.
    """

    by_gradients: ClassVar[bool] = False
    """Whether the learner learns from its matches themselves instead of their fitness.

    It then has a method `learn_from`, which a run calls after the matches of an epoch, and before
    `tell`, with the keyword arguments of `transitions.experience` that describe these matches.
    """
    keeps_fixed_genes: ClassVar[bool] = False
    """Whether the learner leaves genes as they are, such as those of a mask."""
    keeps_population: ClassVar[bool] = False
    """Whether candidates are individuals of a population, instead of samples around one genome."""
    learning_time: ClassVar[float] = 1.0
    """About how long a training match takes with what is learned from it, in times of another."""
    steps: ClassVar[tuple[str, ...]] = ()
    """Settings that say how far the learner goes at a time: too far, if it diverges."""

    population: int = setting(
        48, "candidates per epoch", by={"hall-of-fame": 24, "against": 128}, least=2
    )

    @property
    def conditions(self) -> tuple[str, ...]:
        """Names under which a setting may have another default with this learner."""
        return (self.kind, "gradients") if self.by_gradients else (self.kind,)

    @property
    def starting_genomes(self) -> int:
        """Number of genomes from which the learner starts."""
        return self.population if self.keeps_population else 1

    @property
    def first_sigma(self) -> float:
        """Standard deviation of the mutants of a genome from which a population starts."""
        return MUTATION

    @property
    def elite_matches(self) -> int:
        """New matches against each opponent at the end of a generation, to choose a champion.

        If there are any, the learner has `elite_genomes` and `choose_champion`.
        """
        return 0

    def check_fits(self, path: str, world: WorldConfig, network: Network) -> None:
        """Raise ValueError if the learner cannot learn in a world, or such a network.

        `path` is the setting that has the learner.
        """

    def untrained(
        self, network: Network, rng: np.random.Generator, *, weight: float, head: float
    ) -> Genome:
        """Return an untrained genome; `weight` and `head` are scales of hidden and last layer."""
        return network.initial(rng, weight=weight, head=head)

    def population_of(self, genome: Genome, rng: np.random.Generator) -> Genomes:
        """Return genomes (`starting_genomes`, genes) to start from: a genome, and mutants of it."""
        population = np.repeat(genome[np.newaxis], self.starting_genomes, axis=0)
        noise = rng.standard_normal(population[1:].shape, dtype=np.float32)
        population[1:] += np.float32(self.first_sigma) * noise
        return population

    def diverged(self, path: str) -> DivergedError:
        """Return the error for genes that are not finite; `path` is the setting of the learner."""
        named = [f"{path}.{name} (now {getattr(self, name):g})" for name in self.steps]
        lower = f"; lower {' or '.join(named)}" if named else ""
        return DivergedError(
            f"{path} {self.kind}: expected finite genes, got NaN or infinity: it diverges{lower}"
        )

    @abstractmethod
    def new(self, task: Task) -> Learner:
        """Return a new learner of a team."""


def checked_fitness(fitness: ArrayLike, n: int) -> FloatArray:
    """Return `fitness` as (n,) float64; ValueError if it has another shape or is not finite.

    n is the number of candidates that were asked for; RuntimeError if there are none.
    """
    if not n:
        raise RuntimeError("tell: expected a call of ask before it, got none")
    values = check_floats("fitness", fitness)
    if values.shape != (n,):
        raise ValueError(f"fitness: expected shape ({n},), got {values.shape}")
    # One NaN would spread to the whole genome, or be taken for the best.
    if not np.isfinite(values).all():
        raise ValueError(f"fitness: expected finite numbers, got {values}")
    return values


# Parts: a table of normal numbers, and steps of gradient ascent.

VECTORS_PER_TABLE = 256
MOST_EXTRA_NUMBERS = 2**24
"""Bound of the table's memory: 64 MiB beyond one noise vector."""


def table_length(size: int) -> int:
    """Return how many numbers the table of noise vectors of a size has."""
    return size + min(VECTORS_PER_TABLE * size, MOST_EXTRA_NUMBERS)


class NoiseTable:
    """Noise vectors as windows of one long row of normal numbers.

    To draw a normal number for each gene of each candidate costs more time than all other work of a
    learner. A window at a random place of a long shared table serves as well and costs nothing
    (Salimans et al. 2017, section 2.1; for genetic algorithms Such et al. 2017, arXiv:1712.06567).

    Parameters
    ----------
    size : int
        Length of a noise vector (genes), at least 1.
    rng : numpy.random.Generator
        Generator that fills the table.
    sigma : float
        Standard deviation of the numbers, in units of the genes, above 0.
    fixed : ndarray of bool, shape (size,), optional
        Genes without noise. By default none.
    """

    def __init__(
        self,
        size: int,
        rng: np.random.Generator,
        *,
        sigma: float,
        fixed: BoolArray | None = None,
    ) -> None:
        self.size: int = check_integer("size", size, 1)
        self.sigma: float = check_number("sigma", sigma, least=0.0, positive=True)
        self.fixed: BoolArray | None = fixed
        check_instance("rng", rng, np.random.Generator)
        self._numbers = rng.standard_normal(table_length(size), dtype=np.float32)
        with np.errstate(over="ignore"):
            self._numbers *= np.float32(sigma)
        # Views of the table leave this class, so nothing may write to it.
        self._numbers.flags.writeable = False

    def draw(self, count: int, rng: np.random.Generator) -> list[Genome]:
        """Return `count` noise vectors (size,) float32, not to be written to."""
        # The last window may end with the table, hence the endpoint.
        starts = rng.integers(0, len(self._numbers) - self.size, size=count, endpoint=True)
        windows = [self._numbers[start : start + self.size] for start in starts]
        if self.fixed is None:
            return windows
        return [np.where(self.fixed, np.float32(0.0), window) for window in windows]


ANNEALED = 0.1
"""Share of a learning rate that is left after annealing."""


def annealed(updates: int, over: int | None) -> float:
    """Return the share of a rate after some updates, if it falls linearly `over` so many."""
    return 1.0 if over is None else 1.0 - (1.0 - ANNEALED) * min(1.0, updates / over)


class Adam(Saved):
    """Steps of Adam, in ascent (Kingma & Ba 2015, algorithm 1), with the constants given there."""

    saved: ClassVar[tuple[str, ...]] = ("mean", "square", "updates")

    def __init__(self, size: int) -> None:
        self.mean: Genome = np.zeros(size, dtype=np.float32)
        self.square: Genome = np.zeros(size, dtype=np.float32)
        self.updates = 0

    def step(self, gradient: Genome, rate: float) -> Genome:
        """Return the change (size,) float32 for one `gradient` at learning rate `rate`."""
        beta1, beta2, epsilon = 0.9, 0.999, 1e-8
        self.updates += 1
        # In place, and in float32 throughout: both averages are as long as the genome.
        self.mean += (1 - beta1) * (gradient - self.mean)
        self.square += (1 - beta2) * (gradient * gradient - self.square)
        # Both averages start at zero; the divisions correct their bias in the first steps.
        mean = self.mean / (1 - beta1**self.updates)
        square = self.square / (1 - beta2**self.updates)
        change: Genome = np.float32(rate) * mean / (np.sqrt(square) + epsilon)
        return change


class Momentum(Saved):
    """Steps of classical momentum, in ascent: ``v = momentum * v + rate * gradient``.

    Unlike with Adam, the length of a step follows that of the gradient. Polyak 1964; as written by
    Sutskever et al. 2013, "On the importance of initialization and momentum in deep learning".
    """

    saved: ClassVar[tuple[str, ...]] = ("velocity", "updates")

    def __init__(self, size: int, momentum: float) -> None:
        check_momentum(momentum)
        self.momentum = momentum
        self.velocity: Genome = np.zeros(size, dtype=np.float32)
        self.updates = 0

    def step(self, gradient: Genome, rate: float) -> Genome:
        """Return the change (size,) float32 for one `gradient` at learning rate `rate`."""
        self.updates += 1
        kept: Genome = np.float32(self.momentum) * self.velocity
        self.velocity = kept + np.float32(rate) * gradient
        return self.velocity


def check_momentum(momentum: float) -> None:
    """Raise ValueError unless the share of the last step that is kept is in [0, 1)."""
    if check_number("momentum", momentum, least=0.0) >= 1.0:
        raise ValueError(f"momentum: expected a number below 1, got {shown(momentum)}")
