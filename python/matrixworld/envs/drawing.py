"""The episode of an environment, recorded and drawn."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.episodes.display import Display
from matrixworld.episodes.episode import Episode
from matrixworld.episodes.record import Recorder
from matrixworld.episodes.render import ansi, rgb
from matrixworld.world.world import World


class Drawing:
    """The episode of a world so far, drawn in a render mode.

    Parameters
    ----------
    world : World
        The world to record.
    mode : str or None
        A render mode; None only records.
    viewers : sequence of int
        The agents whose fields of view pictures outline.
    """

    def __init__(self, world: World, mode: str | None, viewers: Sequence[int]) -> None:
        self._recorder = Recorder(world)
        self._mode = mode
        self._look: dict[str, Any] = {"fov": world.config.fov, "viewers": viewers}
        self._display: Display | None = None

    def begin(self) -> None:
        """Start to record an episode; call it after a reset of the world."""
        self._recorder.begin()
        self._show()

    def note(self, actions: NDArray[np.int64]) -> None:
        """Record a round; call it after the world has played it with these actions."""
        self._recorder.note(actions)
        self._show()

    def episode(self) -> Episode:
        """Return what was recorded since the reset."""
        return self._recorder.episode()

    def render(self) -> NDArray[np.uint8] | str | None:
        """Return a picture or a text; None for "human", which every step shows by itself."""
        if self._mode == "human":
            return None
        scene = self._recorder.scene()
        return ansi(scene) if self._mode == "ansi" else rgb(scene, **self._look)

    def _show(self) -> None:
        if self._mode != "human":
            return
        if self._display is None:
            self._display = Display()
        self._display.show(self._recorder.scene(), **self._look)

    def close(self) -> None:
        """Close the display."""
        if self._display is not None:
            self._display.close()
            self._display = None

    def __getstate__(self) -> dict[str, Any]:
        # A window cannot be copied. The copy opens its own when it has something to show.
        return self.__dict__ | {"_display": None}
