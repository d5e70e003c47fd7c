"""A built-in team in the worlds of a vector environment."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.arrays import integers
from matrixworld.built_in import BuiltInTeam, Opponents
from matrixworld.play import MOMENT


class BuiltInWorlds:
    """A team that plays in all worlds of a batch, against an opponent for each.

    Parameters
    ----------
    team : BuiltInTeam
        The team.
    buffers : dict of str to ndarray
        The arrays that the batch writes: those of `MOMENT`, ``terminated``, ``truncated`` and
        ``ended``.
    waits : bool
        Whether a world whose episode has ended waits for the next step or for a reset.

    Attributes
    ----------
    team : BuiltInTeam
        The team.
    last : ndarray of int64, shape (W,)
        The place in ``team.opponents`` of the opponent in each world's last ended episode.
    """

    def __init__(self, team: BuiltInTeam, buffers: dict[str, NDArray[Any]], waits: bool) -> None:
        self.team = team
        self.last = np.zeros_like(team.chosen)
        self._moment = {name: buffers[name] for name in MOMENT}
        self._ended = buffers["ended"]
        self._over = (buffers["terminated"], buffers["truncated"]) if waits else None
        self._actions: NDArray[np.int64] = np.zeros(buffers["alive"].shape, np.int64)
        self._episodes = self._keys()

    def _keys(self) -> NDArray[np.uint64]:
        """Return a copy of seed and episode of every world, (2, W)."""
        return np.stack([self._moment["seed"], self._moment["episode"]])

    def begin(self, worlds: ArrayLike | None, opponents: Opponents | None) -> None:
        """Draw opponents after a reset, of all worlds or of those of a mask (W,)."""
        if opponents is not None:
            self.team.opponents = opponents
        self._episodes = self._keys()
        mask = None if worlds is None else np.asarray(worlds)
        self.team.begin(self._episodes[0], self._episodes[1], mask)

    def actions(self, given: ArrayLike) -> NDArray[np.int64]:
        """Return the actions of all agents, (W, A), with those of the caller's agents given.

        Raises ValueError for another shape and TypeError if they are not integers.
        """
        chosen = integers("actions", given)
        learners = self.team.learners
        expected = (len(self._actions), len(learners))
        if chosen.shape != expected:
            raise ValueError(f"actions: expected shape {expected}, got {chosen.shape}")
        self._actions[:, learners.start : learners.stop] = chosen
        running = None if self._over is None else ~np.logical_or(*self._over)
        self.team.decide(self._moment, range(self._actions.shape[1]), self._actions, running)
        return self._actions

    def note_step(self) -> None:
        """Draw opponents of the episodes that the batch began by itself; call it after a step."""
        self.last[self._ended] = self.team.chosen[self._ended]
        keys = self._keys()
        begun = (keys != self._episodes).any(axis=0)
        if begun.any():
            self._episodes = keys
            self.team.begin(keys[0], keys[1], begun)
