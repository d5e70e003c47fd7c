"""The episode of an environment: recorded, drawn, and shown in a notebook or terminal."""

from __future__ import annotations

import sys
import time
from typing import Any, TextIO

import numpy as np
from numpy.typing import NDArray

from matrixworld.episodes.record import Recorder
from matrixworld.episodes.replay import CLEAR, WRAP_OFF, WRAP_ON, draw, text_look
from matrixworld.world.render import Scene, ansi, png, rgb
from matrixworld.world.world import World

FPS = 10.0
"""The most scenes per second."""


class Drawing(Recorder):
    """The episode of a world so far, drawn in a render mode; None only records."""

    def __init__(self, world: World, mode: str | None) -> None:
        super().__init__(world)
        self._mode = mode
        self._place: Notebook | Text | None = None
        self._due = 0.0

    def render(self) -> NDArray[np.uint8] | str | None:
        """Return a picture or a text; None for "human", in which `show` is called at every step."""
        if self._mode == "human":
            return None
        return ansi(self.scene()) if self._mode == "ansi" else rgb(self.scene())

    def show(self) -> None:
        """Show the moment in the mode "human", when the one before has been there for its time."""
        if self._mode != "human":
            return
        if self._place is None:
            self._place = first_place()
        if self._place.watched:
            time.sleep(max(0.0, self._due - time.monotonic()))
            self._due = time.monotonic() + 1 / FPS
        self._place.show(self.scene())

    def __getstate__(self) -> dict[str, Any]:
        # A place cannot be copied. The copy opens its own when it has something to show.
        return self.__dict__ | {"_place": None}


class Notebook:
    """An output of a notebook cell that is redrawn; each cell run later gets its own."""

    watched = True  # a scene replaces the one before, which needs time to be seen

    def __init__(self, shell: Any, display: Any) -> None:
        self._shell = shell  # of IPython
        self._display = display  # `IPython.display.display`
        self._handle: Any = None
        self._run = -1  # execution count of the cell that shows it

    def show(self, scene: Scene) -> None:
        """Show a scene."""
        data = {"image/png": png(scene)}
        if self._handle is not None and self._run == self._shell.execution_count:
            self._handle.update(data, raw=True)
            return
        self._run = self._shell.execution_count
        self._handle = self._display(data, raw=True, display_id=True)


class Text:
    """Text: in a terminal redrawn in place, with the cursor below it; else one below the other."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self.watched = stream.isatty()
        self._start = WRAP_OFF + CLEAR

    def show(self, scene: Scene) -> None:
        """Show a scene."""
        if not self.watched:
            self._stream.write(ansi(scene, color="none") + "\n\n")
            return
        drawn = ansi(scene, **text_look(scene.shape, self._stream))
        self._stream.write(self._start)
        draw(drawn, self._stream)
        self._stream.write(WRAP_ON + "\n")
        self._stream.flush()
        self._start = WRAP_OFF


def first_place() -> Notebook | Text:
    """Return the notebook that runs this program, or its output: a terminal, a file or a pipe."""
    if "IPython" in sys.modules:  # a notebook has imported it; importing it here is slow
        from IPython import get_ipython
        from IPython.display import display

        shell = get_ipython()
        if hasattr(shell, "kernel"):
            return Notebook(shell, display)
    return Text(sys.stdout)
