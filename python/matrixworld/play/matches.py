"""Matches in which functions play: the engine's rollouts know networks and scripts only."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import SEED_MAX, check_instance, check_integer, check_shape
from matrixworld.play.policies import RatingPolicy
from matrixworld.world.arrays import array_specs, integers, new_arrays
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import EnginePolicy, Population

Callback: TypeAlias = Callable[[NDArray[np.uint8]], ArrayLike]
"""A policy as a function: observations uint8 (n, 3, fov, fov) of n living agents of one team, to
actions (n,), integers. What fails for n observations, or returns one integer, is a function of one
agent: it is asked for each observation, uint8 (3, fov, fov)."""

Plays: TypeAlias = EnginePolicy | Callback
"""What chooses a team's actions: a population of one genome, the name of a script, a function."""

Chooser: TypeAlias = Callable[[NDArray[np.bool_], NDArray[np.uint8]], ArrayLike]
"""A `Callback` that is also told who asks: bool (episodes, A) with n agents that have to act."""

Arrays: TypeAlias = Mapping[str, NDArray[Any]]
"""The arrays `_READ` of the present moment, each with a leading axis of worlds."""

_READ = ("views", "alive", "terminated", "truncated", "capture_rate")


def checked_actions(policy: Callback, views: NDArray[Any], n_actions: int) -> NDArray[np.int64]:
    """Return the actions (n,) of a function; ValueError or TypeError if they are not legal."""
    chosen = _asked(policy, views.astype(np.uint8, copy=False))
    check_shape("actions of the policy", chosen, len(views))
    if chosen.min() < 0 or chosen.max() >= n_actions:
        wrong = chosen[(chosen < 0) | (chosen >= n_actions)][0]
        raise ValueError(f"actions of the policy: expected 0 to {n_actions - 1}, got {wrong}")
    return chosen


def _asked(policy: Callback, views: NDArray[np.uint8]) -> NDArray[Any]:
    """Return what a function chooses for n views at once, or one by one if it takes one only."""

    def one_by_one() -> NDArray[Any]:
        actions: Any = [policy(view) for view in views]
        return integers("actions of the policy", actions)

    try:
        chosen = integers("actions of the policy", policy(views))
    except Exception:
        with suppress(Exception):
            return one_by_one()
        raise
    return chosen if chosen.ndim else one_by_one()


def capture_rates(
    config: WorldConfig, pursuers: Plays, evaders: Plays, *, seed: int, episodes: int
) -> NDArray[np.float64]:
    """Play the episodes of a match side by side and return their capture rates.

    Parameters
    ----------
    config : WorldConfig
        The world.
    pursuers, evaders : Population, str or callable
        As for `matrixworld.rollout`, or a function (see `Callback`); a population has one genome.
    seed : int
        Seed of the match. Episode j is the seed's episode j.
    episodes : int
        Number of episodes.

    Returns
    -------
    ndarray of float64, shape (episodes,)
        The capture rates.
    """
    check_instance("config", config, WorldConfig)
    seed = check_integer("seed", seed, 0, SEED_MAX)
    episodes = check_integer("episodes", episodes, 1)
    first = _chooser("pursuers", pursuers, config)
    second = _chooser("evaders", evaders, config)
    return play_episodes(config, first, second, seed=seed, episodes=episodes)


def _chooser(name: str, policy: Plays, config: WorldConfig) -> EnginePolicy | Chooser:
    if isinstance(policy, RatingPolicy):  # a function of inputs, not of views
        policy = policy.population()
    if callable(policy):
        return lambda asked, views: checked_actions(policy, views, config.n_actions)
    if isinstance(policy, Population):
        policy.policy.check_fits(name, config)
    return policy


def play_episodes(
    config: WorldConfig,
    pursuers: EnginePolicy | Chooser,
    evaders: EnginePolicy | Chooser,
    *,
    seed: int,
    episodes: int,
    on_round: Callable[[NDArray[np.int64], NDArray[np.bool_]], None] | None = None,
    on_decision: Callable[[int, float], None] | None = None,
    threads: int | None = None,
) -> NDArray[np.float64]:
    """Play the episodes of a match side by side and return their capture rates, (episodes,).

    `on_round` is called after each round with the actions, int64 (episodes, A), and the episodes
    that played it, bool (episodes,); both change in the next round. `on_decision` is called when a
    population or a script has decided, with its team, 0 or 1, and the processor time in seconds
    that it took in this thread.
    """
    teams = {range(config.n_pursuers): pursuers, range(config.n_pursuers, config.n_agents): evaders}
    specs = {name: array_specs(config)[name] for name in _READ}
    batch = Batch(episodes, config, buffers=new_arrays(specs, episodes), threads=threads)
    for episode in range(episodes):
        chosen = np.arange(episodes) == episode
        batch.reset(np.full(episodes, seed, np.uint64), episode=episode, mask=chosen)
    first = np.zeros(episodes, np.int32)  # of one policy
    actions = np.zeros((episodes, config.n_agents), np.int64)
    while (running := _running(batch.buffers)).any():
        for _ in range(batch.n_turns):
            turn = batch.actors
            for number, (team, policy) in enumerate(teams.items()):
                acting = range(max(team.start, turn.start), min(team.stop, turn.stop))
                if not acting:
                    continue
                if callable(policy):
                    _ask(policy, batch.buffers, acting, actions)
                    continue
                began = time.thread_time()
                batch.decide([policy], first, acting, actions)
                if on_decision is not None:
                    on_decision(number, time.thread_time() - began)
            batch.play_turn(actions)
        if on_round is not None:
            on_round(actions, running)
    return np.asarray(batch.buffers["capture_rate"], np.float64)


def _ask(policy: Chooser, arrays: Arrays, agents: range, actions: NDArray[np.int64]) -> None:
    """Write what a function chooses for the living agents among `agents`; it may be for none."""
    asked = np.zeros(actions.shape, np.bool_)
    asked[:, agents] = arrays["alive"][:, agents] & _running(arrays)[:, None]
    if asked.any():
        actions[asked] = policy(asked, arrays["views"][asked])


def _running(arrays: Arrays) -> NDArray[np.bool_]:
    return np.asarray(~(arrays["terminated"] | arrays["truncated"]))
