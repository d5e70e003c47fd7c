"""One world, to play and to look at from Python. `matrixworld.Batch` plays many at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import Unpack

from matrixworld import _core
from matrixworld._util.checks import SEED_MAX, check_bool, check_integer, shown
from matrixworld.world import arrays
from matrixworld.world.config import MapLike, WorldConfig, WorldSettings, read_map
from matrixworld.world.conflicts import CONFLICT_COLUMNS, Conflict, conflict_of
from matrixworld.world.masks import check_team
from matrixworld.world.policy import TEAMS, EnginePolicy, check_agents
from matrixworld.world.render import Scene
from matrixworld.world.rules import Rules


class Turns:
    """The turns of a round, in one world or in many that are in the same turn."""

    _core: Any

    @property
    def n_turns(self) -> int:
        """Turns in a round: 1 where all agents move at once, 2 for teams, A for single agents."""
        return int(self._core.n_turns())

    @property
    def turn(self) -> int:
        """Number of the next turn in the round, from 0."""
        return int(self._core.turn())

    @property
    def actors(self) -> range:
        """Indices of the agents that act in the next turn, including agents that are gone."""
        return range(*self._core.actors())


def start_of(
    config: WorldConfig,
    pursuers: ArrayLike | None,
    evaders: ArrayLike | None,
    obstacles: MapLike | None,
    n_worlds: int | None = None,
) -> dict[str, Any]:
    """Return start cells and a map as the engine takes them."""
    own_map = None if obstacles is None else read_map(obstacles)
    config.check_map(own_map)
    return {
        "pursuers": arrays.positions_of("pursuers", pursuers, config.n_pursuers, n_worlds),
        "evaders": arrays.positions_of("evaders", evaders, config.n_evaders, n_worlds),
        "map": None if own_map is None else own_map.astype(np.uint8),
    }


class World(Turns, arrays.WorldArrays):
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
    keeps_conflicts : bool
        Whether every step keeps the list of `conflicts`, as with ``explain=True``. A `Recorder`
        sets it.
    positions, alive, rewards, terminated, ...
        All that `matrixworld.array_specs` lists: the present moment, and results of the last step.
        What has the shape () is a number of Python; none can be assigned to. `views`, `inputs` and
        `state` are methods.

    Notes
    -----
    A copy (`copy.deepcopy`, `pickle`) is at the same moment of the same episode, and goes on
    independently. Where several threads of Python use one world, their calls follow each other.

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

    config: WorldConfig
    keeps_conflicts: bool

    def __init__(
        self, config: WorldConfig | Rules | str = "O", **changes: Unpack[WorldSettings]
    ) -> None:
        self._begin(WorldConfig.of(config, **changes))
        self.reset(0)

    def __repr__(self) -> str:
        config = self.config
        return (
            f"<World: {config.rows} x {config.cols} cells, {config.n_pursuers} pursuers, "
            f"{config.n_evaders} evaders, seed {self.seed}, episode {self.episode}, "
            f"step {self.steps}>"
        )

    def _begin(self, config: WorldConfig, keeps_conflicts: bool = False) -> None:
        self.config, self.keeps_conflicts = config, keeps_conflicts
        self._specs = arrays.array_specs(config)
        self._core = _core.World(config.setup)
        self._explained = False

    def reset(
        self,
        seed: int | None = None,
        *,
        episode: int = 0,
        pursuers: ArrayLike | None = None,
        evaders: ArrayLike | None = None,
        obstacles: MapLike | None = None,
    ) -> None:
        """Start an episode. The same seed and number give the same start, on every machine.

        Parameters
        ----------
        seed : int, optional
            From 0 to 2**64 - 1. By default the next episode of the present seed starts.
        episode : int, optional
            Number of the seed's episode. The default is 0.
        pursuers, evaders : array_like of int, shape (n, 2), optional
            Start cells of a whole team. By default they are drawn.
        obstacles : map, optional
            A map for this episode only, as `read_map` takes it. The default is that of the config.

        Raises
        ------
        ValueError, TypeError
            If start cells overlap, lie outside the grid or on an obstacle; if a map has another
            size or no room for the agents; and for wrong numbers. The world stays as it was.
        """
        if seed is None:
            # Numbers of episodes wrap around, so that a world never runs out of them.
            if episode != 0:
                raise ValueError(f"episode: expected a seed with it, got episode {episode} alone")
            key = self.seed, (self.episode + 1) % (SEED_MAX + 1)
        else:
            key = (
                check_integer("seed", seed, 0, SEED_MAX),
                check_integer("episode", episode, 0, SEED_MAX),
            )
        self._core.reset(*key, **start_of(self.config, pursuers, evaders, obstacles))
        self._explained = False

    def step(self, actions: ArrayLike, *, explain: bool = False) -> NDArray[np.float32]:
        """Play one round.

        Parameters
        ----------
        actions : array_like of int, shape (A,)
            Numbers of `Action`; those of agents that are gone are ignored. Where the rules take
            turns, all are chosen before the first turn.
        explain : bool, optional
            Whether the list of `conflicts` is kept. The default is False.

        Returns
        -------
        ndarray of float32, shape (A,)
            The rewards.

        Raises
        ------
        RuntimeError
            If the episode has ended, or a round is being played by turns.
        """
        self._require_open()
        if self.turn:
            raise RuntimeError(
                f"turn {self.turn} of {self.n_turns} is next: finish the round by play_turn()"
            )
        keeps_list = check_bool("explain", explain) or self.keeps_conflicts
        self._core.step(arrays.integers("actions", actions), keeps_list)
        self._explained = keeps_list
        return self.rewards

    def play_turn(self, actions: ArrayLike, *, explain: bool = False) -> NDArray[np.float32]:
        """Play the next turn of a round and return the rewards of the round so far.

        Only the actions of the living `actors` are read; otherwise the arguments are those of
        `step`, with `explain` in every turn. Captors, involvement, fault and rewards accumulate
        over a round, and `steps` grows after its last turn. If the world terminates before, the
        remaining turns have to be played as well, but nothing happens in them.
        """
        if not self.turn:
            self._require_open()
        # A list that misses the first turns of a round would be incomplete, so it is not kept.
        wanted = check_bool("explain", explain) or self.keeps_conflicts
        keeps_list = wanted and (self._explained or not self.turn)
        self._core.play_turn(arrays.integers("actions", actions), keeps_list)
        self._explained = keeps_list
        return self.rewards

    def decide(self, policy: EnginePolicy, agents: range, actions: NDArray[np.int64]) -> None:
        """Write the actions that a policy chooses at this moment for agents of one team.

        The policy uses the random numbers that it has in a rollout for the same seed, episode, step
        and agent. The world stays as it is, and so do entries of `actions`, int64 (A,), of gone
        agents and of agents that are not in `agents`; in an ended episode all do.
        """
        arrays.check_written("actions", actions)
        first, last = check_agents(agents)
        team = TEAMS[first >= self.config.n_pursuers]
        self._core.decide(check_team("policy", policy, self.config, team), first, last, actions)

    def _require_open(self) -> None:
        if self.terminated or self.truncated:
            raise RuntimeError("the episode has ended: call reset() before the next step")

    @property
    def conflicts(self) -> list[Conflict]:
        """The conflicts of the last step; RuntimeError unless it had ``explain=True``."""
        table = self.conflict_table().tolist()
        return [conflict_of(numbers, self.config.n_pursuers) for numbers in table]

    def conflict_table(self) -> NDArray[np.int32]:
        """Return the conflicts of the last step, int32 of shape (n, 10); see `CONFLICT_COLUMNS`.

        RuntimeError unless the step had ``explain=True``.
        """
        if not self._explained:
            raise RuntimeError("no list of conflicts was kept: play the step with explain=True")
        rows = [(*record[:5], *record[5], *record[6:]) for record in self._core.conflicts()]
        return np.array(rows, np.int32).reshape(-1, len(CONFLICT_COLUMNS))

    def read(self, *names: str) -> dict[str, NDArray[Any]]:
        """Return several arrays of `array_specs` with one call of the engine, each a fresh copy."""
        unknown = set(names) - set(self._specs)
        if unknown:
            raise ValueError(f"read: expected some of {list(self._specs)}, got {sorted(unknown)}")
        found = {name: np.empty(*self._specs[name]) for name in names}
        self._core.write(found)
        return found

    if not TYPE_CHECKING:  # or a misspelled attribute would pass the type checker

        def __getattr__(self, name: str) -> Any:
            """Return an array of `array_specs`, or its number if it has no axes."""
            if name not in arrays.WORLD_FIELDS:
                raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
            return arrays.python_value(self.read(name)[name])

        def __setattr__(self, name: str, value: Any) -> None:
            if name in arrays.WORLD_FIELDS:  # it would hide what the engine tells
                raise AttributeError(f"{name}: expected no assignment: the world computes it")
            super().__setattr__(name, value)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *arrays.WORLD_FIELDS]

    @property
    def map(self) -> NDArray[np.bool_]:
        """Obstacles of this episode, bool of shape (rows, cols)."""
        return np.asarray(self.state()[arrays.CHANNEL["obstacle"]], np.bool_)

    def views(self) -> NDArray[np.uint8]:
        """Return what each agent sees, uint8 of shape (A, 3, fov, fov).

        0 or 1, in the channels evaders, pursuers and obstacles (also outside the grid), centred on
        the agent, which is not drawn; a teammate on its cell is. An agent that is gone sees zeros.
        """
        return self.read("views")["views"]

    def inputs(self) -> NDArray[np.float32]:
        """Return the named inputs of all moves of each agent, float32 (A, moves, inputs).

        The last axis is in the order of `INPUTS`. Those of an agent that is gone are zeros.
        """
        return self.read("inputs")["inputs"]

    def state(self) -> NDArray[np.uint8]:
        """Return the whole world, uint8 of shape (3, rows, cols), in the channels of `views`."""
        return self.read("state")["state"]

    def scene(self, title: str = "") -> Scene:
        """Return this moment, and a line of text above it, for `matrixworld.render`."""
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

    def __reduce__(self) -> tuple[Any, ...]:
        """Keep all that the future depends on, but not the list of conflicts."""
        return type(self).at, (self.config, self._core.snapshot(), self.keeps_conflicts)

    @classmethod
    def at(
        cls, config: WorldConfig, moment: dict[str, Any], keeps_conflicts: bool = False
    ) -> World:
        """Return a world that continues from a snapshot of the engine."""
        world = cls.__new__(cls)
        world._begin(config, keeps_conflicts)
        try:
            world._core.restore(moment)
        except (OverflowError, RuntimeError, TypeError) as error:  # other values than its own
            got = shown(moment)
            raise TypeError(f"moment: expected that of a copied world, got {got}") from error
        return world
