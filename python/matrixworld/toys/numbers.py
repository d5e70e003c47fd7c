"""Numbers games: more ones win, in one dimension or another (Watson & Pollack 2001).

An individual is a string of bits, in one or several dimensions. Selection uses wins alone; the
number of ones, the objective, is only observed:

- scalar: more ones win. Both populations climb.
- focusing: the dimension with the greatest difference decides. Other dimensions drift away.
- intransitive: the dimension with the least difference decides. a beats b, b beats c, c beats a:
  a population can win and lose ones.

A mutation rate of 0.005 a bit can be read in two ways: flip the bit, or redraw it (0 or 1 with
equal chance). A redrawn bit changes in half of the cases, so redrawing at 0.005 is flipping at
0.0025. This toy flips, so that the rate is the probability of a change; ``flips=0.0025`` is the
other reading. Mean final objective and its standard deviation over 20 seeds:

=========  ===========  ===========  ============
reading    scalar       focusing     intransitive
=========  ===========  ===========  ============
flip       99.3 +- 0.2  85.6 +- 2.8  53.2 +- 20.4
redraw     99.7 +- 0.1  90.2 +- 3.0  39.3 +- 26.1
=========  ===========  ===========  ============

Watson & Pollack 2001, "Coevolutionary dynamics in a minimal substrate", GECCO.
"""

from __future__ import annotations

import numpy as np

from matrixworld.coevolution.opponents.samplers import OpponentSampler
from matrixworld.coevolution.types import BoolArray, Indices, IntArray
from matrixworld.toys.populations import Game, History, Side, evolve, select_proportionate

BITS = 100
"""Bits of an individual, over all dimensions."""


def beats_in_sum(a: IntArray, b: IntArray) -> BoolArray:
    """Return (M,) whether a has more ones than b in total; a and b are (M, dimensions)."""
    return np.asarray(a.sum(axis=1) > b.sum(axis=1))


def beats_where_farthest(a: IntArray, b: IntArray) -> BoolArray:
    """Return (M,) whether a has more ones in the dimension, of (M, d), where they differ most."""
    return _beats_at(np.argmax(np.abs(a - b), axis=1), a, b)


def beats_where_nearest(a: IntArray, b: IntArray) -> BoolArray:
    """Return (M,) whether a has more ones in the dimension, of (M, d), where they differ least."""
    return _beats_at(np.argmin(np.abs(a - b), axis=1), a, b)


def _beats_at(dimension: Indices, a: IntArray, b: IntArray) -> BoolArray:
    each = np.arange(len(a))
    return np.asarray(a[each, dimension] > b[each, dimension])


GAMES = {
    "scalar": Game((1, BITS), beats_in_sum),
    "focusing": Game((10, BITS // 10), beats_where_farthest),
    "intransitive": Game((2, BITS // 2), beats_where_nearest),
}
"""Numbers games by name."""


def flip(bits: BoolArray, rng: np.random.Generator, *, probability: float) -> BoolArray:
    """Return the bits, each flipped with `probability`."""
    return np.asarray(bits ^ (rng.random(bits.shape) < probability))


def numbers_game(
    name: str,
    seed: int,
    *,
    population: int = 25,
    generations: int = 600,
    opponents: int = 15,
    flips: float = 0.005,
    samplers: tuple[OpponentSampler, OpponentSampler] | None = None,
) -> History:
    """Play a numbers game with fitness-proportionate selection.

    Parameters
    ----------
    name : {"scalar", "focusing", "intransitive"}
        Name in `GAMES`.
    seed : int
        Seed of all random numbers.
    population : int, optional
        Individuals of each population.
    generations : int, optional
        Generations that both populations breed.
    opponents : int, optional
        Living opponents of each individual.
    flips : float, optional
        Probability that a bit is flipped; half of the probability that it is redrawn.
    samplers : tuple of OpponentSampler, optional
        Per side, chooses among the other side's past champions. By default there are no matches
        with champions.

    Returns
    -------
    History
        What happened.

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
        population=population,
        generations=generations,
        opponents=opponents,
        samplers=samplers,
    )
