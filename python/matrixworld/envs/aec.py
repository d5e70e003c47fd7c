"""The AEC API: one agent acts after the other."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pettingzoo import AECEnv

from matrixworld.checks import check_integer
from matrixworld.envs.base import MatrixWorldBase, Status

View = NDArray[np.uint8]


class MatrixWorldAEC(MatrixWorldBase, AECEnv[str, View, int]):  # type: ignore[misc]
    """One agent acts after the other. Takes the arguments of `MatrixWorldBase`."""

    agent_selection: str
    _to_commit: list[str]  # the others who act in this turn

    def reset(self, seed: int | None = None, options: Mapping[str, Any] | None = None) -> None:
        """Start an episode; see `MatrixWorldParallel.reset`."""
        self._reset_world(seed, options)
        self._actions = np.zeros(self.config.n_agents, np.int64)
        self._views = self.world.views()
        self.rewards = dict.fromkeys(self.agents, 0.0)
        self._cumulative_rewards = dict.fromkeys(self.agents, 0.0)
        self.terminations = dict.fromkeys(self.agents, False)
        self.truncations = dict.fromkeys(self.agents, False)
        self.infos = dict(zip(self.agents, self.status.infos(), strict=True))
        self._skip_agent_selection: str | None = None
        self._call_actors()

    def observe(self, agent: str) -> View:
        """``(3, fov, fov)`` uint8: what the agent sees now, with the turns that were played."""
        view: View = self._views[self._index[agent]]
        return view

    def step(self, action: Any) -> None:
        """Commit the action of `agent_selection`; None for an agent that has ended.

        The turn is played when all who act in it have committed. Raises ValueError for an action
        out of range and TypeError for what is no integer, before anything is changed; RuntimeError
        in an ended episode.
        """
        if not self.agents:
            raise RuntimeError("the episode has ended, or never began: call reset()")
        agent = self.agent_selection
        if self.terminations[agent] or self.truncations[agent]:
            self._was_dead_step(action)
            return
        self._actions[self._index[agent]] = check_integer(
            "action", action, 0, self.config.n_actions - 1
        )
        self._cumulative_rewards[agent] = 0.0
        self._clear_rewards()
        if self._to_commit:
            self.agent_selection = self._to_commit.pop(0)
            return
        self._play_turn()
        self._accumulate_rewards()
        self._deads_step_first()

    def _play_turn(self) -> None:
        """Play what has been committed, and call those who act next."""
        before = self.world.rewards.astype(float) if self.world.turn else 0.0
        self.world.play_turn(self._actions)
        while self.world.turn and not self._living_actors():
            self.world.play_turn(self._actions)
        status = Status.of(self.world)
        paid = (status.rewards.astype(float) - before).tolist()
        infos, terminations = status.infos(), status.terminations.tolist()
        truncations = status.truncations.tolist()
        for agent in self.agents:
            i = self._index[agent]
            self.rewards[agent] = paid[i]
            self.terminations[agent] = terminations[i]
            self.truncations[agent] = truncations[i]
            self.infos[agent] = infos[i]
        self._views = self.world.views()
        if self.world.turn == 0 and self._drawing is not None:
            self._drawing.note(self._actions)
        if not (status.terminated or status.truncated):
            self._call_actors()

    def _living_actors(self) -> list[str]:
        """Who is still to act in the next turn; nobody when the world has terminated."""
        if self.world.terminated:
            return []
        alive = self.world.alive
        return [self.possible_agents[i] for i in self.world.actors if alive[i]]

    def _call_actors(self) -> None:
        while not (called := self._living_actors()):  # the first agents of a round may be gone
            self.world.play_turn(self._actions)
        self.agent_selection, *self._to_commit = called
