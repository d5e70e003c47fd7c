"""Rock-paper-scissors between two teams with a perfect learner: it plays a best response.

Only the schedule matters then. Specialists cycle with period three. A team that answers all past
hands of the other plays fictitious play (Brown 1951), whose average approaches the equilibrium
(Robinson 1951).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.schedules import SCHEDULES, available
from matrixworld.coevolution.types import TEAMS, FloatArray, Team, other

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

    Parameters
    ----------
    pursuers, evaders : ndarray of float64, shape (n, 3) and (m, 3)
        Strategies: probabilities of the hands. ``np.eye(3)[hands]`` are pure ones.
    luck : float, optional
        Probability, in [0, 1/2], that the worse hand wins.

    Raises
    ------
    ValueError
        If `luck` is out of range.
    """
    if not 0.0 <= luck <= 0.5:
        raise ValueError(f"luck: expected a number in [0, 0.5], got {luck}")
    return np.asarray(luck + (1.0 - 2.0 * luck) * (pursuers @ PAYOFF @ evaders.T))


def best_response(team: Team, opponents: ArrayLike, rng: np.random.Generator) -> int:
    """Return the hand with the highest mean payoff to a team against hands (c,).

    Ties are decided at random.
    """
    counts = np.bincount(np.asarray(opponents), minlength=3)
    payoffs = PAYOFF @ counts if team == "pursuer" else -(counts @ PAYOFF)
    # Equal sums may differ in their last bits, and a tie must stay a tie.
    best = np.flatnonzero(payoffs > payoffs.max() - ROUNDING)
    return int(rng.choice(best))


def alternate(schedule: str, generations: int, epochs: int, seed: int = 0) -> HandHistory:
    """Play an alternating race, and return the hands of each team; both start with rock.

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
