"""Drawings in text, shown one after the other in a terminal."""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Iterable, Mapping
from typing import TextIO

# Control sequences of ECMA-48 that practically all terminals know.
HOME = "\x1b[H"
CLEAR = "\x1b[2J"
CLEAR_LINE = "\x1b[K"
CLEAR_BELOW = "\x1b[J"
HIDE_CURSOR = "\x1b[?25l"
SHOW_CURSOR = "\x1b[?25h"
WRAP_OFF = "\x1b[?7l"  # a drawing wider than the terminal is cut instead of broken into pieces
WRAP_ON = "\x1b[?7h"


def play(frames: Iterable[str], stream: TextIO, *, fps: float) -> None:
    """Show drawings in place, one after the other, until the last one or Ctrl-C.

    A drawing higher than the terminal is cut. In any case the cursor is visible again afterwards,
    on the line below the drawing.

    Parameters
    ----------
    frames : iterable of str
        The drawings, as `render.ansi` returns them.
    stream : file
        A terminal.
    fps : float
        Drawings per second.
    """
    due = time.monotonic()
    try:
        stream.write(HIDE_CURSOR + WRAP_OFF + CLEAR)
        for frame in frames:
            draw(frame, stream)
            # Waiting for a point in time, not for a period, makes up for the time to draw.
            due += 1 / fps
            time.sleep(max(0.0, due - time.monotonic()))
    except KeyboardInterrupt:
        return  # the viewer has seen enough
    finally:
        stream.write(WRAP_ON + SHOW_CURSOR + "\n")
        stream.flush()


def draw(frame: str, stream: TextIO) -> None:
    """Replace the drawing in a terminal by another one, cut to the height of the terminal."""
    height = terminal_size(stream).lines - 1
    # Each line is cleared behind its text: clearing the whole screen first would flicker.
    lines = (line + CLEAR_LINE for line in frame.split("\n")[:height])
    stream.write(HOME + "\n".join(lines) + CLEAR_BELOW)
    stream.flush()


def color_mode(stream: TextIO, environ: Mapping[str, str] = os.environ) -> str:
    """Return the colors that `render.ansi` may use on a stream.

    Parameters
    ----------
    stream : file
        Where the text goes.
    environ : mapping, optional
        Environment variables; NO_COLOR (https://no-color.org), TERM and COLORTERM are read.

    Returns
    -------
    str
        ``"true"``, ``"256"`` or ``"none"``.
    """
    encoding = (getattr(stream, "encoding", None) or "utf-8").lower()
    plain = not stream.isatty() or environ.get("NO_COLOR") or environ.get("TERM") == "dumb"
    if plain or not encoding.startswith("utf"):
        return "none"
    return "true" if environ.get("COLORTERM") in ("truecolor", "24bit") else "256"


def terminal_size(stream: TextIO) -> os.terminal_size:
    """Return columns and lines of a terminal; without one, of the variables COLUMNS and LINES."""
    try:
        return os.get_terminal_size(stream.fileno())
    except OSError:
        return shutil.get_terminal_size()


def fits(shape: tuple[int, ...], stream: TextIO) -> bool:
    """Return whether rows x cols cells of two characters, below a title, fit the terminal."""
    columns, lines = terminal_size(stream)
    rows, cols = shape
    return 2 * cols <= columns and rows + 2 <= lines
