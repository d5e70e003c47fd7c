"""Where an environment shows itself to a person: a notebook, a window, or the terminal."""

from __future__ import annotations

import sys
import time
from typing import Any, Protocol, TextIO

from matrixworld.render import Scene, ansi, png, rgb
from matrixworld.render.screen import CLEAR, color_mode, draw, fits

FPS = 10.0
"""Drawings a second, at most."""


class Place(Protocol):
    """Somewhere to show one scene after the other."""

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene instead of the one before; ``look`` as `render.rgb` takes it."""

    def close(self) -> None:
        """Take it away, if it stands in anybody's way."""


class Screen:
    """The output of a notebook's cell; else a window, where there is a display; else the terminal.

    Shows at most `FPS` scenes a second, waiting where they come faster.
    """

    def __init__(self) -> None:
        self._place: Place = _notebook() or _window() or Terminal(sys.stdout)
        self._due = time.monotonic()

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene instead of the one before; ``look`` as `render.rgb` takes it."""
        time.sleep(max(0.0, self._due - time.monotonic()))
        self._due = time.monotonic() + 1 / FPS
        self._place.show(scene, **look)

    def close(self) -> None:
        """Close the window, if it is one."""
        self._place.close()


class Notebook:
    """One output of a cell, drawn anew."""

    def __init__(self, display: Any) -> None:
        self._display = display
        self._handle: Any = None

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene in the place of the one before."""
        data = {"image/png": png(scene, **look)}
        if self._handle is None:
            self._handle = self._display(data, raw=True, display_id=True)
        else:
            self._handle.update(data, raw=True)

    def close(self) -> None:
        """The last picture stays."""


class Window:
    """A window of Matplotlib's. Closed by its user, it stays closed; nothing else stops."""

    def __init__(self, plt: Any, figure: Any) -> None:
        self._plt = plt
        self._figure = figure
        self._image: Any = None

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene in the place of the one before."""
        if not self._plt.fignum_exists(self._figure.number):
            return
        picture = rgb(scene, **look)
        if self._image is None:
            height, width, _ = picture.shape
            self._figure.set_size_inches(width / self._figure.dpi, height / self._figure.dpi)
            axes = self._figure.add_axes((0, 0, 1, 1))
            axes.set_axis_off()
            self._image = axes.imshow(picture)
            self._figure.show()
        self._image.set_data(picture)
        self._figure.canvas.draw_idle()
        self._figure.canvas.flush_events()

    def close(self) -> None:
        """Close the window."""
        self._plt.close(self._figure)


class Terminal:
    """Text, in place; where the stream is no terminal, one drawing after the other."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._begun = False

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene as text; ``look`` is for pictures only."""
        if not self._stream.isatty():
            self._stream.write(ansi(scene, color="none") + "\n")
            return
        if not self._begun:
            self._stream.write(CLEAR)
            self._begun = True
        mode = color_mode(self._stream)
        compact = mode != "none" and not fits(scene.shape, self._stream)
        draw(ansi(scene, color=mode, compact=compact), self._stream)

    def close(self) -> None:
        """Leave the cursor below the drawing."""
        if self._begun:
            self._stream.write("\n")


def _notebook() -> Place | None:
    if "IPython" not in sys.modules:
        return None
    from IPython import get_ipython
    from IPython.display import display

    return Notebook(display) if hasattr(get_ipython(), "kernel") else None


def _window() -> Place | None:
    import matplotlib.pyplot as plt

    figure = plt.figure("matrixworld")
    if figure.canvas.required_interactive_framework is not None:
        return Window(plt, figure)
    plt.close(figure)  # drawn nowhere
    return None
