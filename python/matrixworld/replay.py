"""Watching a recorded episode: in a terminal, as an animation, as a sheet of pictures."""

from __future__ import annotations

import base64
import io
import os
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from matrixworld.episode import Episode
from matrixworld.files import replacing
from matrixworld.render import MARK_STEPS, Scene, ansi, rgb
from matrixworld.render.gif import write_gif
from matrixworld.render.layout import LARGEST_CELL
from matrixworld.render.mp4 import write_mp4
from matrixworld.render.screen import color_mode, fits, play

__all__ = [
    "Animation",
    "Episode",
    "animate_terminal",
    "animation",
    "contact_sheet",
    "save",
    "scene",
]

FRAMES = 120
"""Frames of an animation in a notebook, at most."""
PIXELS = 480
"""The longer side of its field that is aimed at."""
FOV = 11
"""Side of a field of view where an episode does not tell its own."""


def scene(episode: Episode, step: int = -1, *, trail: int = 6, title: str | None = None) -> Scene:
    """What there is to draw after so many steps, from 0; negative numbers count from the end.

    trail: how many steps back the trails of the agents go
    title: by default the step and the share of the evaders that are captured

    Raises IndexError for a step outside the episode.
    """
    now = range(episode.length + 1)[step]
    captures, deaths = _marks(episode, now)
    return Scene(
        positions=episode.last_positions[now],
        alive=episode.alive[now],
        captured=episode.captured[now],
        map=episode.map,
        n_pursuers=episode.n_pursuers,
        involved=episode.involved[now - 1] if now else None,
        fault=episode.fault[now - 1] if now else None,
        trail=episode.positions[max(0, now - trail) : now],
        captures=captures,
        deaths=deaths,
        title=capture_title(episode, now, f"step {now} of {episode.length}")
        if title is None
        else title,
    )


def animate_terminal(
    episode: Episode,
    stream: TextIO | None = None,
    *,
    fps: float = 10.0,
    every: int = 1,
    color: str | None = None,
) -> None:
    """Show an episode in a terminal, in place, until its end or Ctrl-C.

    stream: None for standard output; when it is no terminal, the last moment is printed as
        plain text instead
    fps: drawings a second; every: steps from one to the next
    color: as `render.ansi` takes it; None finds out

    A grid too large for the terminal is drawn in half blocks. Raises ValueError for an fps that
    is not positive and for every below 1.
    """
    if not fps > 0:
        raise ValueError(f"fps: expected more than 0 drawings a second, got {fps}")
    times = _times(episode, every)
    out = sys.stdout if stream is None else stream
    if not out.isatty():
        out.write(ansi(scene(episode), color="none") + "\n")
        return
    mode = color_mode(out) if color is None else color
    compact = mode != "none" and not fits(episode.map.shape, out)
    play((ansi(scene(episode, t), color=mode, compact=compact) for t in times), out, fps=fps)


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
) -> None:
    """Write an episode as the end of the name says: ``.gif``, ``.mp4``, or ``.png`` for one moment.

    fps: frames a second, 0.1 to 50; every: steps from one frame to the next, the last step always
        being shown, and held for `hold` seconds more
    step: which moment a PNG shows, as for `scene`
    cell: pixels per cell; None chooses by the size of the grid
    trail: how many steps back the trails go
    viewers: agents whose fields of view are outlined, by number or name; fov: their side in cells,
        by default that of the episode's world

    The file appears complete or not at all. Raises ValueError for another suffix and for a value
    out of range, ImportError for MP4 without the extra ``video``.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in (".gif", ".mp4", ".png"):
        raise ValueError(f"path: expected a name that ends in .gif, .mp4 or .png, got {path}")
    draw = _artist(episode, cell=cell, trail=trail, fov=fov, viewers=viewers)
    times = _times(episode, every)
    with replacing(path) as file:
        if suffix == ".png":
            Image.fromarray(draw(step)).save(file, "PNG")
        else:
            write = write_gif if suffix == ".gif" else write_mp4
            write(file, draw, times, fps=fps, hold=hold)


@dataclass(frozen=True, repr=False)
class Animation:
    """A GIF that a notebook shows. data: the file's bytes."""

    data: bytes

    def __repr__(self) -> str:
        return f"<Animation: a GIF of {len(self.data) / 1000:.0f} kB>"

    def _repr_html_(self) -> str:
        encoded = base64.b64encode(self.data).decode("ascii")
        return (
            f'<img src="data:image/gif;base64,{encoded}" alt="an episode of pursuit and evasion">'
        )


def animation(
    episode: Episode,
    *,
    fps: float = 10.0,
    every: int | None = None,
    cell: int | None = None,
    trail: int = 6,
    fov: int | None = None,
    viewers: Sequence[int | str] = (),
) -> Animation:
    """What a notebook shows as a moving picture, kept in the notebook itself.

    every: None shows at most `FRAMES` of an episode's steps; cell: None aims at `PIXELS` a side.
    The rest is as for `save`. A long episode on 40 x 40 cells takes 1 MB or so.
    """
    if every is None:
        every = -(-episode.length // FRAMES) or 1
    if cell is None:
        cell = min(max(PIXELS // max(episode.map.shape), 1), LARGEST_CELL)
    draw = _artist(episode, cell=cell, trail=trail, fov=fov, viewers=viewers)
    buffer = io.BytesIO()
    write_gif(buffer, draw, _times(episode, every), fps=fps, hold=2.0)
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
) -> Image.Image:
    """Moments of an episode from first to last, evenly spread, side by side: one picture.

    A notebook shows it. cell, trail, fov, viewers: as for `save`.
    """
    if rows < 1 or cols < 1:
        raise ValueError(f"rows, cols: expected at least 1, got {rows}, {cols}")
    times = np.linspace(0, episode.length, rows * cols).round().astype(int)
    draw = _artist(episode, cell=cell, trail=trail, fov=fov, viewers=viewers)
    pictures = [draw(t) for t in times.tolist()]
    lines = [np.concatenate(pictures[i : i + cols], axis=1) for i in range(0, len(times), cols)]
    return Image.fromarray(np.concatenate(lines))


def _artist(
    episode: Episode,
    *,
    cell: int | None,
    trail: int,
    fov: int | None,
    viewers: Sequence[int | str],
) -> Callable[[int], NDArray[np.uint8]]:
    """How a moment of the episode is drawn."""
    side = int(episode.config.get("fov", FOV)) if fov is None else fov

    def draw(time: int) -> NDArray[np.uint8]:
        return rgb(scene(episode, time, trail=trail), cell=cell, fov=side, viewers=viewers)

    return draw


def _times(episode: Episode, every: int) -> list[int]:
    if every < 1:
        raise ValueError(f"every: expected 1 step or more, got {every}")
    times = list(range(0, episode.length + 1, every))
    return times if times[-1] == episode.length else [*times, episode.length]


def capture_title(episode: Episode, now: int, start: str) -> str:
    """A line of text: ``start``, and how many of the evaders are captured."""
    caught, of = int(episode.counted[now].sum()), episode.n_evaders
    share = f" ({caught / of:.0%})" if of else ""
    return f"{start}    captured {caught} of {of}{share}"


def _marks(episode: Episode, now: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Row, column and age of the captures and of the other deaths of the last steps."""
    captures: list[tuple[int, int, int]] = []
    deaths: list[tuple[int, int, int]] = []
    for step in range(max(1, now - MARK_STEPS + 1), now + 1):
        caught = _newly_captured(episode, step)
        gone = episode.alive[step - 1] & ~episode.alive[step]
        for marks, agents in ((captures, caught), (deaths, gone & ~caught)):
            last_positions = episode.last_positions[step, agents].tolist()
            marks.extend((row, col, now - step) for row, col in last_positions)
    return np.array(captures, int).reshape(-1, 3), np.array(deaths, int).reshape(-1, 3)


def _newly_captured(episode: Episode, step: int) -> NDArray[np.bool_]:
    """``(A,)``: whose first capture was in the step that led to this moment."""
    evaders = episode.ever_captured[step] & ~episode.ever_captured[step - 1]
    return np.concatenate([np.zeros(episode.n_pursuers, bool), evaders])
