"""Toy races with labels: the matches of their generations, and what is known to be true of them.

Most labels follow from the exact chances of the generations (`judgement_truths`); gains
follow from the objective, which selection does not use (the number of ones), and from the rules of
the game (no hand is better than another). Labels never use the matches.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from course import toys
from judgement_races import SyntheticRace
from judgement_truths import WINDOWS, Truth, Truths, span_of, truths
from matrixworld.coevolution.types import TEAMS, FloatArray, Indices

GENERATIONS = 31
"""Generations of each race that play against each other."""
EPISODES = (10, 20, 40)
"""Episodes of each pair. Five seeds in a row have the same number, so they can be pooled."""
MOST_LUCK = 0.3
"""Rock-paper-scissors: upper bound of the probability, drawn for each race, that the worse wins."""
RISE, STANDSTILL = 5.0, 1.0
"""Ones that a population gains in a window: it rises from `RISE` on, and not up to `STANDSTILL`."""


@dataclass(frozen=True)
class LabelledRace:
    """A race and what is true of it: window -> condition -> `Truth`.

    `scores` (n, n, episodes) are those of the first side in each match: 1 for a win, 1/2 for a
    draw, 0 for a loss.
    """

    scores: FloatArray
    truths: Mapping[str, Truths]


def _episode_count(seed: int) -> int:
    return EPISODES[seed // 5 % len(EPISODES)]


# ---- Rock-paper-scissors -------------------------------------------------------------------------


def _race_of_strategies(pursuers: FloatArray, evaders: FloatArray, seed: int) -> LabelledRace:
    """Play mixed hands (n, 3): no hand is better than another, so neither team gains by design."""
    # Another key than that of the race, so that luck and hands are independent.
    rng = np.random.default_rng([seed, 1])
    luck = rng.uniform(0.0, MOST_LUCK)
    chances = luck + (1.0 - 2.0 * luck) * (pursuers @ toys.PAYOFF @ evaders.T)
    # A draw is decided at random.
    wins = rng.random((*chances.shape, _episode_count(seed))) < chances[..., np.newaxis]
    still = np.zeros(len(chances))
    race = SyntheticRace(chances, still, still)
    return LabelledRace(wins.astype(float), {window: truths(race, window) for window in WINDOWS})


def _hands(name: str, generations: int, seed: int) -> list[FloatArray]:
    hands = toys.race_of_hands(name, generations, seed)
    return [np.eye(3)[hands[team]] for team in TEAMS]


def _race_of_hands(name: str) -> Callable[[int], LabelledRace]:
    return lambda seed: _race_of_strategies(*_hands(name, GENERATIONS - 1, seed), seed)


def _averages_race(seed: int) -> LabelledRace:
    """Play generations that are averages of fictitious play, which has nearly converged."""
    rounds = 100 + 10 * (GENERATIONS - 1)
    counts = (hands.cumsum(axis=0) for hands in _hands("fictitious play", rounds, seed))
    averages = (count / np.arange(1, len(count) + 1)[:, np.newaxis] for count in counts)
    # The first 100 rounds are left out, in which the averages still move.
    pursuers, evaders = (each[100::10] for each in averages)
    return _race_of_strategies(pursuers, evaders, seed)


def _small_steps_race(seed: int) -> LabelledRace:
    """Play exact scores of mixed hands that answer the other team's in small steps (hedge)."""
    rng = np.random.default_rng([seed, 3])
    step, hands = rng.uniform(0.02, 0.4), [rng.dirichlet(np.full(3, 5.0), 2)]
    for _ in range(GENERATIONS - 1):
        pursuers, evaders = hands[-1]
        gains = np.array([toys.PAYOFF @ evaders, -(pursuers @ toys.PAYOFF)])
        weights = hands[-1] * np.exp(step * 3.0 * gains)
        hands.append(weights / weights.sum(axis=1, keepdims=True))
    pursuers, evaders = np.array(hands).swapaxes(0, 1)
    rates, still = pursuers @ toys.PAYOFF @ evaders.T, np.zeros(GENERATIONS)
    race = SyntheticRace(rates, still, still)
    twice = np.repeat(rates[..., np.newaxis], 2, axis=2)
    return LabelledRace(twice, {window: truths(race, window) for window in WINDOWS})


# ---- Populations of bits -------------------------------------------------------------------------


def chances_of_history(history: toys.History, generations: Indices) -> FloatArray:
    """Return the exact mean score of each pair of generations (k,), over all pairs of individuals.

    The chances (k, k) are those of side 0 (rows) against side 1 (columns); half of a draw is a win.
    """
    first, second = history.ones[generations, 0], history.ones[generations, 1]
    k, n = first.shape[:2]
    # All individuals of a generation against all individuals of all generations.
    others = np.tile(second.reshape(k * n, -1), (n, 1))
    rows = []
    for generation in first:
        ones = np.repeat(generation, k * n, axis=0)
        scores = np.asarray(history.game.play(ones, others, np.random.default_rng(0)))
        rows.append(scores.reshape(n, k, n).mean(axis=(0, 2)))
    return np.array(rows)


def truths_of_history(
    history: toys.History, generations: Indices, *, selected: bool = True
) -> dict[str, Truths]:
    """Return what is true of a race of populations, by chances and ones of some generations.

    Without selection (`selected`) all gains are chance.

    All but gains are as in `judgement_truths.truths`. A population rises in a window if it gains 5
    ones or more, and some in three of four parts; it does not if it gains 1 at most; otherwise it
    is open. Where more than one number decides, ones do not say who is better, so gains are open.
    """
    still = np.zeros(len(generations))
    race = SyntheticRace(chances_of_history(history, generations), still, still)
    ones = history.objective[generations].mean(axis=2).T  # (2, k)
    found = {}
    for window in WINDOWS:
        by_chances = truths(race, window)
        span = span_of(race.rates, window)
        rises = [_rises(course[span]) if selected else False for course in ones]
        if history.ones.shape[3] > 1 and selected:
            rises = [None, None]
        arms = False if False in rises else None if None in rises else True
        one_sided = None if None in rises else rises[0] is not rises[1]
        gains = {"arms race": arms, "one-sided progress": one_sided}
        if by_chances["disengagement"].holds:
            gains = dict.fromkeys(gains)
        found[window] = by_chances | {
            name: Truth(holds, by_chances[name].size) for name, holds in gains.items()
        }
    return found


def _rises(ones: FloatArray) -> bool | None:
    gained = ones[-1] - ones[0]
    last = len(ones) - 1
    parts = np.diff(np.interp(np.linspace(0, last, 5), np.arange(last + 1), ones))
    if gained >= RISE and np.count_nonzero(parts > 0.0) >= 3:
        return True
    return False if gained <= STANDSTILL else None


def _evenly_spaced(
    play: Callable[[int], toys.History], first: int, last: int, *, selected: bool = True
) -> Callable[[int], LabelledRace]:
    """Return a race with matches of generations from `first` to `last`, evenly spaced."""
    generations = np.linspace(first, last, GENERATIONS).round().astype(int)

    def race(seed: int) -> LabelledRace:
        history, rng = play(seed), np.random.default_rng([seed, 2])
        scores = history.scores(generations, _episode_count(seed), rng)
        return LabelledRace(scores, truths_of_history(history, generations, selected=selected))

    return race


def _drift(seed: int) -> toys.History:
    """Play mutation without selection: tournaments of one."""
    return toys.evolve(toys.SCALAR, toys.Bits(tournament=1), seed, generations=600, opponents=5)


def _frozen(seed: int) -> toys.History:
    """Play without mutation: all bits stay zero, and every match is a draw."""
    return toys.numbers_game("scalar", seed, generations=GENERATIONS, flips=0.0)


RACES: Mapping[str, Callable[[int], LabelledRace]] = {
    "rock-paper-scissors, specialists": _race_of_hands("specialists"),
    "rock-paper-scissors, generalists": _race_of_hands("generalists"),
    "rock-paper-scissors, fictitious play": _race_of_hands("fictitious play"),
    "rock-paper-scissors, its averages": _averages_race,
    "rock-paper-scissors, small steps": _small_steps_race,
    "scalar, climbing": _evenly_spaced(
        lambda seed: toys.numbers_game("scalar", seed, generations=150), 0, 150
    ),
    "scalar, at the top": _evenly_spaced(lambda seed: toys.numbers_game("scalar", seed), 300, 600),
    "scalar, without mutation": _evenly_spaced(_frozen, 0, GENERATIONS - 1),
    "focusing, climbing": _evenly_spaced(
        lambda seed: toys.numbers_game("focusing", seed, generations=150), 0, 150
    ),
    "focusing, later": _evenly_spaced(lambda seed: toys.numbers_game("focusing", seed), 200, 600),
    "intransitive": _evenly_spaced(lambda seed: toys.numbers_game("intransitive", seed), 0, 600),
    "virulence 1": _evenly_spaced(lambda seed: toys.hosts_and_parasites(1.0, seed), 0, 600),
    "virulence .75, climbing": _evenly_spaced(
        lambda seed: toys.hosts_and_parasites(0.75, seed, generations=60), 0, 60
    ),
    "virulence .75, later": _evenly_spaced(
        lambda seed: toys.hosts_and_parasites(0.75, seed), 200, 600
    ),
    "mutation without selection": _evenly_spaced(_drift, 200, 600, selected=False),
}
"""Races by name: seed -> race."""
