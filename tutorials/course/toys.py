"""Toys with known answers: games of two populations, raced in memory, which takes seconds.

The loop of their races is that of the package, with its schedules, opponents and pairings: what
these do here they do in real races, too. ``evolution/games`` has such games for races in files.

>>> from course import toys
>>> toys.numbers_game("scalar", seed=0).final_objective.round()
array([ 99., 100.])

*Rock-paper-scissors* between two teams with a perfect learner: it plays a best response, so only
the schedule matters. Specialists cycle with period three. A team that answers all past hands of the
other plays fictitious play (Brown 1951), whose average approaches the equilibrium.

*Numbers games* (Watson & Pollack 2001, "Coevolutionary dynamics in a minimal substrate", GECCO):
two populations of bit strings, where more ones win, in one dimension or another. Selection uses
wins alone; the number of ones, the objective, is only observed. A mutation rate of 0.005 a bit can
be read in two ways: here it flips the bit. To redraw the bit at this rate changes half as many, as
``flips=0.0025``; ``tests/course/test_toys.py`` has the results of both.

*Hosts and parasites* (Cartlidge & Bullock 2004, "Combating coevolutionary disengagement by reducing
parasite virulence", Evolutionary Computation 12(2)): the scalar game, but a bit that mutates
becomes a one with the probability of its side's *bias*, which is higher for parasites. Those of
reduced virulence are rewarded for winning less than the most.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.integrate import solve_ivp

from matrixworld.coevolution import Game, GeneticAlgorithm, RaceSettings, Task, Training, train
from matrixworld.coevolution.games.game import Scores
from matrixworld.coevolution.learners.generational import unscored
from matrixworld.coevolution.learners.genetic_algorithm import TOURNAMENT
from matrixworld.coevolution.learners.selection import select_tournament
from matrixworld.coevolution.states import State
from matrixworld.coevolution.types import (
    TEAMS,
    BoolArray,
    FloatArray,
    Genomes,
    Indices,
    IntArray,
    Matches,
    Rng,
    Team,
)

# ---- Rock-paper-scissors -------------------------------------------------------------------------

PAYOFF = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]])
"""Of the pursuers' rock, paper and scissors (rows) against the evaders', who get one minus it."""
WEIGHTED = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.4], [0.0, 0.6, 0.5]])
"""The same where scissors beat paper in 60 % of the matches only."""


def _hands_game(payoff: FloatArray) -> Game:
    """Return the game of strategies, which are probabilities of hands; all start with rock."""

    def play(a: FloatArray, b: FloatArray, rng: Rng) -> FloatArray:
        return np.asarray(np.einsum("mi,ij,mj->m", a, payoff, b))

    def rock(rng: Rng) -> FloatArray:
        return np.eye(3)[0]

    return Game(play, 3, ("pursuers", "evaders"), rock, deterministic=True)


HANDS, WEIGHTED_HANDS = _hands_game(PAYOFF), _hands_game(WEIGHTED)


@dataclass(frozen=True)
class BestHand(GeneticAlgorithm):
    """Tries all three hands; the one that scores most is the champion."""

    population: int = 3

    def ask(self, state: State, rng: Rng) -> tuple[Genomes, State]:
        """Return the hands in random order: of equals the first one is best."""
        hands = rng.permutation(np.eye(3, dtype=np.float32))
        return hands, state._replace(candidates=hands)


ALL = 10**6
IN_TURNS = {"pursuer_epochs": 1, "evader_epochs": 1}
AT_ONCE = {"kind": "hall-of-fame", "joint_epochs": 1, "contemporaries": 0}
RACES_OF_HANDS: dict[str, dict[str, Any]] = {
    "specialists": {"kind": "specialist-specialist", **IN_TURNS},
    "generalists": {"kind": "generalist-generalist", "opponents": ALL, **IN_TURNS},
    "fictitious play": {**AT_ONCE, "hall_sample": ALL},
}
"""Schedules: answers to the newest hand, and to all past hands, in turns or at the same time."""


def race_of_hands(name: str, generations: int, seed: int = 0) -> dict[Team, list[int]]:
    """Play one of `RACES_OF_HANDS`, and return the hands of each team, 0 to 2.

    `generations` are those after the first one.
    """
    schedule = {**RACES_OF_HANDS[name], "generations": generations}
    settings = RaceSettings.of(game=HANDS, learner=BestHand(), schedule=schedule, seed=seed)
    race = train(Training(settings, threads=1))
    return {team: np.argmax(race.archive[team], axis=1).tolist() for team in TEAMS}


def replicators(
    payoff: FloatArray, start: ArrayLike, *, time: float, points: int
) -> tuple[FloatArray, FloatArray]:
    """Return times (points,) and shares (points, n) of the first of two populations.

    A strategy becomes more frequent if it gains more than the mean of its population
    (Taylor and Jonker 1978): ``x_g' = x_g ((A y)_g - x A y)``, ``y_h' = y_h (x A y - (x A)_h)``.
    The second population begins with equal shares.
    """
    n, m = payoff.shape
    x, y = np.asarray(start, float), np.full(m, 1.0 / m)

    def shares(first: FloatArray, collected: FloatArray) -> FloatArray:
        # Shares are proportional to the exponential of what a strategy has collected.
        grown = first * np.exp(collected - collected.max(axis=-1, keepdims=True))
        return np.asarray(grown / grown.sum(axis=-1, keepdims=True))

    def gained(_: float, state: FloatArray) -> FloatArray:
        return np.append(payoff @ shares(y, state[n:]), shares(x, state[:n]) @ -payoff)

    times = np.linspace(0.0, time, points)
    solved = solve_ivp(
        gained, (0.0, time), np.zeros(n + m), "DOP853", times, rtol=1e-12, atol=1e-12
    )
    return times, shares(x, solved.y[:n].T)


# ---- Nim -----------------------------------------------------------------------------------------

STONES, MOST = 13, 3
"""Players take 1 to 3 of 13 stones in turn; who takes the last one wins.

A genome has a preference for each move, by the stones that are left. Perfect play leaves a multiple
of four, so that the first player can win against everybody.
"""


def taken(genomes: Genomes, left: IntArray) -> IntArray:
    """Return how many stones genomes (M, genes) take of those that are left (M,)."""
    preferences = genomes.reshape(-1, STONES, MOST)[np.arange(len(genomes)), left - 1]
    allowed = np.arange(1, MOST + 1) <= left[:, np.newaxis]
    return np.asarray(1 + np.argmax(np.where(allowed, preferences, -np.inf), axis=1))


def _play_nim(a: Genomes, b: Genomes, rng: Rng) -> FloatArray:
    left, scores = np.full(len(a), STONES), np.empty(len(a))
    for turn in range(STONES):
        going = np.flatnonzero(left)
        left[going] -= taken((a, b)[turn % 2][going], left[going])
        scores[going] = 1 - turn % 2  # the last one who moves wins
    return scores


NIM = Game(_play_nim, STONES * MOST, ("first", "second"), deterministic=True)


def race_of_nim(seed: int, generations: int = 20) -> list[Genomes]:
    """Play a race of generalists, and return the champions of both players by generation."""
    schedule = {"kind": "generalist-generalist", "generations": generations}
    settings = RaceSettings.of(game=NIM, learner="ga", schedule=schedule, seed=seed)
    race = train(Training(settings))
    return [np.array(race.archive[team]) for team in TEAMS]


def all_against_all(game: Game, first: Genomes, second: Genomes) -> FloatArray:
    """Return the scores (n, m) of genomes of the first team against those of the second one."""
    i, j = np.indices((len(first), len(second)))
    scores = game.play(first[i.ravel()], second[j.ravel()], np.random.default_rng(0))
    return np.asarray(scores).reshape(i.shape)


def perfect_players(count: int) -> Genomes:
    """Return players of Nim that leave multiples of four, and move at random where they cannot."""
    genomes = np.random.default_rng(0).random((count, STONES, MOST), dtype=np.float32)
    for left in range(1, STONES + 1):
        if left % 4:
            genomes[:, left - 1, left % 4 - 1] += 1.0
    return genomes.reshape(count, -1)


# ---- Populations of bits -------------------------------------------------------------------------

BITS = 100
"""Bits of an individual, over all numbers."""
POPULATION = 25
"""Individuals of each population."""
REDRAWN = 0.03
"""Probability that a mutation of hosts and parasites redraws a bit."""
HOST_BIAS, PARASITE_BIAS = 0.5, 0.75
"""Probability that a redrawn bit is a one."""


def _numbers_game(count: int, extreme: Callable[..., Indices]) -> Game:
    """Return a game of some numbers; the one with the extreme difference decides."""

    def play(a: FloatArray, b: FloatArray, rng: Rng) -> FloatArray:
        each, deciding = np.arange(len(a)), extreme(np.abs(a - b), axis=1)
        return np.asarray((1.0 + np.sign(a[each, deciding] - b[each, deciding])) / 2.0)

    def zeros(rng: Rng) -> FloatArray:
        return np.zeros(count)

    return Game(play, count, ("hosts", "parasites"), zeros, deterministic=True)


SCALAR = _numbers_game(1, np.argmax)
FOCUSING = _numbers_game(10, np.argmax)
INTRANSITIVE = _numbers_game(2, np.argmin)
GAMES = {"scalar": SCALAR, "focusing": FOCUSING, "intransitive": INTRANSITIVE}
"""Numbers games: more ones win, in the number in which individuals differ most, or least.

A genome is how many of its bits are ones, for each number. In the focusing game other numbers drift
away. In the intransitive one a beats b, b beats c, and c beats a: a population can win and lose
ones."""


def beats(game: Game, a: ArrayLike, b: ArrayLike) -> BoolArray:
    """Return (M,) whether a beats b, by ones (M, numbers); if neither does, it is a draw."""
    rng = np.random.default_rng(0)  # which these games do not use
    return np.asarray(game.play(np.asarray(a), np.asarray(b), rng)) == 1.0


class Counted(NamedTuple):
    """A population of ones and its wins; the bits of each of its numbers, and the team's bias."""

    population: Genomes
    fitness: FloatArray
    champion: NDArray[np.intp]
    bits: IntArray
    bias: FloatArray
    candidates: Genomes | None = None


@dataclass(frozen=True)
class Bits(GeneticAlgorithm):
    """A genetic algorithm of ones: children are their parents with redrawn bits."""

    population: int = POPULATION
    redrawn: float = REDRAWN
    host_bias: float = HOST_BIAS
    parasite_bias: float = HOST_BIAS
    proportionate: bool = False
    """Whether parents are drawn in proportion to their wins, instead of by tournaments."""

    def start(self, task: Task) -> State:
        """Return a population that nobody has scored yet."""
        bits, bias = BITS // task.game.genome_size("pursuer"), (self.host_bias, self.parasite_bias)
        facts = {"bits": np.array(bits), "bias": np.array(bias[task.team])}
        return Counted(**unscored(task.genomes(self.population)), **facts)

    def offspring(self, state: State, rng: Rng) -> Genomes:
        """Return the children of a population."""
        parents = state.population[self._parents(state.fitness, rng)].astype(int)
        gained = rng.binomial(state.bits - parents, self.redrawn * state.bias)
        lost = rng.binomial(parents, self.redrawn * (1.0 - state.bias))
        return (parents + gained - lost).astype(np.float32)

    def fitness(self, game: Any, scores: Scores, team: Team, table: Any) -> FloatArray:
        """Return the fitness of individuals by their wins, which the game counts."""
        return np.asarray(game.fitness(team), float)

    def _parents(self, wins: FloatArray, rng: Rng) -> Indices:
        if not self.proportionate:
            return select_tournament(wins, len(wins), rng, size=self.tournament or TOURNAMENT)
        sums = np.cumsum(wins if wins.any() else np.ones(len(wins)))
        return np.searchsorted(sums, rng.random(len(wins)) * sums[-1], "right")


@dataclass(frozen=True)
class History:
    """Two populations of n individuals, from the start to generation G."""

    game: Game
    ones: IntArray  # of each individual, (G + 1, 2, n, numbers)
    wins: FloatArray  # matches that each individual won, (G + 1, 2, n)

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
        """Whether individuals of both populations differ in their wins, (G + 1,)."""
        return np.asarray((np.ptp(self.wins, axis=2) > 0.0).all(axis=1))

    def scores(self, generations: ArrayLike, episodes: int, rng: Rng) -> FloatArray:
        """Play matches between k generations, each of two individuals drawn with replacement.

        Returns the scores (k, k, episodes) of side 0 (rows) against side 1 (columns).
        """
        picked = np.asarray(generations)
        shape = (len(picked), len(picked), episodes)
        # One draw for each side of all matches: new individuals in each episode.
        first, second = (rng.integers(self.ones.shape[2], size=shape).ravel() for _ in (0, 1))
        i, j, _ = (index.ravel() for index in np.indices(shape))
        a, b = self.ones[picked[i], 0, first], self.ones[picked[j], 1, second]
        return self.game.play(a, b, rng).reshape(shape)


@dataclass(frozen=True, eq=False)
class _Watched(Game):
    """A game that keeps who has played in each epoch, and how many matches they have won."""

    parasites: Callable[[FloatArray], Any] = np.asarray
    ones: list[list[Genomes]] = field(default_factory=list)
    wins: list[list[IntArray]] = field(default_factory=list)

    def rollout(self, first: Any, second: Any, matches: Matches, **options: Any) -> Scores:
        """Play the matches of an epoch; draws are worth nothing."""
        scores = super().rollout(first, second, matches, **options)
        won = zip(matches[:2], (scores.of(team)[:, 0] == 1.0 for team in TEAMS), strict=True)
        self.ones.append([first.genomes, second.genomes])
        self.wins.append([np.bincount(*each, POPULATION) for each in won])
        return scores

    def fitness(self, team: Team) -> FloatArray:
        """Return the fitness (n,) of a team's individuals in the last epoch."""
        hosts, parasites = self.wins[-1]
        return hosts if team == "pursuer" else self.parasites(parasites * 1.0)


def evolve(
    game: Game,
    learner: Bits,
    seed: int,
    *,
    generations: int,
    opponents: int,
    parasites: Callable[[FloatArray], Any] = np.asarray,
) -> History:
    """Evolve two populations against each other, from all zeros.

    A generation is an epoch of a race in which both learn at the same time: each individual plays
    some opponents, and both sides breed by their wins. `parasites` returns the fitness of side 1
    for its wins (n,).
    """
    schedule = {
        "kind": "hall-of-fame", "generations": 1, "joint_epochs": generations + 1,
        "contemporaries": opponents, "hall_sample": 0,
    }  # fmt: skip
    settings = RaceSettings.of(game=game, learner=learner, schedule=schedule, seed=seed)
    given = {each.name: getattr(game, each.name) for each in fields(game) if each.init}
    watched = _Watched(**given, parasites=parasites)
    race = Training(settings, threads=1)
    race.game = watched
    train(race)
    return History(game, np.array(watched.ones).astype(int), np.array(watched.wins))


def numbers_game(name: str, seed: int, *, generations: int = 600, flips: float = 0.005) -> History:
    """Play one of `GAMES` with fitness-proportionate selection; individuals meet 15 opponents each.

    A bit is flipped with the probability `flips`.
    """
    learner = Bits(proportionate=True, redrawn=2.0 * flips)  # half of the redrawn bits change
    return evolve(GAMES[name], learner, seed, generations=generations, opponents=15)


def reduced_virulence(wins: FloatArray, virulence: float) -> FloatArray:
    """Return the fitness (n,) of reduced virulence, at most 1; zeros if all wins (n,) are 0.

    ``f = 2x/v - x^2/v^2`` with ``x = wins / max(wins)`` and a virulence v from 0.5 to 1: the best
    share of the most wins is v. At virulence 1 more wins are always better. Below 1 a side that
    could win every match is held back, so that the other one keeps something to learn from.
    """
    best = wins.max()
    share = (wins / best if best > 0.0 else wins) / virulence
    return np.asarray(2.0 * share - share * share)


def hosts_and_parasites(
    virulence: float | Callable[[FloatArray], ArrayLike], seed: int, *, generations: int = 600
) -> History:
    """Evolve hosts (side 0, of virulence 1) and parasites (side 1), which meet 5 opponents each.

    `virulence` is that of the parasites, from 0.5 to 1; or their fitness, as a function of the wins
    (n,).
    """
    own = virulence if callable(virulence) else partial(reduced_virulence, virulence=virulence)
    learner = Bits(parasite_bias=PARASITE_BIAS)
    return evolve(SCALAR, learner, seed, generations=generations, opponents=5, parasites=own)
