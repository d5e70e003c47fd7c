"""The episode of an environment: recorded, drawn, and shown in a notebook, window or terminal.

A place shows at most `FPS` scenes a second and waits if they come faster.
"""

from __future__ import annotations

import sys
import time
from typing import Any, TextIO

import numpy as np
from numpy.typing import NDArray

from matrixworld.episodes.record import Recorder
from matrixworld.episodes.render import Scene, ansi, png, rgb
from matrixworld.episodes.replay import CLEAR, WRAP_OFF, WRAP_ON, draw, text_look
from matrixworld.world.world import World

FPS = 10.0
"""The most scenes per second."""


class Drawing(Recorder):
    """The episode of a world so far, drawn in a render mode; None only records."""

    def __init__(self, world: World, mode: str | None) -> None:
        super().__init__(world)
        self._mode = mode
        self._place: _Place | None = None

    def render(self) -> NDArray[np.uint8] | str | None:
        """Return a picture or a text; None for "human", in which `show` is called at every step."""
        if self._mode == "human":
            return None
        return ansi(self.scene()) if self._mode == "ansi" else rgb(self.scene())

    def show(self) -> None:
        """Show the present moment in the mode "human"."""
        if self._mode != "human":
            return
        if self._place is None:
            self._place = first_place()
        self._place.follow(self.scene())

    def close(self) -> None:
        """Close the place, for example a window."""
        if self._place is not None:
            self._place.close()
            self._place = None

    def __getstate__(self) -> dict[str, Any]:
        # A window cannot be copied. The copy opens its own when it has something to show.
        return self.__dict__ | {"_place": None}


class _Place:
    """A place where scenes are shown one after the other."""

    watched: bool = True  # whether a scene replaces the one before, which needs time to be seen
    _due = 0.0

    def follow(self, scene: Scene) -> None:
        """Show a scene as soon as the one before has been there for its time."""
        if self.watched:
            time.sleep(max(0.0, self._due - time.monotonic()))
            self._due = time.monotonic() + 1 / FPS
        self.show(scene)

    def show(self, scene: Scene) -> None:
        """Show a scene."""
        raise NotImplementedError

    def close(self) -> None:
        """Remove the place if it would be in the way; by default the last drawing stays."""


class _Notebook(_Place):
    """An output of a notebook cell that is redrawn; each cell run later gets its own."""

    def __init__(self, shell: Any, display: Any) -> None:
        self._shell = shell  # of IPython
        self._display = display  # `IPython.display.display`
        self._handle: Any = None
        self._run = -1  # execution count of the cell that shows it

    def show(self, scene: Scene) -> None:
        data = {"image/png": png(scene)}
        if self._handle is not None and self._run == self._shell.execution_count:
            self._handle.update(data, raw=True)
            return
        self._run = self._shell.execution_count
        self._handle = self._display(data, raw=True, display_id=True)


class _Window(_Place):
    """A window of Matplotlib, which the key q closes.

    A window closed by its user stays closed. The program goes on, and no longer waits for it.
    """

    def __init__(self, plt: Any, figure: Any) -> None:
        self._plt, self._figure = plt, figure
        self._image: Any = None

    @property
    def watched(self) -> bool:  # type: ignore[override]
        return bool(self._plt.fignum_exists(self._figure.number))

    def show(self, scene: Scene) -> None:
        if not self.watched:
            return
        picture = rgb(scene)
        if self._image is None:
            height, width, _ = picture.shape
            self._figure.set_size_inches(width / self._figure.dpi, height / self._figure.dpi)
            axes = self._figure.add_axes((0, 0, 1, 1))
            axes.set_axis_off()
            self._image = axes.imshow(picture)
            self._figure.show()
        # Only the pixels change; drawing the axes anew would be slower.
        self._image.set_data(picture)
        self._figure.canvas.draw_idle()
        self._figure.canvas.flush_events()

    def close(self) -> None:
        self._plt.close(self._figure)


class _Text(_Place):
    """Text: in a terminal redrawn in place, with the cursor below it; else one below the other."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self.watched = stream.isatty()
        self._start = WRAP_OFF + CLEAR

    def show(self, scene: Scene) -> None:
        if not self.watched:
            self._stream.write(ansi(scene, color="none") + "\n\n")
            return
        drawn = ansi(scene, **text_look(scene.shape, self._stream))
        self._stream.write(self._start)
        draw(drawn, self._stream)
        self._stream.write(WRAP_ON + "\n")
        self._stream.flush()
        self._start = WRAP_OFF


def first_place() -> _Place:
    """Return the first place that exists: a notebook, a window, the terminal, or a file or pipe."""
    return _notebook() or _window() or _Text(sys.stdout)


def _notebook() -> _Place | None:
    if "IPython" not in sys.modules:  # a notebook has imported it; importing it here is slow
        return None
    from IPython import get_ipython
    from IPython.display import display

    shell = get_ipython()
    return _Notebook(shell, display) if hasattr(shell, "kernel") else None


def _window() -> _Place | None:
    import matplotlib.pyplot as plt

    try:
        with plt.rc_context({"toolbar": "None"}):
            figure = plt.figure()
    except ImportError:  # the chosen backend lacks its display or its library
        return None
    manager = figure.canvas.manager
    if manager is None or figure.canvas.required_interactive_framework is None:
        plt.close(figure)  # this backend only writes files
        return None
    manager.set_window_title("matrixworld")
    return _Window(plt, figure)
