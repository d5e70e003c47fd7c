"""What a learner is: its settings, and functions of its state; and what it starts and learns from.

Parts of learners are in `fitness`, `generational`, `noise`, `optimizers` and `selection`.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_floats, shown
from matrixworld._util.constraints import OneOf, Whole
from matrixworld._util.plugins import PluginError
from matrixworld._util.sections import Section, SettingError, section, setting
from matrixworld.coevolution import types
from matrixworld.coevolution.games.game import Game, GameSettings, Scores, clipped
from matrixworld.coevolution.games.operators import Operators, are_texts, as_genomes
from matrixworld.coevolution.games.pursuit import FITNESS, REWARDED, PursuitSettings
from matrixworld.coevolution.learners.fitness import (
    COMPETITIVE,
    NO_SHARING,
    Table,
    feasible_first,
    mean_over_opponents,
    shared_fitness,
)
from matrixworld.coevolution.learners.noise import Noise
from matrixworld.coevolution.seeding import Purpose, keyed_generator
from matrixworld.coevolution.states import State
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, Rng, Team

MUTATION = 0.05  # standard deviation of a mutation, unless another one is given


class DivergedError(ArithmeticError):
    """A learner has left the range of float32; the run holds what was before."""


class Bounds(NamedTuple):
    """Least and largest value of the genes, as a state holds them."""

    low: NDArray[np.float32]
    high: NDArray[np.float32]


@dataclass(frozen=True, eq=False)
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

        The first ones do not depend on `count`. `sigma` is the standard deviation of the mutants of
        vectors; the game mutates objects itself.
        """
        rng = keyed_generator(self.seed, Purpose.INITIAL, self.team)
        if self.begin is not None and self.game.texts:
            begin = self.begin[np.newaxis]
            operators = self.game.operators[types.TEAMS[self.team]]
            mutants = [operators.child(begin, rng, mutates=True) for _ in range(count - 1)]
            return np.concatenate([begin, as_genomes(mutants)])
        if self.begin is None:
            genomes = np.stack([self.untrained(rng) for _ in range(count)])
        else:
            genomes = np.repeat(self.begin[np.newaxis], count, axis=0)
            noise = rng.standard_normal(genomes[1:].shape, dtype=np.float32)
            genomes[1:] += np.float32(sigma) * noise
        genomes = clipped(genomes, self.game.bounds)
        if self.mask is not None:
            genomes = self.mask.write(genomes)
        return genomes

    def noise(self) -> Noise:
        """Return what a state holds of mutations."""
        key = np.array([self.seed, Purpose.NOISE, self.team], np.int64)
        return Noise(key, None if self.mask is None else self.mask.fixed)

    def bounds(self) -> Bounds | None:
        """Return what a state holds of the bounds of genes; None without any."""
        if self.game.bounds is None:
            return None
        low, high = self.game.bounds
        return Bounds(np.array(low), np.array(high))


def _outside(*_: Any) -> Any:
    raise TypeError("operators: expected those of a game, got a learner outside of a race")


OUTSIDE = Operators(_outside, _outside)
"""The operators of a learner that is in no race."""


def _no_experience(**options: Any) -> Any:
    raise TypeError("experience: expected matches of a run, got fitness alone")


@dataclass(frozen=True, eq=False)
class Results:
    """The `fitness` (n,) of the candidates of an epoch; higher is better.

    Where all candidates are equal, `experience` plays their matches once more and returns what the
    agents of the team saw, did and earned; with ``states=True`` also the states of the world.
    """

    fitness: FloatArray
    experience: Callable[..., Any] = _no_experience


@section()
class Learner(Section):
    """Base of the learners. A learner is its settings; its state is a tuple, or a dict, of arrays.

    ::

        state = learner.start(task)
        in each epoch:
            candidates, state = learner.ask(state, rng)     # (n, genes) float32, or (n, 1) text
            state = learner.tell(state, results)            # their fitness (n,)
        learner.genome(state)                               # genome that enters the archive

    The state between `tell` and `ask` is what a checkpoint holds. No method changes the arrays that
    it gets; random numbers come only from the generator of `ask`. A learner of your own is a frozen
    dataclass with this base, or with `Evolutionary` to be selected by any measure, in the settings
    itself or by its name ``module:object``, with fields of numbers, text, true or false: see
    `check_learner`. With a field ``anneal`` that is true, a race cannot become longer.

    A learner with ``texts = True`` improves genomes that are objects: arrays (n, 1) of text, which
    its `operators` mutate and mate. These are no setting, but those of the game of its race.
    """

    policies: ClassVar[tuple[str, ...]] = ("cells", "rating")
    """Kinds of policies in pursuit whose genomes the learner improves."""
    any_game: ClassVar[bool] = True
    """Whether it improves any vectors, and so the genomes of a game of your own, too."""
    texts: ClassVar[bool] = False
    """Whether it improves objects in place of vectors, as arrays (n, 1) of text, by `operators`."""
    keeps_mask: ClassVar[bool] = False
    """Whether it leaves the weights of a mask in a network as they are."""
    replays: ClassVar[bool] = False
    """Whether it learns from the rewards of matches that are played again (`Results`)."""
    learning_time: ClassVar[float] = 1.0
    """About how long a training match takes with what is learned from it, in times of another."""
    steps: ClassVar[tuple[str, ...]] = ()
    """Settings that say how far the learner goes at a time: too far, if it diverges."""

    population: int = setting(48, "candidates per epoch", Whole(2))
    operators: Operators = field(default=OUTSIDE, compare=False, repr=False, kw_only=True)

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
        genome: Genome = state["genome"] if isinstance(state, dict) else state.genome
        return genome

    def fitness(self, game: Game, scores: Scores, team: Team, table: Table) -> FloatArray:
        """Return the fitness (n,) of a team's candidates from their matches (M,)."""
        return mean_over_opponents(table(game.values(scores, team, FITNESS[0]).mean(axis=1)))

    @property
    def rewarded(self) -> bool:
        """Whether the rewards of a world have an effect."""
        return self.replays

    @property
    def seed_groups(self) -> Indices:
        """Group of each candidate, (n,) ints from 0: one group is scored on the same match seed.

        All groups have the same size. By default all candidates are one group.
        """
        return np.zeros(self.population, dtype=np.intp)

    def check_race(self, path: str, game: GameSettings) -> None:
        """Raise SettingError if the learner, of the setting `path`, cannot learn what is raced."""
        name = self.kind or type(self).__name__
        if isinstance(game, PursuitSettings):
            policy = game.policy
            if not self.policies:
                raise SettingError(path, "a learner of vectors in pursuit and evasion", name)
            if policy.kind not in self.policies:
                expected = f"{' or '.join(self.policies)} with the learner {name}"
                raise SettingError("policy", expected, policy.kind, fits=self.policies[0])
            if policy.kind == "cells" and policy.mask != "none" and not self.keeps_mask:
                raise SettingError("policy.mask", f"'none' with {name}", repr(policy.mask))
        elif self.texts != game.known.texts or not self.any_game:
            expected = "es, ga, cma or your own in a game of your own"
            if game.known.texts:
                kind = f"{game.variant} has genomes of any kind"
                expected = f"breeding, or your own for text ({kind})"
            raise SettingError(path, expected, name)
        # A run is read without an import of its game.
        self.check_fits(path, game.known)

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


@section()
class Evolutionary(Learner):
    """Base of learners that select candidates by their fitness."""

    measure: str = setting(
        FITNESS[0],
        f"what candidates are selected by: {', '.join(FITNESS)} (of one team alone, in a world "
        "that can be solved)",
        OneOf(FITNESS),
    )
    cost_limit: float | None = setting(
        None,
        "collisions at fault per 1000 agent-steps; candidates within it rank first; default: no "
        "limit",
    )
    sharing: str = setting(
        NO_SHARING,
        f"fitness sharing over several opponents: {NO_SHARING} or {COMPETITIVE}",
        OneOf((NO_SHARING, COMPETITIVE)),
    )

    def check(self) -> None:
        """Raise SettingError for sharing of rewards, which are not in [0, 1]."""
        if self.sharing != NO_SHARING and self.measure == REWARDED:
            raise SettingError("sharing", "a measure from 0 to 1", repr(REWARDED))

    @property
    def rewarded(self) -> bool:
        """Whether the rewards of a world have an effect."""
        return self.measure == REWARDED

    def fitness(self, game: Game, scores: Scores, team: Team, table: Table) -> FloatArray:
        """Return the fitness (n,) of a team's candidates from their matches (M,)."""
        values = table(game.values(scores, team, self.measure).mean(axis=1))
        fitness = mean_over_opponents(values)
        if self.sharing != NO_SHARING:
            # Sharing is of results in [0, 1]; the penalty is subtracted afterwards.
            payoff = table(game.values(scores, team, self.measure, raw=True).mean(axis=1))
            fitness = shared_fitness(payoff) - mean_over_opponents(payoff - values)
        if self.cost_limit is None:
            return fitness
        costs = mean_over_opponents(table(game.costs(scores, team)))
        return feasible_first(fitness, costs - self.cost_limit)


def not_asked() -> RuntimeError:
    """Return the error for a state that `tell` gets without an `ask` before."""
    return RuntimeError("tell: expected a state of `ask`, got one without candidates")


def check_genomes(name: str, array: Any, shape: tuple[int, ...], *, texts: bool = False) -> None:
    """Raise PluginError unless a learner's method has returned float32, or texts, of a shape."""
    if texts:
        if not are_texts(array, shape):
            raise PluginError(f"{name}: expected an array of text {shape}, got {shown(array)}")
        return
    is_array = isinstance(array, np.ndarray) and not isinstance(array, np.ma.MaskedArray)
    if not is_array or (array.dtype, array.shape) != (np.float32, shape):
        got = f"{array.dtype} {array.shape}" if is_array else shown(array)
        raise PluginError(f"{name}: expected an array of float32 {shape}, got {got}")


def checked_fitness(fitness: ArrayLike, n: int) -> FloatArray:
    """Return `fitness` as (n,) float64; ValueError if it has another shape or is not finite."""
    values = check_floats("fitness", fitness)
    if values.shape != (n,):
        raise ValueError(f"fitness: expected shape ({n},), got {values.shape}")
    # One NaN would spread to the whole genome, or be taken for the best.
    if not np.isfinite(values).all():
        raise ValueError(f"fitness: expected finite numbers, got {values}")
    return values
