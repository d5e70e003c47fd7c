"""Where an environment with ``render_mode="human"`` is shown: notebook, window or terminal."""

from __future__ import annotations

import sys
import time
from typing import Any, Protocol, TextIO

from matrixworld.episodes.render import Scene, ansi, png, rgb
from matrixworld.episodes.render.terminal_animation import (
    CLEAR,
    WRAP_OFF,
    WRAP_ON,
    color_mode,
    draw,
    fits,
)

FPS = 10.0
"""The most scenes per second."""


class Place(Protocol):
    """A place where scenes are shown one after the other."""

    @property
    def watched(self) -> bool:
        """Whether each scene replaces the one before, so that a person needs time to see it."""

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene. `look` holds keyword arguments of `render.rgb`."""

    def close(self) -> None:
        """Remove the place if it would be in the way."""


class Display:
    """Shows scenes in the first place that exists: a notebook, a window, the terminal.

    It shows at most `FPS` scenes per second and waits if they come faster. If the output is not a
    terminal but a file or a pipe, it prints every scene as plain text without waiting.
    """

    def __init__(self) -> None:
        self._place: Place = _notebook() or _window() or _text(sys.stdout)
        self._due = time.monotonic()

    def show(self, scene: Scene, **look: Any) -> None:
        """Replace the scene shown. `look` holds keyword arguments of `render.rgb`."""
        if self._place.watched:
            time.sleep(max(0.0, self._due - time.monotonic()))
            self._due = time.monotonic() + 1 / FPS
        self._place.show(scene, **look)

    def close(self) -> None:
        """Close the window, if there is one."""
        self._place.close()


class Notebook:
    """An output of a notebook cell that is redrawn; each cell run later gets its own.

    Parameters
    ----------
    shell : object
        The IPython shell.
    display : callable
        `IPython.display.display`.
    """

    watched = True

    def __init__(self, shell: Any, display: Any) -> None:
        self._shell = shell
        self._display = display
        self._handle: Any = None
        self._run = -1  # execution count of the cell that shows it

    def show(self, scene: Scene, **look: Any) -> None:
        """Replace the scene shown."""
        data = {"image/png": png(scene, **look)}
        if self._handle is not None and self._run == self._shell.execution_count:
            self._handle.update(data, raw=True)
            return
        self._run = self._shell.execution_count
        self._handle = self._display(data, raw=True, display_id=True)

    def close(self) -> None:
        """Do nothing: the last picture stays."""


class Window:
    """A window of Matplotlib, which the key q closes.

    A window closed by its user stays closed. The program goes on, and no longer waits for it.

    Parameters
    ----------
    plt : module
        `matplotlib.pyplot`.
    figure : matplotlib.figure.Figure
        An empty figure with a window.
    """

    def __init__(self, plt: Any, figure: Any) -> None:
        self._plt = plt
        self._figure = figure
        self._image: Any = None

    @property
    def watched(self) -> bool:
        """Whether the window is still open."""
        return bool(self._plt.fignum_exists(self._figure.number))

    def show(self, scene: Scene, **look: Any) -> None:
        """Replace the scene shown."""
        if not self.watched:
            return
        picture = rgb(scene, **look)
        if self._image is None:
            self._open(picture)
        # Only the pixels change; drawing the axes anew would be slower.
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
    """Text in a terminal, redrawn in place, with the cursor below it."""

    watched = True

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._begun = False

    def show(self, scene: Scene, **look: Any) -> None:
        """Show a scene as text; `look` is for pictures only."""
        mode = color_mode(self._stream)
        compact = mode != "none" and not fits(scene.shape, self._stream)
        self._stream.write(WRAP_OFF if self._begun else WRAP_OFF + CLEAR)
        self._begun = True
        draw(ansi(scene, color=mode, compact=compact), self._stream)
        self._stream.write(WRAP_ON + "\n")
        self._stream.flush()

    def close(self) -> None:
        """Do nothing: the last drawing stays."""


class Printout:
    """Plain text, one drawing below the other with a blank line between them."""

    watched = False

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def show(self, scene: Scene, **look: Any) -> None:
        """Print a scene; `look` is for pictures only."""
        self._stream.write(ansi(scene, color="none") + "\n\n")

    def close(self) -> None:
        """Do nothing: printed text stays."""


def _text(stream: TextIO) -> Place:
    return Terminal(stream) if stream.isatty() else Printout(stream)


def _notebook() -> Place | None:
    if "IPython" not in sys.modules:  # a notebook has imported it; importing it here is slow
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
    except ImportError:  # the chosen backend lacks its display or its library
        return None
    manager = figure.canvas.manager
    if manager is None or figure.canvas.required_interactive_framework is None:
        plt.close(figure)  # this backend only writes files
        return None
    manager.set_window_title("matrixworld")
    return Window(plt, figure)
