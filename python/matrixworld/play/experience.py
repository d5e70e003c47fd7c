"""Transitions: what the agents of a team saw, did and earned, for a learner by gradients."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from matrixworld.world.arrays import array_specs, new_arrays
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Population, Team, TeamPolicy

BoolArray = NDArray[np.bool_]
Views = NDArray[np.uint8]
Reals = NDArray[np.float32]

ARRAYS = ("views", "state", "rewards", "cost", "alive", "terminated", "truncated")
"""Output arrays of a batch that transitions are taken from."""


@dataclass(frozen=True)
class Experience:
    """Transitions of the agents of one team in W episodes of at most T steps.

    The n transitions of all agents are in the order of (step, episode, agent). An agent has one in
    each step at whose begin, or at the begin of whose turn, it is alive.
    """

    acted: BoolArray
    """(T, W, A): which agents of the team acted in each step."""
    views: Views
    """(n, 3 * fov * fov): what each one saw before its turn."""
    actions: NDArray[np.int64]
    rewards: Reals
    """(n,): what the agent earned from its turn to its next one."""
    costs: Reals
    """(n,): number of kinds of collision in which it was at fault, as often."""
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
    chosen: NDArray[np.intp],
    seeds: NDArray[np.uint64],
    *,
    worlds: int = 1,
    states: bool = False,
    threads: int | None = None,
) -> Experience:
    """Play matches and return the transitions of one team.

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
    # Everything is copied, and selected at the end: that is faster than to index in each step.
    # Memory of steps that are not played is never touched.
    steps, shape = config.max_steps, buffers["alive"][:, part].shape
    acted, last = (np.zeros((steps + 1, *shape), np.bool_) for _ in range(2))
    views = np.empty((steps + 1, *buffers["views"][:, part].shape), np.uint8)
    seen = np.empty((steps + 1, *buffers["state"].shape), np.uint8) if states else None
    earned = {name: np.zeros((steps + 1, *shape), np.float32) for name in ("rewards", "cost")}
    actions = np.zeros((steps, *buffers["alive"].shape), np.int64)
    rivals = _opponents(opponents, np.repeat(chosen, worlds))
    decisions = ([policy], np.zeros(n, np.int32), own), (*rivals, others)
    for t in range(steps + 1):
        going = ~(buffers["terminated"] | buffers["truncated"])
        if seen is not None:
            seen[t] = buffers["state"]
        if not going.any():
            views[t] = buffers["views"][:, part]
            break
        paid = dict.fromkeys(earned, np.float32(0.0))
        for _ in range(batch.n_turns):
            actors = batch.actors
            turn = slice(*(max(end - own.start, 0) for end in (actors.start, actors.stop)))
            views[t][:, turn] = buffers["views"][:, part][:, turn]
            ready = buffers["alive"] & (going & ~buffers["terminated"])[:, np.newaxis]
            acted[t][:, turn] = ready[:, part][:, turn]
            for policies, numbers, agents in decisions:
                both = range(max(actors.start, agents.start), min(actors.stop, agents.stop))
                if both:
                    batch.decide(policies, numbers, both, actions[t])
            batch.play_turn(actions[t])
            for name, total in earned.items():
                so_far = buffers[name][:, part].astype(np.float32)
                change, paid[name] = so_far - paid[name], so_far
                total[t][:, : turn.stop] += change[:, : turn.stop]
                # Whose turn is still to come is paid for the last one; before the first one for
                # none: the last row is no step.
                total[t - 1][:, turn.stop :] += change[:, turn.stop :]
        ended = going & buffers["truncated"]
        last[t] = buffers["alive"][:, part] & ended[:, np.newaxis] & acted[t]
    return Experience(
        acted=acted[:t],
        views=_rows(views[:t][acted[:t]]),
        actions=actions[:t, :, part][acted[:t]],
        rewards=earned["rewards"][:t][acted[:t]],
        costs=earned["cost"][:t][acted[:t]],
        last=last[:t],
        last_views=_rows(views[1 : t + 1][last[:t]]),
        states=None if seen is None else seen[:t].reshape(t, n, -1),
        last_states=None if seen is None else _rows(seen[t]),
    )


def _opponents(
    opponents: TeamPolicy, chosen: NDArray[np.intp]
) -> tuple[list[TeamPolicy], NDArray[np.int32]]:
    """Return the opponents that play, and the place of each match's opponent among them."""
    if isinstance(opponents, str):
        return [opponents], np.zeros(len(chosen), np.int32)
    met, places = np.unique(chosen, return_inverse=True)
    return (
        [Population(opponents.genomes[i], opponents.policy) for i in met],
        places.astype(np.int32),
    )


def _rows(arrays: Views) -> Views:
    """Return arrays (n, ...) as rows (n, size), also if n is 0."""
    rows: Views = arrays.reshape(len(arrays), int(np.prod(arrays.shape[1:])))
    return rows
