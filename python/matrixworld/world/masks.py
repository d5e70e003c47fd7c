"""Action masks: the moves that run into neither an obstacle nor the border."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.world.config import WorldConfig

# Rows and columns from an agent to the cell that each `Action` leads to.
STEPS = np.array([(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1), (-1, 1), (1, 1), (1, -1), (-1, -1)])
CHANNEL = {"evader": 0, "pursuer": 1, "obstacle": 2}
"""Channels of a view by what they show."""
_STAY = 0


def check_maskable(config: WorldConfig) -> None:
    """Raise ValueError if agents do not see the cells that they can move to."""
    if config.fov < 3:
        raise ValueError(f"action_mask: expected a fov of at least 3, got {config.fov}")


def action_masks(views: NDArray[Any], n_actions: int) -> NDArray[np.int8]:
    """Return which actions of agents lead to a free cell, from what the agents see.

    Parameters
    ----------
    views : ndarray, shape (..., 3, fov, fov)
        Views of agents, with a `fov` of at least 3.
    n_actions : int
        5, or 9 with diagonal moves.

    Returns
    -------
    ndarray of int8, shape (..., n_actions)
        1 for a move to a cell without an obstacle inside the grid, and for staying; 0 for the other
        moves. Other agents do not matter. All actions of an agent that is gone are 1.
    """
    rows, cols = STEPS[:n_actions].T + views.shape[-1] // 2
    # Views draw the cells outside the grid as obstacles, and an agent that is gone sees none.
    masks: NDArray[np.int8] = (views[..., CHANNEL["obstacle"], rows, cols] == 0).astype(np.int8)
    masks[..., _STAY] = 1  # staying is never a collision, even on an obstacle's cell
    return masks
