"""Rock-paper-scissors between two teams whose learner is perfect: it plays a best response.

What is left to see is the schedule alone. Specialists run in circles of three; who answers all of
the past plays fictitious play (Brown 1951), whose average play approaches the equilibrium
(Robinson 1951).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution.opponents import OpponentSampler
from matrixworld.coevolution.opponents.schedules import SCHEDULES, available
from matrixworld.coevolution.types import TEAMS, Team, other

Values = NDArray[np.float64]
Hands = dict[Team, list[int]]

ROCK, PAPER, SCISSORS = range(3)
DRAW = 0.5
ROUNDING = 1e-9
"""Sums of payoffs that differ by less are equal."""


def payoff_matrix(draw: float = DRAW) -> Values:
    """Return (3, 3) the pursuers' payoff, rows their hands: 1 for a win, `draw`, 0 for a loss.

    The evaders' payoff is one minus it. With ``draw=0`` a pursuer captures only by a win.
    """
    if not 0.0 <= draw <= 1.0:
        raise ValueError(f"draw: expected a number in [0, 1], got {draw}")
    return np.array([[draw, 0.0, 1.0], [1.0, draw, 0.0], [0.0, 1.0, draw]])


def shares(played: ArrayLike) -> Values:
    """Return (k, 3) the shares of the hands played (k,) so far: the average play up to each."""
    hands = np.eye(3)[np.asarray(played)]
    return np.asarray(hands.cumsum(axis=0) / np.arange(1, len(hands) + 1)[:, np.newaxis])


def chances(pursuers: Values, evaders: Values, *, luck: float = 0.0) -> Values:
    """Return (n, m) the chance that each pursuer captures each evader; a draw is half of one.

    Parameters
    ----------
    pursuers, evaders : (n, 3) and (m, 3) shares of hands; ``np.eye(3)[hands]`` are pure ones.
    luck : chance, in [0, 1/2], that the worse hand wins.
    """
    if not 0.0 <= luck <= 0.5:
        raise ValueError(f"luck: expected a number in [0, 0.5], got {luck}")
    return np.asarray(luck + (1.0 - 2.0 * luck) * (pursuers @ payoff_matrix() @ evaders.T))


def best_response(
    team: Team, opponents: ArrayLike, matrix: Values, rng: np.random.Generator
) -> int:
    """Return the hand with the highest mean payoff to `team` against hands (c,); ties by lot."""
    shares = np.bincount(np.asarray(opponents), minlength=3)
    payoffs = matrix @ shares if team == "pursuer" else -(shares @ matrix)
    best = np.flatnonzero(payoffs > payoffs.max() - ROUNDING)
    return int(rng.choice(best))


def alternate(schedule: str, generations: int, epochs: int, seed: int = 0) -> Hands:
    """Return the hands of each generation, 0 included, of an alternating race.

    Both begin with rock. A generation answers all opponents that the schedule names in its
    epochs, each as often as it is met.

    Parameters
    ----------
    schedule : one of `coevolution.SCHEDULES`.
    """
    rng, matrix = np.random.default_rng(seed), payoff_matrix()
    samplers = {team: SCHEDULES[schedule].selection(team) for team in TEAMS}
    hands: Hands = {"pursuer": [ROCK], "evader": [ROCK]}
    for k in range(1, generations + 1):
        for team in TEAMS:
            there = available(team, k)
            met = [int(samplers[team].choose(there, i, rng)[0]) for i in range(epochs)]
            opponents = [hands[other(team)][index] for index in met]
            hands[team].append(best_response(team, opponents, matrix, rng))
    return hands


def play_together(
    samplers: dict[Team, OpponentSampler], rounds: int, seed: int = 0, *, draw: float = DRAW
) -> Hands:
    """Return the hands, first ones included, of teams that answer each other at the same time.

    Both begin with rock. In each round a team answers those of the other's hands of the past that
    its selection names: with ``Uniform(None)``, all of them, this is fictitious play.
    """
    rng, matrix = np.random.default_rng(seed), payoff_matrix(draw)
    hands: Hands = {"pursuer": [ROCK], "evader": [ROCK]}
    for epoch in range(rounds):
        answers = {team: _answer(team, hands, samplers[team], epoch, matrix, rng) for team in TEAMS}
        for team in TEAMS:
            hands[team].append(answers[team])
    return hands


def _answer(
    team: Team,
    hands: Hands,
    selection: OpponentSampler,
    epoch: int,
    matrix: Values,
    rng: np.random.Generator,
) -> int:
    past = np.array(hands[other(team)])
    met = selection.choose(len(past), epoch, rng)
    hand = best_response(team, past[met], matrix, rng)
    own = matrix[hand, past[met]] if team == "pursuer" else 1.0 - matrix[past[met], hand]
    selection.tell(met, own[np.newaxis])
    return hand


def exploitability(hands: Hands, *, draw: float = DRAW) -> float:
    """Return what best responses to both teams' average play gain together; 0 in equilibrium.

    That is ``max_i (M y)_i - min_j (x M)_j``, x and y the shares of hands played so far.
    """
    matrix = payoff_matrix(draw)
    x, y = (np.bincount(hands[team], minlength=3) / len(hands[team]) for team in TEAMS)
    return float((matrix @ y).max() - (x @ matrix).min())
