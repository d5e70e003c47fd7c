"""Recorded episodes to watch: in a terminal, as an animation, as a picture."""

from __future__ import annotations

import base64
import html
import io
import os
import shutil
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO, TextIO

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageColor
from PIL.PngImagePlugin import PngInfo

from matrixworld._util import checks, colors
from matrixworld._util.files import replacing
from matrixworld.episodes.episode import Episode, scene
from matrixworld.version import imported
from matrixworld.world.canvas import SMALLEST_NUMBERED, fitting_cell
from matrixworld.world.render import Scene, ansi, rgb

__all__ = ["Animation", "animation", "save", "scene"]

SLOWEST, FASTEST = 0.1, 50.0  # frames per second; most viewers slow down faster animations
HOLD = 2.0  # seconds for which the last frame is shown longer
FRAMES = 120  # the most frames of an animation in a notebook
PIXELS = 480  # wanted length of the longer side of its field

Draw = Callable[[int], NDArray[np.uint8]]
"""Takes a time and returns a frame, uint8 (height, width, 3); all have the same, even sides."""

PALETTE_COLORS = 128  # pictures have few hues and their blends; fewer colours compress better
TOO_CLOSE = 8  # levels; Pillow's coarse look-up could confuse a colour this near with one of ours
SAMPLES = 8  # frames looked at to choose the palette


@dataclass(frozen=True, repr=False)
class Animation:
    """A GIF that a notebook shows: `data`, the contents of the file, and `alt`, its text."""

    data: bytes
    alt: str = "an episode"

    def __repr__(self) -> str:
        return f"<Animation: a GIF of {len(self.data) / 1000:.0f} kB>"

    def _repr_html_(self) -> str:
        encoded = base64.b64encode(self.data).decode("ascii")
        return f'<img src="data:image/gif;base64,{encoded}" alt="{html.escape(self.alt)}">'


def animate_terminal(episode: Episode, *, fps: float = 10.0, every: int = 1) -> None:
    """Show an episode in the terminal, in place; without one, print the last moment."""
    fps = checks.check_number("fps", fps, least=0.0, positive=True)
    times, screen = _times(episode, every), Screen(sys.stdout)
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
    times, draw_step = _times(episode, every), _pictures(episode, look)
    with replacing(path) as file:
        if suffix == ".png":
            drawn = PngInfo()
            drawn.add_text("Software", "matrixworld")
            Image.fromarray(draw_step(step)).save(file, "PNG", pnginfo=drawn)
        else:
            write = write_gif if suffix == ".gif" else write_mp4
            write(file, draw_step, times, fps=fps, hold=HOLD)


def animation(
    episode: Episode, *, fps: float = 10.0, every: int | None = None, **look: Any
) -> Animation:
    """Return an animation that a notebook shows, and stores in itself.

    A long episode on 40 x 40 cells takes about 1 MB.

    Takes `episode`, `fps`, `every` and `look` as `save` does. By default it has at most about 120
    frames, and about 480 pixels a side.
    """
    fps = checks.check_number("fps", fps, least=SLOWEST, most=FASTEST)
    # A notebook keeps the animation in its file, so both frames and pixels are limited.
    times, buffer = _times(episode, every), io.BytesIO()
    if look.get("cell") is None:
        least = SMALLEST_NUMBERED if look.get("numbers") else 1
        look["cell"] = fitting_cell(episode.map.shape, PIXELS, least)
    write_gif(buffer, _pictures(episode, look), times, fps=fps, hold=HOLD)
    return Animation(buffer.getvalue())


def _pictures(episode: Episode, look: dict[str, Any]) -> Draw:
    """Return what draws moments of an episode."""
    trail = look.pop("trail", 6)
    return lambda step: rgb(scene(episode, step, trail=trail), **look)


def _times(episode: Episode, every: int | None) -> list[int]:
    """Return the times of frames; the end, the most interesting one, whatever the stride."""
    checks.check_instance("episode", episode, Episode)
    length = episode.length
    default = -(-length // FRAMES) or 1
    stride = default if every is None else checks.check_integer("every", every, 1)
    times = list(range(0, length + 1, stride))
    return times if times[-1] == length else [*times, length]


# Terminals:

# Control sequences of ECMA-48 that practically all terminals know.
HOME, CLEAR, CLEAR_LINE, CLEAR_BELOW = "\x1b[H", "\x1b[2J", "\x1b[K", "\x1b[J"
HIDE_CURSOR, SHOW_CURSOR = "\x1b[?25l", "\x1b[?25h"
WRAP_OFF, WRAP_ON = "\x1b[?7l", "\x1b[?7h"  # off: what is too wide is cut, not broken


class Screen:
    """What text is written to; in a terminal each drawing replaces the one before."""

    def __init__(self, stream: TextIO) -> None:
        self._stream, self._start = stream, WRAP_OFF + CLEAR
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


# Frames of a GIF, and of an MP4 by ffmpeg:


def write_gif(file: BinaryIO, draw: Draw, times: Sequence[int], *, fps: float, hold: float) -> None:
    """Write an endless animation with one frame for each time, and the last one `hold` s longer."""
    looked_at = np.unique(np.linspace(0, len(times) - 1, SAMPLES).round().astype(int))
    palette = _palette([draw(times[i]) for i in looked_at])
    pictures = (
        Image.fromarray(draw(moment)).quantize(palette=palette, dither=Image.Dither.NONE)
        for moment in times
    )
    durations = [10 * round(100 / fps)] * len(times)  # in ms, as whole hundredths of a second
    durations[-1] += round(1000 * hold)
    look: dict[str, Any] = {"duration": durations, "loop": 0, "comment": b"matrixworld"}
    next(pictures).save(file, "GIF", save_all=True, append_images=pictures, **look)


def _palette(pictures: list[NDArray[np.uint8]]) -> Image.Image:
    """Return 256 colours: those of the project exactly, and the most frequent of some pictures."""
    names = [*colors.TEAMS, colors.PAPER, colors.GRID, colors.INK, colors.OBSTACLE]
    names += [colors.CAPTURE, colors.COLLISION]
    exact = np.array([ImageColor.getrgb(name) for name in names])
    together = Image.fromarray(np.concatenate(pictures)).quantize(PALETTE_COLORS - len(exact))
    common = np.array(together.getpalette()).reshape(-1, 3)
    distance = np.abs(common[:, None] - exact).max(axis=2).min(axis=1)
    values = np.concatenate([exact, common[distance > TOO_CLOSE]])[:PALETTE_COLORS]
    filled = np.concatenate([values, np.repeat(exact[:1], 256 - len(values), axis=0)])
    palette = Image.new("P", (1, 1))
    palette.putpalette(filled.ravel().tolist())
    return palette


def write_mp4(file: BinaryIO, draw: Draw, times: Sequence[int], *, fps: float, hold: float) -> None:
    """Write a film (H.264, yuv420p) as `write_gif` does, into an open file that has a name.

    Raises MissingExtraError without imageio-ffmpeg.
    """
    imageio_ffmpeg = imported("imageio_ffmpeg", "video")
    last = draw(times[-1])
    height, width, _ = last.shape
    color_space = "colorspace=bt709:color_primaries=bt709:color_trc=bt709"
    writer = imageio_ffmpeg.write_frames(
        file.name,
        (width, height),
        fps=fps,
        quality=None,
        macro_block_size=2,  # the least that yuv420p needs; a larger one would rescale frames
        ffmpeg_log_level="error",
        output_params=[
            # A browser can start before it has the whole file.
            *("-f", "mp4", "-movflags", "+faststart", "-metadata", "comment=matrixworld"),
            *("-crf", "16", "-tune", "animation"),
            # Without these tags browsers guess the colour space from the height of the film.
            *("-vf", f"scale=out_color_matrix=bt709:out_range=tv,setparams={color_space}"),
        ],
    )
    writer.send(None)
    try:
        for moment in times:
            writer.send(draw(moment).tobytes())
        for _ in range(round(hold * fps)):
            writer.send(last.tobytes())
    finally:
        writer.close()
