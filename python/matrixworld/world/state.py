"""What can be read from a world: its present state and the results of its last step."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.episodes.render.scene import Scene
from matrixworld.world.arrays import WORLD_FIELDS, Specs
from matrixworld.world.config import WorldConfig

if TYPE_CHECKING:
    from matrixworld import _core


class WorldState:
    """The arrays of a world, as attributes. `World` is the class to use.

    Every array is a fresh copy. A = n_pursuers + n_evaders is the number of agents, pursuers first,
    and E = n_evaders. `matrixworld.array_specs` lists shapes and dtypes.
    """

    config: WorldConfig
    _specs: Specs
    _core: _core.World

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

    if not TYPE_CHECKING:  # or a misspelled attribute would pass the type checker

        def __getattr__(self, name: str) -> NDArray[Any]:
            """Return an array of `array_specs` that has no property of its own."""
            if name in WORLD_FIELDS:
                return self._read(name)
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

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
        """Whether each agent was in a collision of each kind, bool of shape (A, 3)."""
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
        return np.asarray(self.state()[2], np.bool_)  # after evaders and pursuers

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
        """Return this moment for `matrixworld.episodes.render`; a notebook shows it as a picture.

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
        # Unlike an indexed +=, this counts every agent of a shared cell.
        np.add.at(counts, (team[alive].astype(int), *self.positions[alive].T), 1)
        picture = np.where(self.map, "#", ".")
        picture[counts[0] > 0] = "P"
        picture[counts[1] > 0] = "E"
        several = counts.max(axis=0) > 1
        picture[several] = counts.max(axis=0).clip(0, 9)[several].astype(str)
        picture[(counts > 0).all(axis=0)] = "X"
        return "\n".join("".join(row) for row in picture)
