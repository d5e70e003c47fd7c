"""Functions of the user's own as policies of a team."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.world.arrays import integers
from matrixworld.world.policy import TeamPolicy

Callback: TypeAlias = Callable[[NDArray[np.uint8]], ArrayLike]
"""A policy as a function: observations uint8 (n, 3, fov, fov) of n living agents of one team, to
actions (n,), integers."""

Plays: TypeAlias = TeamPolicy | Callback
"""What chooses a team's actions: a population of one genome, the name of a script, a function."""


def ask(
    policy: Callback,
    views: NDArray[Any],
    asked: NDArray[np.bool_],
    actions: NDArray[np.int64],
    n_actions: int,
) -> None:
    """Write the actions that a function chooses for some agents of W worlds.

    Parameters
    ----------
    policy : callable
        The function.
    views : ndarray, shape (W, A, 3, fov, fov)
        What the agents see.
    asked : ndarray of bool, shape (W, A)
        The agents that act; all are alive and of one team. If there are none, the function is not
        called.
    actions : ndarray of int64, shape (W, A)
        Where to write. Entries of other agents stay as they are.
    n_actions : int
        Number of legal actions.

    Raises
    ------
    ValueError, TypeError
        If the function returns something else than one legal action for each agent.
    """
    if asked.any():
        actions[asked] = _called(policy, views[asked].astype(np.uint8, copy=False), n_actions)


def _called(policy: Callback, views: NDArray[np.uint8], n_actions: int) -> NDArray[Any]:
    """Return the actions of a callable for n views, checked."""
    chosen = integers("actions of the policy", policy(views))
    if chosen.shape != (len(views),):
        raise ValueError(
            f"actions of the policy: expected shape {(len(views),)}, got {chosen.shape}"
        )
    if chosen.min() < 0 or chosen.max() >= n_actions:
        wrong = chosen[(chosen < 0) | (chosen >= n_actions)][0]
        raise ValueError(f"actions of the policy: expected 0 to {n_actions - 1}, got {wrong}")
    return chosen
