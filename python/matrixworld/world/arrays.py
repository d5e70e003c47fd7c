"""Names, shapes and dtypes of world output arrays, and the check of integer inputs."""

from __future__ import annotations

import math
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from matrixworld import _core
from matrixworld._util.memory import check_memory
from matrixworld.world.config import WorldConfig

Specs: TypeAlias = dict[str, tuple[tuple[int, ...], DTypeLike]]


class OutputField(NamedTuple):
    """One row of the engine's table of output arrays.

    Parameters
    ----------
    name : str
        Name of the array.
    dtype : numpy.dtype
        Dtype of the array. Arrays of views may also be float32.
    axes : tuple of str
        Axes of one world's part: ``agents``, ``evaders``, ``teams``, ``kinds``, ``row_col``,
        ``channels``, ``fov``, ``rows`` or ``cols``.
    written : {"moment", "step", "step start", "episode end"}
        When the engine writes it. After an automatic reset, a ``moment`` is of the new episode and
        a ``step`` still of the ended one.
    """

    name: str
    dtype: np.dtype[Any]
    axes: tuple[str, ...]
    written: str


# The engine's own table: a new output is declared there (cpp/play/output_fields.cpp), and described
# in the docstring of `array_specs` or `episode_specs` below.
WORLD_FIELDS = {row[0]: OutputField(*row) for row in _core.world_fields()}
BATCH_FIELDS = {row[0]: OutputField(*row) for row in _core.batch_fields()}


def array_specs(config: WorldConfig) -> Specs:
    """Return shape and dtype of every array that a world can write.

    Parameters
    ----------
    config : WorldConfig
        The configuration, which gives the sizes.

    Returns
    -------
    dict of str to (tuple of int, dtype)
        By name: the shape for one world, without an axis of worlds, and the dtype.

    Notes
    -----
    A is the number of agents, pursuers first, E of evaders. An axis of 3 kinds is a collision with
    an obstacle, a teammate, an adversary; one of 2 teams is pursuers, evaders; the 3 channels are
    evaders, pursuers, obstacles.

    =================  ===================  =======  =======================================
    positions          (A, 2)               int32    row and column; (-1, -1) when gone
    last_positions     (A, 2)               int32    the same, but for a gone agent the cell
                                                     where it disappeared
    alive              (A,)                 bool     whether the agent is in the world
    captured           (E,)                 bool     captured now, or when it disappeared
    ever_captured      (E,)                 bool     captured at some time of the episode
    captors            (E,)                 int32    pursuers that took part in a capture
    involved           (A, 3)               bool     in a collision of each kind
    fault              (A, 3)               bool     at fault in a collision of each kind
    cost               (A,)                 float32  number of kinds in which it is at fault
    rewards            (A,)                 float32  reward of the step
    terminations       (A,)                 bool     gone, or the world has terminated
    truncations        (A,)                 bool     the world was truncated, and neither
                                                     it nor the agent has terminated
    steps              ()                   int32    rounds played in the episode
    seed               ()                   uint64   seed of the episode
    episode            ()                   uint64   number of the episode for its seed
    terminated         ()                   bool     whether the world has terminated
    truncated          ()                   bool     whether the episode ended at max_steps
    capture_rate       ()                   float32  share of evaders that count as captured
    ever_capture_rate  ()                   float32  share of evaders captured at some time
    survival_rate      (2,)                 float32  share of each team that is alive
    views              (A, 3, fov, fov)     uint8    what each agent sees
    state              (3, rows, cols)      uint8    the whole world
    =================  ===================  =======  =======================================

    ``positions``, ``last_positions``, ``alive``, ``steps``, ``seed``, ``episode``, ``views`` and
    ``state`` describe the present moment, the others the last step.
    """
    return _specs(WORLD_FIELDS, config)


def episode_specs(config: WorldConfig) -> Specs:
    """Return shape and dtype of the arrays that only a batch writes.

    Parameters
    ----------
    config : WorldConfig
        The configuration, which gives the sizes.

    Returns
    -------
    dict of str to (tuple of int, dtype)
        By name: the shape for one world, without an axis of worlds, and the dtype.

    Notes
    -----
    Letters and axes are those of `array_specs`.

    =========================  ================  =======  ======================================
    acted                      (A,)              bool     alive when the step began, in an
                                                          episode that had not ended
    ended                      ()                bool     whether the episode ended in this step
    final_views                (A, 3, fov, fov)  uint8    views at the end of the episode
    episode_capture_rate       ()                float32  as in `EpisodeStatistics`
    episode_ever_capture_rate  ()                float32  as in `EpisodeStatistics`
    episode_length             ()                int32    steps
    episode_return             (2,)              float64  rewards summed over team and steps
    episode_survivors          (2,)              int32    agents alive at the end
    episode_collisions         (2, 3)            int32    agent-steps in a collision
    episode_faults             (2, 3)            int32    agent-steps at fault in a collision
    episode_agent_steps        (2,)              int64    steps of agents alive as they began
    =========================  ================  =======  ======================================

    ``final_views`` and the ``episode_...`` arrays are written when an episode ends, and stay until
    the next episode of that world ends.
    """
    return _specs(BATCH_FIELDS, config)


def _specs(fields: dict[str, OutputField], config: WorldConfig) -> Specs:
    sizes = config.setup.axis_sizes()
    return {
        name: (tuple(sizes[axis] for axis in field.axes), field.dtype)
        for name, field in fields.items()
    }


def new_arrays(specs: Specs, n_worlds: int) -> dict[str, NDArray[Any]]:
    """Return an array of zeros for each of some specs, with a leading axis of worlds.

    Raises OutOfMemoryError if they need more memory than is available.
    """
    sizes = {
        name: n_worlds * math.prod(shape) * np.dtype(dtype).itemsize
        for name, (shape, dtype) in specs.items()
    }
    check_memory("arrays", **sizes)
    return {name: np.zeros((n_worlds, *shape), dtype) for name, (shape, dtype) in specs.items()}


def state_bytes(config: WorldConfig) -> int:
    """Return about how many bytes a world in a batch needs for itself."""
    return 1000 + 32 * config.n_agents + (4 * config.rows * config.cols if config.density else 0)


def workspace_bytes(config: WorldConfig) -> int:
    """Return about how many bytes a thread needs to play any number of worlds, one by one."""
    return 32 * config.rows * config.cols + 160 * config.n_agents


def integers(name: str, given: ArrayLike) -> NDArray[Any]:
    """Return integers as an array of a dtype that the engine takes.

    Parameters
    ----------
    name : str
        Name of the argument, for the error message.
    given : array_like of int
        The integers, of any integer dtype.

    Returns
    -------
    ndarray of uint8 or int64
        The same integers. Values above the largest int64 become that one: they are out of range for
        every argument of the engine, which then names them in its own message.

    Raises
    ------
    TypeError
        If the values are not integers.
    """
    array = np.asarray(given)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected integers, got dtype {array.dtype}")
    if array.dtype in (np.uint8, np.int64):
        return array
    if array.dtype.kind == "u" and array.itemsize == 8:
        array = array.clip(max=np.iinfo(np.int64).max)  # a cast alone would make them negative
    return array.astype(np.int64)
