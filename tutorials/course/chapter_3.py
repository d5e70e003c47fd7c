"""Exercises of notebook 3: neuroevolution."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from deap import base, tools

from course.checks import Mistake, about, array, compare, described, function
from matrixworld import EpisodeStatistics, Matches, Network, Population, WorldConfig, rollout
from matrixworld.coevolution.learners.toolbox import Individual
from matrixworld.coevolution.types import FloatArray, Genome, Team

# ---- Evolution -----------------------------------------------------------------------------------

Score = Callable[[Sequence[Genome], Any], FloatArray]
"""Fitness (n,) of n genomes, as the mean over the matches of some seeds."""
MATCHES = 4
"""Of each genome in a generation."""
CHILDREN = 40
"""In a generation."""


def play_each(
    world: WorldConfig,
    network: Network,
    genomes: Sequence[Genome],
    seeds: Any,
    against: Any,
    team: Team = "pursuer",
) -> EpisodeStatistics:
    """Play each genome of a team on each seed; return the statistics, genome by genome."""
    own, who = Population(np.stack(genomes), network), np.repeat(range(len(genomes)), len(seeds))
    matches = np.tile(seeds, len(genomes))
    if team == "pursuer":
        return rollout(world, own, against, Matches.of(who, 0, matches))
    return rollout(world, against, own, Matches.of(0, who, matches))


def make_toolbox(
    network: Network, score: Score, rng: np.random.Generator, sigma: float = 0.2
) -> base.Toolbox:
    """Return a toolbox; all genomes of a generation play the same four matches."""

    def mutate(player: Individual) -> tuple[Individual]:
        noise = rng.standard_normal(len(player.genome), dtype=np.float32)
        player.genome = player.genome + np.float32(sigma) * noise
        return (player,)

    def evaluate_all(evaluate: Score, players: Sequence[Individual]) -> list[tuple[float]]:
        seeds = rng.integers(2**63, size=MATCHES)
        return [(value,) for value in evaluate([player.genome for player in players], seeds)]

    toolbox = base.Toolbox()
    toolbox.register("player", lambda: Individual(network.initial(rng, weight=0.2, head=0.5)))
    toolbox.register("population", tools.initRepeat, list, toolbox.player)
    toolbox.register("mutate", mutate)
    toolbox.register("select", tools.selBest)
    toolbox.register("evaluate", score)
    toolbox.register("map", evaluate_all)
    return toolbox


def evolve(
    loop: Callable[..., Any], network: Network, score: Score, seed: int, generations: int
) -> tuple[Genome, list[float]]:
    """Return the champion, and the best fitness in each generation."""
    random.seed(seed)  # the loops of DEAP use Python's own generator
    toolbox = make_toolbox(network, score, np.random.default_rng(seed))
    statistics = tools.Statistics(lambda player: player.fitness.values[0])
    statistics.register("best", np.max)
    sizes = {"mu": 8, "lambda_": CHILDREN, "cxpb": 0.0, "mutpb": 1.0, "ngen": generations}
    population, logbook = loop(
        toolbox.population(n=8), toolbox, **sizes, stats=statistics, verbose=False
    )
    return tools.selBest(population, 1)[0].genome, logbook.select("best")


def best_of_random(
    network: Network, score: Score, seed: int, generations: int
) -> tuple[Genome, float]:
    """Return the best of as many random genomes as an evolution tries, and its fitness."""
    rng = np.random.default_rng(seed)
    genomes: list[Genome] = []
    fitness: list[float] = []
    for _ in range(generations):
        new = [network.initial(rng, weight=0.2, head=0.5) for _ in range(CHILDREN)]
        fitness.extend(score(new, rng.integers(2**63, size=MATCHES)))
        genomes.extend(new)
    return genomes[int(np.argmax(fitness))], max(fitness)


def ask_and_tell(
    make_learner: Callable[..., Any], network: Network, score: Score, seed: int, generations: int
) -> Genome:
    """Return what a learner finds with as many matches as an evolution."""
    rng, matches_left = np.random.default_rng(seed), CHILDREN * MATCHES * generations
    learner = make_learner(network.initial(rng), rng)
    while matches_left > 0:  # whatever the number of candidates
        candidates = learner.ask(rng)
        fitness = score(candidates, rng.integers(2**63, size=2))
        learner.tell(np.asarray(fitness, float))
        matches_left -= 2 * len(candidates)
    genome: Genome = learner.genome
    return genome


# ---- Exercises -----------------------------------------------------------------------------------


def exercise_1(answer: Any) -> None:
    """Count the numbers of a genome."""
    compare(
        answer,
        lambda side, hidden, moves: Network((hidden,), fov=side, n_actions=moves).genome_size,
        [(5, 8, 5), (11, 32, 5), (3, 4, 9)],
        case="For a view of {side} x {side}, {hidden} hidden units and {moves} moves",
        clues={
            "It counts the weights. What else does each unit have?": (
                lambda side, hidden, moves: 3 * side * side * hidden + hidden * moves
            ),
            "How many layers does a view have?": (
                lambda side, hidden, moves: (side * side + 1) * hidden + (hidden + 1) * moves
            ),
        },
        otherwise="Expected another number.",
    )


def exercise_2(answer: Any) -> None:
    """Say how many matches a standard error takes."""
    compare(
        answer,
        lambda spread, error: math.ceil(round((spread / error) ** 2, 6)),
        [(0.2, 0.1), (0.17, 0.01), (0.3, 0.05), (0.2, 0.03)],
        case="For a spread of {spread} and an error of {error}",
        otherwise=_why_matches,
    )


def _why_matches(found: float, right: int, spread: float, error: float) -> str:
    if math.isclose(found, spread / error) or found == math.ceil(spread / error):
        return "It is too few. Half the error takes more than twice the matches."
    if right - 1 < found < right:
        return f"Exactly it is {found}, and a number of matches is whole: round up."
    if found in (right - 1, right + 1):
        return "One match more is needed." if found < right else "One match less is enough."
    error_then = f"{spread / math.sqrt(found):.3g}" if found > 0 else "not defined"
    return f"With so many matches the standard error is {error_then}, and {error:g} is asked for."


TEAM = 10
CROWDS: tuple[list[tuple[int, int]], ...] = (
    [(0, 0), (0, 0), (0, 0), (4, 7), (4, 7)],
    [(1, 1), (2, 2), (3, 3)],
    [(5, 5)] * TEAM,
    [],
)
"""Cells of living agents."""


def exercise_3(answer: Any) -> None:
    """Measure how much a team overlaps."""
    compare(
        answer,
        lambda cells, team: (len(cells) - len(set(cells))) / team,
        [(cells, TEAM) for cells in CROWDS],
        case="For the cells {cells} and a team of {team}",
        clues={
            "It counts all agents on shared cells; the first on each is not counted.": (
                lambda cells, team: sum(cells.count(cell) > 1 for cell in cells) / team
            ),
            "It is a share of the living; expected a share of the whole team.": (
                lambda cells, team: (len(cells) - len(set(cells))) / (len(cells) or team)
            ),
        },
        otherwise=lambda found, right, cells, team: (
            f"Expected {right:g}. How many different cells are there?"
        ),
    )


GENES, EPOCHS, NOISE = 60, 200, 0.01
ENOUGH = 1 / 3
"""Share of the distance to the optimum that a learner has to cover."""
MOST_CANDIDATES = 200


def exercise_4(answer: Any) -> None:
    """Write a learner: a class with `ask` and `tell`."""
    if not isinstance(answer, type):
        raise Mistake("Expected a class: write `class Climber:` and then `answer = Climber`.")
    for name in ("ask", "tell"):
        if not callable(getattr(answer, name, None)):
            raise Mistake(f"The class has no method {name!r}.")
    least = min(_gain(answer, seed) for seed in range(3))
    if least < ENOUGH:
        raise Mistake(
            f"It ran without an error. After {EPOCHS} epochs it had covered {least:.0%} of "
            "the distance to the optimum; expected at least a third. Does `genome` move to the "
            "best candidate? Are the steps neither tiny nor huge?"
        )


def _gain(make: Any, seed: int) -> float:
    """Return the share of the distance to an optimum that a learner covers."""
    rng = np.random.default_rng(seed)
    start = rng.standard_normal(GENES).astype(np.float32) * np.float32(0.1)
    target = start + rng.standard_normal(GENES).astype(np.float32) * np.float32(0.5)
    # A copy: the start must stay what it is, even if a learner changes its genome in place.
    learner = function(make)(start.copy(), np.random.default_rng(seed))
    if not hasattr(learner, "genome"):
        raise Mistake("The learner has no attribute `genome`; set it in `__init__`.")
    begin = float(np.linalg.norm(start - target))
    for _ in range(EPOCHS):
        candidates = _candidates(function(learner.ask)(rng))
        distances = np.linalg.norm(candidates - target, axis=1) / begin
        function(learner.tell)(-distances + NOISE * rng.standard_normal(len(candidates)))
    with about("genome"):
        genome = array(learner.genome, f"{GENES} numbers", GENES)
        if not np.isfinite(genome).all():
            raise Mistake(f"Expected {GENES} numbers, got NaN or infinity among them.")
    return max(0.0, 1.0 - float(np.linalg.norm(genome - target)) / begin)


def _candidates(given: Any) -> np.ndarray:
    if not isinstance(given, np.ndarray):
        raise Mistake(f"ask: expected an array, got {described(given)}.")
    if given.ndim != 2 or given.shape[1] != GENES or not len(given):
        raise Mistake(f"ask: expected the shape (n, {GENES}), got {given.shape}.")
    if given.dtype != np.float32:
        raise Mistake(f"ask: expected the dtype float32, got {given.dtype}.")
    if not np.isfinite(given).all():
        raise Mistake("ask: expected numbers, got NaN or infinity among them.")
    if len(given) > MOST_CANDIDATES:
        raise Mistake(f"ask: expected at most {MOST_CANDIDATES} candidates here, got {len(given)}.")
    return given
