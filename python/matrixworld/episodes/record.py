"""Episodes recorded while they are played, and shown in a notebook or terminal."""

from __future__ import annotations

import sys
import time
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld import _core
from matrixworld._util.checks import INT_MAX, SEED_MAX, check_instance, check_integer, check_shape
from matrixworld._util.teams import PLURALS, TEAMS
from matrixworld.episodes.episode import MOMENT_ARRAYS, STEP_ARRAYS, Episode, capture_title, scene
from matrixworld.episodes.replay import Screen
from matrixworld.play.functions import Function
from matrixworld.play.matches import member_of, play_episodes
from matrixworld.play.player import Plays
from matrixworld.play.tables import in_engine
from matrixworld.world.arrays import array_specs, integers
from matrixworld.world.config import WorldConfig
from matrixworld.world.conflicts import CONFLICT_COLUMNS
from matrixworld.world.masks import check_team
from matrixworld.world.render import MARK_STEPS, Scene, ansi, png, rgb
from matrixworld.world.rules import Rules
from matrixworld.world.world import World

FPS = 10.0
"""The most scenes per second that a place shows."""


class Recorder:
    """Record of the episode of a `world` that the caller plays.

    Call `begin` after a reset and `note` after each round. The recording begins with the present
    moment. From now on the world keeps the conflicts of every step, which the recording contains.
    """

    def __init__(self, world: World) -> None:
        check_instance("world", world, World)
        self.world = world
        world.keeps_conflicts = True
        self.begin()

    def begin(self) -> None:
        """Start a new recording with the world's present moment; RuntimeError within a round."""
        if self.world.turn:
            raise RuntimeError(
                f"expected begin() between two rounds, got turn {self.world.turn} of a round"
            )
        self._map = self.world.map
        self._start = self.world.steps
        self._arrays: dict[str, list[NDArray[Any]]] = {
            name: [] for name in (*MOMENT_ARRAYS, "actions", *STEP_ARRAYS)
        }
        self._conflicts: list[NDArray[np.int32]] = []
        self._keep(*MOMENT_ARRAYS)

    def note(self, actions: ArrayLike) -> None:
        """Record the round that was just played, with its actions (A,)."""
        row = integers("actions", actions)
        check_shape("actions", row, self.world.config.n_agents)
        # The world counts its own rounds: a difference means that a call is missing.
        noted = len(self._arrays["actions"]) + 1
        played = self.world.steps - self._start
        if noted != played:
            raise RuntimeError(
                f"expected begin() after a reset and note() after each round: this is note "
                f"{noted}, and the world has played {played}"
            )
        self._arrays["actions"].append(row.astype(np.int8))
        self._conflicts.append(self.world.conflict_table())
        self._keep(*MOMENT_ARRAYS, *STEP_ARRAYS)

    def _keep(self, *names: str) -> None:
        for name, array in self.world.read(*names).items():
            self._arrays[name].append(array)

    def episode(self) -> Episode:
        """Return the recorded episode, as `matrixworld.record` returns one."""
        return self._last(len(self._arrays["actions"]))

    def scene(self, *, trail: int = 6) -> Scene:
        """Return a drawing of the present moment with trails of `trail` steps."""
        steps = len(self._arrays["actions"])
        trail = check_integer("trail", trail, 0)
        # A picture shows few steps; a copy of the whole recording for each would cost its length.
        window = self._last(min(steps, max(trail, MARK_STEPS)))
        title = capture_title(window, window.length, f"step {self.world.steps}")
        return scene(window, trail=trail, title=title)

    def _last(self, steps: int) -> Episode:
        """Return the last steps, with one moment more than steps, as an episode."""
        config = self.world.config
        specs = {**array_specs(config), "actions": ((config.n_agents,), np.int8)}
        arrays: dict[str, Any] = {}
        for name, rows in self._arrays.items():
            count = steps + (name in MOMENT_ARRAYS)
            shape, dtype = specs[name]
            # An array of no steps at all has a shape, too.
            arrays[name] = np.array(rows[len(rows) - count :], dtype).reshape(count, *shape)
        tables = self._conflicts[len(self._conflicts) - steps :]
        numbered = [np.insert(table, 0, step, axis=1) for step, table in enumerate(tables, 1)]
        none = np.empty((0, 1 + len(CONFLICT_COLUMNS)), np.int32)
        return Episode(
            **arrays,
            map=self._map.copy(),
            n_pursuers=config.n_pursuers,
            config=config.to_json(),
            conflict_table=np.concatenate([none, *numbered]),
        )


def record_actions(
    config: WorldConfig | Rules | str, actions: ArrayLike, *, seed: int = 0, episode: int = 0
) -> Episode:
    """Play given actions and return the episode with every moment of it.

    Parameters
    ----------
    config
        As for `World`.
    actions : array_like of int, shape (T, A)
        Actions of each step; those after the end of the episode are ignored.
    seed, episode : int, optional
        As for `World.reset`. The default is 0.

    Returns
    -------
    Episode
        All that happened.
    """
    world = World(config)
    world.reset(seed, episode=episode)
    recorder = Recorder(world)
    rows = integers("actions", actions)
    for row in rows:
        if world.terminated or world.truncated:
            break
        world.step(row)
        recorder.note(row)
    return recorder.episode()


def record(
    config: WorldConfig | Rules | str,
    pursuers: Any,
    evaders: Any,
    *,
    seed: int = 0,
    pursuer: int = 0,
    evader: int = 0,
    episode: int = 0,
) -> Episode:
    """Play one episode and return it with every moment.

    Parameters
    ----------
    config, pursuers, evaders
        As for `matrixworld.rollout`.
    seed : int, optional
        Seed of the match. All numbers are 0 by default.
    pursuer, evader : int, optional
        Indices into the populations.
    episode : int, optional
        Number of the seed's episode, that of this world of the match in `rollout`.

    Returns
    -------
    Episode
        All that happened.
    """
    config = WorldConfig.of(config)
    seed = check_integer("seed", seed, 0, SEED_MAX)
    episode = check_integer("episode", episode, 0, SEED_MAX)
    numbers = (
        check_integer("pursuer", pursuer, 0, INT_MAX),
        check_integer("evader", evader, 0, INT_MAX),
    )
    plays = [
        in_engine(given, team, config)
        for team, given in zip(TEAMS, (pursuers, evaders), strict=True)
    ]
    if any(isinstance(each, Function) for each in plays):
        return _record_asked(config, plays, numbers, seed, episode)
    # The engine chooses the actions; a world that plays them again gives everything else.
    first, second = (
        check_team(PLURALS[team], each, config, team)
        for team, each in zip(TEAMS, plays, strict=True)
    )
    chosen = _core.record(
        config.setup,
        first,
        second,
        pursuer=numbers[0],
        evader=numbers[1],
        seed=seed,
        episode=episode,
        of_moments=(),
        of_steps=(),
    )
    return record_actions(config, chosen["actions"], seed=seed, episode=episode)


def _record_asked(
    config: WorldConfig, plays: list[Plays], numbers: tuple[int, int], seed: int, episode: int
) -> Episode:
    """Record an episode in which functions are asked in every step."""
    members = [
        member_of(PLURALS[team], each, number)
        for team, each, number in zip(TEAMS, plays, numbers, strict=True)
    ]
    rounds: list[NDArray[np.int64]] = []

    def keep(actions: NDArray[np.int64], running: NDArray[np.bool_]) -> None:
        rounds.append(actions[0].copy())

    play_episodes(config, *members, seed=seed, episodes=1, first=episode, on_round=keep)
    return record_actions(config, np.array(rounds), seed=seed, episode=episode)


# Shown while it is played:


class Drawing(Recorder):
    """The episode of a world so far, drawn in a render mode; None only records."""

    def __init__(self, world: World, mode: str | None) -> None:
        super().__init__(world)
        self._mode = mode
        self._place: Notebook | Screen | None = None
        self._due = 0.0

    def render(self) -> NDArray[np.uint8] | str | None:
        """Return a picture or a text; None for "human", which `show` draws."""
        if self._mode == "human":
            return None
        return ansi(self.scene()) if self._mode == "ansi" else rgb(self.scene())

    def show(self) -> None:
        """Show the moment in the mode "human", when the one before has been there for its time."""
        if self._mode != "human":
            return
        if self._place is None:
            self._place = first_place()
        if self._place.in_place:
            time.sleep(max(0.0, self._due - time.monotonic()))
            self._due = time.monotonic() + 1 / FPS
        self._place.show(self.scene())

    def __getstate__(self) -> dict[str, Any]:
        # A place cannot be copied. The copy opens its own when it has something to show.
        return self.__dict__ | {"_place": None}


class Notebook:
    """An output of a notebook cell that is redrawn; each cell run later gets its own."""

    in_place = True

    def __init__(self, shell: Any, display: Any) -> None:
        self._shell = shell  # of IPython
        self._display = display  # `IPython.display.display`
        self._handle: Any = None
        self._run: Any = None  # execution count of the cell that shows it

    def show(self, scene: Scene) -> None:
        """Show a scene."""
        data = {"image/png": png(scene)}
        if self._run == self._shell.execution_count:
            self._handle.update(data, raw=True)
        else:
            self._run = self._shell.execution_count
            self._handle = self._display(data, raw=True, display_id=True)


def first_place() -> Notebook | Screen:
    """Return the notebook that runs this program, or its output: a terminal, a file or a pipe."""
    if "IPython" in sys.modules:  # a notebook has imported it; importing it here is slow
        from IPython import get_ipython
        from IPython.display import display

        shell = get_ipython()
        if hasattr(shell, "kernel"):
            return Notebook(shell, display)
    return Screen(sys.stdout)
