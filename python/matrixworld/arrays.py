"""The arrays in which worlds tell of themselves, and those that they take."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from matrixworld.config import WorldConfig

Specs: TypeAlias = dict[str, tuple[tuple[int, ...], DTypeLike]]


def array_specs(config: WorldConfig) -> Specs:
    """Shape (of one world) and dtype of everything that a world tells of itself.

    `World` says what each is. ``positions``, ``last_positions``, ``alive``, ``steps``, ``seed``,
    ``episode``, ``views`` and ``state`` are of the moment, the others of the last step.
    """
    a, e = config.n_agents, config.n_evaders
    return {
        "positions": ((a, 2), np.int32),
        "last_positions": ((a, 2), np.int32),
        "alive": ((a,), np.bool_),
        "captured": ((e,), np.bool_),
        "ever_captured": ((e,), np.bool_),
        "captors": ((e,), np.int32),
        "involved": ((a, 3), np.bool_),
        "fault": ((a, 3), np.bool_),
        "cost": ((a,), np.float32),
        "rewards": ((a,), np.float32),
        "terminations": ((a,), np.bool_),
        "truncations": ((a,), np.bool_),
        "steps": ((), np.int32),
        "seed": ((), np.uint64),
        "episode": ((), np.uint64),
        "terminated": ((), np.bool_),
        "truncated": ((), np.bool_),
        "capture_rate": ((), np.float32),
        "ever_capture_rate": ((), np.float32),
        "survival_rate": ((2,), np.float32),
        "views": ((a, 3, config.fov, config.fov), np.uint8),
        "state": ((3, config.rows, config.cols), np.uint8),
    }


def episode_specs(config: WorldConfig) -> Specs:
    """Shape (of one world) and dtype of what a batch, besides, tells of its episodes.

    ``acted``: who was alive as the step began, in an episode that had not ended. ``ended``: whether
    the episode ended in this very step. The others are written when an episode ends and stand until
    the next one of that world does: ``final_views``, the views at its end, and what it came to, as
    in `EpisodeStatistics`.
    """
    return {
        "acted": ((config.n_agents,), np.bool_),
        "ended": ((), np.bool_),
        "final_views": ((config.n_agents, 3, config.fov, config.fov), np.uint8),
        "episode_return": ((2,), np.float64),
        "episode_length": ((), np.int32),
        "episode_capture_rate": ((), np.float32),
        "episode_ever_capture_rate": ((), np.float32),
        "episode_survivors": ((2,), np.int32),
        "episode_collisions": ((2, 3), np.int32),
        "episode_faults": ((2, 3), np.int32),
        "episode_agent_steps": ((2,), np.int64),
    }


def integers(name: str, given: ArrayLike) -> NDArray[Any]:
    """Integers of a dtype that the engine takes; TypeError for others."""
    array = np.asarray(given)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected integers, got dtype {array.dtype}")
    if array.dtype in (np.uint8, np.int64):
        return array
    if array.dtype.kind == "u" and array.itemsize == 8:
        array = array.clip(max=np.iinfo(np.int64).max)
    return array.astype(np.int64)
