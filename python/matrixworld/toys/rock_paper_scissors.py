"""Rock-paper-scissors between two teams with a perfect learner: it plays a best response.

Only the schedule matters then. Specialists cycle with period three. A team that answers all past
hands of the other plays fictitious play (Brown 1951), whose average approaches the equilibrium
(Robinson 1951).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.opponents.samplers import OpponentSampler
from matrixworld.coevolution.schedules import SCHEDULES, available
from matrixworld.coevolution.types import TEAMS, FloatArray, Team, other

HandHistory = dict[Team, list[int]]
"""Team -> its hand in each generation: `ROCK`, `PAPER` or `SCISSORS`."""

ROCK, PAPER, SCISSORS = range(3)
DRAW = 0.5
ROUNDING = 1e-9
"""Sums of payoffs that differ by less are equal."""


def payoff_matrix(draw: float = DRAW) -> FloatArray:
    """Return the payoffs (3, 3) of the pursuers' hands (rows) against the evaders'.

    A win is 1, a draw `draw`, a loss 0. The evaders' payoff is one minus it. With ``draw=0`` a
    pursuer captures only by a win.
    """
    if not 0.0 <= draw <= 1.0:
        raise ValueError(f"draw: expected a number in [0, 1], got {draw}")
    return np.array([[draw, 0.0, 1.0], [1.0, draw, 0.0], [0.0, 1.0, draw]])


def average_strategies(played: ArrayLike) -> FloatArray:
    """Return the average strategy up to each of k generations, (k, 3), from their hands (k,)."""
    hands = np.eye(3)[np.asarray(played)]
    return np.asarray(hands.cumsum(axis=0) / np.arange(1, len(hands) + 1)[:, np.newaxis])


def capture_probabilities(
    pursuers: FloatArray, evaders: FloatArray, *, luck: float = 0.0
) -> FloatArray:
    """Return the probability that each pursuer captures each evader; a draw counts one half.

    Parameters
    ----------
    pursuers, evaders : ndarray of float64, shape (n, 3) and (m, 3)
        Strategies: probabilities of the hands. ``np.eye(3)[hands]`` are pure ones.
    luck : float, optional
        Probability, in [0, 1/2], that the worse hand wins.

    Returns
    -------
    ndarray of float64, shape (n, m)
        The probabilities.

    Raises
    ------
    ValueError
        If `luck` is out of range.
    """
    if not 0.0 <= luck <= 0.5:
        raise ValueError(f"luck: expected a number in [0, 0.5], got {luck}")
    return np.asarray(luck + (1.0 - 2.0 * luck) * (pursuers @ payoff_matrix() @ evaders.T))


def best_response(
    team: Team, opponents: ArrayLike, matrix: FloatArray, rng: np.random.Generator
) -> int:
    """Return the hand with the highest mean payoff to a team against hands (c,).

    Ties are decided at random.
    """
    counts = np.bincount(np.asarray(opponents), minlength=3)
    payoffs = matrix @ counts if team == "pursuer" else -(counts @ matrix)
    # Equal sums may differ in their last bits, and a tie must stay a tie.
    best = np.flatnonzero(payoffs > payoffs.max() - ROUNDING)
    return int(rng.choice(best))


def alternate(schedule: str, generations: int, epochs: int, seed: int = 0) -> HandHistory:
    """Play an alternating race. Both teams start with rock.

    A generation responds to the opponents that the schedule's sampler chooses in its epochs, each
    weighted by how often it was chosen.

    Parameters
    ----------
    schedule : str
        Name in `coevolution.SCHEDULES`.
    generations : int
        Generations after the first one.
    epochs : int
        Epochs of a generation.
    seed : int, optional
        Seed of all random numbers.

    Returns
    -------
    dict
        Hands of all generations of both teams, generation 0 included.
    """
    rng, matrix = np.random.default_rng(seed), payoff_matrix()
    samplers = {team: SCHEDULES[schedule].new_sampler(team) for team in TEAMS}
    hands: HandHistory = {"pursuer": [ROCK], "evader": [ROCK]}
    for k in range(1, generations + 1):
        for team in TEAMS:
            count = available(team, k)
            chosen = [int(samplers[team].sample(count, i, rng)[0]) for i in range(epochs)]
            opponents = [hands[other(team)][index] for index in chosen]
            hands[team].append(best_response(team, opponents, matrix, rng))
    return hands


def play_together(
    samplers: dict[Team, OpponentSampler], rounds: int, seed: int = 0, *, draw: float = DRAW
) -> HandHistory:
    """Play a race in which both teams respond at the same time. Both start with rock.

    Each team's sampler chooses among the other team's past hands. With ``Uniform(None)``, which
    chooses all of them, this is fictitious play.
    """
    rng, matrix = np.random.default_rng(seed), payoff_matrix(draw)
    hands: HandHistory = {"pursuer": [ROCK], "evader": [ROCK]}
    for epoch in range(rounds):
        # Both answers first, so that neither team sees the hand of this round.
        answers = {team: _answer(team, hands, samplers[team], epoch, matrix, rng) for team in TEAMS}
        for team in TEAMS:
            hands[team].append(answers[team])
    return hands


def _answer(
    team: Team,
    hands: HandHistory,
    sampler: OpponentSampler,
    epoch: int,
    matrix: FloatArray,
    rng: np.random.Generator,
) -> int:
    past = np.array(hands[other(team)])
    chosen = sampler.sample(len(past), epoch, rng)
    hand = best_response(team, past[chosen], matrix, rng)
    own = matrix[hand, past[chosen]] if team == "pursuer" else 1.0 - matrix[past[chosen], hand]
    sampler.tell(chosen, own[np.newaxis])
    return hand


def exploitability(hands: HandHistory, *, draw: float = DRAW) -> float:
    """Return what best responses to both teams' average strategies gain together.

    Parameters
    ----------
    hands : dict
        Hands of both teams, see `HandHistory`.
    draw : float, optional
        Payoff of a draw to the pursuers.

    Returns
    -------
    float
        ``max_i (M y)_i - min_j (x M)_j`` with the average strategies x and y; 0 in equilibrium.
    """
    matrix = payoff_matrix(draw)
    x, y = (np.bincount(hands[team], minlength=3) / len(hands[team]) for team in TEAMS)
    return float((matrix @ y).max() - (x @ matrix).min())
