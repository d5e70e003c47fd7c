"""Recorded episodes to watch: in a terminal, as an animation, as a picture."""

from __future__ import annotations

import os
import shutil
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any, TextIO, TypedDict

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from PIL.PngImagePlugin import PngInfo
from typing_extensions import Unpack

from matrixworld._util import checks
from matrixworld._util.files import replacing
from matrixworld.episodes.episode import Episode, scene
from matrixworld.episodes.films import (
    PIXELS,
    Animation,
    few_times,
    times_of,
    write_gif,
    write_mp4,
)
from matrixworld.world.canvas import SMALLEST_NUMBERED, Layout, fitting_cell
from matrixworld.world.render import ansi, rgb

__all__ = ["Animation", "animation", "save", "scene"]

FOV = 11  # side of a field of view if the episode does not state it
MOST_ANIMATED = 2**34  # pixels of all frames: minutes of work, hours on the largest grids
SLOWEST, FASTEST = 0.1, 50.0  # frames per second; most viewers slow down faster animations
LONGEST_HOLD = 600.0  # seconds; a GIF has 16 bits for hundredths


class Look(TypedDict, total=False):
    """Keyword arguments of pictures of an episode, for type checkers; see `save`."""

    cell: int | None
    trail: int
    fov: int | None
    viewers: Sequence[int | str]
    numbers: bool


def animate_terminal(episode: Episode, *, fps: float = 10.0, every: int = 1) -> None:
    """Show an episode in the terminal, in place, until its end or Ctrl-C.

    A grid too large for the terminal is drawn in half blocks. Where there is no terminal, the last
    moment is printed as plain text.
    """
    fps = checks.check_number("fps", fps, least=0.0, positive=True)
    times, stream = _times(episode, every), sys.stdout
    if not stream.isatty():
        print_moment(episode)
        return
    look = text_look(episode.map.shape, stream)
    due = time.monotonic()
    try:
        stream.write(HIDE_CURSOR + WRAP_OFF + CLEAR)
        for moment in times:
            draw(ansi(scene(episode, moment), **look), stream)
            # Waiting for a point in time, not for a period, makes up for the time to draw.
            due += 1 / fps
            time.sleep(max(0.0, due - time.monotonic()))
    except KeyboardInterrupt:
        return  # the viewer has seen enough
    finally:
        stream.write(WRAP_ON + SHOW_CURSOR + "\n")
        stream.flush()


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
    hold: float = 2.0,
    step: int = -1,
    **look: Unpack[Look],
) -> None:
    """Write an episode as an animation, a film, or a picture of one moment.

    The file appears complete or not at all.

    Parameters
    ----------
    episode : Episode
        The recording.
    path : path
        The file. Its suffix decides: ``.gif``, ``.mp4``, or ``.png`` for one moment.
    fps : float, optional
        Frames per second, 0.1 to 50.
    every : int, optional
        Steps from one frame to the next. The last step is always shown.
    hold : float, optional
        Seconds for which the last frame is shown longer.
    step : int, optional
        The moment of a PNG, as for `scene`.
    **look
        ``cell``, ``viewers`` and ``numbers`` as for `render.rgb`; ``fov``, too, but by default that
        of the episode's world. ``trail``: steps back that the trails of the agents go, 6 by
        default.

    Raises
    ------
    ValueError, IndexError
        If the suffix is another, a value is out of range, `step` is outside the episode, or all
        frames together would have more than 2**34 pixels.
    ImportError
        If the extra ``video`` is not installed, which MP4 needs.

    Examples
    --------
    >>> from matrixworld import WorldConfig, record, replay
    >>> episode = record(WorldConfig("O", max_steps=100), "chaser", "fleer", seed=1)
    >>> replay.save(episode, "chase.gif")  # doctest: +SKIP
    """
    checks.check_keywords(look, Look.__annotations__, save)
    step = checks.check_integer("step", step)
    suffix = Path(path).suffix.lower()
    if suffix not in (".gif", ".mp4", ".png"):
        raise ValueError(f"path: expected a name that ends in .gif, .mp4 or .png, got {path}")
    pictures = _Pictures(episode, look)
    if suffix == ".png":
        picture, drawn = Image.fromarray(pictures.draw(step)), PngInfo()
        drawn.add_text("Software", "matrixworld")
    else:
        times = _times(episode, every)
        fps, hold = pictures.check_frames(times, fps=fps, hold=hold)
    with replacing(path) as file:
        if suffix == ".png":
            picture.save(file, "PNG", pnginfo=drawn)
        else:
            write = write_gif if suffix == ".gif" else write_mp4
            write(file, pictures.draw, times, fps=fps, hold=hold)


def animation(
    episode: Episode, *, fps: float = 10.0, every: int | None = None, **look: Unpack[Look]
) -> Animation:
    """Return an animation that a notebook shows, and stores in itself.

    A long episode on 40 x 40 cells takes about 1 MB.

    Parameters
    ----------
    episode : Episode
        The recording.
    fps : float, optional
        Frames per second, 0.1 to 50.
    every : int, optional
        Steps from one frame to the next. The default shows at most `FRAMES` frames.
    **look
        As for `save`. The default of ``cell`` gives about `PIXELS` pixels a side.
    """
    checks.check_keywords(look, Look.__annotations__, animation)
    # A notebook keeps the animation in its file, so both frames and pixels are limited.
    pictures = _Pictures(episode, look, PIXELS)
    times = few_times(episode.length) if every is None else _times(episode, every)
    fps, hold = pictures.check_frames(times, fps=fps, hold=2.0)
    return Animation.of(pictures.draw, times, fps=fps, hold=hold)


class _Pictures:
    """Pictures of an episode's moments; `field` is the wanted size of a field, in pixels."""

    def __init__(self, episode: Episode, look: Look, field: int | None = None) -> None:
        checks.check_instance("episode", episode, Episode)
        self._episode = episode
        self._look: dict[str, Any] = {**look}
        self._trail = checks.check_integer("trail", self._look.pop("trail", 6), 0)
        if self._look.get("fov") is None:
            self._look["fov"] = int(episode.config.get("fov", FOV))
        least = SMALLEST_NUMBERED if look.get("numbers") else 1
        shape, cell = episode.map.shape, look.get("cell")
        if cell is None and field is not None:
            self._look["cell"] = cell = fitting_cell(shape, field, least)
        self.pixels: int = Layout.of(shape, cell, least=least).pixels

    def draw(self, step: int) -> NDArray[np.uint8]:
        return rgb(scene(self._episode, step, trail=self._trail), **self._look)

    def check_frames(self, times: list[int], *, fps: float, hold: float) -> tuple[float, float]:
        """Return fps and hold, or raise ValueError or TypeError before a file is begun."""
        pixels = len(times) * self.pixels
        if pixels > MOST_ANIMATED:
            expected = f"at most {MOST_ANIMATED:,} pixels in all"
            raise ValueError(f"animation: expected {expected}, got {checks.shown(pixels)}")
        return (
            checks.check_number("fps", fps, least=SLOWEST, most=FASTEST),
            checks.check_number("hold", hold, least=0.0, most=LONGEST_HOLD),
        )


def _times(episode: Episode, every: int) -> list[int]:
    return times_of(episode.length, checks.check_integer("every", every, 1))


# Terminals:

# Control sequences of ECMA-48 that practically all terminals know.
HOME, CLEAR, CLEAR_LINE, CLEAR_BELOW = "\x1b[H", "\x1b[2J", "\x1b[K", "\x1b[J"
HIDE_CURSOR, SHOW_CURSOR = "\x1b[?25l", "\x1b[?25h"
WRAP_OFF, WRAP_ON = "\x1b[?7l", "\x1b[?7h"  # off: what is too wide is cut, not broken


def draw(frame: str, stream: TextIO) -> None:
    """Replace the drawing in a terminal by another one, cut to the height of the terminal."""
    height = terminal_size(stream).lines - 1
    # Each line is cleared behind its text: clearing the whole screen first would flicker.
    lines = (line + CLEAR_LINE for line in frame.split("\n")[:height])
    stream.write(HOME + "\n".join(lines) + CLEAR_BELOW)
    stream.flush()


def color_mode(stream: TextIO) -> str:
    """Return the colors that `ansi` may use on a stream, by NO_COLOR, TERM and COLORTERM."""
    encoding = (getattr(stream, "encoding", None) or "utf-8").lower()
    plain = os.environ.get("NO_COLOR") or os.environ.get("TERM") == "dumb"
    if plain or not stream.isatty() or not encoding.startswith("utf"):
        return "none"
    return "true" if os.environ.get("COLORTERM") in ("truecolor", "24bit") else "256"


def terminal_size(stream: TextIO) -> os.terminal_size:
    """Return columns and lines of a terminal; without one, of the variables COLUMNS and LINES."""
    try:
        return os.get_terminal_size(stream.fileno())
    except OSError:
        return shutil.get_terminal_size()


def text_look(shape: tuple[int, ...], stream: TextIO) -> dict[str, Any]:
    """Return the keyword arguments of `ansi` for a grid, in half blocks where it would not fit."""
    mode, (columns, lines), (rows, cols) = color_mode(stream), terminal_size(stream), shape
    fits = 2 * cols <= columns and rows + 2 <= lines  # cells of two characters, below a title
    return {"color": mode, "compact": mode != "none" and not fits}
