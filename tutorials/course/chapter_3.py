"""Exercises of notebook 3: a race of two teams, written by hand."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
from deap import base

from course.checks import Mistake, about, array, compare, described, function, whole
from matrixworld import EpisodeStatistics, Matches, Network, Population, WorldConfig, rollout
from matrixworld.coevolution.types import FloatArray, Genome, Genomes

# ---- A race by hand ------------------------------------------------------------------------------

WORLD = WorldConfig("O", rows=12, cols=12, n_pursuers=3, n_evaders=6, fov=5, max_steps=60)
NETWORK = Network.for_config(WORLD, hidden=(8,))
EPOCHS, CANDIDATES, MATCHES, BEST = 8, 40, 4, 8
SIGMA = np.float32(0.2)
SIDES = ("pursuers", "evaders")
Archives = Sequence[Sequence[Genome]]
"""The genomes of pursuers and of evaders, from generation 0 on."""


def captured(pursuers: Genomes, evaders: Genomes, matches: Matches) -> EpisodeStatistics:
    """Play matches of genomes."""
    return rollout(WORLD, Population(pursuers, NETWORK), Population(evaders, NETWORK), matches)


def first_genome(seed: int, side: int) -> Genome:
    """Return the genome of generation 0."""
    return NETWORK.initial(np.random.default_rng([seed, 0, side]), weight=0.2, head=0.5)


def scores(side: int, candidates: Genomes, opponent: Genome, seeds: Any) -> FloatArray:
    """Return the mean score of each candidate of a side (0 pursuers, 1 evaders)."""
    who, luck = np.repeat(range(len(candidates)), len(seeds)), np.tile(seeds, len(candidates))
    if side == 0:
        shares = captured(candidates, opponent[None], Matches.of(who, 0, luck)).captured_fraction
    else:
        played = captured(opponent[None], candidates, Matches.of(0, who, luck))
        shares = 1 - played.captured_fraction
    return np.asarray(shares.reshape(len(candidates), len(seeds)).mean(axis=1))


def mean_of_best(candidates: Genomes, found: FloatArray) -> Genome:
    """Return the next parent."""
    return candidates[np.argsort(found)[-BEST:]].mean(axis=0)


def learn(
    side: int,
    parent: Genome,
    opponent: Genome,
    rng: np.random.Generator,
    select: Callable[[Genomes, FloatArray], Genome] = mean_of_best,
) -> Genome:
    """Return what a side learns against an opponent in a turn."""
    for _ in range(EPOCHS):
        noise = rng.standard_normal((CANDIDATES, len(parent)), dtype=np.float32)
        candidates = parent + SIGMA * noise
        seeds = rng.integers(2**63, size=MATCHES)
        parent = select(candidates, scores(side, candidates, opponent, seeds))
    return parent


def turn(archives: Archives, seed: int, generation: int, side: int, **other: Any) -> Genome:
    """Return what a side should have learned in a turn, from what is archived before it."""
    opponent = archives[1 - side][generation - 1 + side]  # pursuers learn first
    parent = archives[side][generation - 1]
    return learn(side, parent, opponent, np.random.default_rng([seed, generation, side]), **other)


def race(seed: int, generations: int) -> tuple[list[Genome], list[Genome]]:
    """Return the archives of both teams."""
    archives = [first_genome(seed, 0)], [first_genome(seed, 1)]
    for generation in range(1, generations + 1):
        for side in (0, 1):
            archives[side].append(turn(archives, seed, generation, side))
    return archives


def all_against_all(archives: Archives, episodes: int = 10) -> FloatArray:
    """Return the capture rates of all generations against all."""
    shape = (*map(len, archives), episodes)
    matches = Matches.of(*(each.ravel() for each in np.indices(shape)))
    rates = captured(np.stack(archives[0]), np.stack(archives[1]), matches).capture_rate
    return np.asarray(rates.reshape(shape).mean(axis=2), np.float64)


# ---- The same with DEAP --------------------------------------------------------------------------


class Fitness(base.Fitness):
    """One value; more is better."""

    weights = (1.0,)


class Player:
    """An individual, as DEAP expects it."""

    def __init__(self, genome: Genome) -> None:
        self.genome, self.fitness = genome, Fitness()


def mutate(player: Player, rng: np.random.Generator) -> tuple[Player]:
    """Return a child."""
    noise = rng.standard_normal(len(player.genome), dtype=np.float32)
    return (Player(player.genome + SIGMA * noise),)


def evaluate(
    players: Sequence[Player], side: int, opponent: Genome, rng: np.random.Generator
) -> FloatArray:
    """Return the fitness of players of a side, a row each, by one call of `rollout`."""
    genomes = np.stack([player.genome for player in players])
    return scores(side, genomes, opponent, rng.integers(2**63, size=MATCHES))[:, None]


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


FEWEST_GENERATIONS = 3
CLOSE = 1e-3
"""Genes that differ by less are equal: sums may be rounded in another order."""


def exercise_3(answer: Any) -> None:
    """Write a race by hand; each turn is compared with what the reference learns in it."""
    if not isinstance(answer, tuple | list) or len(answer) != 4:
        raise Mistake("Expected `answer = SEED, pursuers, evaders, payoff`.")
    seed = whole(answer[0], "a whole number as seed")
    archives = [_archive(answer[1 + side], side, seed) for side in (0, 1)]
    counts = [*map(len, archives)]
    if counts[0] != counts[1] or counts[0] <= FEWEST_GENERATIONS:
        raise Mistake(
            f"Expected generation 0 and {FEWEST_GENERATIONS} or more after it in both archives, "
            f"got {counts[0]} and {counts[1]} genomes."
        )
    for generation in range(1, counts[0]):
        for side in (0, 1):
            if not _equal(archives[side][generation], turn(archives, seed, generation, side)):
                told = _why_other(archives, seed, generation, side)
                raise Mistake(f"Generation {generation} of the {SIDES[side]}: {told}")
    with about("payoff"):
        _judge_payoff(array(answer[3], "all against all", *counts), all_against_all(archives))


def _archive(value: Any, side: int, seed: int) -> list[Genome]:
    """Return an archive of a student as float32."""
    genes = NETWORK.genome_size
    with about(SIDES[side]):
        if not isinstance(value, Iterable):
            raise Mistake(f"Expected a list of genomes, got {described(value)}.")
        found = [array(each, f"genomes of {genes} numbers", genes) for each in value]
        if not np.isfinite(found).all():
            raise Mistake("Expected numbers, got NaN or infinity among them.")
        if not found or not _equal(found[0], first_genome(seed, side)):
            raise Mistake(
                f"Generation 0 is first_genome(seed, {side}), before anybody has learned."
            )
    return [each.astype(np.float32) for each in found]


def _equal(one: Any, other: Any) -> bool:
    return bool(np.allclose(one, other, rtol=0.0, atol=CLOSE))


def _why_other(archives: Archives, seed: int, generation: int, side: int) -> str:
    """Say what a turn did that gave another genome."""
    found, (own, opponents) = archives[side][generation], (archives[side], archives[1 - side])
    parent, opponent = own[generation - 1], opponents[generation - 1 + side]

    def learned(opponent: Genome, drawn: int = side, **other: Any) -> Genome:
        rng = np.random.default_rng([seed, generation, drawn])
        return learn(side, parent, opponent, rng, **other)

    typical: dict[str, Callable[[], Genome]] = {
        "it is the generation before, and has learned nothing.": lambda: parent,
        "these are the candidates with the lowest scores. What does this team want?": (
            lambda: learned(opponent, select=lambda c, s: c[np.argsort(1 - s)[-BEST:]].mean(axis=0))
        ),
        "it is the best candidate alone; the next parent is the mean of several.": (
            lambda: learned(opponent, select=lambda c, s: c[np.argmax(s)])
        ),
        "it learned against the wrong generation. Which opponents are the newest in this turn?": (
            lambda: learned(opponents[generation - side])
        ),
        "the opponents were those of generation 0. The newest ones stand at the end.": (
            lambda: learned(opponents[0])
        ),
        "the generator is that of the other team's turn.": lambda: learned(opponent, 1 - side),
    }
    for told, make in typical.items():
        if _equal(found, make()):
            return told
    return (
        "another genome was expected from what you archived before it. Compare the turn with the "
        "docstrings, line by line: first the noise, then the seeds, in each epoch."
    )


def _judge_payoff(found: FloatArray, right: FloatArray) -> None:
    if _equal(found, right):
        return
    if _equal(found, right.T):
        raise Mistake("Rows and columns are exchanged: a row is a generation of pursuers.")
    if _equal(found, 1 - right):
        raise Mistake("These are the shares that escaped.")
    raise Mistake(
        "The archives are right, and other capture rates were expected. Is it the capture rate at "
        "the end, the second value of `captured`? Are the seeds 0 to 9?"
    )


GENES, ASKED, NOISE = 60, 200, 0.01
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
            f"It ran without an error. After {ASKED} epochs it had covered {least:.0%} of "
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
    for _ in range(ASKED):
        candidates = _candidates(function(learner.ask)(rng))
        distances = np.linalg.norm(candidates - target, axis=1) / begin
        function(learner.tell)(-distances + NOISE * rng.standard_normal(len(candidates)))
    with about("genome"):
        genome = array(learner.genome, f"{GENES} numbers", GENES)
        if not np.isfinite(genome).all():
            raise Mistake(f"Expected {GENES} numbers, got NaN or infinity among them.")
    return 1.0 - float(np.linalg.norm(np.float32(genome) - target)) / begin


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
