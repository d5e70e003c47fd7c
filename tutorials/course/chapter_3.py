"""Exercises of notebook 3: a race of two teams, written by hand."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from deap import base

from course.checks import Mistake, about, array, comparison, described, whole
from matrixworld import EpisodeStatistics, Game, Matches, Network, Population, WorldConfig, rollout
from matrixworld.coevolution import check_game
from matrixworld.coevolution.types import TEAMS, FloatArray, Genome, Genomes

# ---- A race by hand ------------------------------------------------------------------------------

WORLD = WorldConfig("O", rows=12, cols=12, n_pursuers=3, n_evaders=6, fov=5, max_steps=60)
NETWORK = Network.for_config(WORLD, hidden=(8,))
EPOCHS, CANDIDATES, MATCHES, BEST = 8, 40, 4, 8
SIGMA = np.float32(0.2)
SIDES = ("pursuers", "evaders")
Archives = Sequence[Sequence[Genome]]
"""The genomes of pursuers and of evaders, from generation 0 on."""


def captured(pursuers: Genomes, evaders: Genomes, matches: Matches) -> EpisodeStatistics:
    return rollout(WORLD, Population(pursuers, NETWORK), Population(evaders, NETWORK), matches)


def first_genome(seed: int, side: int) -> Genome:
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


def turn(
    archives: Archives, seed: int, generation: int, side: int, learn: Callable[..., Genome] = learn
) -> Genome:
    """Return what a side should have learned in a turn, from what is archived before it."""
    opponent = archives[1 - side][generation - 1 + side]  # pursuers learn first
    rng = np.random.default_rng([seed, generation, side])
    return learn(side, archives[side][generation - 1], opponent, rng)


def race(
    seed: int, generations: int, learn: Callable[..., Genome] = learn
) -> tuple[list[Genome], list[Genome]]:
    archives = [first_genome(seed, 0)], [first_genome(seed, 1)]
    for generation in range(1, generations + 1):
        for side in (0, 1):
            archives[side].append(turn(archives, seed, generation, side, learn))
    return archives


def all_against_all(archives: Archives, episodes: int = 10) -> FloatArray:
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
    noise = rng.standard_normal(len(player.genome), dtype=np.float32)
    return (Player(player.genome + SIGMA * noise),)


def evaluate(
    players: Sequence[Player], side: int, opponent: Genome, rng: np.random.Generator
) -> FloatArray:
    """Return the fitness of players of a side, a row each, by one call of `rollout`."""
    genomes = np.stack([player.genome for player in players])
    return scores(side, genomes, opponent, rng.integers(2**63, size=MATCHES))[:, None]


# ---- Exercises -----------------------------------------------------------------------------------


exercise_1 = comparison(
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
"""Count the numbers of a genome."""


def _why_matches(found: float, right: int, spread: float, error: float) -> str:
    if math.isclose(found, spread / error) or found == math.ceil(spread / error):
        return "It is too few. Half the error takes more than twice the matches."
    if right - 1 < found < right:
        return f"Exactly it is {found}, and a number of matches is whole: round up."
    if found in (right - 1, right + 1):
        return "One match more is needed." if found < right else "One match less is enough."
    error_then = f"{spread / math.sqrt(found):.3g}" if found > 0 else "not defined"
    return f"With so many matches the standard error is {error_then}, and {error:g} is asked for."


exercise_2 = comparison(
    lambda spread, error: math.ceil(round((spread / error) ** 2, 6)),
    [(0.2, 0.1), (0.17, 0.01), (0.3, 0.05), (0.2, 0.03)],
    case="For a spread of {spread} and an error of {error}",
    otherwise=_why_matches,
)
"""Say how many matches a standard error takes."""


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
        found, right = array(answer[3], "all against all", *counts), all_against_all(archives)
        typical = {
            "Rows and columns are exchanged: a row is a generation of pursuers.": right.T,
            "These are the shares that escaped.": 1 - right,
        }
        if not _equal(found, right):
            other = "The archives are right, and capture rates with the seeds 0 to 9 were expected."
            raise Mistake(next((t for t, wrong in typical.items() if _equal(found, wrong)), other))


def _archive(value: Any, side: int, seed: int) -> list[Genome]:
    """Return an archive of a student as float32."""
    genes = NETWORK.genome_size
    with about(SIDES[side]):
        found = array(value, f"a list of genomes of {genes} numbers", ..., genes)
        if not len(found) or not _equal(found[0], first_genome(seed, side)):
            raise Mistake(
                f"Generation 0 is first_genome(seed, {side}), before anybody has learned."
            )
    return [*found.astype(np.float32)]


def _equal(one: Any, other: Any) -> bool:
    return bool(np.allclose(one, other, rtol=0.0, atol=CLOSE))


def _why_other(archives: Archives, seed: int, generation: int, side: int) -> str:
    """Say what a turn did that gave another genome."""
    parent, found = archives[side][generation - 1 : generation + 1]
    opponents = archives[1 - side]
    usual = {"opponent": opponents[generation - 1 + side], "drawn": side}
    typical: dict[str, dict[str, Any]] = {
        "these are the candidates with the lowest scores. What does this team want?": {
            "select": lambda candidates, found: mean_of_best(candidates, 1 - found)
        },
        "it is the best candidate alone; the next parent is the mean of several.": {
            "select": lambda candidates, found: candidates[np.argmax(found)]
        },
        "it learned against the wrong generation. Which opponents are the newest in this turn?": {
            "opponent": opponents[generation - side]
        },
        "the opponents were those of generation 0. The newest ones stand at the end.": {
            "opponent": opponents[0]
        },
        "the generator is that of the other team's turn.": {"drawn": 1 - side},
    }
    if _equal(found, parent):
        return "it is the generation before, and has learned nothing."
    for told, change in typical.items():
        how = usual | change
        rng = np.random.default_rng([seed, generation, how.pop("drawn")])
        if _equal(found, learn(side, parent, rng=rng, **how)):
            return told
    return (
        "another genome was expected from what you archived before it. Compare the turn with the "
        "docstrings, line by line: first the noise, then the seeds, in each epoch."
    )


DRAWN = 64
"""Random pairs of genomes of which not all may have the same score."""


def exercise_4(answer: Any) -> None:
    """Write a game of one's own: `check_game` says which of its promises is broken."""
    if not isinstance(answer, Game):
        raise Mistake(f"Expected a game: `mw.Game(play, genes=...)`, got {described(answer)}.")
    try:
        check_game(answer)
    except ValueError as error:
        if str(error).startswith(("play:", "scores of the game:", "initial:")):
            raise Mistake(f"A promise is broken. {error}.") from None
        raise
    rng = np.random.default_rng(0)
    first, second = (
        answer.population(team, np.stack([answer.untrained(team, rng) for _ in range(DRAWN)]))
        for team in TEAMS
    )
    matches = Matches.of(range(DRAWN), range(DRAWN), range(DRAWN))
    scores = answer.rollout(first, second, matches, episodes=1, threads=1).of("pursuer")
    if np.ptp(scores) == 0.0:
        raise Mistake(
            f"All of {DRAWN} matches between random genomes have the score {scores.flat[0]:g}, so "
            "selection has nothing to choose from."
        )
