"""One world, to play and to look at from Python. `matrixworld.Batch` plays many at once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld import _core
from matrixworld.arrays import array_specs, integers
from matrixworld.checks import SEED_MAX, check_integer
from matrixworld.config import WorldConfig
from matrixworld.conflicts import Conflict, conflict_of
from matrixworld.maps import MapLike, read_map
from matrixworld.render import Scene
from matrixworld.rules import Rules


def _positions(name: str, given: ArrayLike | None, n: int) -> NDArray[np.int32] | None:
    if given is None:
        return None
    array = integers(name, given)
    if array.shape != (n, 2):
        raise ValueError(f"{name}: expected shape {(n, 2)}, got {array.shape}")
    # Clipped cells are still outside the grid, so the engine refuses them with its own message.
    return np.ascontiguousarray(array.clip(-(2**31), 2**31 - 1), dtype=np.int32)


class World:
    """One world of pursuers and evaders on a grid.

    A new world is in its first episode of seed 0. `step` plays one round; `reset` starts another
    episode. The results of the last step are attributes, and every array is a fresh copy.

    Arrays over agents hold the pursuers first and then the evaders: A = n_pursuers + n_evaders
    agents, of which E = n_evaders are evaders. An agent keeps its index when others disappear.
    Cells are (row, column) from (0, 0) at the top left.

    Parameters
    ----------
    config : WorldConfig, Rules or str, optional
        The settings, the rules, or the name of a variant. The default is ``"O"``.
    **changes
        Fields of `WorldConfig` to change.

    Attributes
    ----------
    config : WorldConfig
        The settings.

    Raises
    ------
    ValueError, TypeError
        As `WorldConfig` does.

    See Also
    --------
    matrixworld.parallel_env : The same world as a PettingZoo environment.
    matrixworld.Batch : Many worlds at once.

    Notes
    -----
    A copy (`copy.deepcopy`, `pickle`) is at the same moment of the same episode, and goes on
    independently.

    Examples
    --------
    Two pursuers and an evader; the first pursuer moves east, the evader north.

    >>> from matrixworld import Action, World
    >>> world = World("O", rows=3, cols=4, n_pursuers=2, n_evaders=1)
    >>> world.reset(pursuers=[[0, 0], [2, 3]], evaders=[[1, 2]])
    >>> rewards = world.step([Action.EAST, Action.STAY, Action.NORTH])
    >>> print(world)
    .PE.
    ....
    ...P
    >>> world.positions.tolist()
    [[0, 1], [2, 3], [0, 2]]
    >>> [round(float(reward), 2) for reward in rewards]
    [0.05, -0.05, -0.15]
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

        The same seed and episode number give the same start, on every machine.

        Parameters
        ----------
        seed : int, optional
            Seed of the episode, 0 to 2**64 - 1. Without it the next episode of the present seed
            starts.
        episode : int, optional
            Number of the episode of `seed`, 0 to 2**64 - 1. Needs a seed. The default is 0.
        pursuers, evaders : array_like of int, shape (n, 2), optional
            Start cells of a whole team. By default they are drawn.
        obstacles : map, optional
            A map for this episode only, as `read_map` takes it. By default that of the config.

        Raises
        ------
        ValueError
            If start cells overlap, lie outside the grid or on an obstacle, or have a wrong number;
            if a map has another size or no room for the agents; if a number is out of range.
        TypeError
            If a number is not an integer.

        Notes
        -----
        If an argument is refused, the world stays as it was.
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
        """Play one round.

        Parameters
        ----------
        actions : array_like of int, shape (A,)
            The actions, see `Action`. Those of agents that are gone are ignored. Where the rules
            take turns, all actions are chosen before the first turn.
        explain : bool, optional
            Whether to keep the list of `conflicts`. The default is False.

        Returns
        -------
        ndarray of float32, shape (A,)
            The rewards.

        Raises
        ------
        RuntimeError
            If the episode has ended, or a round is being played turn by turn.
        ValueError
            If the shape is another, or the action of a living agent is out of range.
        TypeError
            If the actions are not integers.
        """
        self._require_open()
        if self.turn:
            raise RuntimeError(
                f"turn {self.turn} of {self.n_turns} is next: finish the round by play_turn()"
            )
        self._core.step(integers("actions", actions), explain)
        self._explained = explain
        return self.rewards

    def play_turn(self, actions: ArrayLike, *, explain: bool = False) -> NDArray[np.float32]:
        """Play the next turn of a round.

        The round is over after its last turn; then `steps` grows. Captors, involvement, fault and
        rewards accumulate over a round. If the world terminates in the middle of a round, the
        remaining turns have to be played as well, but nothing happens in them.

        Parameters
        ----------
        actions : array_like of int, shape (A,)
            Only the actions of the living `actors` are read.
        explain : bool, optional
            Whether to keep the list of `conflicts`; pass it in every turn of the round.

        Returns
        -------
        ndarray of float32, shape (A,)
            The rewards of the round so far.

        Raises
        ------
        RuntimeError, ValueError, TypeError
            As `step` does.
        """
        if not self.turn:
            self._require_open()
        # A list that misses the first turns of a round would be incomplete, so it is not kept.
        keeps_list = explain and (self._explained or not self.turn)
        self._core.play_turn(integers("actions", actions), keeps_list)
        self._explained = keeps_list
        return self.rewards

    def _require_open(self) -> None:
        if self.terminated or self.truncated:
            raise RuntimeError("the episode has ended: call reset() before the next step")

    @property
    def n_turns(self) -> int:
        """Turns in a round: 1 where all agents move at once, 2 for teams, A for single agents."""
        return self._core.n_turns()

    @property
    def turn(self) -> int:
        """Number of the next turn in the round, from 0."""
        return self._core.turn()

    @property
    def actors(self) -> range:
        """Indices of the agents that act in the next turn, including agents that are gone."""
        return range(*self._core.actors())

    @property
    def conflicts(self) -> list[Conflict]:
        """The conflicts of the last step; RuntimeError unless it had ``explain=True``."""
        if not self._explained:
            raise RuntimeError("no list of conflicts was kept: play the step with explain=True")
        return [conflict_of(record, self.config) for record in self._core.conflicts()]

    def read(self, *names: str) -> dict[str, NDArray[Any]]:
        """Return several arrays with one call of the engine.

        Parameters
        ----------
        *names : str
            Names from `array_specs`.

        Returns
        -------
        dict of str to ndarray
            A fresh array for each name, with the shape and dtype of `array_specs`.

        Raises
        ------
        ValueError
            If a name is unknown.
        """
        unknown = set(names) - set(self._specs)
        if unknown:
            raise ValueError(f"read: expected some of {list(self._specs)}, got {sorted(unknown)}")
        arrays = {name: np.empty(*self._specs[name]) for name in names}
        self._core.write(arrays)
        return arrays

    def _read(self, name: str) -> NDArray[Any]:
        return self.read(name)[name]

    def __getstate__(self) -> dict[str, Any]:
        """Return all that the future of the world depends on, without the list of conflicts."""
        return {"config": self.config, "moment": self._core.snapshot()}

    @classmethod
    def at(cls, config: WorldConfig, moment: dict[str, Any]) -> World:
        """Return a world that continues from a snapshot of the engine."""
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
        """Seed of this episode."""
        return int(self._read("seed"))

    @property
    def episode(self) -> int:
        """Number of this episode among those of its seed."""
        return int(self._read("episode"))

    @property
    def positions(self) -> NDArray[np.int32]:
        """Cells of the agents, int32 of shape (A, 2); (-1, -1) for an agent that is gone."""
        return self._read("positions")

    @property
    def last_positions(self) -> NDArray[np.int32]:
        """Cells of the agents, int32 of shape (A, 2); where a gone agent disappeared."""
        return self._read("last_positions")

    @property
    def alive(self) -> NDArray[np.bool_]:
        """Whether each agent is alive, bool of shape (A,)."""
        return self._read("alive")

    @property
    def captured(self) -> NDArray[np.bool_]:
        """Whether each evader is captured now, or was when it disappeared; bool of shape (E,)."""
        return self._read("captured")

    @property
    def ever_captured(self) -> NDArray[np.bool_]:
        """Whether each evader was captured at some time of this episode, bool of shape (E,)."""
        return self._read("ever_captured")

    @property
    def captors(self) -> NDArray[np.int32]:
        """Number of captors of each evader in the last step, int32 of shape (E,)."""
        return self._read("captors")

    @property
    def involved(self) -> NDArray[np.bool_]:
        """Whether each agent was in a collision of each kind of `KINDS`, bool of shape (A, 3)."""
        return self._read("involved")

    @property
    def fault(self) -> NDArray[np.bool_]:
        """Whether each agent was at fault in a collision of each kind, bool of shape (A, 3)."""
        return self._read("fault")

    @property
    def cost(self) -> NDArray[np.float32]:
        """Number of kinds in which each agent was at fault, float32 of shape (A,)."""
        return self._read("cost")

    @property
    def terminations(self) -> NDArray[np.bool_]:
        """Whether each agent is gone or the world has terminated, bool of shape (A,)."""
        return self._read("terminations")

    @property
    def truncations(self) -> NDArray[np.bool_]:
        """Whether the episode was cut off for each agent, bool of shape (A,).

        True where the world is truncated, and neither the world nor the agent has terminated.
        """
        return self._read("truncations")

    @property
    def rewards(self) -> NDArray[np.float32]:
        """Rewards of the last step, float32 of shape (A,)."""
        return self._read("rewards")

    @property
    def steps(self) -> int:
        """Rounds played in this episode."""
        return int(self._read("steps"))

    @property
    def terminated(self) -> bool:
        """Whether every evader is gone or captured, or a team has no agents left."""
        return bool(self._read("terminated"))

    @property
    def truncated(self) -> bool:
        """Whether the episode ended at ``max_steps``."""
        return bool(self._read("truncated"))

    @property
    def capture_rate(self) -> float:
        """Share of the evaders that count as captured.

        Under occupation these are the evaders captured at some time, under surround those
        captured now.
        """
        return float(self._read("capture_rate"))

    @property
    def ever_capture_rate(self) -> float:
        """Share of the evaders that were captured at some time."""
        return float(self._read("ever_capture_rate"))

    @property
    def survival_rate(self) -> NDArray[np.float32]:
        """Shares of the pursuers and of the evaders that are alive, float32 of shape (2,)."""
        return self._read("survival_rate")

    @property
    def map(self) -> NDArray[np.bool_]:
        """Obstacles of this episode, bool of shape (rows, cols)."""
        return np.asarray(self.state()[2], np.bool_)

    def views(self) -> NDArray[np.uint8]:
        """Return what each agent sees.

        Returns
        -------
        ndarray of uint8, shape (A, 3, fov, fov)
            0 or 1, in the channels evaders, pursuers and obstacles, centred on the agent. Cells
            outside the grid are obstacles. The agent itself is not drawn; a teammate on its cell
            is. An agent that is gone sees zeros.
        """
        return self._read("views")

    def state(self) -> NDArray[np.uint8]:
        """Return the whole world, uint8 of shape (3, rows, cols), in the channels of `views`."""
        return self._read("state")

    def scene(self, title: str = "") -> Scene:
        """Return this moment for `matrixworld.render`; a notebook shows it as a picture.

        Collisions of the last step are marked.

        Parameters
        ----------
        title : str, optional
            A line of text above the drawing.

        Returns
        -------
        Scene
            The arrays to draw.
        """
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
        """Return the world as text: '.' free, '#' obstacle, 'P' pursuer, 'E' evader, 'X' both.

        A digit is the number of agents of one team on a cell; 9 stands for more as well.
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
