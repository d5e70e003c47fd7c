"""One world."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld import _core
from matrixworld.arrays import WORLD_FIELDS, array_specs, integers
from matrixworld.checks import SEED_MAX, check_integer
from matrixworld.config import WorldConfig
from matrixworld.conflicts import Conflict, conflict_of
from matrixworld.maps import MapLike, read_map
from matrixworld.rules import Rules

if TYPE_CHECKING:
    from matrixworld.render import Scene


def _positions(name: str, given: ArrayLike | None, n: int) -> NDArray[np.int32] | None:
    if given is None:
        return None
    array = integers(name, given)
    if array.shape != (n, 2):
        raise ValueError(f"{name}: expected shape {(n, 2)}, got {array.shape}")
    return np.ascontiguousarray(array.clip(-(2**31), 2**31 - 1), dtype=np.int32)


class World:
    """One world of pursuers and evaders on a grid.

    The agents' axis of every array holds the pursuers and then the evaders, A = n_pursuers +
    n_evaders in all. Every attribute that is an array is a fresh copy.

    config: a `WorldConfig`, `Rules`, or the name of a variant; keywords change its fields:
        ``World("O", rows=10, cols=10, n_pursuers=2, n_evaders=3)``.

    A new world is in its first episode of seed 0. A copy (`copy.deepcopy`, `pickle`) is in the same
    episode and moment and goes on independently.
    """

    def __init__(self, config: WorldConfig | Rules | str = "O", **changes: Any) -> None:
        self.config = WorldConfig.of(config, **changes)
        self._specs = array_specs(self.config)
        self._core = _core.World(self.config.setup)
        self._explained = False
        self.reset(0)

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
            key = self.seed, (self.episode + 1) % (SEED_MAX + 1)
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
        self._explained = False

    def step(self, actions: ArrayLike, *, explain: bool = False) -> NDArray[np.float32]:
        """Play one round and return the rewards, ``(A,)`` float32.

        actions: ``(A,)`` ints, see `Action`; those of gone agents are not looked at. Where the
            rules take turns, all are committed before the first turn.
        explain: keep the list of `conflicts`

        Raises RuntimeError in an ended episode and between the turns of a round, ValueError for an
        illegal action of a living agent or another shape, TypeError for actions that are not
        integers.
        """
        self._require_open()
        if self.turn:
            raise RuntimeError(
                f"turn {self.turn} of {self.n_turns} is next: play the round to its end by turns"
            )
        self._core.step(integers("actions", actions), explain)
        self._explained = explain
        return self.rewards

    def play_turn(self, actions: ArrayLike, *, explain: bool = False) -> NDArray[np.float32]:
        """Play the next turn of a round and return the rewards of the round so far, ``(A,)``.

        actions: ``(A,)`` ints, of which only those of the living `actors` are looked at
        explain: keep the list of `conflicts` of the round; say so in all of its turns

        After its last turn the round is over and `steps` grows. Captors, involvement, fault and
        rewards add up over a round. When the world terminates in the middle of a round its other
        turns are still to be played; nothing happens in them. Raises as `step` does.
        """
        if not self.turn:
            self._require_open()
        keeps_list = explain and (self._explained or not self.turn)
        self._core.play_turn(integers("actions", actions), keeps_list)
        self._explained = keeps_list
        return self.rewards

    def _require_open(self) -> None:
        if self.terminated or self.truncated:
            raise RuntimeError("the episode has ended: call reset() before the next step")

    @property
    def n_turns(self) -> int:
        """Turns in a round: 1, or 2 (of swarms), or A (of agents)."""
        return self._core.n_turns()

    @property
    def turn(self) -> int:
        """The number of the turn that comes next in the round, from 0."""
        return self._core.turn()

    @property
    def actors(self) -> range:
        """Who acts in the next turn, the gone included."""
        return range(*self._core.actors())

    @property
    def conflicts(self) -> list[Conflict]:
        """The conflicts of the last step, which must have been played with ``explain=True``.

        Raises RuntimeError otherwise.
        """
        if not self._explained:
            raise RuntimeError("no list of conflicts was kept: play the step with explain=True")
        return [conflict_of(record, self.config) for record in self._core.conflicts()]

    def read(self, *names: str) -> dict[str, NDArray[Any]]:
        """Fresh arrays by name, as `array_specs` says; ValueError for a name that is not there."""
        unknown = set(names) - set(self._specs)
        if unknown:
            raise ValueError(f"read: expected some of {list(self._specs)}, got {sorted(unknown)}")
        arrays = {name: np.empty(*self._specs[name]) for name in names}
        self._core.write(arrays)
        return arrays

    def _read(self, name: str) -> NDArray[Any]:
        return self.read(name)[name]

    if not TYPE_CHECKING:  # or a misspelled attribute would pass the type checker

        def __getattr__(self, name: str) -> NDArray[Any]:
            """Return an array of `array_specs` that has no property of its own."""
            if name in WORLD_FIELDS:
                return self._read(name)
            raise AttributeError(f"'World' object has no attribute {name!r}")

    def __getstate__(self) -> dict[str, Any]:
        """Everything that its future depends on; the list of conflicts is left out."""
        return {"config": self.config, "moment": self._core.snapshot()}

    @classmethod
    def at(cls, config: WorldConfig, moment: dict[str, Any]) -> World:
        """A world of this config at a moment of the engine's."""
        world = cls.__new__(cls)
        world.__setstate__({"config": config, "moment": moment})
        return world

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.config = state["config"]
        self._specs = array_specs(self.config)
        self._core = _core.World(self.config.setup)
        self._core.restore(state["moment"])
        self._explained = False

    @property
    def seed(self) -> int:
        """The seed of this episode."""
        return int(self._read("seed"))

    @property
    def episode(self) -> int:
        """Which episode of its seed this is."""
        return int(self._read("episode"))

    @property
    def positions(self) -> NDArray[np.int32]:
        """``(A, 2)`` int32 row and column of each agent, (-1, -1) when gone."""
        return self._read("positions")

    @property
    def last_positions(self) -> NDArray[np.int32]:
        """``(A, 2)`` int32 row and column of each agent; of one that is gone, where it went."""
        return self._read("last_positions")

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
    def cost(self) -> NDArray[np.float32]:
        """``(A,)`` float32: the number of kinds in which it is at fault."""
        return self._read("cost")

    @property
    def terminations(self) -> NDArray[np.bool_]:
        """``(A,)`` bool: gone, or the world has terminated."""
        return self._read("terminations")

    @property
    def truncations(self) -> NDArray[np.bool_]:
        """``(A,)`` bool: the world is truncated, and neither it nor the agent has terminated."""
        return self._read("truncations")

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
    def capture_rate(self) -> float:
        """Share of the evaders that count as captured.

        Those captured at some time under occupation, at this moment under surround.
        """
        return float(self._read("capture_rate"))

    @property
    def ever_capture_rate(self) -> float:
        """Share of the evaders that were captured at some time."""
        return float(self._read("ever_capture_rate"))

    @property
    def survival_rate(self) -> NDArray[np.float32]:
        """``(2,)`` float32: shares of the pursuers and of the evaders that are alive."""
        return self._read("survival_rate")

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
            positions=self.last_positions,
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
