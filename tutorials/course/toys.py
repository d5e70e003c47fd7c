"""Toys with known answers: co-evolution in plain NumPy that takes seconds.

They use the schedules, pairings and selection of the real races: what these do here they do there,
too. A race in files takes 15 times as long, or more; ``evolution/games`` has such games for it.

>>> from course import toys
>>> toys.numbers_game("scalar", seed=0).final_objective.round()
array([99., 99.])

*Rock-paper-scissors* between two teams with a perfect learner: it plays a best response, so only
the schedule matters. Specialists cycle with period three. A team that answers all past hands of the
other plays fictitious play (Brown 1951), whose average approaches the equilibrium.

*Numbers games* (Watson & Pollack 2001, "Coevolutionary dynamics in a minimal substrate", GECCO):
two populations of bit strings, where more ones win, in one dimension or another. Selection uses
wins alone; the number of ones, the objective, is only observed. A mutation rate of 0.005 a bit can
be read in two ways: here it flips the bit. To redraw the bit at this rate changes half as many, as
``flips=0.0025``; ``docs/coevolution.md`` has the results of both.

*Hosts and parasites* (Cartlidge & Bullock 2004, "Combating coevolutionary disengagement by reducing
parasite virulence", Evolutionary Computation 12(2)): the scalar game, but a bit that mutates
becomes a one with the probability of its side's *bias*, which is higher for parasites. Those of
reduced virulence are rewarded for winning less than the most.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from scipy.integrate import solve_ivp

from matrixworld.coevolution.learners.genetic_algorithm import select_tournament
from matrixworld.coevolution.race import SCHEDULES, available, pairings
from matrixworld.coevolution.types import (
    TEAMS,
    BoolArray,
    FloatArray,
    Indices,
    IntArray,
    Team,
    other,
)

# ---- Rock-paper-scissors -------------------------------------------------------------------------

HandHistory = dict[Team, list[int]]
"""Team -> its hand in each generation: `ROCK`, `PAPER` or `SCISSORS`."""

ROCK, PAPER, SCISSORS = range(3)
PAYOFF = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]])
"""Of the pursuers' hands (rows) against the evaders', whose own payoff is one minus it."""
ROUNDING = 1e-9
"""Sums of payoffs that differ by less are equal."""


def capture_probabilities(
    pursuers: FloatArray, evaders: FloatArray, *, luck: float = 0.0
) -> FloatArray:
    """Return the probability (n, m) that each pursuer captures each evader; a draw is one half.

    Strategies (n, 3) and (m, 3) are probabilities of the hands; ``np.eye(3)[hands]`` are pure ones.
    `luck`, in [0, 1/2], is the probability that the worse hand wins.
    """
    return np.asarray(luck + (1.0 - 2.0 * luck) * (pursuers @ PAYOFF @ evaders.T))


def best_response(team: Team, opponents: ArrayLike, rng: np.random.Generator) -> int:
    """Return the hand with the highest mean payoff to a team against hands (c,); ties by lot."""
    counts = np.bincount(np.asarray(opponents), minlength=3)
    payoffs = PAYOFF @ counts if team == "pursuer" else -(counts @ PAYOFF)
    # Equal sums may differ in their last bits, and a tie must stay a tie.
    best = np.flatnonzero(payoffs > payoffs.max() - ROUNDING)
    return int(rng.choice(best))


def alternate(schedule: str, generations: int, epochs: int, seed: int = 0) -> HandHistory:
    """Play an alternating race, and return the hands of each team; both start with rock.

    A generation responds to the opponents that the sampler of a schedule of `coevolution.SCHEDULES`
    chooses in its epochs, each weighted by how often it was chosen. `generations` are those after
    the first one.
    """
    rng = np.random.default_rng(seed)
    samplers = {team: SCHEDULES[schedule].sampler(team) for team in TEAMS}
    hands: HandHistory = {"pursuer": [ROCK], "evader": [ROCK]}
    for k in range(1, generations + 1):
        for team in TEAMS:
            count = available(team, k)
            chosen = [int(samplers[team].sample({}, count, 1, i, rng)[0]) for i in range(epochs)]
            opponents = [hands[other(team)][index] for index in chosen]
            hands[team].append(best_response(team, opponents, rng))
    return hands


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


# ---- Populations of bits -------------------------------------------------------------------------

BITS = 100
"""Bits of an individual, over all dimensions."""
POPULATION = 25
"""Individuals of each population."""
REDRAWN = 0.03
"""Probability that a mutation of hosts and parasites redraws a bit."""
HOST_BIAS, PARASITE_BIAS = 0.5, 0.75
"""Probability that a redrawn bit is a one."""


@dataclass(frozen=True)
class Game:
    """A game between two individuals, decided by their ones in each dimension.

    `shape` is (dimensions, bits in each). The dimension with the `extreme` difference decides.
    """

    shape: tuple[int, int]
    extreme: Callable[..., Indices]

    def beats(self, a: IntArray, b: IntArray) -> BoolArray:
        """Return (M,) whether a beats b, by ones (M, dimensions); if neither does, it is a draw."""
        each, dimension = np.arange(len(a)), self.extreme(np.abs(a - b), axis=1)
        return np.asarray(a[each, dimension] > b[each, dimension])

    def scores(self, a: IntArray, b: IntArray) -> FloatArray:
        """Return the scores (M,) of a against b: 1 for a win, 1/2 for a draw, 0 for a loss."""
        return np.asarray((1.0 + self.beats(a, b) - self.beats(b, a)) / 2.0)


GAMES = {
    "scalar": Game((1, BITS), np.argmax),
    "focusing": Game((10, BITS // 10), np.argmax),
    "intransitive": Game((2, BITS // 2), np.argmin),
}
"""Numbers games: more ones win, in the dimension in which individuals differ most, or least.

In the focusing game other dimensions drift away. In the intransitive one a beats b, b beats c, and
c beats a: a population can win and lose ones."""


Breed = Callable[[BoolArray, FloatArray, np.random.Generator], BoolArray]
"""Takes the bits (n, ...) of a population, its wins (n,) and a generator; returns the children."""


@dataclass(frozen=True)
class History:
    """G generations of two populations of n individuals."""

    game: Game
    ones: IntArray  # of each individual, (G + 1, 2, n, dimensions), from the start to the end
    wins: FloatArray  # matches that each individual won, (G, 2, n)

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
        """Whether individuals of both populations differ in their wins, (G,)."""
        return np.asarray((np.ptp(self.wins, axis=2) > 0.0).all(axis=1))

    def scores(self, generations: ArrayLike, episodes: int, rng: np.random.Generator) -> FloatArray:
        """Play matches between k generations, each of two individuals drawn with replacement.

        Returns the scores (k, k, episodes) of side 0 (rows) against side 1 (columns).
        """
        picked = np.asarray(generations)
        shape = (len(picked), len(picked), episodes)
        # One draw for each side of all matches: new individuals in each episode.
        first, second = (rng.integers(self.ones.shape[2], size=shape).ravel() for _ in (0, 1))
        i, j, _ = (index.ravel() for index in np.indices(shape))
        a, b = self.ones[picked[i], 0, first], self.ones[picked[j], 1, second]
        return self.game.scores(a, b).reshape(shape)


def evolve(
    game: Game, breeds: tuple[Breed, Breed], seed: int, *, generations: int, opponents: int
) -> History:
    """Evolve two populations against each other, from all zeros.

    In each generation each individual plays some opponents, paired by random permutations, and both
    sides breed by their wins.
    """
    rng = np.random.default_rng(seed)
    bits = [np.zeros((POPULATION, *game.shape), dtype=np.bool_) for _ in breeds]
    ones, wins = [_ones(bits)], []
    one_group = np.zeros(POPULATION, dtype=np.intp)
    for _ in range(generations):
        pairs = pairings(one_group, opponents, (0, 0), rng)
        scores = game.scores(ones[-1][0, pairs.pursuer], ones[-1][1, pairs.evader])
        won = [
            np.bincount(players, weights=each == 1.0, minlength=POPULATION)
            for players, each in ((pairs.pursuer, scores), (pairs.evader, 1.0 - scores))
        ]
        bits = [breed(*each, rng) for breed, *each in zip(breeds, bits, won, strict=True)]
        ones.append(_ones(bits))
        wins.append(won)
    return History(game, np.array(ones), np.array(wins))


def _ones(bits: list[BoolArray]) -> IntArray:
    return np.array([team.sum(axis=2) for team in bits])


def numbers_game(name: str, seed: int, *, generations: int = 600, flips: float = 0.005) -> History:
    """Play one of `GAMES` with fitness-proportionate selection; individuals meet 15 opponents each.

    A bit is flipped with the probability `flips`.
    """

    def breed(bits: BoolArray, wins: FloatArray, rng: np.random.Generator) -> BoolArray:
        # Wins are the fitness: the objective must not leak into selection.
        chances = wins / wins.sum() if wins.any() else None
        parents = rng.choice(POPULATION, size=POPULATION, p=chances)
        return np.asarray(bits[parents] ^ (rng.random(bits.shape) < flips))

    return evolve(GAMES[name], (breed, breed), seed, generations=generations, opponents=15)


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
    virulence: float | Callable[[FloatArray], ArrayLike],
    seed: int,
    *,
    generations: int = 600,
    tournament: int = 5,
    biases: tuple[float, float] = (HOST_BIAS, PARASITE_BIAS),
) -> History:
    """Evolve hosts (side 0, of virulence 1) and parasites (side 1), which meet 5 opponents each.

    `virulence` is that of the parasites, from 0.5 to 1; or their fitness, as a function of the wins
    (n,). Parents win tournaments of so many individuals. `biases` are the probabilities that a
    redrawn bit is a one, of the hosts and of the parasites.
    """

    def breed(
        bits: BoolArray, wins: FloatArray, rng: np.random.Generator, own: Any, bias: float
    ) -> BoolArray:
        fitness = own(wins.copy()) if callable(own) else reduced_virulence(wins, own)
        parents = select_tournament(np.asarray(fitness), POPULATION, rng, size=tournament)
        # Redrawn, not flipped: without selection a bit ends at its bias whatever it was before.
        drawn = rng.random(bits.shape) < bias
        return np.where(rng.random(bits.shape) < REDRAWN, drawn, bits[parents])

    hosts = partial(breed, own=1.0, bias=biases[0])
    parasites = partial(breed, own=virulence, bias=biases[1])
    return evolve(GAMES["scalar"], (hosts, parasites), seed, generations=generations, opponents=5)
