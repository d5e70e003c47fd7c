"""Recorded episodes to watch: in a terminal, as an animation, as a sheet of pictures."""

from __future__ import annotations

import base64
import html
import io
import os
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TextIO

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from matrixworld._util.checks import check_instance, check_integer, check_number
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
from matrixworld.episodes.render.terminal import color_mode, fits, play

__all__ = [
    "Animation",
    "Episode",
    "animate_terminal",
    "animation",
    "contact_sheet",
    "print_moment",
    "save",
    "scene",
]

FRAMES = 120
"""The most frames of an animation in a notebook."""
PIXELS = 480
"""Wanted length of the longer side of its field."""
FOV = 11
"""Side of a field of view if the episode does not state it."""


def animate_terminal(
    episode: Episode,
    stream: TextIO | None = None,
    *,
    fps: float = 10.0,
    every: int = 1,
    color: str | None = None,
) -> None:
    """Show an episode in a terminal, in place, until its end or Ctrl-C.

    A grid too large for the terminal is drawn in half blocks.

    Parameters
    ----------
    episode : Episode
        The recording.
    stream : file, optional
        Where to show it. The default is standard output. If it is not a terminal, the last moment
        is printed as plain text instead.
    fps : float, optional
        Drawings per second.
    every : int, optional
        Steps from one drawing to the next.
    color : {"true", "256", "none"}, optional
        As for `render.ansi`. By default it follows from the terminal.

    Raises
    ------
    ValueError
        If `fps` is not positive or `every` is below 1.
    """
    check_number("fps", fps, least=0.0, positive=True)
    times = _times(episode, every)
    out = sys.stdout if stream is None else stream
    if not out.isatty():
        print_moment(episode, out, color="none")
        return
    look = _text_look(episode, out, color)
    play((ansi(scene(episode, t), **look) for t in times), out, fps=fps)


def print_moment(
    episode: Episode, stream: TextIO | None = None, *, step: int = -1, color: str | None = None
) -> None:
    """Print one moment of an episode as text.

    Parameters
    ----------
    episode : Episode
        The recording.
    stream : file, optional
        Where to print it. The default is standard output.
    step : int, optional
        The moment, as for `scene`. The default is the end.
    color : {"true", "256", "none"}, optional
        As for `animate_terminal`.

    Raises
    ------
    IndexError
        If the step is outside the episode.
    """
    out = sys.stdout if stream is None else stream
    out.write(ansi(scene(episode, step), **_text_look(episode, out, color)) + "\n")


def _text_look(episode: Episode, stream: TextIO, color: str | None) -> dict[str, Any]:
    """Return the keyword arguments of `render.ansi` that suit a stream."""
    mode = color_mode(stream) if color is None else color
    return {"color": mode, "compact": mode != "none" and not fits(episode.map.shape, stream)}


def save(
    episode: Episode,
    path: str | os.PathLike[str],
    *,
    fps: float = 10.0,
    every: int = 1,
    hold: float = 2.0,
    step: int = -1,
    cell: int | None = None,
    trail: int = 6,
    fov: int | None = None,
    viewers: Sequence[int | str] = (),
    numbers: bool = False,
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
    cell : int, optional
        Pixels per cell. By default the size of the grid decides.
    trail : int, optional
        Steps back that the trails of the agents go.
    fov : int, optional
        Side of the fields of view in cells. By default that of the episode's world.
    viewers : sequence of int or str, optional
        The agents whose fields of view are outlined, by number or name.
    numbers : bool, optional
        Whether agents carry their numbers in their teams, as in `render.rgb`.

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
    check_instance("episode", episode, Episode)
    check_integer("step", step)
    suffix = Path(path).suffix.lower()
    if suffix not in (".gif", ".mp4", ".png"):
        raise ValueError(f"path: expected a name that ends in .gif, .mp4 or .png, got {path}")
    draw = _drawer(episode, cell=cell, trail=trail, fov=fov, viewers=viewers, numbers=numbers)
    times = _times(episode, every)
    if suffix == ".png":
        picture = Image.fromarray(draw(step))
    else:
        _check_animation(episode, times, cell=cell, numbers=numbers, fps=fps, hold=hold)
    with replacing(path) as file:
        if suffix == ".png":
            picture.save(file, "PNG")
        else:
            write = write_gif if suffix == ".gif" else write_mp4
            write(file, draw, times, fps=fps, hold=hold)


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
    episode: Episode,
    *,
    fps: float = 10.0,
    every: int | None = None,
    cell: int | None = None,
    trail: int = 6,
    fov: int | None = None,
    viewers: Sequence[int | str] = (),
    numbers: bool = False,
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
    cell : int, optional
        Pixels per cell. The default gives about `PIXELS` pixels a side.
    trail, fov, viewers, numbers : optional
        As for `save`.

    Returns
    -------
    Animation
        The animated GIF.

    Raises
    ------
    ValueError
        If a value is out of range, or all frames together would have more than 2**34 pixels.
    """
    check_instance("episode", episode, Episode)
    # A notebook keeps the animation in its file, so both frames and pixels are limited.
    if every is None:
        every = -(-episode.length // FRAMES) or 1
    if cell is None:
        cell = fitting_cell(episode.map.shape, PIXELS, SMALLEST_NUMBERED if numbers else 1)
    draw = _drawer(episode, cell=cell, trail=trail, fov=fov, viewers=viewers, numbers=numbers)
    times = _times(episode, every)
    _check_animation(episode, times, cell=cell, numbers=numbers, fps=fps, hold=2.0)
    buffer = io.BytesIO()
    write_gif(buffer, draw, times, fps=fps, hold=2.0)
    return Animation(buffer.getvalue())


def contact_sheet(
    episode: Episode,
    *,
    rows: int = 2,
    cols: int = 3,
    cell: int | None = None,
    trail: int = 6,
    fov: int | None = None,
    viewers: Sequence[int | str] = (),
    numbers: bool = False,
) -> Image.Image:
    """Draw moments of an episode, evenly spread from first to last, as one picture.

    Parameters
    ----------
    episode : Episode
        The recording.
    rows, cols : int, optional
        How many moments are below and beside each other.
    cell : int, optional
        Pixels per cell. By default the size of the grid decides.
    trail, fov, viewers, numbers : optional
        As for `save`.

    Returns
    -------
    PIL.Image.Image
        The picture, which a notebook shows.

    Raises
    ------
    ValueError
        If a value is out of range, or the picture would have more than 2**26 pixels.
    """
    check_instance("episode", episode, Episode)
    count = check_integer("rows", rows, 1) * check_integer("cols", cols, 1)
    check_pixels("contact sheet", count * _pixels(episode, cell, numbers), MOST_PIXELS)
    times = np.linspace(0, episode.length, count).round().astype(int)
    draw = _drawer(episode, cell=cell, trail=trail, fov=fov, viewers=viewers, numbers=numbers)
    pictures = [draw(t) for t in times.tolist()]
    lines = [np.concatenate(pictures[i : i + cols], axis=1) for i in range(0, len(times), cols)]
    return Image.fromarray(np.concatenate(lines))


def _drawer(
    episode: Episode,
    *,
    cell: int | None,
    trail: int,
    fov: int | None,
    viewers: Sequence[int | str],
    numbers: bool,
) -> Callable[[int], NDArray[np.uint8]]:
    """Return a function that draws a moment of the episode."""
    check_integer("trail", trail, 0)
    side = int(episode.config.get("fov", FOV)) if fov is None else fov

    def draw(time: int) -> NDArray[np.uint8]:
        return rgb(
            scene(episode, time, trail=trail), cell=cell, fov=side, viewers=viewers, numbers=numbers
        )

    return draw


def _check_animation(
    episode: Episode,
    times: list[int],
    *,
    cell: int | None,
    numbers: bool,
    fps: float,
    hold: float,
) -> None:
    """Raise ValueError or TypeError before a file is begun."""
    check_timing(times, fps=fps, hold=hold)
    check_pixels("animation", len(times) * _pixels(episode, cell, numbers), MOST_ANIMATED)


def _pixels(episode: Episode, cell: int | None, numbers: bool) -> int:
    least = SMALLEST_NUMBERED if numbers else 1
    return Layout.of(episode.map.shape, cell, least=least).pixels


def _times(episode: Episode, every: int) -> list[int]:
    check_integer("every", every, 1)
    times = list(range(0, episode.length + 1, every))
    # The end is the most interesting moment, so it is shown whatever the stride.
    return times if times[-1] == episode.length else [*times, episode.length]
