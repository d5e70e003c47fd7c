"""Toy races of which it is known what happened, and the matches between their generations.

What is true of a race is told by the game (nobody can cycle where one number decides who wins) and
by what an observer sees and nobody is selected for (how many ones there are); never by the matches,
from which a diagnosis has to find it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from matrixworld.coevolution.opponents import Uniform
from matrixworld.coevolution.types import TEAMS
from matrixworld.toys.numbers import GAMES, numbers_game
from matrixworld.toys.populations import History
from matrixworld.toys.rock_paper_scissors import Hands, alternate, chances, play_together, shares
from matrixworld.toys.virulence import HOST_BIAS, hosts_and_parasites

Truth = dict[str, bool | None]
"""By condition: whether the race has it; None where the rules below leave it open."""
Values = np.ndarray

GENERATIONS = 31
"""That are matched with one another."""
EPISODES = (10, 20, 40)
"""Of each pair. Seeds take turns in fives, so that five in a row can be taken together."""
MOST_LUCK = 0.3
"""In rock-paper-scissors: the chance that the worse hand wins is drawn below it, for each race."""

RISE = 5.0
"""Ones that both populations gain in the last half, at least, in an arms race."""
STANDSTILL = 2.0
"""Ones by which populations that stagnate differ at most between the middle and the end."""
FALL = 10.0
"""Ones that both lose again, at least, where the intransitive game has run in a circle."""
FORGOTTEN, KEPT = 0.2, 0.05
"""Share of a dimension's ones by which it lies below its best: forgotten above, kept below."""
LOST, HELD = 1.5, 0.5
"""The same where one number decides, in standard deviations of the population."""
ENGAGED, DISENGAGED = 0.8, 0.2
"""Share of the generations of the last half in which individuals differ in their wins."""


@dataclass(frozen=True)
class KnownRace:
    """One race.

    Attributes
    ----------
    scores : (n, n, episodes) what the first side scores in each match, 1 for a win, 1/2 for a draw.
    truth : by condition (the names of `analysis.CONDITIONS`) whether the race has it.
    """

    scores: Values
    truth: Truth


def known_race(name: str, seed: int) -> KnownRace:
    """Play one of `RACES`. ValueError for another name."""
    if name not in RACES:
        raise ValueError(f"race: expected one of {', '.join(RACES)}, got {name!r}")
    return RACES[name](seed)


# ---- Rock-paper-scissors -------------------------------------------------------------------------


def truth_of_hands(hands: Hands, first: int) -> Truth:
    """What is true of a race whose generations play pure hands.

    No hand is better than another, so there is no arms race, and each team phase is open. The race
    has gone round if both teams changed their hand three times or more from generation `first` on,
    and a hand that was changed loses to what it beat.
    """
    changes = min(np.count_nonzero(np.diff(hands[team][first:])) for team in TEAMS)
    round_once = True if changes >= 3 else None
    return {
        "arms race": False,
        "cycling": round_once,
        "disengagement": False,
        "forgetting": round_once,
        "stagnation": False if round_once else None,
    }


def _of_hands(hands: Hands, seed: int) -> KnownRace:
    pursuers, evaders = (np.eye(3)[hands[team]] for team in TEAMS)
    return KnownRace(
        _episodes(pursuers, evaders, seed), truth_of_hands(hands, len(hands["pursuer"]) // 2)
    )


def _scheduled(schedule: str, seed: int) -> KnownRace:
    return _of_hands(alternate(schedule, GENERATIONS - 1, GENERATIONS - 1, seed), seed)


def _fictitious(seed: int) -> KnownRace:
    return _of_hands(_all_of_the_past(GENERATIONS - 1, seed), seed)


def _averages(seed: int) -> KnownRace:
    """Generations that play the average of fictitious play so far, which has all but converged.

    Their exploitability lies below .1 from the first to the last, so that nothing is to be gained,
    lost or forgotten; a circle round the equilibrium grows too small to be called one or not.
    """
    hands = _all_of_the_past(100 + 10 * (GENERATIONS - 1), seed)
    pursuers, evaders = (shares(hands[team])[100::10] for team in TEAMS)
    truth: Truth = {
        "arms race": False,
        "cycling": None,
        "disengagement": False,
        "forgetting": False,
        "stagnation": True,
    }
    return KnownRace(_episodes(pursuers, evaders, seed), truth)


def _all_of_the_past(rounds: int, seed: int) -> Hands:
    return play_together({team: Uniform(None) for team in TEAMS}, rounds, seed)


def _episodes(pursuers: Values, evaders: Values, seed: int) -> Values:
    """Matches that are won or lost; a draw is decided by lot."""
    rng = np.random.default_rng([seed, 1])
    chance = chances(pursuers, evaders, luck=rng.uniform(0.0, MOST_LUCK))
    return (rng.random((*chance.shape, _episodes_of(seed))) < chance[..., np.newaxis]).astype(float)


# ---- Populations of bits -------------------------------------------------------------------------


def truth_of_history(history: History, generations: np.ndarray) -> Truth:
    """What is true of a race of populations, by the ones of the generations (k,) looked at.

    - arms race: both populations gain 5 ones or more in the last half; False: one of them at most
      1. Not told where that is the upward part of a circle.
    - cycling: False where one number decides. In the intransitive game True if both populations
      fall 10 ones or more below their best so far. In the focusing game not told.
    - disengagement: individuals differ in their wins in 20 % of the generations of the last half
      at most; False: in 80 % at least.
    - forgetting: on average over the last half, a population's worst dimension lies below its best
      so far by 20 % of its bits or more; False: by 5 % at most in both populations. Where one
      number decides, by 1.5 standard deviations of the population or more; False: by half of one at
      most. Not told of disengaged races.
    - stagnation: engaged, one number decides, and both populations end within 2 ones of where they
      were in the middle; False: an arms race or a circle.
    """
    ones = history.ones[generations].mean(axis=2)  # (k, 2, dimensions)
    spread = history.objective[generations].std(axis=2).mean(axis=0)  # (2,)
    middle, totals = len(ones) // 2, ones.sum(axis=2)
    gained = totals[-1] - totals[middle]
    below_best = (np.maximum.accumulate(ones) - ones)[middle:].mean(axis=0)  # (2, dimensions)
    fallen = (np.maximum.accumulate(totals) - totals).max(axis=0)
    one_number = history.game.shape[0] == 1
    engaged = history.engaged[generations[middle] : generations[-1]].mean()
    circle = False if one_number else _circle(history, fallen.min())
    arms_race = _between(gained.min(), above=RISE, below=1.0)
    forgotten = (
        _between((below_best[:, 0] / np.maximum(spread, 0.5)).max(), above=LOST, below=HELD)
        if one_number
        else _between(below_best.max() / history.game.shape[1], above=FORGOTTEN, below=KEPT)
    )
    disengaged = _between(1.0 - engaged, above=1.0 - DISENGAGED, below=1.0 - ENGAGED)
    still = one_number and disengaged is False and np.abs(gained).max() <= STANDSTILL
    return {
        "arms race": None if circle and arms_race else arms_race,
        "cycling": circle,
        "disengagement": disengaged,
        "forgetting": None if disengaged else forgotten,
        "stagnation": True if still else (False if arms_race or circle else None),
    }


def _circle(history: History, fallen: float) -> bool | None:
    intransitive = history.game is GAMES["intransitive"]
    return True if intransitive and fallen >= FALL else None


def _between(value: float, *, above: float, below: float) -> bool | None:
    """True from `above` on, False up to `below`, None in between."""
    return True if value >= above else False if value <= below else None


def _seen(play: Callable[[int], History], first: int, last: int) -> Callable[[int], KnownRace]:
    """A race of which generations from `first` to `last` are matched, evenly spaced."""
    generations = np.linspace(first, last, GENERATIONS).round().astype(int)

    def race(seed: int) -> KnownRace:
        history, rng = play(seed), np.random.default_rng([seed, 2])
        scores = history.scores(generations, _episodes_of(seed), rng)
        return KnownRace(scores, truth_of_history(history, generations))

    return race


def _episodes_of(seed: int) -> int:
    return EPISODES[seed // 5 % len(EPISODES)]


def _drift(seed: int) -> History:
    """Mutation without selection: tournaments of one."""
    biases = HOST_BIAS, HOST_BIAS
    return hosts_and_parasites(1.0, seed, tournament=1, biases=biases)


def _frozen(seed: int) -> KnownRace:
    """No mutation: all are zeros for ever, and every match is a draw."""
    generations = np.arange(GENERATIONS)
    history = numbers_game("scalar", seed, generations=GENERATIONS, flips=0.0)
    scores = history.scores(generations, _episodes_of(seed), np.random.default_rng([seed, 2]))
    truth = truth_of_history(history, generations)
    # Nobody wins, so that individuals do not differ; but neither team wins everything.
    return KnownRace(
        scores, truth | {"disengagement": None, "forgetting": False, "stagnation": True}
    )


RACES: Mapping[str, Callable[[int], KnownRace]] = {
    "rock-paper-scissors, specialists": lambda seed: _scheduled("specialist-specialist", seed),
    "rock-paper-scissors, generalists": lambda seed: _scheduled("generalist-generalist", seed),
    "rock-paper-scissors, fictitious play": _fictitious,
    "rock-paper-scissors, its averages": _averages,
    "scalar, climbing": _seen(lambda seed: numbers_game("scalar", seed, generations=150), 0, 150),
    "scalar, at the top": _seen(lambda seed: numbers_game("scalar", seed), 300, 600),
    "scalar, without mutation": _frozen,
    "focusing, climbing": _seen(
        lambda seed: numbers_game("focusing", seed, generations=150), 0, 150
    ),
    "focusing, later": _seen(lambda seed: numbers_game("focusing", seed), 200, 600),
    "intransitive": _seen(lambda seed: numbers_game("intransitive", seed), 0, 600),
    "virulence 1": _seen(lambda seed: hosts_and_parasites(1.0, seed), 0, 600),
    "virulence .75, climbing": _seen(
        lambda seed: hosts_and_parasites(0.75, seed, generations=60), 0, 60
    ),
    "virulence .75, later": _seen(lambda seed: hosts_and_parasites(0.75, seed), 200, 600),
    "mutation without selection": _seen(_drift, 200, 600),
}
"""By name: from a seed to a race."""
