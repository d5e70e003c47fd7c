"""A built-in team in the worlds of a vector environment."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.envs.opponents import BuiltInTeam, Opponents
from matrixworld.play import Plays, ask
from matrixworld.world.arrays import integers
from matrixworld.world.batch import Batch


class BuiltInWorlds:
    """A team that plays in all worlds of a batch, against an opponent for each.

    Parameters
    ----------
    team : BuiltInTeam
        The team.
    batch : Batch
        The batch. It writes at least ``views``, ``alive``, ``seed``, ``episode``, ``terminated``,
        ``truncated`` and ``ended``.
    waits : bool
        Whether a world whose episode has ended waits for the next step or for a reset.

    Attributes
    ----------
    team : BuiltInTeam
        The team.
    last : ndarray of int64, shape (W,)
        The place in ``team.opponents`` of the opponent in each world's last ended episode.
    """

    def __init__(self, team: BuiltInTeam, batch: Batch, waits: bool) -> None:
        self.team = team
        self.last = np.zeros_like(team.chosen)
        self._batch, self._waits = batch, waits
        self._actions: NDArray[np.int64] = np.zeros(batch.buffers["alive"].shape, np.int64)
        self._episodes = self._keys()
        self._group_worlds()

    def _keys(self) -> NDArray[np.uint64]:
        """Return a copy of seed and episode of every world, (2, W)."""
        return np.stack([self._batch.buffers["seed"], self._batch.buffers["episode"]])

    def _draw(self, worlds: NDArray[np.bool_] | None) -> None:
        """Draw the opponents of worlds whose episodes have begun."""
        self._episodes = self._keys()
        self.team.begin(self._episodes[0], self._episodes[1], worlds)
        self._group_worlds()

    def _group_worlds(self) -> None:
        """List the policies that play, and the place in this list of each world's policy."""
        # By identity: equality of functions of the user may be anything.
        places: dict[int, int] = {}
        playing = self.team.playing
        numbers = [places.setdefault(id(policy), len(places)) for policy in playing]
        self._chosen = np.array(numbers, np.int32)
        self._policies: list[Plays] = list({id(policy): policy for policy in playing}.values())

    def begin(self, worlds: ArrayLike | None, opponents: Opponents | None) -> None:
        """Draw opponents after a reset, of all worlds or of those of a mask (W,)."""
        if opponents is not None:
            self.team.opponents = opponents
        self._draw(None if worlds is None else np.asarray(worlds))

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
        engine = [None if callable(policy) else policy for policy in self._policies]
        self._batch.decide(engine, self._chosen, self.team.agents, self._actions)
        for number, policy in enumerate(self._policies):
            if callable(policy):
                asked = self._acting() & (self._chosen == number)[:, None]
                views = self._batch.buffers["views"]
                ask(policy, views, asked, self._actions, self._batch.config.n_actions)
        return self._actions

    def _acting(self) -> NDArray[np.bool_]:
        """Return which agents of the team act now, bool (W, A)."""
        buffers = self._batch.buffers
        acting = np.zeros_like(buffers["alive"])
        acting[:, self.team.agents] = buffers["alive"][:, self.team.agents]
        if self._waits:
            acting[buffers["terminated"] | buffers["truncated"]] = False
        return acting

    def note_step(self) -> None:
        """Draw opponents of the episodes that the batch began by itself; call it after a step."""
        ended = self._batch.buffers["ended"]
        self.last[ended] = self.team.chosen[ended]
        begun = (self._keys() != self._episodes).any(axis=0)
        if begun.any():
            self._draw(begun)
