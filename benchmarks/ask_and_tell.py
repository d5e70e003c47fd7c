"""Learners of the package and of other libraries, each asked and told by a few lines.

Every adapter is called with a game and its settings. It asks its algorithm for candidates, lets the
game play them, and tells the fitness, until the game ends::

    while game.goes_on(mean):
        game.fitness(candidates)

`sigma` is the standard deviation of the first samples, in units of the genes. `rate` is the length
of a step in each gene. A `population` of None leaves its size to the library.
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from functools import cache, partial
from itertools import count
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution import Against, RaceSettings, Team
from matrixworld.coevolution.learners.cma_es import CmaEs
from matrixworld.coevolution.learners.evolution_strategy import (
    EvolutionStrategy,
    EvolutionStrategySettings,
    centred_ranks,
)
from matrixworld.coevolution.learners.genetic_algorithm import GeneticAlgorithm
from matrixworld.coevolution.learners.learner import Adam, Learner, NoiseTable

Genomes = NDArray[np.float32]
Fitness = NDArray[np.float64]


class Game(Protocol):
    """What an algorithm gets: genomes to start from, and matches that give a fitness."""

    seed: int
    matches: int
    team: Team

    def untrained(self, count: int) -> Genomes:
        """Return the first `count` untrained genomes, (count, genes)."""

    def goes_on(self, genome: ArrayLike) -> bool:
        """Take the genome (genes,) of this moment; return whether there are matches left."""

    def fitness(self, candidates: ArrayLike, groups: ArrayLike = 0) -> Fitness:
        """Play candidates (n, genes), those of a group in the same world; higher is better."""


Algorithm = Callable[..., None]


# ---- The package -----------------------------------------------------------------------------


def drive(game: Game, learner: Learner, groups: ArrayLike | None = None, matches: int = 1) -> None:
    rng = np.random.default_rng([game.seed, 1])
    group = learner.seed_groups if groups is None else np.asarray(groups)
    # Match k of a candidate is in world k of its group.
    worlds = (matches * group[:, None] + np.arange(matches)).ravel()
    while game.goes_on(learner.genome):
        candidates = np.repeat(learner.ask(rng), matches, axis=0)
        learner.tell(game.fitness(candidates, worlds).reshape(-1, matches).mean(axis=1))


def noise(game: Game, sigma: float) -> NoiseTable:
    return NoiseTable(game.untrained(1).size, np.random.default_rng([game.seed, 2]), sigma=sigma)


def es(
    game: Game,
    *,
    population: int,
    sigma: float,
    rate: float,
    relative: float = 0.0,
    worlds: str = "pair",
    matches: int = 1,
) -> None:
    learner = EvolutionStrategy(
        game.untrained(1)[0],
        noise(game, sigma),
        samples=population,
        learning_rate=rate,
        relative_sigma=relative,
    )
    # Who plays in the same worlds: the two candidates of a pair, nobody, or all.
    groups = {
        "pair": learner.seed_groups,
        "own": np.arange(population),
        "one": 0 * learner.seed_groups,
    }
    drive(game, learner, groups[worlds], matches)


def default_es(game: Game) -> None:
    """Play the evolution strategy with the defaults of a team that learns alone."""
    usual = RaceSettings(schedule=Against(team=game.team)).learner
    epochs = max(1, game.matches // usual.population)
    settings = RaceSettings(schedule=Against(team=game.team, epochs=epochs)).learner
    assert isinstance(settings, EvolutionStrategySettings)
    learner = EvolutionStrategy(
        game.untrained(1)[0],
        noise(game, settings.sigma),
        samples=settings.population,
        learning_rate=settings.learning_rate,
        anneal_over=epochs if settings.anneal else None,
        relative_sigma=settings.relative_sigma,
    )
    drive(game, learner)


def unpaired_es(game: Game, *, population: int, sigma: float, rate: float) -> None:
    """Play the evolution strategy without mirrored pairs, with new noise, all in one world."""
    rng, genome = np.random.default_rng([game.seed, 1]), game.untrained(1)[0]
    optimizer = Adam(genome.size)
    while game.goes_on(genome):
        changes = sigma * rng.standard_normal((population, genome.size), dtype=np.float32)
        ranks = centred_ranks(game.fitness(genome + changes)).astype(np.float32)
        genome = genome + optimizer.step(ranks @ changes / (population * sigma**2), rate)


def ga(game: Game, *, population: int, sigma: float) -> None:
    drive(game, GeneticAlgorithm(game.untrained(population), noise(game, sigma)))


def cma_es(game: Game, *, population: int, sigma: float) -> None:
    drive(game, CmaEs(game.untrained(1)[0], sigma=sigma, samples=population))


# ---- evosax ----------------------------------------------------------------------------------


@cache  # each object is compiled anew
def strategy(name: str, genes: int, population: int, *, steps: bool) -> Any:
    import evosax.algorithms
    import optax

    # The rate is in the state, so that other rates are not compiled anew.
    adam = optax.inject_hyperparams(optax.adam)(learning_rate=1.0)
    options = {"optimizer": adam} if steps else {}
    return getattr(evosax.algorithms, name)(population, np.zeros(genes, np.float32), **options)


def evosax(name: str) -> Algorithm:
    def play(game: Game, *, population: int, sigma: float, rate: float | None = None) -> None:
        import jax

        # In units of sigma: the first standard deviation of all these algorithms is 1.
        start = game.untrained(1)[0] / sigma
        algorithm = strategy(name, start.size, population, steps=rate is not None)
        params = algorithm.default_params
        keys = map(partial(jax.random.fold_in, jax.random.key(game.seed)), count())
        state = algorithm.init(next(keys), start, params)
        if rate is not None:
            state.opt_state.hyperparams["learning_rate"] = jax.numpy.float32(rate / sigma)
        while game.goes_on(sigma * np.asarray(state.mean)):
            candidates, state = algorithm.ask(next(keys), state, params)
            losses = -game.fitness(sigma * np.asarray(candidates)).astype(np.float32)
            state, _ = algorithm.tell(next(keys), candidates, losses, state, params)

    return play


# ---- EvoTorch --------------------------------------------------------------------------------


def evotorch(name: str) -> Algorithm:
    def play(game: Game, *, sigma: float, population: int | None = None, rate: float = 0) -> None:
        import evotorch.algorithms
        import torch

        logging.disable(logging.INFO)
        torch.manual_seed(game.seed)
        start = game.untrained(1)[0]
        problem = evotorch.Problem(
            "max",
            lambda candidates: torch.as_tensor(game.fitness(candidates), dtype=torch.float32),
            solution_length=start.size,
            initial_bounds=(-1, 1),
            vectorized=True,
            seed=game.seed,
        )
        options: dict[str, Any] = {"popsize": population, "stdev_init": sigma}
        if name == "PGPE":
            # Of its optimizer, ClipUp, a step has a length in the space of all genes.
            options |= {"center_learning_rate": rate * start.size**0.5, "stdev_learning_rate": 0.1}
        search = getattr(evotorch.algorithms, name)(
            problem, center_init=torch.as_tensor(start), **options
        )
        centre = start
        while game.goes_on(centre):
            search.step()
            centre = search.status["center"].numpy()

    return play


# ---- pycma -----------------------------------------------------------------------------------


def pycma(game: Game, *, sigma: float, population: int | None = None) -> None:
    import cma

    start = game.untrained(1)[0].astype(float)
    options = {"seed": game.seed + 1, "verbose": -9, "CMA_diagonal": start.size > 1000}
    if population:
        options["popsize"] = population
    search = cma.CMAEvolutionStrategy(start, sigma, options)
    while game.goes_on(search.mean):
        candidates = search.ask()
        search.tell(candidates, list(-game.fitness(np.array(candidates))))
