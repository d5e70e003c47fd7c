"""Matches in which functions play: the engine's rollouts know networks and scripts only."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from matrixworld.arrays import array_specs
from matrixworld.batch import Batch
from matrixworld.config import WorldConfig
from matrixworld.play.decide import MOMENT, Moment, Plays, check_fits, decide
from matrixworld.policy import Population
from matrixworld.world import World

_READ = (*MOMENT, "terminated", "truncated", "capture_rate")


def capture_rates(
    config: WorldConfig, pursuers: Plays, evaders: Plays, *, seed: int, episodes: int
) -> NDArray[np.float64]:
    """Play the episodes of a match side by side and return their capture rates.

    Parameters
    ----------
    config : WorldConfig
        The settings of the worlds.
    pursuers, evaders : Population, str or callable
        What plays for the teams, as `decide` takes it.
    seed : int
        The seed of the match. Episode j is the seed's episode j, as in `matrixworld.rollout`.
    episodes : int
        Number of episodes.

    Returns
    -------
    ndarray of float64, shape (episodes,)
        The capture rates, as in `matrixworld.EpisodeStatistics`.
    """
    teams = {
        range(config.n_pursuers): pursuers,
        range(config.n_pursuers, config.n_agents): evaders,
    }
    for name, policy in (("pursuers", pursuers), ("evaders", evaders)):
        if isinstance(policy, Population):
            check_fits(name, policy.network, config)
    simultaneous = World(config).n_turns == 1
    worlds: _Worlds = (_Together if simultaneous else _InTurns)(config, seed, episodes)
    actions = np.zeros((episodes, config.n_agents), np.int64)
    while (running := _running(worlds.moment())).any():
        for turn in worlds.turns():
            moment = worlds.moment()
            for team, policy in teams.items():
                acting = range(max(team.start, turn.start), min(team.stop, turn.stop))
                if len(acting):
                    decide(policy, config, moment, acting, actions, _running(moment))
            worlds.play(actions, running)
    return np.asarray(worlds.moment()["capture_rate"], np.float64)


def _running(moment: Moment) -> NDArray[np.bool_]:
    return np.asarray(~(moment["terminated"] | moment["truncated"]))


class _Worlds(Protocol):
    """The worlds of a match's episodes."""

    def moment(self) -> Moment: ...

    def turns(self) -> Iterator[range]: ...

    def play(self, actions: NDArray[np.int64], running: NDArray[np.bool_]) -> None: ...


class _Together:
    """Worlds in which all agents act at once: a batch."""

    def __init__(self, config: WorldConfig, seed: int, episodes: int) -> None:
        specs = array_specs(config)
        buffers = {name: np.zeros((episodes, *specs[name][0]), specs[name][1]) for name in _READ}
        self._batch = Batch(episodes, config, buffers=buffers)
        self._agents = range(config.n_agents)
        for episode in range(episodes):
            chosen = np.arange(episodes) == episode
            self._batch.reset(np.full(episodes, seed, np.uint64), episode=episode, mask=chosen)

    def moment(self) -> Moment:
        return self._batch.buffers

    def turns(self) -> Iterator[range]:
        yield self._agents

    def play(self, actions: NDArray[np.int64], running: NDArray[np.bool_]) -> None:
        self._batch.step(actions)


class _InTurns:
    """Worlds whose rounds have several turns, played turn by turn."""

    def __init__(self, config: WorldConfig, seed: int, episodes: int) -> None:
        self._worlds = [World(config) for _ in range(episodes)]
        for episode, world in enumerate(self._worlds):
            world.reset(seed, episode=episode)

    def moment(self) -> Moment:
        read = [world.read(*_READ) for world in self._worlds]
        return {name: np.stack([arrays[name] for arrays in read]) for name in _READ}

    def turns(self) -> Iterator[range]:
        # Worlds of one configuration have the same turns.
        world = next(world for world in self._worlds if not (world.terminated or world.truncated))
        yield world.actors
        while world.turn:
            yield world.actors

    def play(self, actions: NDArray[np.int64], running: NDArray[np.bool_]) -> None:
        for number in np.flatnonzero(running):
            self._worlds[number].play_turn(actions[number])
