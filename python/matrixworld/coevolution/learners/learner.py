"""What a learner is: its settings, and three functions of its state. Parts that learners share."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_floats, expect, shown
from matrixworld.coevolution import types
from matrixworld.coevolution.game import Game
from matrixworld.coevolution.sections import PluginError, Section, by_race, section
from matrixworld.coevolution.seeding import Purpose, keyed_generator
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, Rng, State

MUTATION = 0.05  # standard deviation of a mutation, unless another one is given


class DivergedError(ArithmeticError):
    """A learner has left the range of float32; the run holds what was before."""


@dataclass(frozen=True)
class Task:
    """What a learner starts from: a team of a run of a `seed`, in the `game` as it is evaluated.

    `team` is its number in `TEAMS`, `epochs` are those in which it learns. `untrained` draws a
    genome from a generator; a learner starts from `begin`, a genome (genes,), if there is one.
    """

    seed: int
    team: int
    epochs: int
    untrained: Callable[[Rng], Genome]
    begin: Genome | None
    game: Game

    @property
    def mask(self) -> Any:
        """Genes that do not change, and their values; None without any."""
        return self.game.mask(types.TEAMS[self.team])

    def genomes(self, count: int, sigma: float = MUTATION) -> Genomes:
        """Return genomes (count, genes) to start from: untrained ones, or `begin` and its mutants.

        The first ones do not depend on `count`. `sigma` is the standard deviation of the mutants.
        """
        rng = keyed_generator(self.seed, Purpose.INITIAL, self.team)
        if self.begin is None:
            genomes = np.stack([self.untrained(rng) for _ in range(count)])
        else:
            genomes = np.repeat(self.begin[np.newaxis], count, axis=0)
            noise = rng.standard_normal(genomes[1:].shape, dtype=np.float32)
            genomes[1:] += np.float32(sigma) * noise
        genomes = self.game.clipped(genomes)
        return genomes if self.mask is None else self.mask.write(genomes)

    def noise_state(self) -> State:
        """Return what a state holds of mutations: the key of their noise, and genes without."""
        key = np.array([self.seed, Purpose.NOISE, self.team], np.int64)
        state = {"noise": key, **self.bounds()}
        return state if self.mask is None else {**state, "fixed": self.mask.fixed}

    def bounds(self) -> State:
        """Return what a state holds of the bounds of genes; nothing without any."""
        bounds = self.game.bounds
        return {} if bounds is None else {"low": np.array(bounds[0]), "high": np.array(bounds[1])}


def _no_experience(**options: Any) -> Any:
    raise TypeError("experience: expected matches of a run, got fitness alone")


@dataclass(frozen=True)
class Results:
    """The `fitness` (n,) of the candidates of an epoch; higher is better.

    Where all candidates are equal, `experience` plays their matches once more and returns what the
    agents of the team saw, did and earned; with ``states=True`` also the states of the world.
    """

    fitness: FloatArray
    experience: Callable[..., Any] = _no_experience


@section
class Learner(Section):
    """Base of the learners. A learner is its settings; its state is a dict of arrays.

    ::

        state = learner.start(task)
        in each epoch:
            candidates, state = learner.ask(state, rng)     # (n, genes) float32
            state = learner.tell(state, results)            # their fitness (n,)
        learner.genome(state)                               # genome that enters the archive

    The state between `tell` and `ask` is what a checkpoint holds. No method changes the arrays that
    it gets; random numbers come only from the generator of `ask`. A learner of your own is a frozen
    dataclass with this base, in the settings itself or by its name ``module:object``, with fields
    of numbers, text, true or false: see `check_learner`. With a field ``anneal`` that is true, a
    race cannot become longer.
    """

    ignores: ClassVar[tuple[str, ...]] = ("policy.mask",)
    """Settings of a run, or sections of them, that have no effect with the learner."""
    policies: ClassVar[tuple[str, ...]] = ("cells", "rating")
    """Kinds of policies in pursuit whose genomes the learner improves."""
    any_game: ClassVar[bool] = True
    """Whether it improves any vectors, and so the genomes of a game of your own, too."""
    defaults: ClassVar[Mapping[str, Any]] = {}
    """Settings of a run that have other defaults with the learner, by their paths."""
    learning_time: ClassVar[float] = 1.0
    """About how long a training match takes with what is learned from it, in times of another."""
    steps: ClassVar[tuple[str, ...]] = ()
    """Settings that say how far the learner goes at a time: too far, if it diverges."""

    population: int = by_race(48, "candidates per epoch", least=2)

    @abstractmethod
    def start(self, task: Task) -> State:
        """Return the state before the first epoch."""

    @abstractmethod
    def ask(self, state: State, rng: Rng) -> tuple[Genomes, State]:
        """Return the candidates (n, genes) float32 to be scored, and the state for `tell`."""

    @abstractmethod
    def tell(self, state: State, results: Results) -> State:
        """Return the state after learning from the results of the candidates."""

    def genome(self, state: State) -> Genome:
        """Return the genome (genes,) float32 that represents the team: champion or mean."""
        return state["genome"]

    @property
    def seed_groups(self) -> Indices:
        """Group of each candidate, (n,) ints from 0: one group is scored on the same match seed.

        All groups have the same size. By default all candidates are one group.
        """
        return np.zeros(self.population, dtype=np.intp)

    def check_fits(self, path: str, game: Game) -> None:
        """Raise ValueError if the learner, of the setting `path`, cannot learn in a game."""

    def check_machine(self) -> None:
        """Raise ModuleNotFoundError or ValueError if this machine lacks what the learner needs."""

    def untrained(self, game: Game, team: types.Team, rng: Rng) -> Genome:
        """Return an untrained genome of a team."""
        return game.untrained(team, rng)

    def diverged(
        self, path: str, problem: str = "expected finite genes, got NaN or infinity"
    ) -> DivergedError:
        """Return the error for genes that are too large; `path` is the setting of the learner."""
        named = [f"{path}.{name} (now {getattr(self, name):g})" for name in self.steps]
        lower = f"; lower {' or '.join(named)}" if named else ""
        name = self.kind or type(self).__name__
        return DivergedError(f"{path} {name}: {problem}: it diverges{lower}")


@section
class Generational(Learner):
    """Base of learners whose candidates are a population, of which the next one is made."""

    ignores: ClassVar[tuple[str, ...]] = ()

    def check(self) -> None:
        """Raise ValueError for too many elites, which are a setting of each of these learners."""
        elites, most = vars(self)["elites"], self.population
        expect(most is None or elites < most, "elites", f"fewer than {most}", elites)

    @abstractmethod
    def offspring(self, state: State, rng: Rng) -> Genomes:
        """Return the population after a scored one: its elites unchanged, and then children."""

    def genome(self, state: State) -> Genome:
        """Return the champion of the last scored population."""
        genome: Genome = state["population"][int(state["champion"])]
        return genome

    def ask(self, state: State, rng: Rng) -> tuple[Genomes, State]:
        """Return the next population: at first as given, later elites and children."""
        genomes = self.offspring(state, rng) if len(state["fitness"]) else state["population"]
        return genomes, {**state, "candidates": genomes}

    def tell(self, state: State, results: Results) -> State:
        """Make the candidates the population, with this fitness."""
        before = {name: value for name, value in state.items() if name != "candidates"}
        population = state["candidates"]
        fitness = checked_fitness(results.fitness, len(population))
        champion = np.array(np.argmax(fitness))
        return {**before, "population": population, "fitness": fitness, "champion": champion}


def unscored(population: Genomes) -> State:
    """Return the state of a population that nobody has scored yet."""
    return {"population": population, "fitness": np.zeros(0), "champion": np.array(0)}


def check_genomes(name: str, array: Any, shape: tuple[int, ...]) -> None:
    """Raise PluginError unless a learner's method `name` has returned float32 of a shape."""
    is_array = isinstance(array, np.ndarray) and not isinstance(array, np.ma.MaskedArray)
    if not is_array or (array.dtype, array.shape) != (np.float32, shape):
        got = f"{array.dtype} {array.shape}" if is_array else shown(array)
        raise PluginError(f"{name}: expected an array of float32 {shape}, got {got}")


def checked_fitness(fitness: ArrayLike, n: int) -> FloatArray:
    """Return `fitness` as (n,) float64; ValueError if it has another shape or is not finite."""
    values = check_floats("fitness", fitness)
    expect(values.shape == (n,), "fitness", f"shape ({n},)", values.shape)
    # One NaN would spread to the whole genome, or be taken for the best.
    expect(np.isfinite(values).all(), "fitness", "finite numbers", values)
    return values


# Selection:


def select_tournament(fitness: FloatArray, k: int, rng: Rng, *, size: int) -> Indices:
    """Return the parents (k,): each the fittest of `size` random entrants; size 1 is random."""
    entrants = rng.integers(0, len(fitness), size=(k, size))
    # Rows are tournaments; of equal fitness the first entrant wins, and their order is random.
    winners = np.argmax(fitness[entrants], axis=1)
    selected: Indices = entrants[np.arange(k), winners]
    return selected


def fittest(fitness: FloatArray, k: int) -> Indices:
    """Return the k fittest individuals, the fittest first; of equals the first."""
    return np.argsort(-fitness, kind="stable")[:k]


def inside_bounds(state: State, genomes: Genomes) -> Genomes:
    """Return genomes clipped to the bounds that a state holds."""
    return np.clip(genomes, state["low"], state["high"]) if "low" in state else genomes


# Noise vectors as windows of one long row of normal numbers:

VECTORS_PER_TABLE = 256
MOST_EXTRA_NUMBERS = 2**24  # bound of the table's memory: 64 MiB beyond one noise vector


def table_length(genes: int) -> int:
    """Return how many numbers the table of noise vectors for so many genes has."""
    return genes + min(VECTORS_PER_TABLE * genes, MOST_EXTRA_NUMBERS)


@lru_cache(maxsize=4)  # both teams of two runs; made again from its key where it is missing
def _table(key: tuple[int, ...], genes: int, sigma: float) -> Genome:
    seed, purpose, team = key
    rng = keyed_generator(seed, Purpose(purpose), team)
    numbers = rng.standard_normal(table_length(genes), dtype=np.float32)
    with np.errstate(over="ignore"):
        numbers *= np.float32(sigma)
    numbers.flags.writeable = False
    return numbers


def draw_windows(count: int, genes: int, rng: Rng) -> Indices:
    """Return where the windows of `count` noise vectors begin."""
    # The last window may end with the table, hence the endpoint.
    return rng.integers(0, table_length(genes) - genes, size=count, endpoint=True)


def noise_of(state: State, windows: Indices, genes: int, sigma: float) -> list[Genome]:
    """Return noise vectors (genes,) float32 with standard deviation sigma, not to be written to."""
    # To draw a normal number for each gene of each candidate costs more time than all other work of
    # a learner. A window at a random place of a long shared table serves as well (Salimans et al.
    # 2017, section 2.1; for genetic algorithms Such et al. 2017, arXiv:1712.06567).
    table = _table(tuple(map(int, state["noise"])), genes, sigma)
    vectors = [table[start : start + genes] for start in windows]
    if "fixed" not in state:
        return vectors
    return [np.where(state["fixed"], np.float32(0.0), vector) for vector in vectors]


# Steps of gradient ascent:

ANNEALED = 0.1  # share of a learning rate that is left after annealing


def annealed(updates: int, over: int) -> float:
    """Return the share of a rate after some updates, if it falls linearly `over` so many."""
    return 1.0 - (1.0 - ANNEALED) * min(1.0, updates / over)


def adam_state(genes: int, prefix: str = "") -> State:
    """Return averages of Adam before its first step; names in a state begin with `prefix`."""
    zeros = np.zeros(genes, dtype=np.float32)
    return {f"{prefix}mean": zeros, f"{prefix}square": zeros, f"{prefix}updates": np.array(0)}


def adam(state: State, gradient: Genome, rate: float, prefix: str = "") -> tuple[Genome, State]:
    """Return the change (genes,) for a gradient, in ascent, and averages: Kingma & Ba 2015."""
    beta1, beta2, epsilon = 0.9, 0.999, 1e-8
    mean, square = state[f"{prefix}mean"], state[f"{prefix}square"]
    updates = int(state[f"{prefix}updates"]) + 1
    mean = mean + (1 - beta1) * (gradient - mean)
    square = square + (1 - beta2) * (gradient * gradient - square)
    # Both averages start at zero; the divisions correct their bias in the first steps.
    unbiased, spread = mean / (1 - beta1**updates), square / (1 - beta2**updates)
    change: Genome = np.float32(rate) * unbiased / (np.sqrt(spread) + epsilon)
    names = (f"{prefix}mean", f"{prefix}square", f"{prefix}updates")
    return change, dict(zip(names, (mean, square, np.array(updates)), strict=True))
