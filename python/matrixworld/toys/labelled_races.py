"""Toy races with labels: what is known to be true of each race, and the matches of its generations.

The labels follow from the rules of the game (there is no cycle where one number decides who wins)
and from the objective, which selection does not use (the number of ones). They never use the
matches, from which a diagnosis has to find the same.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from matrixworld.coevolution.opponents.samplers import Uniform
from matrixworld.coevolution.types import TEAMS, FloatArray, Indices
from matrixworld.toys.numbers import GAMES, numbers_game
from matrixworld.toys.populations import History
from matrixworld.toys.rock_paper_scissors import (
    HandHistory,
    alternate,
    average_strategies,
    capture_probabilities,
    play_together,
)
from matrixworld.toys.virulence import HOST_BIAS, hosts_and_parasites

Truth = dict[str, bool | None]
"""Condition -> whether the race has it; None where the rules below do not decide."""

GENERATIONS = 31
"""Generations of each race that play against each other."""
EPISODES = (10, 20, 40)
"""Episodes of each pair. Five seeds in a row have the same number, so they can be pooled."""
MOST_LUCK = 0.3
"""Rock-paper-scissors: upper bound of the probability, drawn for each race, that the worse wins."""

RISE = 5.0
"""Arms race: ones that both populations gain in the last half, at least."""
STANDSTILL = 2.0
"""Stagnation: largest difference in ones between the middle and the end."""
FALL = 10.0
"""Cycling in the intransitive game: ones that both populations lose again, at least."""
FORGOTTEN, KEPT = 0.2, 0.05
"""Share of a dimension's ones by which it lies below its best: forgotten above, kept below."""
LOST, HELD = 1.5, 0.5
"""The same where one number decides, in standard deviations of the population."""
ENGAGED, DISENGAGED = 0.8, 0.2
"""Share of the generations of the last half in which individuals differ in their wins."""


@dataclass(frozen=True)
class LabelledRace:
    """A race and what is true of it.

    Parameters
    ----------
    scores : ndarray of float64, shape (n, n, episodes)
        Scores of the first side in each match: 1 for a win, 1/2 for a draw, 0 for a loss.
    truth : dict of str to bool or None
        Condition (a name of `analysis.CONDITIONS`) -> whether the race has it, None if unknown.
    """

    scores: FloatArray
    truth: Truth


def labelled_race(name: str, seed: int) -> LabelledRace:
    """Play one of `RACES`.

    Parameters
    ----------
    name : str
        Name in `RACES`.
    seed : int
        Seed of the race and of its matches.

    Returns
    -------
    LabelledRace
        The race.

    Raises
    ------
    ValueError
        If there is no race of that name.
    """
    if name not in RACES:
        raise ValueError(f"race: expected one of {', '.join(RACES)}, got {name!r}")
    return RACES[name](seed)


def _episode_count(seed: int) -> int:
    return EPISODES[seed // 5 % len(EPISODES)]


# ---- Rock-paper-scissors -------------------------------------------------------------------------


def truth_of_hands(hands: HandHistory, first: int) -> Truth:
    """Return what is true of a race whose generations play pure hands.

    No hand is better than another, so there is no arms race, and no team wins everything. The race
    cycles, and forgets, if both teams change their hand at least three times from generation
    `first` on: a changed hand loses to the hand that it beat before.

    Parameters
    ----------
    hands : dict
        Hands of both teams, see `HandHistory`.
    first : int
        Generation from which changes are counted.

    Returns
    -------
    dict of str to bool or None
        The labels.
    """
    # Both teams: one team alone may change its hand without a cycle.
    changes = min(np.count_nonzero(np.diff(hands[team][first:])) for team in TEAMS)
    cycling = True if changes >= 3 else None
    return {
        "arms race": False,
        "cycling": cycling,
        "disengagement": False,
        "forgetting": cycling,
        "stagnation": False if cycling else None,
    }


def _race_of_hands(hands: HandHistory, seed: int) -> LabelledRace:
    pursuers, evaders = (np.eye(3)[hands[team]] for team in TEAMS)
    truth = truth_of_hands(hands, len(hands["pursuer"]) // 2)
    return LabelledRace(_play_episodes(pursuers, evaders, seed), truth)


def _scheduled_race(schedule: str, seed: int) -> LabelledRace:
    return _race_of_hands(alternate(schedule, GENERATIONS - 1, GENERATIONS - 1, seed), seed)


def _fictitious_play_race(seed: int) -> LabelledRace:
    return _race_of_hands(_fictitious_play(GENERATIONS - 1, seed), seed)


def _averages_race(seed: int) -> LabelledRace:
    """Play generations that are averages of fictitious play, which has nearly converged.

    Their exploitability is below .1 from the first to the last, so that nothing can be gained, lost
    or forgotten. A circle round the equilibrium is too small to decide on cycling.
    """
    hands = _fictitious_play(100 + 10 * (GENERATIONS - 1), seed)
    # The first 100 rounds are left out, in which the averages still move.
    pursuers, evaders = (average_strategies(hands[team])[100::10] for team in TEAMS)
    truth: Truth = {
        "arms race": False,
        "cycling": None,
        "disengagement": False,
        "forgetting": False,
        "stagnation": True,
    }
    return LabelledRace(_play_episodes(pursuers, evaders, seed), truth)


def _fictitious_play(rounds: int, seed: int) -> HandHistory:
    return play_together({team: Uniform(None) for team in TEAMS}, rounds, seed)


def _play_episodes(pursuers: FloatArray, evaders: FloatArray, seed: int) -> FloatArray:
    """Return scores of matches that are won or lost; a draw is decided at random."""
    # Another key than that of the race, so that luck and hands are independent.
    rng = np.random.default_rng([seed, 1])
    wins = capture_probabilities(pursuers, evaders, luck=rng.uniform(0.0, MOST_LUCK))
    return (rng.random((*wins.shape, _episode_count(seed))) < wins[..., np.newaxis]).astype(float)


# ---- Populations of bits -------------------------------------------------------------------------


def truth_of_history(history: History, generations: Indices) -> Truth:
    """Return what is true of a race of populations, by the ones of some of its generations.

    Parameters
    ----------
    history : History
        The race.
    generations : ndarray of int, shape (k,)
        Generations to look at, in ascending order.

    Returns
    -------
    dict of str to bool or None
        The labels.

    Notes
    -----
    - arms race: both populations gain 5 ones or more in the last half; False: one of them gains at
      most 1. None where the gain is the rising part of a circle.
    - cycling: False where one number decides. In the intransitive game True if both populations
      fall 10 ones or more below their best so far. None in the focusing game.
    - disengagement: individuals differ in their wins in 20 % of the generations of the last half
      at most; False: in 80 % at least.
    - forgetting: on average over the last half, a population's worst dimension lies below its best
      so far by 20 % of its bits or more; False: by 5 % at most in both populations. Where one
      number decides, by 1.5 standard deviations of the population or more; False: by half of one at
      most. None for disengaged races.
    - stagnation: engaged, one number decides, and both populations end within 2 ones of their
      number in the middle; False: an arms race or cycling.
    """
    ones = history.ones[generations].mean(axis=2)  # (k, 2, dimensions)
    spread = history.objective[generations].std(axis=2).mean(axis=0)  # (2,)
    middle, totals = len(ones) // 2, ones.sum(axis=2)
    gained = totals[-1] - totals[middle]
    # Both compare with the best so far: of each dimension, and of the total.
    below_best = (np.maximum.accumulate(ones) - ones)[middle:].mean(axis=0)  # (2, dimensions)
    fallen = (np.maximum.accumulate(totals) - totals).max(axis=0)
    one_number = history.game.shape[0] == 1
    engaged = history.engaged[generations[middle] : generations[-1]].mean()
    cycling = False if one_number else _cycling(history, fallen.min())
    arms_race = _label(gained.min(), true_from=RISE, false_to=1.0)
    forgotten = (
        # At least half a one, since a population of equals has no spread.
        _label((below_best[:, 0] / np.maximum(spread, 0.5)).max(), true_from=LOST, false_to=HELD)
        if one_number
        else _label(below_best.max() / history.game.shape[1], true_from=FORGOTTEN, false_to=KEPT)
    )
    disengaged = _label(1.0 - engaged, true_from=1.0 - DISENGAGED, false_to=1.0 - ENGAGED)
    still = one_number and disengaged is False and np.abs(gained).max() <= STANDSTILL
    return {
        # The rising part of a circle looks like an arms race in the last half.
        "arms race": None if cycling and arms_race else arms_race,
        "cycling": cycling,
        "disengagement": disengaged,
        "forgetting": None if disengaged else forgotten,
        "stagnation": True if still else (False if arms_race or cycling else None),
    }


def _cycling(history: History, fallen: float) -> bool | None:
    intransitive = history.game is GAMES["intransitive"]
    return True if intransitive and fallen >= FALL else None


def _label(value: float, *, true_from: float, false_to: float) -> bool | None:
    """Return True from `true_from` on, False up to `false_to`, None in between."""
    return True if value >= true_from else False if value <= false_to else None


def _evenly_spaced(
    play: Callable[[int], History], first: int, last: int
) -> Callable[[int], LabelledRace]:
    """Return a race with matches of generations from `first` to `last`, evenly spaced."""
    generations = np.linspace(first, last, GENERATIONS).round().astype(int)

    def race(seed: int) -> LabelledRace:
        history, rng = play(seed), np.random.default_rng([seed, 2])
        scores = history.scores(generations, _episode_count(seed), rng)
        return LabelledRace(scores, truth_of_history(history, generations))

    return race


def _drift(seed: int) -> History:
    """Play mutation without selection: tournaments of one."""
    biases = HOST_BIAS, HOST_BIAS
    return hosts_and_parasites(1.0, seed, tournament=1, biases=biases)


def _frozen_race(seed: int) -> LabelledRace:
    """Play without mutation: all bits stay zero, and every match is a draw."""
    generations = np.arange(GENERATIONS)
    history = numbers_game("scalar", seed, generations=GENERATIONS, flips=0.0)
    scores = history.scores(generations, _episode_count(seed), np.random.default_rng([seed, 2]))
    truth = truth_of_history(history, generations)
    # There are no wins, so individuals do not differ in them; but neither team wins everything.
    return LabelledRace(
        scores, truth | {"disengagement": None, "forgetting": False, "stagnation": True}
    )


RACES: Mapping[str, Callable[[int], LabelledRace]] = {
    "rock-paper-scissors, specialists": lambda s: _scheduled_race("specialist-specialist", s),
    "rock-paper-scissors, generalists": lambda s: _scheduled_race("generalist-generalist", s),
    "rock-paper-scissors, fictitious play": _fictitious_play_race,
    "rock-paper-scissors, its averages": _averages_race,
    "scalar, climbing": _evenly_spaced(
        lambda seed: numbers_game("scalar", seed, generations=150), 0, 150
    ),
    "scalar, at the top": _evenly_spaced(lambda seed: numbers_game("scalar", seed), 300, 600),
    "scalar, without mutation": _frozen_race,
    "focusing, climbing": _evenly_spaced(
        lambda seed: numbers_game("focusing", seed, generations=150), 0, 150
    ),
    "focusing, later": _evenly_spaced(lambda seed: numbers_game("focusing", seed), 200, 600),
    "intransitive": _evenly_spaced(lambda seed: numbers_game("intransitive", seed), 0, 600),
    "virulence 1": _evenly_spaced(lambda seed: hosts_and_parasites(1.0, seed), 0, 600),
    "virulence .75, climbing": _evenly_spaced(
        lambda seed: hosts_and_parasites(0.75, seed, generations=60), 0, 60
    ),
    "virulence .75, later": _evenly_spaced(lambda seed: hosts_and_parasites(0.75, seed), 200, 600),
    "mutation without selection": _evenly_spaced(_drift, 200, 600),
}
"""Races by name: seed -> race."""
