"""An episode made without the engine: random walks, captures by contact, collisions with walls."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from matrixworld.episodes.episode import Episode

MOVES = [(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1)]


def made_up_episode(
    rows: int = 12,
    cols: int = 16,
    pursuers: int = 5,
    evaders: int = 7,
    steps: int = 30,
    seed: int = 0,
) -> Episode:
    """Return random walks in which an evader disappears when a pursuer shares its cell."""
    rng = np.random.default_rng(seed)
    world = rng.random((rows, cols)) < 0.1
    agents = pursuers + evaders
    start = np.argwhere(~world)
    moments = [start[rng.choice(len(start), agents, replace=False)].astype(np.int32)]
    alive = [np.ones(agents, bool)]
    actions = rng.integers(0, 5, (steps, agents), dtype=np.int8)
    fault = np.zeros((steps, agents, 3), bool)
    last_positions = moments[:]
    for step in range(steps):
        now, fault[step, :, 0] = _walk(moments[-1], actions[step], world)
        touched = (now[pursuers:, None] == now[None, :pursuers]).all(axis=2).any(axis=1)
        living = alive[-1] & ~np.concatenate([np.zeros(pursuers, bool), touched])
        fault[step] &= alive[-1][:, None]
        last_positions.append(
            np.where(alive[-1][:, None], now, last_positions[-1]).astype(np.int32)
        )
        moments.append(np.where(living[:, None], now, -1).astype(np.int32))
        alive.append(living)
    ever = ~np.array(alive)[:, pursuers:]
    return Episode(
        positions=np.array(moments),
        last_positions=np.array(last_positions),
        alive=np.array(alive),
        captured=ever,
        ever_captured=ever,
        actions=actions,
        rewards=rng.normal(size=(steps, agents)).astype(np.float32),
        involved=fault.copy(),
        fault=fault,
        map=world,
        n_pursuers=pursuers,
        config={"rules": "O", "rows": rows, "cols": cols, "rewards": {"step": -0.05}},
    )


def _walk(
    start: NDArray[np.int32], actions: NDArray[np.int8], world: NDArray[np.bool_]
) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    """Return where each agent ends, and whether it was stopped; gone agents start at (-1, -1)."""
    wanted = start + np.array(MOVES)[actions]
    clipped = wanted.clip(0, np.array(world.shape) - 1)
    stopped = (wanted != clipped).any(axis=1) | world[tuple(clipped.T)]
    return np.where(stopped[:, None], start, wanted), stopped
