"""Where an environment shows itself to a person: a notebook, a window, or the terminal."""

from __future__ import annotations

import sys
import time
from typing import Any, Protocol, TextIO

from matrixworld.render import Scene, ansi, png, rgb
from matrixworld.render.screen import CLEAR, WRAP_OFF, WRAP_ON, color_mode, draw, fits

FPS = 10.0
"""Drawings a second, at most."""


class Place(Protocol):
    """Somewhere to show one scene after the other."""

    @property
    def watched(self) -> bool:
        """Whether each scene takes the place of the one before, so that it needs its time."""

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene; ``look`` as `render.rgb` takes it."""

    def close(self) -> None:
        """Take it away, if it stands in anybody's way."""


class Screen:
    """The output of a notebook's cell; else a window, where there is a display; else the terminal.

    Shows at most `FPS` scenes a second, waiting where they come faster. Where the output is no
    terminal (a file, a pipe) every scene is printed as plain text, without waiting.
    """

    def __init__(self) -> None:
        self._place: Place = _notebook() or _window() or _text(sys.stdout)
        self._due = time.monotonic()

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene instead of the one before; ``look`` as `render.rgb` takes it."""
        if self._place.watched:
            time.sleep(max(0.0, self._due - time.monotonic()))
            self._due = time.monotonic() + 1 / FPS
        self._place.show(scene, **look)

    def close(self) -> None:
        """Close the window, if it is one."""
        self._place.close()


class Notebook:
    """One output of a cell, drawn anew; a cell that is run later gets its own."""

    watched = True

    def __init__(self, shell: Any, display: Any) -> None:
        self._shell = shell
        self._display = display
        self._handle: Any = None
        self._run = -1  # the number of the cell's run that shows it

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene in the place of the one before."""
        data = {"image/png": png(scene, **look)}
        if self._handle is not None and self._run == self._shell.execution_count:
            self._handle.update(data, raw=True)
            return
        self._run = self._shell.execution_count
        self._handle = self._display(data, raw=True, display_id=True)

    def close(self) -> None:
        """The last picture stays."""


class Window:
    """A window of Matplotlib's, which the key q closes.

    Closed by its user, it stays closed; nothing else stops, and nothing waits any more.
    """

    def __init__(self, plt: Any, figure: Any) -> None:
        self._plt = plt
        self._figure = figure
        self._image: Any = None

    @property
    def watched(self) -> bool:
        """Whether it is still open."""
        return bool(self._plt.fignum_exists(self._figure.number))

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene in the place of the one before."""
        if not self.watched:
            return
        picture = rgb(scene, **look)
        if self._image is None:
            self._open(picture)
        self._image.set_data(picture)
        self._figure.canvas.draw_idle()
        self._figure.canvas.flush_events()

    def _open(self, picture: Any) -> None:
        height, width, _ = picture.shape
        self._figure.set_size_inches(width / self._figure.dpi, height / self._figure.dpi)
        axes = self._figure.add_axes((0, 0, 1, 1))
        axes.set_axis_off()
        self._image = axes.imshow(picture)
        self._figure.show()

    def close(self) -> None:
        """Close the window."""
        self._plt.close(self._figure)


class Terminal:
    """Text, in place, with the cursor below it."""

    watched = True

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._begun = False

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene as text; ``look`` is for pictures only."""
        mode = color_mode(self._stream)
        compact = mode != "none" and not fits(scene.shape, self._stream)
        self._stream.write(WRAP_OFF if self._begun else WRAP_OFF + CLEAR)
        self._begun = True
        draw(ansi(scene, color=mode, compact=compact), self._stream)
        self._stream.write(WRAP_ON + "\n")
        self._stream.flush()

    def close(self) -> None:
        """The last drawing stays."""


class Printout:
    """Plain text, one drawing below the other, a blank line between them."""

    watched = False

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def show(self, scene: Scene, **look: Any) -> None:
        """Print a scene; ``look`` is for pictures only."""
        self._stream.write(ansi(scene, color="none") + "\n\n")

    def close(self) -> None:
        """What was printed stays."""


def _text(stream: TextIO) -> Place:
    return Terminal(stream) if stream.isatty() else Printout(stream)


def _notebook() -> Place | None:
    if "IPython" not in sys.modules:
        return None
    from IPython import get_ipython
    from IPython.display import display

    shell = get_ipython()
    return Notebook(shell, display) if hasattr(shell, "kernel") else None


def _window() -> Place | None:
    import matplotlib.pyplot as plt

    try:
        with plt.rc_context({"toolbar": "None"}):
            figure = plt.figure()
    except ImportError:  # a backend was asked for whose display or library is not there
        return None
    manager = figure.canvas.manager
    if manager is None or figure.canvas.required_interactive_framework is None:
        plt.close(figure)  # drawn nowhere
        return None
    manager.set_window_title("matrixworld")
    return Window(plt, figure)
