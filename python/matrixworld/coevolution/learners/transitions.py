"""Transitions: what the agents of a team saw, did and earned, for a learner by gradients."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.types import BoolArray, Indices, IntArray, Seeds, Team
from matrixworld.world.arrays import array_specs, new_arrays
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Population, TeamPolicy

Views = NDArray[np.uint8]
Reals = NDArray[np.float32]

ARRAYS = ("views", "state", "rewards", "cost", "alive", "terminated", "truncated")
"""Output arrays of a batch that transitions are taken from."""


@dataclass(frozen=True)
class Experience:
    """Transitions of the agents of one team in W episodes of at most T steps.

    The n transitions of all agents are in the order of (step, episode, agent). An agent has one in
    each step at whose begin it is alive.
    """

    acted: BoolArray
    """(T, W, A): which agents of the team acted in each step."""
    views: Views
    """(n, 3 * fov * fov): what each one saw before."""
    actions: IntArray
    rewards: Reals
    costs: Reals
    """(n,): number of kinds of collision in which the agent was at fault."""
    last: BoolArray
    """(T, W, A): agents alive when `max_steps` ended their episode, in its last step. What they
    would have earned later has to be estimated from their last views."""
    last_views: Views
    """(m, 3 * fov * fov): what these saw after that step, in the same order."""
    states: Views | None = None
    """(T, W, 3 * rows * cols): the worlds before each step, for a central critic only."""
    last_states: Views | None = None
    """(W, 3 * rows * cols): the worlds after the last step."""

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
    worlds: int = 1,
    states: bool = False,
    threads: int | None = None,
) -> Experience:
    """Play matches and return the transitions of one team, all of whose agents act at a time.

    The one genome of `policy` plays for the team in each match, against the opponent `chosen` (W,),
    with a seed (W,) and `worlds` episodes. The states of the worlds are kept if `states`.

    Policies decide in the engine with the random numbers of a rollout: the matches are those that
    `matrixworld.rollout` plays for these seeds, whatever the number of threads.
    """
    specs, everywhere = array_specs(config), np.repeat(seeds, worlds)
    n = len(everywhere)
    buffers = new_arrays({name: specs[name] for name in ARRAYS if states or name != "state"}, n)
    batch = Batch(n, config, threads=threads, buffers=buffers)
    for number in range(worlds):
        batch.reset(everywhere, episode=number, mask=np.arange(n) % worlds == number)
    pursuers, evaders = range(config.n_pursuers), range(config.n_pursuers, config.n_agents)
    own, others = (pursuers, evaders) if team == "pursuer" else (evaders, pursuers)
    part = slice(own.start, own.stop)
    seen = {name: buffers[name][:, part] for name in ("views", "alive", "rewards", "cost")}
    seen |= {name: buffers[name] for name in ("state", "truncated") if name in buffers}
    # Everything is copied, and selected at the end: that is faster than to index in each step.
    # Memory of steps that are not played is never touched.
    steps = config.max_steps
    kept = {name: np.empty((steps + 1, *array.shape), array.dtype) for name, array in seen.items()}
    actions = np.zeros((steps, *buffers["alive"].shape), np.int64)
    going = np.zeros((steps + 1, n), np.bool_)
    rivals, places = _opponents(opponents, np.repeat(chosen, worlds))
    for t in range(steps + 1):
        for name, array in seen.items():
            kept[name][t] = array
        going[t] = ~(buffers["terminated"] | buffers["truncated"])
        if not going[t].any():
            break
        batch.decide([policy], np.zeros(n, np.int32), own, actions[t])
        batch.decide(rivals, places, others, actions[t])
        batch.step(actions[t])
    # What was kept at t is what a step begins with, and what the step before ended with.
    before = {name: array[:t] for name, array in kept.items()}
    after = {name: array[1 : t + 1] for name, array in kept.items()}
    acted = before["alive"] & going[:t, :, np.newaxis]
    # An agent that is alive at the end of its time would have gone on.
    last = after["alive"] & (going[:t] & after["truncated"])[..., np.newaxis]
    return Experience(
        acted=acted,
        views=_rows(before["views"][acted]),
        actions=actions[:t, :, part][acted],
        rewards=after["rewards"][acted],
        costs=after["cost"][acted],
        last=last,
        last_views=_rows(after["views"][last]),
        states=before["state"].reshape(t, n, -1) if states else None,
        last_states=_rows(after["state"][-1]) if states else None,
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


def _rows(arrays: Views) -> Views:
    """Return arrays (n, ...) as rows (n, size), also if n is 0."""
    rows: Views = arrays.reshape(len(arrays), int(np.prod(arrays.shape[1:])))
    return rows
