"""Experience of a team: what its agents saw, did and earned in matches, for gradient learners."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.arrays import array_specs, new_arrays
from matrixworld.batch import Batch
from matrixworld.coevolution.types import BoolArray, Indices, IntArray, Seeds, Team, other
from matrixworld.config import WorldConfig
from matrixworld.policy import Population, TeamPolicy
from matrixworld.short_repr import short_repr

Views = NDArray[np.uint8]
Reals = NDArray[np.float32]

Player = tuple[range, list[TeamPolicy], NDArray[np.int32]]
"""Agents of a team, the policies that play for it, and the place of each match's policy."""

ARRAYS = ("views", "state", "rewards", "cost", "alive", "terminated", "truncated")
"""Output arrays that experience is taken from."""


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


def experience(
    config: WorldConfig,
    team: Team,
    policy: Population,
    opponents: TeamPolicy,
    chosen: Indices,
    seeds: Seeds,
    *,
    episode: int = 0,
    states: bool = False,
    threads: int | None = None,
) -> Experience:
    """Play matches and return what one team has experienced.

    Parameters
    ----------
    config : WorldConfig
        The world. All agents act at the same time.
    team : {"pursuer", "evader"}
        The team.
    policy : Population
        Its policy: one genome.
    opponents : Population or str
        Opponents, or the name of a script.
    chosen : ndarray of int, shape (W,)
        Opponent of each match; ignored for a script.
    seeds : ndarray of uint64, shape (W,)
        Seed of each match.
    episode : int, optional
        Number of the episode of each seed. The default is 0.
    states : bool, optional
        Whether to keep the states of the worlds. The default is False.
    threads : int, optional
        Threads that play. By default one per usable core. The result does not depend on it.

    Returns
    -------
    Experience
        The transitions.

    Notes
    -----
    Policies decide in the engine with the random numbers of a rollout: the matches are those that
    `matrixworld.rollout` plays for these seeds.
    """
    specs = array_specs(config)
    wanted = [name for name in ARRAYS if states or name != "state"]
    buffers = new_arrays({name: specs[name] for name in wanted}, len(seeds))
    batch = Batch(len(seeds), config, threads=threads, buffers=buffers)
    batch.reset(seeds, episode=episode)
    everyone = {
        "pursuer": range(config.n_pursuers),
        "evader": range(config.n_pursuers, config.n_agents),
    }
    players: list[Player] = [
        (everyone[team], [policy], np.zeros(len(seeds), np.int32)),
        (everyone[other(team)], *_opponents(opponents, chosen)),
    ]
    steps = list(_play(batch, everyone[team], players))
    acted, views, actions, rewards, costs, last, last_views, before = zip(*steps, strict=True)
    return Experience(
        acted=np.stack(acted),
        views=np.concatenate(views),
        actions=np.concatenate(actions),
        rewards=np.concatenate(rewards),
        costs=np.concatenate(costs),
        last=np.stack(last),
        last_views=np.concatenate(last_views),
        states=np.stack(before) if states else None,
        last_states=_flat(buffers["state"]) if states else None,
    )


def _opponents(
    opponents: TeamPolicy, chosen: Indices
) -> tuple[list[TeamPolicy], NDArray[np.int32]]:
    """Return the opponents that play, and the place of each match's opponent among them."""
    if isinstance(opponents, str):
        return [opponents], np.zeros(len(chosen), np.int32)
    met, places = np.unique(chosen, return_inverse=True)
    return (
        [Population(opponents.genomes[i], opponents.network) for i in met],
        places.astype(np.int32),
    )


def _play(batch: Batch, team: range, players: list[Player]) -> Iterator[tuple[Any, ...]]:
    """Play all episodes to their ends; yield the fields of `Experience` for each step."""
    buffers = batch.buffers
    part = slice(team.start, team.stop)
    actions = np.zeros(buffers["alive"].shape, np.int64)
    going = np.ones(batch.n_worlds, np.bool_)
    while going.any():
        acted = buffers["alive"][:, part] & going[:, None]
        views = _flat(buffers["views"][:, part][acted])
        before = _flat(buffers["state"]) if "state" in buffers else None
        for agents, policies, places in players:
            batch.decide(policies, places, agents, actions)
        batch.step(actions)
        # An agent that is alive at the end of its time would have gone on.
        last = buffers["alive"][:, part] & (going & buffers["truncated"])[:, None]
        yield (
            acted,
            views,
            actions[:, part][acted],
            buffers["rewards"][:, part][acted],
            buffers["cost"][:, part][acted],
            last,
            _flat(buffers["views"][:, part][last]),
            before,
        )
        going = ~(buffers["terminated"] | buffers["truncated"])


def _flat(arrays: Views) -> Views:
    """Return a copy of arrays (n, ...) as rows (n, size)."""
    rows: Views = arrays.reshape(len(arrays), math.prod(arrays.shape[1:])).copy()
    return rows
