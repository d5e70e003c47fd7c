"""Experience of a team: what its agents saw, did and earned in matches."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.short_repr import short_repr
from matrixworld.coevolution.types import BoolArray, IntArray

Views = NDArray[np.uint8]
Reals = NDArray[np.float32]


@dataclass(frozen=True)
class Experience:
    """Transitions of the agents of one team in W episodes of at most T steps.

    The n transitions of all agents are in the order of (step, episode, agent). An agent has one in
    each step at whose begin it is alive.

    Parameters
    ----------
    acted : ndarray of bool, shape (T, W, A)
        Which agents of the team acted in each step.
    views : ndarray of uint8, shape (n, 3 * fov * fov)
        What each one saw before.
    actions : ndarray of int64, shape (n,)
        What it did.
    rewards : ndarray of float32, shape (n,)
        Its reward.
    costs : ndarray of float32, shape (n,)
        Number of kinds of collision in which it was at fault.
    last : ndarray of bool, shape (T, W, A)
        Agents that were alive when `max_steps` ended their episode, in its last step. What they
        would have earned later has to be estimated from their last views.
    last_views : ndarray of uint8, shape (m, 3 * fov * fov)
        What these saw after that step, in the same order.
    states : ndarray of uint8, shape (T, W, 3 * rows * cols), or None
        The worlds before each step, if they were asked for.
    last_states : ndarray of uint8, shape (W, 3 * rows * cols), or None
        The worlds after the last step.
    """

    acted: BoolArray
    views: Views
    actions: IntArray
    rewards: Reals
    costs: Reals
    last: BoolArray
    last_views: Views
    states: Views | None = None
    last_states: Views | None = None

    __repr__ = short_repr

    def __len__(self) -> int:
        return len(self.actions)
