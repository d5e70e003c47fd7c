"""Two populations of bit strings that evolve against each other, in one short loop.

*Numbers games* (Watson & Pollack 2001, "Coevolutionary dynamics in a minimal substrate", GECCO):
more ones win, in one dimension or another. Selection uses wins alone; the number of ones, the
objective, is only observed.

- scalar: more ones win. Both populations climb.
- focusing: the dimension with the greatest difference decides. Other dimensions drift away.
- intransitive: the dimension with the least difference decides. a beats b, b beats c, c beats a:
  a population can win and lose ones.

A mutation rate of 0.005 a bit can be read in two ways: flip the bit, or redraw it (0 or 1 with
equal chance). A redrawn bit changes in half of the cases, so redrawing at 0.005 is flipping at
0.0025. This toy flips, so that the rate is the probability of a change; ``flips=0.0025`` is the
other reading, and `docs/coevolution.md` has the results of both.

*Hosts and parasites* (Cartlidge & Bullock 2004, "Combating coevolutionary disengagement by reducing
parasite virulence", Evolutionary Computation 12(2)): the scalar game, but a bit that mutates
becomes a one with the probability of its side's *bias*. Parasites, with the higher bias, outrun the
hosts: then all hosts lose all matches, selection among them stops, and they drift back. Parasites
of reduced virulence are rewarded for winning less than the most; they keep the hosts in the race
and climb with them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.fitness import reduced_virulence
from matrixworld.coevolution.learners.genetic_algorithm import select_tournament
from matrixworld.coevolution.opponents.samplers import OpponentSampler
from matrixworld.coevolution.runs.race import pairings
from matrixworld.coevolution.types import BoolArray, FloatArray, Indices, IntArray

Samplers = tuple[OpponentSampler, OpponentSampler]

BITS = 100
"""Bits of an individual, over all dimensions."""
POPULATION = 25
"""Individuals of each population."""
REDRAWN = 0.03
"""Probability that a mutation of hosts and parasites redraws a bit."""
NOBODY = np.zeros(0, dtype=np.intp)
"""A choice of no champions."""
HOST_BIAS, PARASITE_BIAS = 0.5, 0.75
"""Probability that a redrawn bit is a one."""


# ---- Games ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Game:
    """A game between two individuals, decided by their ones in each dimension.

    `shape` is (dimensions, bits in each). `beats` gets the ones of M individuals a and b, each
    (M, dimensions), and returns (M,) whether a beats b. If neither does, the match is a draw.
    """

    shape: tuple[int, int]
    beats: Callable[[IntArray, IntArray], BoolArray]


def beats_where(a: IntArray, b: IntArray, *, extreme: Callable[..., Indices]) -> BoolArray:
    """Return (M,) whether a has more ones in the dimension with the `extreme` difference."""
    each, dimension = np.arange(len(a)), extreme(np.abs(a - b), axis=1)
    return np.asarray(a[each, dimension] > b[each, dimension])


GAMES = {
    "scalar": Game((1, BITS), partial(beats_where, extreme=np.argmax)),
    "focusing": Game((10, BITS // 10), partial(beats_where, extreme=np.argmax)),
    "intransitive": Game((2, BITS // 2), partial(beats_where, extreme=np.argmin)),
}
"""Numbers games by name."""


# ---- Selection and mutation ----------------------------------------------------------------------


@dataclass(frozen=True)
class Side:
    """How one population evolves.

    `fitness` turns wins (n,) into fitness (n,); `select` takes (fitness, n, rng) and returns the
    indices of the parents (n,); `mutate` takes (bits (n, ...), rng) and returns the mutants.
    """

    fitness: Callable[[FloatArray], FloatArray]
    select: Callable[[FloatArray, int, np.random.Generator], Indices]
    mutate: Callable[[BoolArray, np.random.Generator], BoolArray]


def select_proportionate(fitness: FloatArray, k: int, rng: np.random.Generator) -> Indices:
    """Return `k` indices drawn in proportion to fitness; evenly if all fitness is 0."""
    total = fitness.sum()
    return rng.choice(len(fitness), size=k, p=fitness / total if total > 0.0 else None)


def flip(bits: BoolArray, rng: np.random.Generator, *, probability: float) -> BoolArray:
    """Return the bits, each flipped with `probability`."""
    return np.asarray(bits ^ (rng.random(bits.shape) < probability))


def mutate_biased(
    bits: BoolArray, rng: np.random.Generator, *, probability: float, bias: float
) -> BoolArray:
    """Return the bits, each redrawn with `probability`: then a one with probability `bias`."""
    # Redrawn, not flipped: without selection a bit ends at its bias whatever it was before.
    drawn = rng.random(bits.shape) < bias
    return np.asarray(np.where(rng.random(bits.shape) < probability, drawn, bits))


# ---- The loop ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class History:
    """G generations of two populations of n individuals."""

    game: Game
    ones: IntArray  # of each individual, (G + 1, 2, n, dimensions), from the start to the end
    wins: FloatArray  # matches that each individual won, (G, 2, n)

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
        """Play matches between k generations, each of two individuals drawn with replacement.

        Returns the scores (k, k, episodes) of side 0 (rows) against side 1 (columns): 1 for a win,
        1/2 for a draw, 0 for a loss.
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
    generations: int,
    opponents: int,
    samplers: Samplers | None = None,
) -> History:
    """Evolve two populations against each other, from all zeros.

    ::

        in each generation:
            each individual plays some living opponents, paired by random permutations, and those
            of the other side's past champions that its sampler chooses
            both sides breed by their wins; the individual with the most wins is the new champion
    """
    bits = [np.zeros((POPULATION, *game.shape), dtype=np.bool_) for _ in sides]
    champions: tuple[list[BoolArray], list[BoolArray]] = ([], [])
    ones, wins = [_ones(bits)], []
    for generation in range(generations):
        chosen = [NOBODY, NOBODY]
        if samplers is not None and generation:
            # There is a champion of each earlier generation.
            chosen = [sampler.sample(generation, generation, rng) for sampler in samplers]
        playing = [[champions[s][i] for i in chosen[1 - s]] for s in (0, 1)]
        matches = _play(game, bits, playing, opponents, rng)
        won = [matches.wins(s) for s in (0, 1)]
        for s, side in enumerate(sides):
            if samplers is not None and len(chosen[s]):
                samplers[s].tell(chosen[s], matches.scores_on_champions(s))
            # After the matches, so that the champions of a generation are past ones in the next.
            champions[s].append(bits[s][np.argmax(won[s])])
            parents = side.select(side.fitness(won[s]), POPULATION, rng)
            bits[s] = side.mutate(bits[s][parents], rng)
        ones.append(_ones(bits))
        wins.append(won)
    return History(game, np.array(ones), np.array(wins))


@dataclass(frozen=True)
class _Matches:
    """The matches of one generation.

    `index` holds the players of each side in each match, champions from `POPULATION` on; `won`
    whether that side won it.
    """

    index: tuple[Indices, Indices]
    won: tuple[BoolArray, BoolArray]

    def wins(self, side: int) -> FloatArray:
        """Return the wins (n,) of a population."""
        # The wins of champions count for no individual.
        totals = np.bincount(self.index[side], weights=self.won[side], minlength=POPULATION)
        return np.asarray(totals[:POPULATION], dtype=np.float64)

    def scores_on_champions(self, side: int) -> FloatArray:
        """Return the scores (n, c) of a population against c champions; a draw is 1/2."""
        # `pairings` lists each champion's matches in the order of the population.
        champion = self.index[1 - side] >= POPULATION
        won, lost = (self.won[s][champion].reshape(-1, POPULATION).T for s in (side, 1 - side))
        return np.asarray((1.0 + won - lost) / 2.0)


def _play(
    game: Game,
    bits: list[BoolArray],
    champions: list[list[BoolArray]],
    opponents: int,
    rng: np.random.Generator,
) -> _Matches:
    """Play all matches of a generation, those with some champions of each side included."""
    one_group = np.zeros(POPULATION, dtype=np.intp)
    pairs = pairings(one_group, opponents, (len(champions[0]), len(champions[1])), rng)
    index = (pairs.pursuer, pairs.evader)
    ones = [np.array([*bits[side], *champions[side]]).sum(axis=2)[index[side]] for side in (0, 1)]
    return _Matches(index, (game.beats(ones[0], ones[1]), game.beats(ones[1], ones[0])))


def _ones(bits: list[BoolArray]) -> IntArray:
    return np.array([team.sum(axis=2) for team in bits])


# ---- The two experiments -------------------------------------------------------------------------


def numbers_game(
    name: str,
    seed: int,
    *,
    generations: int = 600,
    opponents: int = 15,
    flips: float = 0.005,
    samplers: Samplers | None = None,
) -> History:
    """Play a numbers game with fitness-proportionate selection.

    Parameters
    ----------
    name : {"scalar", "focusing", "intransitive"}
        Name in `GAMES`.
    seed : int
        Seed of all random numbers.
    generations : int, optional
        Generations that both populations of `POPULATION` individuals breed.
    opponents : int, optional
        Living opponents of each individual.
    flips : float, optional
        Probability that a bit is flipped; half of the probability that it is redrawn.
    samplers : tuple of OpponentSampler, optional
        Per side, chooses among the other side's past champions. By default there are no matches
        with champions.

    Raises
    ------
    ValueError
        If there is no game of that name.
    """
    if name not in GAMES:
        raise ValueError(f"game: expected one of {', '.join(GAMES)}, got {name!r}")
    side = Side(
        # Wins are the fitness: the objective must not leak into selection.
        fitness=lambda wins: wins,
        select=select_proportionate,
        mutate=lambda bits, rng: flip(bits, rng, probability=flips),
    )
    return evolve(
        GAMES[name],
        (side, side),
        np.random.default_rng(seed),
        generations=generations,
        opponents=opponents,
        samplers=samplers,
    )


def hosts_and_parasites(
    virulence: float | Callable[[FloatArray], FloatArray],
    seed: int,
    *,
    generations: int = 600,
    tournament: int = 5,
    biases: tuple[float, float] = (HOST_BIAS, PARASITE_BIAS),
) -> History:
    """Evolve hosts (side 0, of virulence 1) and parasites (side 1), which meet 5 opponents each.

    Parameters
    ----------
    virulence : float or callable
        Virulence of the parasites, from 0.5 to 1; or their fitness, as a function of the wins (n,).
    seed : int
        Seed of all random numbers.
    generations : int, optional
        Generations that both populations of `POPULATION` individuals breed.
    tournament : int, optional
        Individuals in a tournament.
    biases : tuple of float, optional
        Probability that a redrawn bit is a one, of the hosts and of the parasites.
    """
    select = partial(select_tournament, size=tournament)
    hosts, parasites = (
        Side(
            fitness=own if callable(own) else partial(reduced_virulence, virulence=own),
            select=select,
            mutate=partial(mutate_biased, probability=REDRAWN, bias=bias),
        )
        for own, bias in zip((1.0, virulence), biases, strict=True)
    )
    return evolve(
        GAMES["scalar"],
        (hosts, parasites),
        np.random.default_rng(seed),
        generations=generations,
        opponents=5,
    )
