"""The arrays that worlds write and read: names, shapes, dtypes, masks, checks of inputs."""

from __future__ import annotations

from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from matrixworld import _core
from matrixworld._util.checks import check_instance, check_integers
from matrixworld.world.config import WorldConfig

Specs: TypeAlias = dict[str, tuple[tuple[int, ...], DTypeLike]]


class OutputField(NamedTuple):
    """One row of the engine's table of output arrays, with the axes of one world's part.

    `written` is when the engine writes it: "moment", "step", "step start" or "episode end". After
    an automatic reset, a moment is of the new episode, a step still of the ended one.
    """

    name: str
    dtype: np.dtype[Any]
    axes: tuple[str, ...]
    written: str


# Rows and columns from an agent to the cell that each `Action` leads to.
MOVES = np.array([(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1), (-1, 1), (1, 1), (1, -1), (-1, -1)])

LARGE = ("views", "inputs", "state")
"""Arrays of moments that are slow to write, and left out unless they are asked for."""

CHANNEL = {"evader": 0, "pursuer": 1, "obstacle": 2}
"""Channels of a view by what they show."""

# The engine's own table: a new output is declared there (cpp/play/output_fields.cpp), and described
# in the docstring of `array_specs` or `episode_specs` below.
WORLD_FIELDS = {row[0]: OutputField(*row) for row in _core.world_fields()}
BATCH_FIELDS = {row[0]: OutputField(*row) for row in _core.batch_fields()}


class WorldArrays:
    """What `array_specs` lists but ``views``, ``inputs`` and ``state``, as attributes.

    What has the shape () is a number of Python. There are A agents, pursuers first, of which E are
    evaders; axes of 3 are the kinds of collision.
    """

    seed: int
    episode: int
    steps: int
    terminated: bool
    truncated: bool
    capture_rate: float
    ever_capture_rate: float
    survival_rate: NDArray[np.float32]  # (2,): of pursuers and of evaders
    positions: NDArray[np.int32]  # (A, 2)
    last_positions: NDArray[np.int32]  # (A, 2)
    alive: NDArray[np.bool_]  # (A,)
    captured: NDArray[np.bool_]  # (E,)
    ever_captured: NDArray[np.bool_]  # (E,)
    captors: NDArray[np.int32]  # (E,)
    involved: NDArray[np.bool_]  # (A, 3), by kind of collision
    fault: NDArray[np.bool_]  # (A, 3)
    cost: NDArray[np.float32]  # (A,)
    rewards: NDArray[np.float32]  # (A,)
    terminations: NDArray[np.bool_]  # (A,)
    truncations: NDArray[np.bool_]  # (A,)


def python_value(array: NDArray[Any]) -> Any:
    """Return an array, or its number if it has no axes."""
    return array if array.ndim else array.item()


def array_specs(config: WorldConfig) -> Specs:
    """Return shape and dtype, by name, of every array that a world of a `config` can write.

    Shapes are those of one world. A is the number of agents, pursuers first, E of evaders. An axis
    of 3 kinds is a collision with an obstacle, a teammate, an adversary; one of 2 teams is
    pursuers, evaders; the 3 channels are evaders, pursuers, obstacles.

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
    inputs             (A, moves, inputs)   float32  the named inputs of each move (`INPUTS`)
    state              (3, rows, cols)      uint8    the whole world
    =================  ===================  =======  =======================================

    ``positions``, ``last_positions``, ``alive``, ``steps``, ``seed``, ``episode``, ``views``,
    ``inputs`` and ``state`` describe the present moment, the others the last step.
    """
    return _specs(WORLD_FIELDS, config)


def episode_specs(config: WorldConfig) -> Specs:
    """Return shape and dtype of the arrays that only a batch writes, for a `config`.

    Letters and axes are those of `array_specs`.

    =========================  ==================  =======  ======================================
    acted                      (A,)                bool     alive when the step began, in an
                                                            episode that had not ended
    ended                      ()                  bool     whether the episode ended in this step
    final_views                (A, 3, fov, fov)    uint8    views at the end of the episode
    final_inputs               (A, moves, inputs)  float32  inputs at the end of the episode
    episode_capture_rate       ()                  float32  as in `EpisodeStatistics`
    episode_ever_capture_rate  ()                  float32  as in `EpisodeStatistics`
    episode_length             ()                  int32    steps
    episode_return             (2,)                float64  rewards summed over team and steps
    episode_survivors          (2,)                int32    agents alive at the end
    episode_collisions         (2, 3)              int32    agent-steps in a collision
    episode_faults             (2, 3)              int32    agent-steps at fault in a collision
    episode_agent_steps        (2,)                int64    steps of agents alive as they began
    =========================  ==================  =======  ======================================

    ``final_views``, ``final_inputs`` and the ``episode_...`` arrays are written when an episode
    ends, and stay until the next episode of that world ends.
    """
    return _specs(BATCH_FIELDS, config)


def _specs(fields: dict[str, OutputField], config: WorldConfig) -> Specs:
    check_instance("config", config, WorldConfig)
    sizes = config.setup.axis_sizes()
    return {
        name: (tuple(sizes[axis] for axis in field.axes), field.dtype)
        for name, field in fields.items()
    }


def new_arrays(specs: Specs, n_worlds: int) -> dict[str, NDArray[Any]]:
    """Return an array of zeros for each of some specs, with a leading axis of worlds."""
    return {name: np.zeros((n_worlds, *shape), dtype) for name, (shape, dtype) in specs.items()}


def integers(name: str, given: ArrayLike) -> NDArray[Any]:
    """Return integers as an array of a dtype that the engine takes, uint8 or int64."""
    if type(given) is np.ndarray and given.dtype in (np.uint8, np.int64):
        return given
    return check_integers(name, given, np.int64, None)


def check_written(name: str, array: NDArray[np.int64]) -> None:
    """Raise TypeError unless the engine can write actions into an array."""
    if not isinstance(array, np.ndarray) or array.dtype != np.int64:
        got = getattr(array, "dtype", type(array).__name__)
        raise TypeError(f"{name}: expected an array of int64, got {got}")


def positions_of(
    name: str, given: ArrayLike | None, n: int, n_worlds: int | None = None
) -> NDArray[np.int32] | None:
    """Return positions of n agents, (n, 2), or of n agents in each world, (n_worlds, n, 2)."""
    if given is None:
        return None
    array = check_integers(name, given, np.int32, None)
    shapes = [(n, 2)] if n_worlds is None else [(n, 2), (n_worlds, n, 2)]
    if array.shape not in shapes:
        expected = " or ".join(map(str, shapes))
        raise ValueError(f"{name}: expected shape {expected}, got {array.shape}")
    return np.ascontiguousarray(np.broadcast_to(array, shapes[-1]))
