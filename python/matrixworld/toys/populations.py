"""Two populations of bit strings that evolve against each other, in one short loop.

The pairing of individuals is that of the real races (`coevolution.hall_of_fame.pairings`), and
halls of fame are asked by the real opponent selection.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution.opponents import Indices, OpponentSampler
from matrixworld.coevolution.runs.hall_of_fame import pairings

Bits = NDArray[np.bool_]
Phenotypes = NDArray[np.int64]
Values = NDArray[np.float64]
Generator = np.random.Generator


@dataclass(frozen=True)
class Side:
    """How one population evolves.

    Parameters
    ----------
    fitness : wins (n,) -> fitness (n,).
    select : (fitness (n,), n, rng) -> parents (n,).
    mutate : (bits (n, ...), rng) -> mutants (n, ...).
    """

    fitness: Callable[[Values], Values]
    select: Callable[[Values, int, Generator], NDArray[np.intp]]
    mutate: Callable[[Bits, Generator], Bits]

    def breed(self, bits: Bits, wins: Values, rng: Generator) -> Bits:
        """Return the next population, of the same size."""
        parents = self.select(self.fitness(wins), len(bits), rng)
        return self.mutate(bits[parents], rng)


@dataclass(frozen=True)
class Game:
    """What is played.

    Parameters
    ----------
    shape : of an individual's bits: (dimensions, bits in each).
    beats : (a (M, dimensions), b (M, dimensions)) -> (M,) whether a beats b; ones are counted in
        each dimension. Where neither beats the other, nobody wins.
    """

    shape: tuple[int, int]
    beats: Callable[[Phenotypes, Phenotypes], Bits]


@dataclass(frozen=True)
class History:
    """What happened in G generations of two populations of n.

    Attributes
    ----------
    game : what they played.
    ones : (G + 1, 2, n, dimensions) ones of each individual in each dimension; the first row is
        the start, the last what came out.
    wins : (G, 2, n) contests that each individual won.
    """

    game: Game
    ones: Phenotypes
    wins: Values

    @property
    def objective(self) -> NDArray[np.int64]:
        """(G + 1, 2, n) ones of each individual, which no one is selected for."""
        return np.asarray(self.ones.sum(axis=3))

    @property
    def final_objective(self) -> Values:
        """(2,) mean ones of each population at the end."""
        return np.asarray(self.objective[-1].mean(axis=1))

    @property
    def engaged(self) -> Bits:
        """(G,) whether in both populations some individuals have won more than others."""
        return np.asarray((np.ptp(self.wins, axis=2) > 0.0).all(axis=1))

    def scores(self, generations: ArrayLike, episodes: int, rng: Generator) -> Values:
        """Return (k, k, episodes) what side 0 scores: 1 for a win, 1/2 for a draw, 0 for a loss.

        Row i is side 0, column j side 1 in the generations (k,) that are named. In each episode
        two individuals, drawn at random with replacement, meet.
        """
        picked = np.asarray(generations)
        shape = (len(picked), len(picked), episodes)
        one, other = (rng.integers(self.ones.shape[2], size=shape).ravel() for _ in (0, 1))
        i, j, _ = (index.ravel() for index in np.indices(shape))
        a, b = self.ones[picked[i], 0, one], self.ones[picked[j], 1, other]
        won, lost = self.game.beats(a, b), self.game.beats(b, a)
        return np.asarray((1.0 + won - lost) / 2.0).reshape(shape)


def evolve(
    game: Game,
    sides: tuple[Side, Side],
    rng: Generator,
    *,
    population: int,
    generations: int,
    opponents: int,
    halls: tuple[OpponentSampler, OpponentSampler] | None = None,
) -> History:
    """Let two populations evolve, from all zeros, and return what happened.

    ::

        in each generation:
            each individual meets some living opponents, paired by random permutations, and those
            of the other side's champions that its own selection names, which is told the scores
            both sides breed by the wins; the champion, with the most wins, joins its hall

    Parameters
    ----------
    game : what is played.
    sides : how each population breeds.
    rng : draws everything.
    population, generations : their size, and how often both breed.
    opponents : living ones that each individual meets.
    halls : per side whom it meets of the other side's champions; None: nobody.
    """
    bits = [np.zeros((population, *game.shape), dtype=np.bool_) for _ in sides]
    champions: tuple[list[Bits], list[Bits]] = ([], [])
    ones, wins = [_ones(bits)], []
    for generation in range(generations):
        met = [_met(halls, s, len(champions[1 - s]), generation, rng) for s in (0, 1)]
        guests = [[champions[s][i] for i in met[1 - s]] for s in (0, 1)]
        contest = _contest(game, bits, guests, opponents, rng)
        won = [contest.wins(side) for side in (0, 1)]
        for side in (0, 1):
            if halls is not None and len(met[side]):
                halls[side].tell(met[side], contest.hall_scores(side))
            champions[side].append(bits[side][np.argmax(won[side])])
            bits[side] = sides[side].breed(bits[side], won[side], rng)
        ones.append(_ones(bits))
        wins.append(won)
    return History(game, np.array(ones), np.array(wins))


def _met(
    halls: tuple[OpponentSampler, OpponentSampler] | None,
    side: int,
    available: int,
    generation: int,
    rng: Generator,
) -> Indices:
    """Return which champions of the other side this side meets."""
    if halls is None or not available:
        return np.zeros(0, dtype=np.intp)
    return halls[side].choose(available, generation, rng)


@dataclass(frozen=True)
class _Contest:
    """The matches of one generation of two populations of n; champions count from n.

    ``index`` names who of each side plays in each match, ``won`` whether that side won it.
    """

    n: int
    index: tuple[Indices, Indices]
    won: tuple[Bits, Bits]

    def wins(self, side: int) -> Values:
        """Return the wins (n,) of a population."""
        totals = np.bincount(self.index[side], weights=self.won[side], minlength=self.n)
        return np.asarray(totals[: self.n], dtype=np.float64)

    def hall_scores(self, side: int) -> Values:
        """Return the scores (n, c) of a population against c champions; a draw is a half."""
        against_hall = self.index[1 - side] >= self.n
        won, lost = (self.won[s][against_hall].reshape(-1, self.n).T for s in (side, 1 - side))
        return np.asarray((1.0 + won - lost) / 2.0)


def _contest(
    game: Game, bits: list[Bits], guests: list[list[Bits]], opponents: int, rng: Generator
) -> _Contest:
    """Play all matches of a generation; guests are champions of each side."""
    n = len(bits[0])
    met = pairings(n, opponents, (len(guests[0]), len(guests[1])), rng)
    index = (met.pursuer, met.evader)
    ones = [np.array([*bits[side], *guests[side]]).sum(axis=2)[index[side]] for side in (0, 1)]
    return _Contest(n, index, (game.beats(ones[0], ones[1]), game.beats(ones[1], ones[0])))


def _ones(bits: list[Bits]) -> Phenotypes:
    return np.array([team.sum(axis=2) for team in bits])


def select_proportionate(fitness: Values, k: int, rng: Generator) -> NDArray[np.intp]:
    """Return `k` indices drawn in proportion to fitness; evenly if nobody has any."""
    total = fitness.sum()
    return rng.choice(len(fitness), size=k, p=fitness / total if total > 0.0 else None)
