"""Keeping an episode of a world while it is played."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.arrays import integers
from matrixworld.config import WorldConfig
from matrixworld.episode import MOMENT_ARRAYS, STEP_ARRAYS, Episode
from matrixworld.maps import MapLike
from matrixworld.render import MARK_STEPS, Scene
from matrixworld.replay import capture_title, scene
from matrixworld.rules import Rules
from matrixworld.world import World


class Recorder:
    """Keeps every step of a world's episode: `begin` after its reset, `note` after each round."""

    def __init__(self, world: World) -> None:
        self.world = world
        self._config = world.config.to_json()
        self.begin()

    def begin(self) -> None:
        """Forget what was kept; the world's present moment is the first."""
        self._map = self.world.map
        self._start = self.world.steps
        self._kept: dict[str, list[NDArray[Any]]] = {
            name: [] for name in (*MOMENT_ARRAYS, "actions", *STEP_ARRAYS)
        }
        self._keep(*MOMENT_ARRAYS)

    def note(self, actions: ArrayLike) -> None:
        """After a round with these actions, ``(A,)`` ints.

        Raises ValueError for another shape, and RuntimeError when it was not called after every
        round, or `begin` not after a reset.
        """
        row = integers("actions", actions)
        if row.shape != (self.world.config.n_agents,):
            raise ValueError(
                f"actions: expected shape {(self.world.config.n_agents,)}, got {row.shape}"
            )
        noted, played = len(self._kept["actions"]) + 1, self.world.steps - self._start
        if noted != played:
            raise RuntimeError(
                f"expected begin() after a reset and note() after each round: this is note "
                f"{noted}, and the world has played {played}"
            )
        self._kept["actions"].append(row.astype(np.int8))
        self._keep(*MOMENT_ARRAYS, *STEP_ARRAYS)

    def _keep(self, *names: str) -> None:
        for name, array in self.world.read(*names).items():
            self._kept[name].append(array)

    def episode(self) -> Episode:
        """All that was kept, as `matrixworld.record` would have it."""
        return self._last(len(self._kept["actions"]))

    def scene(self, *, trail: int = 6) -> Scene:
        """The present moment, with trails of so many steps and marks of what happened lately."""
        steps = len(self._kept["actions"])
        window = self._last(min(steps, max(trail, MARK_STEPS)))
        title = capture_title(window, window.length, f"step {self.world.steps}")
        return scene(window, trail=trail, title=title)

    def _last(self, steps: int) -> Episode:
        """The last so many steps as an episode."""
        n_agents = self.world.config.n_agents
        empty: dict[str, NDArray[Any]] = {
            "actions": np.empty((0, n_agents), np.int8),
            "rewards": np.empty((0, n_agents), np.float32),
            "involved": np.empty((0, n_agents, 3), np.bool_),
            "fault": np.empty((0, n_agents, 3), np.bool_),
        }
        arrays: dict[str, Any] = {
            name: np.stack(kept[len(kept) - steps - (name in MOMENT_ARRAYS) :])
            if steps or name in MOMENT_ARRAYS
            else empty[name]
            for name, kept in self._kept.items()
        }
        return Episode(
            **arrays,
            map=self._map,
            n_pursuers=self.world.config.n_pursuers,
            config=self._config,
        )


def record_actions(
    config: WorldConfig | Rules | str,
    actions: ArrayLike,
    *,
    seed: int = 0,
    episode: int = 0,
    pursuers: ArrayLike | None = None,
    evaders: ArrayLike | None = None,
    obstacles: MapLike | None = None,
) -> Episode:
    """Play given actions and keep every moment.

    actions: ``(T, A)`` ints, one row a round. Playing stops where the episode ends.
    seed, episode, pursuers, evaders, obstacles: where it begins, as of `World.reset`

    Raises as `World.reset` and `World.step` do.
    """
    world = World(config)
    world.reset(seed, episode=episode, pursuers=pursuers, evaders=evaders, obstacles=obstacles)
    recorder = Recorder(world)
    for row in np.asarray(actions):
        if world.terminated or world.truncated:
            break
        world.step(row)
        recorder.note(row)
    return recorder.episode()
