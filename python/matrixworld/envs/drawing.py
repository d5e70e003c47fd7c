"""What an environment shows of itself."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.episode import Episode
from matrixworld.recorder import Recorder
from matrixworld.render import ansi, rgb
from matrixworld.screen import Screen
from matrixworld.world import World


class Drawing:
    """The episode of a world so far, drawn in a render mode.

    viewers: the agents whose fields of view are outlined in pictures
    """

    def __init__(self, world: World, mode: str | None, viewers: Sequence[int]) -> None:
        self._recorder = Recorder(world)
        self._mode = mode
        self._look: dict[str, Any] = {"fov": world.config.fov, "viewers": viewers}
        self._screen: Screen | None = None

    def begin(self) -> None:
        """After a reset."""
        self._recorder.begin()
        self._show()

    def note(self, actions: NDArray[np.int64]) -> None:
        """After a round with these actions."""
        self._recorder.note(actions)
        self._show()

    def episode(self) -> Episode:
        """All that was noted since the reset."""
        return self._recorder.episode()

    def render(self) -> NDArray[np.uint8] | str | None:
        """A picture or a text; "human" has drawn itself."""
        if self._mode == "human":
            return None
        scene = self._recorder.scene()
        return ansi(scene) if self._mode == "ansi" else rgb(scene, **self._look)

    def _show(self) -> None:
        if self._mode != "human":
            return
        if self._screen is None:
            self._screen = Screen()
        self._screen.show(self._recorder.scene(), **self._look)

    def close(self) -> None:
        """Close the screen."""
        if self._screen is not None:
            self._screen.close()
            self._screen = None

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"_screen": None}
