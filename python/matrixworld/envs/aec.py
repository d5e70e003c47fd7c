"""PettingZoo's AEC API: one agent acts after the other."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pettingzoo import AECEnv
from typing_extensions import Unpack

from matrixworld._util.checks import check_integer
from matrixworld.envs.base import EnvSettings, MatrixWorldBase, Status
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import Rules

View = NDArray[np.uint8]


class MatrixWorldAEC(MatrixWorldBase, AECEnv[str, View, int]):  # type: ignore[misc]
    """An environment in which one agent acts after the other.

    Actions are collected until all agents of a turn have chosen; then the turn is played.

    Parameters
    ----------
    config, **settings
        Arguments of `matrixworld.envs.base.MatrixWorldBase`.
    """

    agent_selection: str
    _to_commit: list[str]  # agents of this turn that have not chosen yet

    def __init__(
        self, config: WorldConfig | Rules | str = "O", **settings: Unpack[EnvSettings]
    ) -> None:
        super().__init__(config, **settings)
        # Where teams or agents take turns, they see what earlier ones did: that game is not the one
        # in which all choose at once.
        self.metadata["is_parallelizable"] = self.world.n_turns == 1

    def reset(self, seed: int | None = None, options: Mapping[str, Any] | None = None) -> None:
        """Start an episode; see `MatrixWorldParallel.reset`."""
        self._reset_world(seed, options)
        self._actions = np.zeros(self.config.n_agents, np.int64)
        self.agent_selection, self._to_commit = self.agents[0], []
        self.rewards: dict[str, float] = dict.fromkeys(self.agents, 0.0)
        self._cumulative_rewards = dict.fromkeys(self.agents, 0.0)
        self.terminations: dict[str, bool] = dict.fromkeys(self.agents, False)
        self.truncations: dict[str, bool] = dict.fromkeys(self.agents, False)
        self.infos: dict[str, dict[str, Any]] = {}
        self._skip_agent_selection: str | None = None
        self._play_until_actors()
        self._accumulate_rewards()
        self._deads_step_first()

    def observe(self, agent: str) -> View:
        """Return what an agent sees after the last played turn, uint8 of shape (3, fov, fov)."""
        view: View = self._views[self._index[agent]]
        return view

    def step(self, action: Any) -> None:
        """Choose the action of `agent_selection`; the last choice of a turn plays the turn.

        The action of an agent that has terminated or is truncated is None. If an action is refused
        (ValueError out of range, TypeError if it is no integer), nothing has changed. RuntimeError
        if the episode has ended.
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
        self._play_until_actors()
        self._accumulate_rewards()
        self._deads_step_first()

    def _play_turn(self) -> None:
        """Play a turn and pay it."""
        # Rewards accumulate over a round in the world; an AEC step pays the difference of its turn.
        before = self.world.rewards.astype(float) if self.world.turn else 0.0
        self._decide(self._actions, self.world.actors)
        self.world.play_turn(self._actions)
        paid = (self.world.rewards.astype(float) - before).tolist()
        for agent in self.agents:
            self.rewards[agent] += paid[self._index[agent]]
        if self.world.turn == 0 and self._drawing is not None:
            self._drawing.note(self._actions)

    def _play_until_actors(self) -> None:
        """Play turns in which no living agent of the caller acts, and select those that act next.

        They are turns of agents that are gone, which PettingZoo never asks to act, and of the team
        that the environment plays itself.
        """
        ended: list[Status] = []
        while not (actors := self._living_actors()):
            if self.world.turn == 0 and (self.world.terminated or self.world.truncated):
                break
            if self.world.turn == 0:  # the next turn forgets the collisions of this round
                ended.append(self.status)
            self._play_turn()
        self._report(ended)
        if actors:
            self.agent_selection, *self._to_commit = actors

    def _report(self, ended: list[Status]) -> None:
        """Tell all agents the results of this round, and of rounds that ended before it."""
        status = self.status
        for earlier in ended:
            status.add_collisions(earlier)
        self._views = self.world.views()
        infos, terminations = self._infos(status, self._views), status.terminations.tolist()
        truncations = status.truncations.tolist()
        for agent in self.agents:
            i = self._index[agent]
            self.terminations[agent] = terminations[i]
            self.truncations[agent] = truncations[i]
            self.infos[agent] = infos[i]

    def _living_actors(self) -> list[str]:
        """Return the caller's living agents of the next turn; none when the world is terminated."""
        if self.world.terminated:
            return []
        alive, actors = self.world.alive, self.world.actors
        return [self._names[i] for i in actors if i in self._names and alive[i]]
