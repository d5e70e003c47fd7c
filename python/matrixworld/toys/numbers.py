"""Numbers games: who has more ones, in some dimension (Watson & Pollack 2001).

"Coevolutionary dynamics in a minimal substrate", GECCO 2001. Only wins are selected for, and the
number of ones, the objective, is what an observer sees:

- scalar: more ones win. Both populations climb.
- focusing: the dimension of the greatest difference decides. Whatever is not contested drifts
  away.
- intransitive: the dimension of the least difference decides. a beats b, b beats c, c beats a:
  one can win and lose ground.
"""

from __future__ import annotations

import numpy as np

from matrixworld.coevolution.opponents import OpponentSampler
from matrixworld.toys.populations import (
    Bits,
    Game,
    Generator,
    History,
    Phenotypes,
    Side,
    evolve,
    select_proportionate,
)

BITS = 100


def beats_in_sum(a: Phenotypes, b: Phenotypes) -> Bits:
    """Return (M,) whether a has more ones than b in all; a and b are (M, dimensions)."""
    return np.asarray(a.sum(axis=1) > b.sum(axis=1))


def beats_where_farthest(a: Phenotypes, b: Phenotypes) -> Bits:
    """Return (M,) whether a has more ones in the dimension, of (M, d), where they differ most."""
    return _beats_at(np.argmax(np.abs(a - b), axis=1), a, b)


def beats_where_nearest(a: Phenotypes, b: Phenotypes) -> Bits:
    """Return (M,) whether a has more ones in the dimension, of (M, d), where they differ least."""
    return _beats_at(np.argmin(np.abs(a - b), axis=1), a, b)


def _beats_at(dimension: np.ndarray, a: Phenotypes, b: Phenotypes) -> Bits:
    each = np.arange(len(a))
    return np.asarray(a[each, dimension] > b[each, dimension])


GAMES = {
    "scalar": Game((1, BITS), beats_in_sum),
    "focusing": Game((10, BITS // 10), beats_where_farthest),
    "intransitive": Game((2, BITS // 2), beats_where_nearest),
}


def flip(bits: Bits, rng: Generator, *, probability: float) -> Bits:
    """Return bits of which each has been flipped with `probability`."""
    return np.asarray(bits ^ (rng.random(bits.shape) < probability))


def numbers_game(
    name: str,
    seed: int,
    *,
    population: int = 25,
    generations: int = 600,
    opponents: int = 15,
    flips: float = 0.005,
    halls: tuple[OpponentSampler, OpponentSampler] | None = None,
) -> History:
    """Play a numbers game with fitness-proportionate selection.

    Parameters
    ----------
    name : one of `GAMES`.
    flips : probability that a bit is flipped.
    seed, population, generations, opponents, halls : as for `populations.evolve`.
    """
    if name not in GAMES:
        raise ValueError(f"game: expected one of {', '.join(GAMES)}, got {name!r}")
    side = Side(
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
        halls=halls,
    )
