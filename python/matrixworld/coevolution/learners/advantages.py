"""What an actor-critic learner computes from experience: values in place, and advantages.

References
----------
Schulman, J., Moritz, P., Levine, S., Jordan, M. and Abbeel, P. (2016). High-dimensional continuous
control using generalized advantage estimation. ICLR.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.learners.experience import Experience, Reals
from matrixworld.coevolution.types import BoolArray

SMALL = 1e-8
"""Added to a standard deviation by which is divided."""


def advantages(
    acted: BoolArray, rewards: Reals, values: Reals, discount: float, trace: float
) -> Reals:
    """Return generalized advantage estimates.

    ::

        d_t = r_t + discount * V(s_{t+1}) - V(s_t)
        A_t = d_t + discount * trace * A_{t+1}

    Parameters
    ----------
    acted : ndarray of bool, shape (T, W, A)
        Which agents acted in each step. An agent that stops acting does not begin again.
    rewards : ndarray of float32, shape (T, W, A)
        Their rewards; 0 elsewhere.
    values : ndarray of float32, shape (T + 1, W, A)
        Values of what agents saw before each step, also of agents whose time was over after the
        step before; 0 elsewhere, that is, of agents that are gone and of worlds that have
        terminated.
    discount, trace : float
        Discount factor of rewards (gamma), and of advantages beside it (lambda).

    Returns
    -------
    ndarray of float32, shape (T, W, A)
        The estimates; 0 where no agent acted.

    References
    ----------
    Schulman et al. 2016, equations 11 and 16.
    """
    found = np.zeros_like(rewards)
    following = np.zeros_like(rewards[0])
    for t in range(len(rewards) - 1, -1, -1):
        change = rewards[t] + discount * values[t + 1] - values[t]
        following = np.where(acted[t], change + discount * trace * following, 0.0)
        found[t] = following
    return found


@dataclass(frozen=True)
class CriticRows:
    """What a critic sees, and where its values belong.

    Parameters
    ----------
    inputs : ndarray of uint8, shape (n, inputs)
        Its inputs, those of the ends of episodes included.
    learned : ndarray of uint8, shape (k, inputs)
        Those that it learns from.
    dense : callable
        Arranges its values (n,) as (T + 1, W, A).
    targets : callable
        Takes returns (T, W, A), gives those of `learned`, (k,).
    """

    inputs: NDArray[np.uint8]
    learned: NDArray[np.uint8]
    dense: Callable[[Reals], Reals]
    targets: Callable[[Reals], Reals]


def critic_rows(e: Experience, *, central: bool) -> CriticRows:
    """Return what a critic sees of an experience: the views, or the states if it is central."""
    steps, worlds, agents = e.acted.shape

    def spread(before: NDArray[Any], after: NDArray[Any]) -> Reals:
        # What follows an agent's last step is 0, unless only its time was over.
        dense = np.zeros((steps + 1, worlds, agents), np.float32)
        dense[:-1][e.acted] = before
        dense[1:][e.last] = after
        return dense

    if not central:
        n = len(e.actions)
        return CriticRows(
            np.concatenate([e.views, e.last_views]),
            e.views,
            lambda values: spread(values[:n], values[n:]),
            lambda returns: returns[e.acted],
        )
    if e.states is None or e.last_states is None:
        raise ValueError("experience: expected states for a central critic, got none")
    going = e.acted.any(axis=2)
    world_of = np.nonzero(e.acted)[:2]
    ends = np.nonzero(e.last)[1]

    def dense(values: Reals) -> Reals:
        during = values[: steps * worlds].reshape(steps, worlds)
        return spread(during[world_of], values[steps * worlds :][ends])

    states = e.states.reshape(steps * worlds, -1)
    # One value for all agents of the team: the mean of what they earn.
    return CriticRows(
        np.concatenate([states, e.last_states]),
        states[going.ravel()],
        dense,
        lambda returns: (returns.sum(axis=2, where=e.acted) / np.maximum(e.acted.sum(axis=2), 1))[
            going
        ],
    )


def as_dense(acted: BoolArray, values: Reals) -> Reals:
    """Return values (n,) of transitions as (T, W, A), 0 elsewhere."""
    found = np.zeros(acted.shape, np.float32)
    found[acted] = values
    return found


def normalised(values: Reals) -> Reals:
    """Return values with mean 0 and standard deviation 1."""
    centred = values - values.mean(dtype=np.float64)
    return np.asarray(centred / (centred.std() + SMALL), np.float32)
