"""Matches in which functions play: the engine's rollouts know networks and scripts only."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld.play.functions import Plays, ask
from matrixworld.play.network_policy import check_fits
from matrixworld.world.arrays import array_specs
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Population, TeamPolicy
from matrixworld.world.world import World

_READ = ("views", "alive", "terminated", "truncated", "capture_rate")

Moment: TypeAlias = Mapping[str, NDArray[Any]]
"""The arrays `_READ` of W worlds, each with a leading axis of worlds."""


class Worlds(Protocol):
    """The worlds of a match's episodes."""

    def moment(self) -> Moment:
        """Return the arrays of the present moment."""
        ...

    def turns(self) -> Iterator[range]:
        """Yield the agents that act in each turn of the next round."""
        ...

    def decide(self, policy: TeamPolicy, agents: range, actions: NDArray[np.int64]) -> None:
        """Write the actions (W, A) that a population of one genome or a script chooses."""
        ...

    def play(self, actions: NDArray[np.int64], running: NDArray[np.bool_]) -> None:
        """Play a turn in the worlds that are running."""
        ...


Decide: TypeAlias = Callable[[Worlds, range, NDArray[np.int64]], None]
"""What decides for a team: called with the worlds, the team's agents whose turn it is, and the
actions (W, A), in which it writes those of the agents that have to act."""

OnRound: TypeAlias = Callable[[NDArray[np.int64], NDArray[np.bool_]], None]
"""What is called after each round."""


def capture_rates(
    config: WorldConfig, pursuers: Plays, evaders: Plays, *, seed: int, episodes: int
) -> NDArray[np.float64]:
    """Play the episodes of a match side by side and return their capture rates.

    Parameters
    ----------
    config : WorldConfig
        The settings of the worlds.
    pursuers, evaders : Population, str or callable
        What plays for the teams; a population has one genome.
    seed : int
        The seed of the match. Episode j is the seed's episode j, as in `matrixworld.rollout`.
    episodes : int
        Number of episodes.

    Returns
    -------
    ndarray of float64, shape (episodes,)
        The capture rates, as in `matrixworld.EpisodeStatistics`.
    """
    deciders = []
    for name, policy in (("pursuers", pursuers), ("evaders", evaders)):
        if isinstance(policy, Population):
            check_fits(name, policy.network, config)
        deciders.append(_decider(policy, config.n_actions))
    return play_episodes(config, *deciders, seed=seed, episodes=episodes)


def play_episodes(
    config: WorldConfig,
    pursuers: Decide,
    evaders: Decide,
    *,
    seed: int,
    episodes: int,
    on_round: OnRound = lambda actions, running: None,
) -> NDArray[np.float64]:
    """Play the episodes of a match side by side; any functions decide for the teams.

    Parameters
    ----------
    config, seed, episodes
        As in `capture_rates`.
    pursuers, evaders : Decide
        What decides for the teams.
    on_round : callable, optional
        Called after each round with the actions, int64 (episodes, A), and with the episodes that
        played it, bool (episodes,). Both change in the next round.

    Returns
    -------
    ndarray of float64, shape (episodes,)
        The capture rates.
    """
    teams = {
        range(config.n_pursuers): pursuers,
        range(config.n_pursuers, config.n_agents): evaders,
    }
    simultaneous = World(config).n_turns == 1
    worlds: Worlds = (_Together if simultaneous else _InTurns)(config, seed, episodes)
    actions = np.zeros((episodes, config.n_agents), np.int64)
    while (running := _running(worlds.moment())).any():
        for turn in worlds.turns():
            for team, decide in teams.items():
                acting = range(max(team.start, turn.start), min(team.stop, turn.stop))
                if acting:
                    decide(worlds, acting, actions)
            worlds.play(actions, running)
        on_round(actions, running)
    return np.asarray(worlds.moment()["capture_rate"], np.float64)


def asked_agents(moment: Moment, agents: range) -> NDArray[np.bool_]:
    """Return which of some agents, of all worlds, have to act: bool (W, A)."""
    asked = np.zeros(moment["alive"].shape, np.bool_)
    asked[:, agents] = moment["alive"][:, agents] & _running(moment)[:, None]
    return asked


def decide_by(policy: TeamPolicy) -> Decide:
    """Return a population of one genome, or a script, as what decides for a team."""
    return lambda worlds, agents, actions: worlds.decide(policy, agents, actions)


def _decider(policy: Plays, n_actions: int) -> Decide:
    if not callable(policy):
        return decide_by(policy)
    called = policy

    def decide(worlds: Worlds, agents: range, actions: NDArray[np.int64]) -> None:
        moment = worlds.moment()
        ask(called, moment["views"], asked_agents(moment, agents), actions, n_actions)

    return decide


def _running(moment: Moment) -> NDArray[np.bool_]:
    return np.asarray(~(moment["terminated"] | moment["truncated"]))


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

    def decide(self, policy: TeamPolicy, agents: range, actions: NDArray[np.int64]) -> None:
        self._batch.decide([policy], np.zeros(len(actions), np.int32), agents, actions)

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

    def decide(self, policy: TeamPolicy, agents: range, actions: NDArray[np.int64]) -> None:
        for world, row in zip(self._worlds, actions, strict=True):
            world.decide(policy, agents, row)

    def play(self, actions: NDArray[np.int64], running: NDArray[np.bool_]) -> None:
        for number in np.flatnonzero(running):
            self._worlds[number].play_turn(actions[number])
