"""Frames of an animation: as a GIF, as a film, and as what a notebook shows."""

from __future__ import annotations

import base64
import html
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageColor

from matrixworld._util import colors
from matrixworld.version import imported

# Frames per second; most viewers slow down faster animations.
SLOWEST = 0.1
FASTEST = 50.0
HOLD = 2.0  # seconds for which the last frame is shown longer

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
