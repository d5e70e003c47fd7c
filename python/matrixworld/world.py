"""One world, and batches of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from matrixworld import _core
from matrixworld.checks import SEED_MAX, check_bool, check_integer, check_naturals, check_threads
from matrixworld.config import WorldConfig
from matrixworld.conflicts import Conflict, conflict_of
from matrixworld.maps import MapLike, read_map
from matrixworld.rules import Rules

if TYPE_CHECKING:
    from matrixworld.render import Scene


def array_specs(config: WorldConfig) -> dict[str, tuple[tuple[int, ...], DTypeLike]]:
    """Shape (of one world) and dtype of everything that a world tells of itself."""
    a, e = config.n_agents, config.n_evaders
    return {
        "positions": ((a, 2), np.int32),
        "alive": ((a,), np.bool_),
        "captured": ((e,), np.bool_),
        "ever_captured": ((e,), np.bool_),
        "captors": ((e,), np.int32),
        "involved": ((a, 3), np.bool_),
        "fault": ((a, 3), np.bool_),
        "rewards": ((a,), np.float32),
        "steps": ((), np.int32),
        "terminated": ((), np.bool_),
        "truncated": ((), np.bool_),
        "views": ((a, 3, config.fov, config.fov), np.uint8),
        "state": ((3, config.rows, config.cols), np.uint8),
    }


def _integers(name: str, given: ArrayLike) -> NDArray[Any]:
    array = np.asarray(given)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected integers, got dtype {array.dtype}")
    if array.dtype in (np.uint8, np.int64):
        return array
    if array.dtype.kind == "u" and array.itemsize == 8:
        array = array.clip(max=np.iinfo(np.int64).max)
    return array.astype(np.int64)


def _positions(name: str, given: ArrayLike | None, n: int) -> NDArray[np.int32] | None:
    if given is None:
        return None
    array = _integers(name, given)
    if array.shape != (n, 2):
        raise ValueError(f"{name}: expected shape {(n, 2)}, got {array.shape}")
    return np.ascontiguousarray(array.clip(-(2**31), 2**31 - 1), dtype=np.int32)


class World:
    """One world of pursuers and evaders on a grid.

    The agents' axis of every array holds the pursuers and then the evaders, A = n_pursuers +
    n_evaders in all. Every attribute that is an array is a fresh copy.

    config: a `WorldConfig`, `Rules`, or the name of a variant; keywords change its fields:
        ``World("O", rows=10, cols=10, n_pursuers=2, n_evaders=3)``.

    A new world is in its first episode of seed 0.
    """

    def __init__(self, config: WorldConfig | Rules | str = "O", **changes: Any) -> None:
        self.config = WorldConfig.of(config, **changes)
        self._specs = array_specs(self.config)
        self._core = _core.World(self.config.setup)
        self._explained = False
        self._seed, self._episode = 0, -1
        self.reset()

    def reset(
        self,
        seed: int | None = None,
        *,
        episode: int = 0,
        pursuers: ArrayLike | None = None,
        evaders: ArrayLike | None = None,
        obstacles: MapLike | None = None,
    ) -> None:
        """Start an episode.

        seed, episode: which one, by two ints in [0, 2**64); without a seed the next episode of
            the seed in use, and ``episode`` must be left out
        pursuers, evaders: where they start, ``(n, 2)`` ints (row, col); drawn where not given
        obstacles: a map for this episode, as `read_map` takes it, instead of the config's

        The world stays as it was where an argument is refused: ValueError for positions that
        overlap, lie outside or on an obstacle, or are too few or many, for a map of another size
        or without room; TypeError for values that are not integers.
        """
        if seed is None:
            if episode != 0:
                raise ValueError(f"episode: expected a seed with it, got episode {episode} alone")
            key = self._seed, (self._episode + 1) % (SEED_MAX + 1)
        else:
            key = (
                check_integer("seed", seed, 0, SEED_MAX),
                check_integer("episode", episode, 0, SEED_MAX),
            )
        own_map = None if obstacles is None else read_map(obstacles)
        self.config.check_map(own_map)
        self._core.reset(
            *key,
            pursuers=_positions("pursuers", pursuers, self.config.n_pursuers),
            evaders=_positions("evaders", evaders, self.config.n_evaders),
            map=None if own_map is None else own_map.astype(np.uint8),
        )
        self._seed, self._episode = key
        self._explained = False

    def step(self, actions: ArrayLike, *, explain: bool = False) -> NDArray[np.float32]:
        """Play one round and return the rewards, ``(A,)`` float32.

        actions: ``(A,)`` ints, see `Action`; those of gone agents are not looked at. Where the
            rules take turns, all are committed before the first turn.
        explain: keep the list of `conflicts`

        Raises RuntimeError in an ended episode, ValueError for an illegal action of a living agent
        or another shape, TypeError for actions that are not integers.
        """
        if self.terminated or self.truncated:
            raise RuntimeError("the episode has ended: call reset() before the next step")
        self._core.step(_integers("actions", actions), explain)
        self._explained = explain
        return self.rewards

    @property
    def conflicts(self) -> list[Conflict]:
        """The conflicts of the last step, which must have been played with ``explain=True``.

        Raises RuntimeError otherwise.
        """
        if not self._explained:
            raise RuntimeError("no list of conflicts was kept: play the step with explain=True")
        return [conflict_of(record, self.config) for record in self._core.conflicts()]

    def _read(self, name: str) -> NDArray[Any]:
        shape, dtype = self._specs[name]
        array = np.empty(shape, dtype)
        self._core.write({name: array})
        return array

    @property
    def positions(self) -> NDArray[np.int32]:
        """``(A, 2)`` int32 row and column of each agent, (-1, -1) when gone."""
        return self._read("positions")

    @property
    def alive(self) -> NDArray[np.bool_]:
        """``(A,)`` bool."""
        return self._read("alive")

    @property
    def captured(self) -> NDArray[np.bool_]:
        """``(E,)`` bool: captured at this moment, or when it went."""
        return self._read("captured")

    @property
    def ever_captured(self) -> NDArray[np.bool_]:
        """``(E,)`` bool: captured at some time of this episode."""
        return self._read("ever_captured")

    @property
    def captors(self) -> NDArray[np.int32]:
        """``(E,)`` int32: how many pursuers have part in a capture of the last step."""
        return self._read("captors")

    @property
    def involved(self) -> NDArray[np.bool_]:
        """``(A, 3)`` bool: in a collision with an obstacle, a teammate, an adversary."""
        return self._read("involved")

    @property
    def fault(self) -> NDArray[np.bool_]:
        """``(A, 3)`` bool: at fault in a collision of each kind."""
        return self._read("fault")

    @property
    def rewards(self) -> NDArray[np.float32]:
        """``(A,)`` float32 rewards of the last step."""
        return self._read("rewards")

    @property
    def steps(self) -> int:
        """Rounds played in this episode."""
        return int(self._read("steps"))

    @property
    def terminated(self) -> bool:
        """Whether every evader is gone or captured, or a team has nobody left."""
        return bool(self._read("terminated"))

    @property
    def truncated(self) -> bool:
        """Whether the episode ended at ``max_steps``."""
        return bool(self._read("truncated"))

    @property
    def map(self) -> NDArray[np.bool_]:
        """``(rows, cols)`` bool obstacles of this episode."""
        return np.asarray(self.state()[2], np.bool_)

    def views(self) -> NDArray[np.uint8]:
        """``(A, 3, fov, fov)`` uint8, 0 or 1: what each agent sees.

        Channels evaders, pursuers, obstacles, centred on the agent. Outside the grid is obstacle;
        the agent itself is not drawn, a teammate on its cell is; a gone agent sees zeros.
        """
        return self._read("views")

    def state(self) -> NDArray[np.uint8]:
        """``(3, rows, cols)`` uint8, 0 or 1: the whole world, in the channels of `views`."""
        return self._read("state")

    def scene(self, title: str = "") -> Scene:
        """This moment to be drawn, as `matrixworld.render` does; a notebook shows it as a picture.

        Collisions of the last step are marked.
        """
        from matrixworld.render import Scene

        return Scene(
            positions=self.positions,
            alive=self.alive,
            captured=self.captured,
            map=self.map,
            n_pursuers=self.config.n_pursuers,
            involved=self.involved,
            fault=self.fault,
            title=title,
        )

    def __str__(self) -> str:
        """The world as text: '.' free, '#' obstacle, 'P' pursuer, 'E' evader, 'X' both.

        A digit stands for that many agents of one team on a cell (9 for more).
        """
        counts = np.zeros((2, self.config.rows, self.config.cols), int)
        team = np.arange(self.config.n_agents) >= self.config.n_pursuers
        alive = self.alive
        np.add.at(counts, (team[alive].astype(int), *self.positions[alive].T), 1)
        picture = np.where(self.map, "#", ".")
        picture[counts[0] > 0] = "P"
        picture[counts[1] > 0] = "E"
        several = counts.max(axis=0) > 1
        picture[several] = counts.max(axis=0).clip(0, 9)[several].astype(str)
        picture[(counts > 0).all(axis=0)] = "X"
        return "\n".join("".join(row) for row in picture)


class Batch:
    """W worlds of one configuration, stepped together into arrays of the caller.

    n_worlds: W
    threads: how many work on a step; by default one a core. No result depends on it.
    autoreset: start the seed's next episode in the very step in which one ends. Rewards,
        terminated, truncated, involved, fault and captures are then still of the ended episode;
        positions, alive, steps, views and state are of the new one. Without it an ended world
        stays as it is, with rewards of 0.
    buffers: arrays to write into, any of `array_specs` with W in front; by default all but
        ``views`` and ``state`` are made. The same arrays are written at every step.

    Raises ValueError and TypeError for a buffer of another name, shape, dtype or layout, and for
    other bad arguments.
    """

    def __init__(
        self,
        n_worlds: int,
        config: WorldConfig | Rules | str = "O",
        *,
        threads: int | None = None,
        autoreset: bool = False,
        buffers: dict[str, NDArray[Any]] | None = None,
        **changes: Any,
    ) -> None:
        self.config = WorldConfig.of(config, **changes)
        self.n_worlds = check_integer("n_worlds", n_worlds, 1)
        self.buffers = self._default_buffers() if buffers is None else buffers
        if not isinstance(self.buffers, dict):
            raise TypeError(f"buffers: expected a dict of arrays, got {self.buffers!r}")
        self._core = _core.Batch(
            self.config.setup,
            self.n_worlds,
            check_threads(threads),
            check_bool("autoreset", autoreset),
            dict(self.buffers),
        )
        self.reset(0)

    def _default_buffers(self) -> dict[str, NDArray[Any]]:
        return {
            name: np.zeros((self.n_worlds, *shape), dtype)
            for name, (shape, dtype) in array_specs(self.config).items()
            if name not in ("views", "state")
        }

    def reset(self, seed: int | ArrayLike, *, episode: int = 0) -> dict[str, NDArray[Any]]:
        """Start an episode in every world and return the buffers.

        seed: an int s, which gives world w the seed s + w, or ``(W,)`` ints, one for each.
            World w then plays as `World` does after ``reset(seed of w, episode=episode)``.
        """
        if isinstance(seed, int | np.integer):
            first = check_integer("seed", seed, 0, SEED_MAX)
            seeds = np.array([(first + w) % 2**64 for w in range(self.n_worlds)], np.uint64)
        else:
            seeds = np.ascontiguousarray(check_naturals("seeds", seed, np.uint64))
        self._core.reset(seeds, check_integer("episode", episode, 0, SEED_MAX))
        return self.buffers

    def step(self, actions: ArrayLike) -> dict[str, NDArray[Any]]:
        """Play one round in every world and return the buffers.

        actions: ``(W, A)`` integers; those of gone agents and ended worlds are not looked at

        Raises ValueError for an illegal action, naming world and agent, before anything is
        changed, or another shape; TypeError for actions that are not integers.
        """
        self._core.step(_integers("actions", actions))
        return self.buffers
