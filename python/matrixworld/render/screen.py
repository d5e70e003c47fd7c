"""Text drawings as an animation in a terminal."""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Iterable, Mapping
from typing import TextIO

HOME = "\x1b[H"
CLEAR = "\x1b[2J"
CLEAR_LINE = "\x1b[K"
CLEAR_BELOW = "\x1b[J"
HIDE_CURSOR = "\x1b[?25l"
SHOW_CURSOR = "\x1b[?25h"
WRAP_OFF = "\x1b[?7l"  # a drawing wider than the terminal is cut, not broken into pieces
WRAP_ON = "\x1b[?7h"


def play(frames: Iterable[str], stream: TextIO, *, fps: float) -> None:
    """Show drawings one after the other in place, until the last or Ctrl-C.

    What is higher than the terminal is cut. Whatever happens, the cursor is back afterwards, on
    the line below the drawing.
    """
    due = time.monotonic()
    try:
        stream.write(HIDE_CURSOR + WRAP_OFF + CLEAR)
        for frame in frames:
            draw(frame, stream)
            due += 1 / fps
            time.sleep(max(0.0, due - time.monotonic()))
    except KeyboardInterrupt:
        return  # how a viewer says that this is enough
    finally:
        stream.write(WRAP_ON + SHOW_CURSOR + "\n")
        stream.flush()


def draw(frame: str, stream: TextIO) -> None:
    """Show a drawing in the place of the one before; what is higher than the terminal is cut."""
    height = terminal_size(stream).lines - 1
    lines = (line + CLEAR_LINE for line in frame.split("\n")[:height])
    stream.write(HOME + "\n".join(lines) + CLEAR_BELOW)
    stream.flush()


def color_mode(stream: TextIO, environ: Mapping[str, str] = os.environ) -> str:
    """What `ansi` may use on a stream: "true", "256" or "none" (see https://no-color.org)."""
    encoding = (getattr(stream, "encoding", None) or "utf-8").lower()
    plain = not stream.isatty() or environ.get("NO_COLOR") or environ.get("TERM") == "dumb"
    if plain or not encoding.startswith("utf"):
        return "none"
    return "true" if environ.get("COLORTERM") in ("truecolor", "24bit") else "256"


def terminal_size(stream: TextIO) -> os.terminal_size:
    """Columns and lines; of the variables COLUMNS and LINES for a stream that knows no size."""
    try:
        return os.get_terminal_size(stream.fileno())
    except OSError:
        return shutil.get_terminal_size()


def fits(shape: tuple[int, ...], stream: TextIO) -> bool:
    """Whether rows x cols cells of two characters, below a title, fit the terminal."""
    columns, lines = terminal_size(stream)
    rows, cols = shape
    return 2 * cols <= columns and rows + 2 <= lines
