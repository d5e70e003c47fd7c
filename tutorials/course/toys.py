"""Toys with known answers: co-evolution in plain NumPy that takes seconds.

They use the schedules, opponent samplers and fitness sharing of the real races. What these do here
they do there, too.

>>> from course import toys
>>> toys.numbers_game("scalar", seed=0).final_objective.round()
array([99., 99.])

*Rock-paper-scissors* between two teams with a perfect learner: it plays a best response, so only
the schedule matters. Specialists cycle with period three. A team that answers all past hands of the
other plays fictitious play (Brown 1951), whose average approaches the equilibrium (Robinson 1951).

*Numbers games* (Watson & Pollack 2001, "Coevolutionary dynamics in a minimal substrate", GECCO):
two populations of bit strings, where more ones win, in one dimension or another. Selection uses
wins alone; the number of ones, the objective, is only observed.

- scalar: more ones win. Both populations climb.
- focusing: the dimension with the greatest difference decides. Other dimensions drift away.
- intransitive: the dimension with the least difference decides. a beats b, b beats c, c beats a:
  a population can win and lose ones.

A mutation rate of 0.005 a bit can be read in two ways: flip the bit, or redraw it (0 or 1 with
equal chance). A redrawn bit changes in half of the cases, so redrawing at 0.005 is flipping at
0.0025. This toy flips, so that the rate is the probability of a change; ``flips=0.0025`` is the
other reading, and ``docs/coevolution.md`` has the results of both.

*Hosts and parasites* (Cartlidge & Bullock 2004, "Combating coevolutionary disengagement by reducing
parasite virulence", Evolutionary Computation 12(2)): the scalar game, but a bit that mutates
becomes a one with the probability of its side's *bias*. Parasites, with the higher bias, outrun the
hosts: then all hosts lose all matches, selection among them stops, and they drift back. Parasites
of reduced virulence are rewarded for winning less than the most; they keep the hosts in the race
and climb with them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.fitness import reduced_virulence
from matrixworld.coevolution.learners.genetic_algorithm import select_tournament
from matrixworld.coevolution.opponents import OpponentSampler
from matrixworld.coevolution.runs.race import Pairings, pairings
from matrixworld.coevolution.schedules import SCHEDULES, available
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
    if not 0.0 <= luck <= 0.5:
        raise ValueError(f"luck: expected a number in [0, 0.5], got {luck}")
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
    samplers = {team: SCHEDULES[schedule].new_sampler(team) for team in TEAMS}
    hands: HandHistory = {"pursuer": [ROCK], "evader": [ROCK]}
    for k in range(1, generations + 1):
        for team in TEAMS:
            count = available(team, k)
            chosen = [int(samplers[team].sample(count, i, rng)[0]) for i in range(epochs)]
            opponents = [hands[other(team)][index] for index in chosen]
            hands[team].append(best_response(team, opponents, rng))
    return hands


# ---- Populations of bits -------------------------------------------------------------------------

BITS = 100
"""Bits of an individual, over all dimensions."""
POPULATION = 25
"""Individuals of each population."""
REDRAWN = 0.03
"""Probability that a mutation of hosts and parasites redraws a bit."""
HOST_BIAS, PARASITE_BIAS = 0.5, 0.75
"""Probability that a redrawn bit is a one."""

Samplers = tuple[OpponentSampler, OpponentSampler]


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
"""Numbers games by name."""


Breed = Callable[[BoolArray, FloatArray, np.random.Generator], BoolArray]
"""Takes the bits (n, ...) of a population, its wins (n,) and a generator; returns the children."""


def select_proportionate(fitness: FloatArray, k: int, rng: np.random.Generator) -> Indices:
    """Return `k` indices drawn in proportion to fitness; evenly if all fitness is 0."""
    total = fitness.sum()
    return rng.choice(len(fitness), size=k, p=fitness / total if total > 0.0 else None)


def flip(bits: BoolArray, rng: np.random.Generator, *, probability: float) -> BoolArray:
    """Return the bits, each flipped with `probability`."""
    return np.asarray(bits ^ (rng.random(bits.shape) < probability))


def mutate_biased(
    bits: BoolArray, rng: np.random.Generator, *, probability: float, bias: float
) -> BoolArray:
    """Return the bits, each redrawn with `probability`: then a one with probability `bias`."""
    # Redrawn, not flipped: without selection a bit ends at its bias whatever it was before.
    drawn = rng.random(bits.shape) < bias
    return np.asarray(np.where(rng.random(bits.shape) < probability, drawn, bits))


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
    game: Game,
    breeds: tuple[Breed, Breed],
    seed: int,
    *,
    generations: int,
    opponents: int,
    samplers: Samplers | None = None,
) -> History:
    """Evolve two populations against each other, from all zeros.

    ::

        in each generation:
            each individual plays some living opponents, paired by random permutations, and those
            of the other side's past champions that its sampler chooses
            both sides breed by their wins; the individual with the most wins is the new champion
    """
    rng = np.random.default_rng(seed)
    bits = [np.zeros((POPULATION, *game.shape), dtype=np.bool_) for _ in breeds]
    champions: tuple[list[BoolArray], list[BoolArray]] = ([], [])
    ones, wins = [_ones(bits)], []
    for generation in range(generations):
        chosen = [np.zeros(0, dtype=np.intp)] * 2
        if samplers is not None and generation:
            # There is a champion of each earlier generation.
            chosen = [sampler.sample(generation, generation, rng) for sampler in samplers]
        halls = [[champions[s][i] for i in chosen[1 - s]] for s in (0, 1)]
        one_group = np.zeros(POPULATION, dtype=np.intp)
        pairs = pairings(one_group, opponents, (len(halls[0]), len(halls[1])), rng)
        players = [np.array([*bits[s], *halls[s]]).sum(axis=2) for s in (0, 1)]
        scores = game.scores(players[0][pairs.pursuer], players[1][pairs.evader])
        won = [_wins(pairs.pursuer, scores), _wins(pairs.evader, 1.0 - scores)]
        for s, breed in enumerate(breeds):
            if samplers is not None and len(chosen[s]):
                samplers[s].tell(chosen[s], _scores_on_champions(pairs, scores, s))
            # After the matches, so that the champions of a generation are past ones in the next.
            champions[s].append(bits[s][np.argmax(won[s])])
            bits[s] = breed(bits[s], won[s], rng)
        ones.append(_ones(bits))
        wins.append(won)
    return History(game, np.array(ones), np.array(wins))


def _ones(bits: list[BoolArray]) -> IntArray:
    return np.array([team.sum(axis=2) for team in bits])


def _wins(players: Indices, scores: FloatArray) -> FloatArray:
    """Return the wins (n,) of a population; those of champions do not count."""
    totals = np.bincount(players, weights=scores == 1.0, minlength=POPULATION)
    return np.asarray(totals[:POPULATION], dtype=np.float64)


def _scores_on_champions(pairs: Pairings, scores: FloatArray, side: int) -> FloatArray:
    """Return the scores (n, c) of a population against c champions."""
    opponents = pairs.evader if side == 0 else pairs.pursuer
    own = scores if side == 0 else 1.0 - scores
    # `pairings` lists each champion's matches in the order of the population.
    return own[opponents >= POPULATION].reshape(-1, POPULATION).T


def numbers_game(
    name: str,
    seed: int,
    *,
    generations: int = 600,
    opponents: int = 15,
    flips: float = 0.005,
    samplers: Samplers | None = None,
) -> History:
    """Play one of `GAMES` with fitness-proportionate selection.

    Individuals meet so many living `opponents`; `samplers` choose for each side among the other
    side's past champions, too. A bit is flipped with the probability `flips`.
    """

    def breed(bits: BoolArray, wins: FloatArray, rng: np.random.Generator) -> BoolArray:
        # Wins are the fitness: the objective must not leak into selection.
        parents = select_proportionate(wins, POPULATION, rng)
        return flip(bits[parents], rng, probability=flips)

    return evolve(
        GAMES[name],
        (breed, breed),
        seed,
        generations=generations,
        opponents=opponents,
        samplers=samplers,
    )


def hosts_and_parasites(
    virulence: float | Callable[[FloatArray], FloatArray],
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
        fitness = own(wins) if callable(own) else reduced_virulence(wins, own)
        parents = select_tournament(fitness, POPULATION, rng, size=tournament)
        return mutate_biased(bits[parents], rng, probability=REDRAWN, bias=bias)

    breeds = (
        partial(breed, own=1.0, bias=biases[0]),
        partial(breed, own=virulence, bias=biases[1]),
    )
    return evolve(GAMES["scalar"], breeds, seed, generations=generations, opponents=5)
