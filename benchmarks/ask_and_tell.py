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

import matrixworld as mw
from matrixworld.coevolution import (
    TEAMS,
    Cells,
    CmaEs,
    EvolutionStrategy,
    GeneticAlgorithm,
    Learner,
    Pursuit,
    RaceSettings,
    Results,
    Task,
    Team,
)
from matrixworld.coevolution.learners.evolution_strategy import centred_ranks
from matrixworld.coevolution.learners.optimizers import Adam

Genomes = NDArray[np.float32]
Fitness = NDArray[np.float64]


class Game(Protocol):
    """What an algorithm gets: genomes to start from, and matches that give a fitness."""

    seed: int
    matches: int
    team: Team
    world: mw.WorldConfig
    network: mw.Network

    def untrained(self, count: int) -> Genomes:
        """Return the first `count` untrained genomes, (count, genes)."""

    def goes_on(self, genome: ArrayLike) -> bool:
        """Take the genome (genes,) of this moment; return whether there are matches left."""

    def fitness(self, candidates: ArrayLike, groups: ArrayLike = 0) -> Fitness:
        """Play candidates (n, genes), those of a group in the same world; higher is better."""


Algorithm = Callable[..., None]


# ---- The package -----------------------------------------------------------------------------


def drive(game: Game, learner: Learner, groups: ArrayLike | None = None, matches: int = 1) -> None:
    rng, untrained = np.random.default_rng([game.seed, 1]), iter(game.untrained(learner.population))
    group = learner.seed_groups if groups is None else np.asarray(groups)
    # Match k of a candidate is in world k of its group.
    worlds = (matches * group[:, None] + np.arange(matches)).ravel()
    state = learner.start(
        Task(
            seed=game.seed,
            team=TEAMS.index(game.team),
            epochs=max(1, game.matches // learner.population),
            untrained=lambda rng: next(untrained),
            begin=None,
            game=Pursuit(world=game.world, settings=Cells(hidden=game.network.hidden)),
        )
    )
    while game.goes_on(learner.genome(state)):
        asked, state = learner.ask(state, rng)
        fitness = game.fitness(np.repeat(asked, matches, axis=0), worlds)
        state = learner.tell(state, Results(fitness.reshape(-1, matches).mean(axis=1)))


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
        population, sigma=sigma, learning_rate=rate, relative_sigma=relative
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
    alone = RaceSettings.of({"schedule": "against", "schedule.team": game.team})
    epochs = max(1, game.matches // alone.learner.population)
    drive(game, alone.changed({"schedule.epochs": epochs}).learner)


def unpaired_es(game: Game, *, population: int, sigma: float, rate: float) -> None:
    """Play the evolution strategy without mirrored pairs, with new noise, all in one world."""
    rng, genome = np.random.default_rng([game.seed, 1]), game.untrained(1)[0]
    adam = Adam.start(genome.size)
    while game.goes_on(genome):
        changes = sigma * rng.standard_normal((population, genome.size), dtype=np.float32)
        ranks = centred_ranks(game.fitness(genome + changes)).astype(np.float32)
        step, adam = adam.step(ranks @ changes / (population * sigma**2), rate)
        genome = genome + step


def ga(game: Game, *, population: int, sigma: float) -> None:
    drive(game, GeneticAlgorithm(population, mutation=sigma))


def cma_es(game: Game, *, population: int, sigma: float) -> None:
    drive(game, CmaEs(population, sigma=sigma))


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
