"""Two populations of bit strings that evolve against each other, in one short loop.

Individuals are paired by the races' own `pairings`, and past champions are chosen by the races' own
opponent samplers.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.opponents.samplers import OpponentSampler
from matrixworld.coevolution.runs.hall_of_fame import pairings
from matrixworld.coevolution.types import BoolArray, FloatArray, Indices, IntArray


@dataclass(frozen=True)
class Side:
    """How one population evolves.

    Parameters
    ----------
    fitness : callable
        Wins (n,) -> fitness (n,).
    select : callable
        (Fitness (n,), n, rng) -> indices of the parents (n,).
    mutate : callable
        (Bits (n, ...), rng) -> mutants (n, ...).
    """

    fitness: Callable[[FloatArray], FloatArray]
    select: Callable[[FloatArray, int, np.random.Generator], Indices]
    mutate: Callable[[BoolArray, np.random.Generator], BoolArray]

    def breed(self, bits: BoolArray, wins: FloatArray, rng: np.random.Generator) -> BoolArray:
        """Return the next population, of the same size."""
        parents = self.select(self.fitness(wins), len(bits), rng)
        return self.mutate(bits[parents], rng)


@dataclass(frozen=True)
class Game:
    """A game between two individuals, decided by their ones in each dimension.

    Parameters
    ----------
    shape : tuple of int
        Shape of an individual's bits: (dimensions, bits in each).
    beats : callable
        (Ones a (M, dimensions), ones b (M, dimensions)) -> (M,) whether a beats b. If neither beats
        the other, the match is a draw.
    """

    shape: tuple[int, int]
    beats: Callable[[IntArray, IntArray], BoolArray]


@dataclass(frozen=True)
class History:
    """G generations of two populations of n individuals.

    Parameters
    ----------
    game : Game
        The game that was played.
    ones : ndarray of int64, shape (G + 1, 2, n, dimensions)
        Ones of each individual in each dimension, from the start to the end.
    wins : ndarray of float64, shape (G, 2, n)
        Matches that each individual won.
    """

    game: Game
    ones: IntArray
    wins: FloatArray

    @property
    def objective(self) -> IntArray:
        """Ones of each individual, (G + 1, 2, n); selection does not use them."""
        return np.asarray(self.ones.sum(axis=3))

    @property
    def final_objective(self) -> FloatArray:
        """Mean ones of each population at the end, (2,)."""
        return np.asarray(self.objective[-1].mean(axis=1))

    @property
    def engaged(self) -> BoolArray:
        """Whether individuals of both populations differ in their wins, (G,)."""
        return np.asarray((np.ptp(self.wins, axis=2) > 0.0).all(axis=1))

    def scores(self, generations: ArrayLike, episodes: int, rng: np.random.Generator) -> FloatArray:
        """Play matches between generations.

        Parameters
        ----------
        generations : array_like of int, shape (k,)
            Generations to play.
        episodes : int
            Matches of each pair, between two individuals drawn at random with replacement.
        rng : numpy.random.Generator
            Draws the individuals.

        Returns
        -------
        ndarray of float64, shape (k, k, episodes)
            Scores of side 0 (rows) against side 1 (columns): 1 for a win, 1/2 for a draw, 0 for a
            loss.
        """
        picked = np.asarray(generations)
        shape = (len(picked), len(picked), episodes)
        # One draw for each side of all matches: new individuals in each episode.
        first, second = (rng.integers(self.ones.shape[2], size=shape).ravel() for _ in (0, 1))
        i, j, _ = (index.ravel() for index in np.indices(shape))
        a, b = self.ones[picked[i], 0, first], self.ones[picked[j], 1, second]
        won, lost = self.game.beats(a, b), self.game.beats(b, a)
        return np.asarray((1.0 + won - lost) / 2.0).reshape(shape)


def evolve(
    game: Game,
    sides: tuple[Side, Side],
    rng: np.random.Generator,
    *,
    population: int,
    generations: int,
    opponents: int,
    samplers: tuple[OpponentSampler, OpponentSampler] | None = None,
) -> History:
    """Evolve two populations against each other, from all zeros.

    ::

        in each generation:
            each individual plays some living opponents, paired by random permutations, and those
            of the other side's past champions that its sampler chooses
            both sides breed by their wins; the individual with the most wins is the new champion

    Parameters
    ----------
    game : Game
        What is played.
    sides : tuple of Side
        How each population breeds.
    rng : numpy.random.Generator
        Draws all random numbers.
    population : int
        Individuals of each population.
    generations : int
        Generations that both populations breed.
    opponents : int
        Living opponents of each individual.
    samplers : tuple of OpponentSampler, optional
        Per side, chooses among the other side's past champions. By default there are no matches
        with champions.

    Returns
    -------
    History
        What happened.
    """
    bits = [np.zeros((population, *game.shape), dtype=np.bool_) for _ in sides]
    champions: tuple[list[BoolArray], list[BoolArray]] = ([], [])
    ones, wins = [_ones(bits)], []
    for generation in range(generations):
        chosen = [_sample(samplers, s, len(champions[1 - s]), generation, rng) for s in (0, 1)]
        playing = [[champions[s][i] for i in chosen[1 - s]] for s in (0, 1)]
        matches = _play(game, bits, playing, opponents, rng)
        won = [matches.wins(side) for side in (0, 1)]
        for side in (0, 1):
            if samplers is not None and len(chosen[side]):
                samplers[side].tell(chosen[side], matches.scores_on_champions(side))
            # After the matches, so that the champions of a generation are past ones in the next.
            champions[side].append(bits[side][np.argmax(won[side])])
            bits[side] = sides[side].breed(bits[side], won[side], rng)
        ones.append(_ones(bits))
        wins.append(won)
    return History(game, np.array(ones), np.array(wins))


def _sample(
    samplers: tuple[OpponentSampler, OpponentSampler] | None,
    side: int,
    available: int,
    generation: int,
    rng: np.random.Generator,
) -> Indices:
    """Return the past champions of the other side that this side plays against."""
    if samplers is None or not available:
        return np.zeros(0, dtype=np.intp)
    return samplers[side].sample(available, generation, rng)


@dataclass(frozen=True)
class _Matches:
    """The matches of one generation of two populations of n; champions have indices from n on.

    `index` holds the players of each side in each match, `won` whether that side won it.
    """

    n: int
    index: tuple[Indices, Indices]
    won: tuple[BoolArray, BoolArray]

    def wins(self, side: int) -> FloatArray:
        """Return the wins (n,) of a population."""
        # Indices from n on are champions, whose wins count for no individual.
        totals = np.bincount(self.index[side], weights=self.won[side], minlength=self.n)
        return np.asarray(totals[: self.n], dtype=np.float64)

    def scores_on_champions(self, side: int) -> FloatArray:
        """Return the scores (n, c) of a population against c champions; a draw is 1/2."""
        # `pairings` lists each champion's matches in the order of the population.
        champion = self.index[1 - side] >= self.n
        won, lost = (self.won[s][champion].reshape(-1, self.n).T for s in (side, 1 - side))
        return np.asarray((1.0 + won - lost) / 2.0)


def _play(
    game: Game,
    bits: list[BoolArray],
    champions: list[list[BoolArray]],
    opponents: int,
    rng: np.random.Generator,
) -> _Matches:
    """Play all matches of a generation, those with some champions of each side included."""
    n = len(bits[0])
    one_group = np.zeros(n, dtype=np.intp)
    pairs = pairings(one_group, opponents, (len(champions[0]), len(champions[1])), rng)
    index = (pairs.pursuer, pairs.evader)
    ones = [np.array([*bits[side], *champions[side]]).sum(axis=2)[index[side]] for side in (0, 1)]
    return _Matches(n, index, (game.beats(ones[0], ones[1]), game.beats(ones[1], ones[0])))


def _ones(bits: list[BoolArray]) -> IntArray:
    return np.array([team.sum(axis=2) for team in bits])


def select_proportionate(fitness: FloatArray, k: int, rng: np.random.Generator) -> Indices:
    """Return `k` indices drawn in proportion to fitness; evenly if all fitness is 0."""
    total = fitness.sum()
    return rng.choice(len(fitness), size=k, p=fitness / total if total > 0.0 else None)
