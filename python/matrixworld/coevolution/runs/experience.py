"""Play matches and keep what the agents of one team saw, did and earned, for gradient learners."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.arrays import array_specs, new_arrays
from matrixworld.batch import Batch
from matrixworld.coevolution.learners.experience import Experience, Views
from matrixworld.coevolution.types import Indices, Seeds, Team, other
from matrixworld.config import WorldConfig
from matrixworld.policy import Population, TeamPolicy

Player = tuple[range, list[TeamPolicy], NDArray[np.int32]]
"""Agents of a team, the policies that play for it, and the place of each match's policy."""

ARRAYS = ("views", "state", "rewards", "cost", "alive", "terminated", "truncated")
"""Output arrays that experience is taken from."""


def experience(
    config: WorldConfig,
    team: Team,
    policy: Population,
    opponents: TeamPolicy,
    chosen: Indices,
    seeds: Seeds,
    *,
    worlds: int = 1,
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
    worlds : int, optional
        Episodes of each match, as in a rollout. The default is 1.
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
    everywhere = np.repeat(seeds, worlds)
    buffers = new_arrays({name: specs[name] for name in wanted}, len(everywhere))
    batch = Batch(len(everywhere), config, threads=threads, buffers=buffers)
    for number in range(worlds):
        batch.reset(everywhere, episode=number, mask=np.arange(len(everywhere)) % worlds == number)
    everyone = {
        "pursuer": range(config.n_pursuers),
        "evader": range(config.n_pursuers, config.n_agents),
    }
    players: list[Player] = [
        (everyone[team], [policy], np.zeros(len(everywhere), np.int32)),
        (everyone[other(team)], *_opponents(opponents, np.repeat(chosen, worlds))),
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
