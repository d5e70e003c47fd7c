"""Play matches and keep what the agents of one team saw, did and earned, for gradient learners."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.learners.experience import Experience, Views
from matrixworld.coevolution.types import BoolArray, Indices, Seeds, Team, other
from matrixworld.world.arrays import array_specs, new_arrays
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Population, TeamPolicy

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
    return _played(batch, everyone[team], players, config.max_steps)


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


def _played(batch: Batch, team: range, players: list[Player], most: int) -> Experience:
    """Play all episodes to their ends, at most so many steps; return what the team experienced."""
    buffers, part = batch.buffers, slice(team.start, team.stop)
    seen = {name: buffers[name][:, part] for name in ("views", "alive", "rewards", "cost")}
    seen |= {name: buffers[name] for name in ("state", "truncated") if name in buffers}
    # Everything is copied, and selected at the end: that is faster than to index in each step.
    # Memory of steps that are not played is never touched.
    kept = {name: np.empty((most + 1, *array.shape), array.dtype) for name, array in seen.items()}
    actions = np.zeros((most, *buffers["alive"].shape), np.int64)
    going = np.zeros((most + 1, batch.n_worlds), np.bool_)
    for t in range(most + 1):
        for name, array in seen.items():
            kept[name][t] = array
        np.logical_or(buffers["terminated"], buffers["truncated"], out=going[t])
        np.logical_not(going[t], out=going[t])
        if not going[t].any():
            break
        for agents, policies, places in players:
            batch.decide(policies, places, agents, actions[t])
        batch.step(actions[t])
    return _selected(kept, actions[:, :, part], going, t)


def _selected(
    kept: dict[str, NDArray[Any]], actions: NDArray[np.int64], going: BoolArray, steps: int
) -> Experience:
    """Return the transitions of the agents that acted, from what all agents saw in all steps."""
    # What was kept at t is what a step begins with, and what the step before ended with.
    before = {name: array[:steps] for name, array in kept.items()}
    after = {name: array[1 : steps + 1] for name, array in kept.items()}
    acted = before["alive"] & going[:steps, :, None]
    # An agent that is alive at the end of its time would have gone on.
    last = after["alive"] & (going[:steps] & after["truncated"])[:, :, None]
    return Experience(
        acted=acted,
        views=_flat(before["views"][acted]),
        actions=actions[:steps][acted],
        rewards=after["rewards"][acted],
        costs=after["cost"][acted],
        last=last,
        last_views=_flat(after["views"][last]),
        states=before["state"].reshape(*going[:steps].shape, -1) if "state" in kept else None,
        last_states=_flat(after["state"][-1]) if "state" in kept else None,
    )


def _flat(arrays: Views) -> Views:
    """Return arrays (n, ...) as rows (n, size)."""
    rows: Views = arrays.reshape(len(arrays), math.prod(arrays.shape[1:]))
    return rows
