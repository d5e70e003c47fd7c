"""Hosts and parasites that count ones, where parasites have it easier (Cartlidge & Bullock 2004).

"Combating coevolutionary disengagement by reducing parasite virulence", Evolutionary Computation
12(2). Whoever has more ones wins. A bit that mutates becomes one with the probability of its
side's *bias*, so parasites, with the higher bias, outrun the hosts: then all hosts lose all
contests, selection among them stops and they drift back. Parasites of reduced virulence, rewarded
for winning less than the most, keep the hosts in the race and climb with them.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from matrixworld.coevolution.fitness import reduced_virulence
from matrixworld.coevolution.learners.genetic_algorithm import select_tournament
from matrixworld.toys.numbers import GAMES
from matrixworld.toys.populations import Bits, Generator, History, Side, evolve

HOST_BIAS = 0.5
"""Of hosts: ones and zeros arise alike, so that without selection half of the bits are ones."""
PARASITE_BIAS = 0.75


def mutate_biased(bits: Bits, rng: Generator, *, probability: float, bias: float) -> Bits:
    """Return bits of which each was drawn anew with `probability`, then one with that of `bias`."""
    drawn = rng.random(bits.shape) < bias
    return np.asarray(np.where(rng.random(bits.shape) < probability, drawn, bits))


def hosts_and_parasites(
    virulence: float,
    seed: int,
    *,
    population: int = 25,
    generations: int = 600,
    opponents: int = 5,
    tournament: int = 5,
    mutation: float = 0.03,
    biases: tuple[float, float] = (HOST_BIAS, PARASITE_BIAS),
) -> History:
    """Let hosts (side 0, of virulence 1) and parasites (side 1) evolve against each other.

    Parameters
    ----------
    virulence : of the parasites, from 0.5 to 1.
    tournament : individuals in a tournament.
    mutation : probability that a bit is drawn anew.
    biases : of the hosts and of the parasites, the probability that it is then a one.
    seed, population, generations, opponents : as for `populations.evolve`.
    """
    select = partial(select_tournament, size=tournament)
    hosts, parasites = (
        Side(
            fitness=partial(reduced_virulence, virulence=own),
            select=select,
            mutate=partial(mutate_biased, probability=mutation, bias=bias),
        )
        for own, bias in zip((1.0, virulence), biases, strict=True)
    )
    return evolve(
        GAMES["scalar"],
        (hosts, parasites),
        np.random.default_rng(seed),
        population=population,
        generations=generations,
        opponents=opponents,
    )
