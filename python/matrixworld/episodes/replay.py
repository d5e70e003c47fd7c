"""Recorded episodes to watch: in a terminal, as an animation, as a sheet of pictures."""

from __future__ import annotations

import base64
import html
import io
import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from PIL.PngImagePlugin import PngInfo
from typing_extensions import Unpack

from matrixworld._util.checks import check_instance, check_integer, check_keywords, check_number
from matrixworld._util.files import replacing
from matrixworld.episodes.episode import Episode, scene
from matrixworld.episodes.render import ansi, rgb
from matrixworld.episodes.render.canvas import (
    MOST_ANIMATED,
    MOST_PIXELS,
    SMALLEST_NUMBERED,
    Layout,
    check_pixels,
    fitting_cell,
)
from matrixworld.episodes.render.film import check_timing, write_gif, write_mp4
from matrixworld.episodes.render.terminal import play, text_look

__all__ = [
    "Animation",
    "animation",
    "contact_sheet",
    "save",
    "scene",
]

FRAMES = 120
"""The most frames of an animation in a notebook."""
PIXELS = 480
"""Wanted length of the longer side of its field."""
FOV = 11
"""Side of a field of view if the episode does not state it."""


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
    check_number("fps", fps, least=0.0, positive=True)
    times = _times(episode, every)
    if not sys.stdout.isatty():
        print_moment(episode)
        return
    look = text_look(episode.map.shape, sys.stdout)
    play((ansi(scene(episode, t), **look) for t in times), sys.stdout, fps=fps)


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
    ValueError
        If the suffix is another, a value is out of range, or all frames together would have more
        than 2**34 pixels.
    IndexError
        If `step` is outside the episode.
    ImportError
        If the extra ``video`` is not installed, which MP4 needs.

    Examples
    --------
    >>> from matrixworld import WorldConfig, record, replay
    >>> episode = record(WorldConfig("O", max_steps=100), "chaser", "fleer", seed=1)
    >>> replay.save(episode, "chase.gif")  # doctest: +SKIP
    """
    check_keywords(look, Look.__annotations__, save)
    check_integer("step", step)
    suffix = Path(path).suffix.lower()
    if suffix not in (".gif", ".mp4", ".png"):
        raise ValueError(f"path: expected a name that ends in .gif, .mp4 or .png, got {path}")
    pictures = _Pictures(episode, look)
    if suffix == ".png":
        picture, drawn = Image.fromarray(pictures.draw(step)), PngInfo()
        drawn.add_text("Software", "matrixworld")
    else:
        pictures.check_frames(times := _times(episode, every), fps=fps, hold=hold)
    with replacing(path) as file:
        if suffix == ".png":
            picture.save(file, "PNG", pnginfo=drawn)
        else:
            write = write_gif if suffix == ".gif" else write_mp4
            write(file, pictures.draw, times, fps=fps, hold=hold)


@dataclass(frozen=True, repr=False)
class Animation:
    """A GIF that a notebook shows.

    Parameters
    ----------
    data : bytes
        The contents of the file.
    alt : str, optional
        What it shows, in words, for readers who do not see it.
    """

    data: bytes
    alt: str = "an episode of pursuit and evasion"

    def __repr__(self) -> str:
        return f"<Animation: a GIF of {len(self.data) / 1000:.0f} kB>"

    def _repr_html_(self) -> str:
        encoded = base64.b64encode(self.data).decode("ascii")
        return f'<img src="data:image/gif;base64,{encoded}" alt="{html.escape(self.alt)}">'


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

    Raises
    ------
    ValueError
        If a value is out of range, or all frames together would have more than 2**34 pixels.
    """
    check_keywords(look, Look.__annotations__, animation)
    check_instance("episode", episode, Episode)
    # A notebook keeps the animation in its file, so both frames and pixels are limited.
    if every is None:
        every = -(-episode.length // FRAMES) or 1
    pictures = _Pictures(episode, look, PIXELS)
    times = _times(episode, every)
    pictures.check_frames(times, fps=fps, hold=2.0)
    buffer = io.BytesIO()
    write_gif(buffer, pictures.draw, times, fps=fps, hold=2.0)
    return Animation(buffer.getvalue())


def contact_sheet(
    episode: Episode, *, rows: int = 2, cols: int = 3, **look: Unpack[Look]
) -> Image.Image:
    """Draw moments of an episode, evenly spread from first to last, as one picture for a notebook.

    Parameters
    ----------
    episode : Episode
        The recording.
    rows, cols : int, optional
        How many moments are below and beside each other.
    **look
        As for `save`.

    Raises
    ------
    ValueError
        If a value is out of range, or the picture would have more than 2**26 pixels.
    """
    check_keywords(look, Look.__annotations__, contact_sheet)
    pictures = _Pictures(episode, look)
    count = check_integer("rows", rows, 1) * check_integer("cols", cols, 1)
    check_pixels("contact sheet", count * pictures.pixels, MOST_PIXELS)
    times = np.linspace(0, episode.length, count).round().astype(int)
    drawn = [pictures.draw(t) for t in times.tolist()]
    lines = [np.concatenate(drawn[i : i + cols], axis=1) for i in range(0, count, cols)]
    return Image.fromarray(np.concatenate(lines))


class _Pictures:
    """Pictures of an episode's moments; `field` is the wanted size of a field, in pixels."""

    def __init__(self, episode: Episode, look: Look, field: int | None = None) -> None:
        check_instance("episode", episode, Episode)
        self._episode = episode
        self._look: dict[str, Any] = {**look}
        self._trail = check_integer("trail", self._look.pop("trail", 6), 0)
        if self._look.get("fov") is None:
            self._look["fov"] = int(episode.config.get("fov", FOV))
        least = SMALLEST_NUMBERED if look.get("numbers") else 1
        shape, cell = episode.map.shape, look.get("cell")
        if cell is None and field is not None:
            self._look["cell"] = cell = fitting_cell(shape, field, least)
        self.pixels: int = Layout.of(shape, cell, least=least).pixels

    def draw(self, time: int) -> NDArray[np.uint8]:
        return rgb(scene(self._episode, time, trail=self._trail), **self._look)

    def check_frames(self, times: list[int], *, fps: float, hold: float) -> None:
        """Raise ValueError or TypeError before a file is begun."""
        check_timing(fps=fps, hold=hold)
        check_pixels("animation", len(times) * self.pixels, MOST_ANIMATED)


def _times(episode: Episode, every: int) -> list[int]:
    check_integer("every", every, 1)
    times = list(range(0, episode.length + 1, every))
    # The end is the most interesting moment, so it is shown whatever the stride.
    return times if times[-1] == episode.length else [*times, episode.length]
