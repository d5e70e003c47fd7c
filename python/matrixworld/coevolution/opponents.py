"""Which archived opponents a team meets in an epoch.

Opponents are numbered from the oldest, 0: they are generations of the other team. A team does not
know which one it is: if the teams are swapped, so is the result.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.constraints import OneOf, Range, Whole
from matrixworld._util.own_code import OwnCode
from matrixworld._util.sections import NAMES, OWN, Named, Section, name_section, section, setting
from matrixworld.analysis.games import nash_averaging
from matrixworld.coevolution.states import State
from matrixworld.coevolution.types import FloatArray, Indices, Rng

__all__ = [
    "Latest",
    "NashOpponents",
    "NewestAndOlder",
    "Opponents",
    "Prioritized",
    "RoundRobin",
    "SharedSampling",
    "Uniform",
]

PayoffFunction = Callable[[Indices, Indices], ArrayLike]
"""Generations (n,) of the team and (m,) of its opponents -> payoffs (n, m) to the team, in [0, 1].

One pair always has the same payoff. Both teams have at least one generation: n, m >= 1.
"""
UNKNOWN = 0.5  # assumed win rate against an opponent without games
WEIGHT_DECIMALS = 6
"""Decimals of the weights of a mixture: the last bits differ from processor to processor."""


@section()
class Opponents(Section):
    """Base of the samplers of opponents. A sampler is its settings; its state is a dict of arrays.

    ::

        state = sampler.start()
        in each epoch:
            opponents = sampler.sample(state, available, count, epoch, rng)
            state = sampler.tell(state, opponents, scores)

    No method changes the arrays that it gets; random numbers come only from the generator of
    `sample`. A sampler of your own is a frozen dataclass with this base, in the settings itself or
    by its name ``module:object``, with fields of numbers, text, true or false: see `check_sampler`.
    """

    def start(self) -> State:
        """Return the state before the first epoch."""
        return {}

    @abstractmethod
    def sample(self, state: State, available: int, count: int, epoch: int, rng: Rng) -> Indices:
        """Return the opponents (c,) of an epoch, all below `available`, without repetition.

        At least 1, at most `count` of them. `available` never falls during a run; `epoch` counts
        from 0 in each generation.
        """

    def tell(self, state: State, opponents: Indices, scores: FloatArray) -> State:
        """Return the state after scores (n, c), in [0, 1], of n candidates against opponents (c,).

        NaN marks pairs that have not met.
        """
        return state

    def update(self, state: State, own: int, available: int, payoff: PayoffFunction) -> State:
        """Return the state at the begin of a generation, with so many generations of both teams."""
        return state


@section("latest")
class Latest(Opponents):
    """The newest opponents: ``available - 1, available - 2, ...``."""

    def sample(self, state: State, available: int, count: int, epoch: int, rng: Rng) -> Indices:
        """Return the newest opponents, the newest first."""
        return np.arange(available)[::-1][:count]


@section("uniform")
class Uniform(Opponents):
    """Opponents drawn evenly without replacement.

    A best response to all past opponents, each with the same weight, is fictitious play (Brown
    1951, "Iterative solution of games by fictitious play").
    """

    def sample(self, state: State, available: int, count: int, epoch: int, rng: Rng) -> Indices:
        """Return opponents in random order."""
        return rng.choice(available, size=min(count, available), replace=False)


@section("round-robin")
class RoundRobin(Opponents):
    """All opponents in turn: ``epoch mod available``, as the paper's generalists.

    A generation that has fewer epochs than opponents goes on where the one before it ended, until
    all but the newest opponent have been met; the next one begins with opponent 0 again. Sun et al.
    2023, "MatrixWorld", arXiv:2307.14854, algorithms 2 and 3.
    """

    def start(self) -> State:
        """Return how many opponents have been met since opponent 0 had its turn: none."""
        return {"met": np.array(0)}

    def sample(self, state: State, available: int, count: int, epoch: int, rng: Rng) -> Indices:
        """Return the next opponents in the cycle."""
        # No more than are available, or an opponent would come twice in an epoch.
        turns = np.arange(min(count, available))
        return np.asarray((_met(state) + turns) % available)

    def tell(self, state: State, opponents: Indices, scores: FloatArray) -> State:
        """Count the opponents."""
        return {"met": np.array(_met(state) + len(opponents))}

    def update(self, state: State, own: int, available: int, payoff: PayoffFunction) -> State:
        """Begin with opponent 0 again if all that were there before the newest have been met."""
        return state if _met(state) < available - 1 else self.start()


def _met(state: State) -> int:
    return int(state.get("met", 0))  # runs of earlier versions have not counted


@section("newest-and-older")
class NewestAndOlder(Opponents):
    """Half of the opponents are the newest, and the other half, or one more, older ones by chance.

    With one opponent it is drawn from all, as `Uniform` does.

    Rosin & Belew 1997, "New methods for competitive coevolution", Evolutionary Computation 5(1).
    """

    def sample(self, state: State, available: int, count: int, epoch: int, rng: Rng) -> Indices:
        """Return the newest opponents, the newest first, and then the older ones."""
        # Opponents 0 .. older - 1 are the older ones.
        older = max(0, available - count // 2)
        newest = np.arange(older, available)[::-1]
        drawn = rng.choice(older, size=min(count - count // 2, older), replace=False)
        return np.append(newest, drawn)


def _padded(rows: FloatArray, length: int, value: float = 0.0) -> FloatArray:
    """Return rows, one for each opponent, with rows of a value appended up to a length."""
    missing = max(0, length - len(rows))
    widths = [(0, missing)] + [(0, 0)] * (rows.ndim - 1)
    return np.pad(rows, widths, constant_values=value)


WEIGHTINGS: dict[str, Callable[[FloatArray], FloatArray]] = {
    "hard": lambda x: (1.0 - x) ** 2.0,
    "even": lambda x: x * (1.0 - x),
}
"""Name -> win rates (m,) of the learning team to weights (m,): most on opponents that are seldom
beaten, or on those that are beaten half of the time."""


@section("prioritized")
class Prioritized(Opponents):
    """Opponents drawn with probability ~ f(win rate), without replacement.

    ::

        sample:  x[j] = wins[j] / games[j], or 1/2 without games
                 draw opponents with P(j) = f(x[j]) / sum_i f(x[i])
        tell:    games[j] = decay games[j] + 1;  wins[j] = decay wins[j] + mean score against j

    Opponents of weight 0 are drawn, evenly, only if those of positive weight do not suffice.

    Vinyals et al. 2019, "Grandmaster level in StarCraft II using multi-agent reinforcement
    learning", Nature 575, "prioritized fictitious self-play".
    """

    weighting: str = setting(
        "hard",
        "most weight on opponents that are seldom beaten (hard), or half of the time (even)",
        OneOf(WEIGHTINGS),
    )
    decay: float = setting(
        0.99,
        "factor on earlier games against an opponent with each new one",
        Range(most=1.0, open=True),
    )

    def start(self) -> State:
        """Return no games."""
        return {"wins": np.zeros(0), "games": np.zeros(0)}

    def probabilities(self, state: State, available: int) -> FloatArray:
        """Return the probability (available,) of each opponent; even if all weights are 0."""
        wins = _padded(state["wins"], available)[:available]
        games = _padded(state["games"], available)[:available]
        rates = np.full(available, UNKNOWN)
        # Where there are no games, `out` keeps the assumed rate.
        np.divide(wins, games, out=rates, where=games > 0.0)
        weights = WEIGHTINGS[self.weighting](rates)
        total = weights.sum()
        return weights / total if total > 0.0 else np.full(available, 1.0 / available)

    def sample(self, state: State, available: int, count: int, epoch: int, rng: Rng) -> Indices:
        """Return opponents drawn by their weights, in the order of the draw."""
        probabilities = self.probabilities(state, available)
        positive = np.flatnonzero(probabilities)
        count = min(count, available)
        # `choice` cannot draw more than there are of positive weight; the rest is drawn evenly.
        size = min(count, len(positive))
        chosen = rng.choice(positive, size=size, replace=False, p=probabilities[positive])
        rest = np.flatnonzero(probabilities == 0.0)
        return np.append(chosen, rng.choice(rest, size=count - size, replace=False))

    def tell(self, state: State, opponents: Indices, scores: FloatArray) -> State:
        """Count one game against each opponent, won by the mean of its scores."""
        # The archive grows during a run, and so do the counts.
        size = int(opponents.max()) + 1
        wins = _padded(state["wins"], size)
        games = _padded(state["games"], size)
        wins[opponents] = self.decay * wins[opponents] + scores.mean(axis=0)
        games[opponents] = self.decay * games[opponents] + 1.0
        return {"wins": wins, "games": games}


def shared_sample(beats: ArrayLike, count: int, rng: Rng) -> Indices:
    """Return a greedy sample of `count` opponents, each of which beats what few others in it beat.

    `beats` (m, n) says how surely opponent j beats individual k of the last epoch, in [0, 1];
    `rng` decides ties.
    """
    # Chosen is the j with the most ``sum_k beats[j, k] / (1 + covered[k])``, where covered[k] sums
    # beats[., k] of those chosen before (Rosin & Belew 1997); ties are decided at random.
    matrix = np.asarray(beats, np.float64)
    # argmax takes the first of equals, so a random order of the rows decides ties at random.
    order = rng.permutation(len(matrix))
    shuffled = matrix[order]
    covered = np.zeros(matrix.shape[1])
    chosen: list[int] = []
    for _ in range(min(count, len(matrix))):
        value = (shuffled / (1.0 + covered)).sum(axis=1)
        # Below every value, so that no opponent is chosen twice.
        value[chosen] = -1.0
        chosen.append(int(np.argmax(value)))
        covered += shuffled[chosen[-1]]
    return np.asarray(order[chosen], dtype=np.intp)


@section("shared-sampling")
class SharedSampling(Opponents):
    """Strong and different opponents, by the last scores against each (`shared_sample`).

    An opponent without scores counts as beating every candidate, so that it is soon sampled. If the
    number of candidates changes, all scores are forgotten.
    """

    def start(self) -> State:
        """Return no scores."""
        return {"beats": np.ones((0, 1))}

    def sample(self, state: State, available: int, count: int, epoch: int, rng: Rng) -> Indices:
        """Return the sample, the strongest first."""
        beats = _padded(state["beats"], available, 1.0)[:available]
        return shared_sample(beats, count, rng)

    def tell(self, state: State, opponents: Indices, scores: FloatArray) -> State:
        """Record one minus the scores for each opponent."""
        beats = state["beats"]
        # Columns are candidates; with another number of them old scores fit none.
        if beats.shape[1] != len(scores):
            beats = np.ones((0, len(scores)))
        beats = _padded(beats, int(opponents.max()) + 1, 1.0)
        beats[opponents] = 1.0 - scores.T
        return {"beats": beats}


@section("nash")
class NashOpponents(Opponents):
    """Opponents drawn from a Nash mixture of all generations: policy-space response oracles (PSRO).

    ::

        update:  M = payoffs of all generations of the team against all of its opponents
                 weights = the opponents' mixture of maximum entropy in the equilibrium of M
        sample:  opponent j with probability weights[j]

    With several opponents an epoch they are drawn without replacement, so that all have a more
    equal share than their weights say. Before the first update the newest opponent is met.

    Lanctot et al. 2017, "A unified game-theoretic approach to multiagent reinforcement learning",
    NeurIPS 30.
    """

    episodes: int = setting(10, "matches of each pair in the payoff matrix", Whole(1))

    def start(self) -> State:
        """Return an empty game."""
        return {"payoffs": np.zeros((0, 0)), "weights": np.zeros(0)}

    def update(self, state: State, own: int, available: int, payoff: PayoffFunction) -> State:
        """Add new generations to the game, and solve it."""
        known = state["payoffs"]
        rows = np.arange(own)
        columns = np.arange(available)
        n, m = known.shape

        def played(rows: Indices, columns: Indices) -> FloatArray:
            if not len(rows) or not len(columns):
                return np.zeros((len(rows), len(columns)))
            return np.asarray(payoff(rows, columns))

        # Blocks: earlier generations against earlier opponents, whose payoffs are known, and
        # against new ones; below these, new generations against all opponents.
        payoffs = np.block([[known, played(rows[:n], columns[m:])], [played(rows[n:], columns)]])
        # The opponents' own mixture: the game as they see it has their payoffs.
        rounded = np.round(nash_averaging(payoffs).evaders, WEIGHT_DECIMALS)
        return {"payoffs": payoffs, "weights": rounded / rounded.sum()}

    def sample(self, state: State, available: int, count: int, epoch: int, rng: Rng) -> Indices:
        """Return opponents drawn by their weights."""
        weights = state["weights"]
        if not len(weights):
            return np.array([available - 1], dtype=np.intp)
        support = np.flatnonzero(weights)
        size = min(count, len(support))
        return rng.choice(support, size=size, replace=False, p=weights[support])


@section()
class OwnOpponents(OwnCode):
    """Opponents by a sampler of your own (see `Opponents`)."""

    base: ClassVar[type[Section]] = Opponents


def loaded(sampler: Opponents | OwnOpponents) -> Opponents:
    """Return a sampler; one of your own is imported."""
    if isinstance(sampler, Opponents):
        return sampler
    own: Opponents = sampler.load()
    return own


for _weighting in WEIGHTINGS:
    name_section(f"prioritized-{_weighting}", Prioritized, weighting=_weighting)
NAMES[Opponents][OWN] = Named(OwnOpponents)
