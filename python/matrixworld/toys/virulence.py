"""Hosts and parasites that count ones, in a game that is easier for parasites.

The individual with more ones wins. A bit that mutates becomes a one with the probability of its
side's *bias*. Parasites, with the higher bias, outrun the hosts: then all hosts lose all matches,
selection among them stops, and they drift back. Parasites of reduced virulence are rewarded for
winning less than the most; they keep the hosts in the race and climb with them.

Cartlidge & Bullock 2004, "Combating coevolutionary disengagement by reducing parasite virulence",
Evolutionary Computation 12(2).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from matrixworld.coevolution.fitness import reduced_virulence
from matrixworld.coevolution.learners.genetic_algorithm import select_tournament
from matrixworld.coevolution.types import BoolArray, FloatArray
from matrixworld.toys.numbers import GAMES
from matrixworld.toys.populations import History, Side, evolve

HOST_BIAS = 0.5
"""Bias of the hosts: a redrawn bit is a one half of the time."""
PARASITE_BIAS = 0.75
"""Bias of the parasites."""


def mutate_biased(
    bits: BoolArray, rng: np.random.Generator, *, probability: float, bias: float
) -> BoolArray:
    """Return the bits, each redrawn with `probability`: then a one with probability `bias`."""
    # Redrawn, not flipped: without selection a bit ends at its bias whatever it was before.
    drawn = rng.random(bits.shape) < bias
    return np.asarray(np.where(rng.random(bits.shape) < probability, drawn, bits))


def hosts_and_parasites(
    virulence: float | Callable[[FloatArray], FloatArray],
    seed: int,
    *,
    population: int = 25,
    generations: int = 600,
    opponents: int = 5,
    tournament: int = 5,
    mutation: float = 0.03,
    biases: tuple[float, float] = (HOST_BIAS, PARASITE_BIAS),
) -> History:
    """Evolve hosts (side 0, of virulence 1) and parasites (side 1) against each other.

    Parameters
    ----------
    virulence : float or callable
        Virulence of the parasites, from 0.5 to 1; or their fitness, as a function of the wins (n,).
    seed : int
        Seed of all random numbers.
    population : int, optional
        Individuals of each population.
    generations : int, optional
        Generations that both populations breed.
    opponents : int, optional
        Opponents of each individual.
    tournament : int, optional
        Individuals in a tournament.
    mutation : float, optional
        Probability that a bit is redrawn.
    biases : tuple of float, optional
        Probability that a redrawn bit is a one, of the hosts and of the parasites.

    Returns
    -------
    History
        What happened.
    """
    select = partial(select_tournament, size=tournament)
    hosts, parasites = (
        Side(
            fitness=own if callable(own) else partial(reduced_virulence, virulence=own),
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
