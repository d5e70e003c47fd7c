"""Recorded episodes to watch: in a terminal, as an animation, as a picture."""

from __future__ import annotations

import os
import shutil
import sys
import time
from pathlib import Path
from typing import Any, TextIO

from PIL import Image
from PIL.PngImagePlugin import PngInfo

from matrixworld._util import checks
from matrixworld._util.files import replacing
from matrixworld.episodes.episode import Episode, animation, pictures, scene, times_of
from matrixworld.episodes.frames import FASTEST, HOLD, SLOWEST, Animation, write_gif, write_mp4
from matrixworld.world.render import Scene, ansi

__all__ = ["Animation", "animation", "save", "scene"]


def animate_terminal(episode: Episode, *, fps: float = 10.0, every: int = 1) -> None:
    """Show an episode in the terminal, in place; without one, print the last moment."""
    fps = checks.check_number("fps", fps, least=0.0, positive=True)
    times = times_of(episode, every)
    screen = Screen(sys.stdout)
    if not screen.in_place:
        print_moment(episode)
        return
    due = time.monotonic()
    try:
        sys.stdout.write(HIDE_CURSOR)
        for moment in times:
            screen.show(scene(episode, moment))
            # Waiting for a point in time, not for a period, makes up for the time to draw.
            due += 1 / fps
            time.sleep(max(0.0, due - time.monotonic()))
    except KeyboardInterrupt:
        return  # the viewer has seen enough
    finally:
        sys.stdout.write(WRAP_ON + SHOW_CURSOR + "\n")
        sys.stdout.flush()


def print_moment(episode: Episode, *, step: int = -1) -> None:
    """Print one moment of an episode, as `scene` counts them, in the colors of the output."""
    look = text_look(episode.map.shape, sys.stdout)
    sys.stdout.write(ansi(scene(episode, step), **look) + "\n")


def save(
    episode: Episode,
    path: str | os.PathLike[str],
    *,
    fps: float = 10.0,
    every: int = 1,
    step: int = -1,
    **look: Any,
) -> None:
    """Write an `episode` as an animation, a film, or a picture of one moment.

    The suffix of the `path` decides: ``.gif``, ``.mp4`` (extra ``video``, else ImportError), or
    ``.png`` for one moment, a `step` as for `scene`. There are `fps` frames per second, 0.1 to 50,
    `every` so many steps, and the last step is always shown. `look` is ``cell`` and ``numbers`` as
    for `render.rgb`, and ``trail``: steps back that the trails of the agents go, 6 by default. The
    file appears complete or not at all. Until then the frames of a GIF are in memory: of 40 x 40
    cells they take 0.6 MB each, so a film of thousands of steps should be an MP4.
    """
    step = checks.check_integer("step", step)
    suffix = Path(path).suffix.lower()
    if suffix not in (".gif", ".mp4", ".png"):
        raise ValueError(f"path: expected a name that ends in .gif, .mp4 or .png, got {path}")
    fps = checks.check_number("fps", fps, least=SLOWEST, most=FASTEST)
    times = times_of(episode, every)
    draw = pictures(episode, look)
    with replacing(path) as file:
        if suffix == ".png":
            info = PngInfo()
            info.add_text("Software", "matrixworld")
            Image.fromarray(draw(step)).save(file, "PNG", pnginfo=info)
        elif suffix == ".gif":
            write_gif(file, draw, times, fps=fps, hold=HOLD)
        else:
            write_mp4(file, draw, times, fps=fps, hold=HOLD)


# Terminals:

# Control sequences of ECMA-48 that practically all terminals know.
HOME, CLEAR, CLEAR_LINE, CLEAR_BELOW = "\x1b[H", "\x1b[2J", "\x1b[K", "\x1b[J"
HIDE_CURSOR, SHOW_CURSOR = "\x1b[?25l", "\x1b[?25h"
WRAP_OFF, WRAP_ON = "\x1b[?7l", "\x1b[?7h"  # off: what is too wide is cut, not broken


class Screen:
    """What text is written to; in a terminal each drawing replaces the one before."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._start = WRAP_OFF + CLEAR
        self.in_place = stream.isatty()  # so that a drawing needs time to be seen

    def show(self, scene: Scene) -> None:
        """Show a scene, cut to the height of the terminal, with the cursor below it."""
        if not self.in_place:
            self._stream.write(ansi(scene, color=False) + "\n\n")
            return
        drawn = ansi(scene, **text_look(scene.shape, self._stream)).split("\n")
        # Each line is cleared behind its text: clearing the whole screen first would flicker.
        lines = (line + CLEAR_LINE for line in drawn[: shutil.get_terminal_size().lines - 1])
        frame = HOME + "\n".join(lines) + CLEAR_BELOW
        self._stream.write(self._start + frame + WRAP_ON + "\n")
        self._stream.flush()
        self._start = WRAP_OFF


def text_look(shape: tuple[int, ...], stream: TextIO) -> dict[str, Any]:
    """Return the keyword arguments of `ansi` for a grid, in half blocks where it would not fit.

    Colors need a terminal that shows Unicode, by NO_COLOR and TERM, too.
    """
    encoding = (getattr(stream, "encoding", None) or "utf-8").lower()
    plain = os.environ.get("NO_COLOR") or os.environ.get("TERM") == "dumb"
    color = stream.isatty() and encoding.startswith("utf") and not plain
    (columns, lines), (rows, cols) = shutil.get_terminal_size(), shape
    fits = 2 * cols <= columns and rows + 2 <= lines  # cells of two characters, below a title
    return {"color": color, "compact": color and not fits}
