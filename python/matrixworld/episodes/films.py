"""Animations and films, frame by frame: GIF, and MP4 by ffmpeg."""

from __future__ import annotations

import base64
import html
import io
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageColor

from matrixworld._util import colors
from matrixworld.version import imported

FRAMES = 120  # the most frames of an animation in a notebook
PIXELS = 480  # wanted length of the longer side of its field

Draw = Callable[[int], NDArray[np.uint8]]
"""Takes a time and returns a frame, uint8 (height, width, 3); all have the same, even sides."""

PALETTE_COLORS = 128  # pictures have few hues and their blends; fewer colours compress better
TOO_CLOSE = 8  # levels; Pillow's coarse look-up could confuse a colour this near with one of ours
UNCHANGED = np.uint8(255)  # palette index of a pixel that stays as it was, written as transparent
SAMPLES = 8  # frames looked at to choose the palette
TRAILER = b";"  # the last byte of a GIF


@dataclass(frozen=True, repr=False)
class Animation:
    """A GIF that a notebook shows.

    Parameters
    ----------
    data : bytes
        The contents of the file.
    alt : str, optional
        What it shows, in words.
    """

    data: bytes
    alt: str = "an episode of pursuit and evasion"

    @classmethod
    def of(cls, draw: Draw, times: Sequence[int], *, fps: float, hold: float) -> Animation:
        """Return one of frames that `draw` returns for times, as `write_gif` takes them."""
        buffer = io.BytesIO()
        write_gif(buffer, draw, times, fps=fps, hold=hold)
        return cls(buffer.getvalue())

    def __repr__(self) -> str:
        return f"<Animation: a GIF of {len(self.data) / 1000:.0f} kB>"

    def _repr_html_(self) -> str:
        encoded = base64.b64encode(self.data).decode("ascii")
        return f'<img src="data:image/gif;base64,{encoded}" alt="{html.escape(self.alt)}">'


def times_of(length: int, every: int) -> list[int]:
    """Return the times of frames; the end, the most interesting one, whatever the stride."""
    times = list(range(0, length + 1, every))
    return times if times[-1] == length else [*times, length]


def few_times(length: int) -> list[int]:
    """Return the times of at most about `FRAMES` frames."""
    return times_of(length, -(-length // FRAMES) or 1)


def write_gif(file: BinaryIO, draw: Draw, times: Sequence[int], *, fps: float, hold: float) -> None:
    """Write an endless animation with one frame for each time, and the last one `hold` s longer.

    Durations are rounded to hundredths of a second. Pillow would keep all frames in memory. Here it
    encodes each as a file of its own, whose header is cut off except for the first.
    """
    looked_at = np.unique(np.linspace(0, len(times) - 1, SAMPLES).round().astype(int))
    palette = _palette([draw(times[i]) for i in looked_at])
    durations = [round(100 / fps)] * len(times)
    durations[-1] += round(100 * hold)
    before: NDArray[np.uint8] | None = None
    for moment, duration in zip(times, durations, strict=True):
        wanted = _indices(draw(moment), palette)
        changes = wanted if before is None else np.where(wanted == before, UNCHANGED, wanted)
        encoded = _encoded(changes, palette, duration)
        file.write(encoded if before is None else encoded[_header_length(encoded) :])
        before = wanted
    file.write(TRAILER)


def _indices(picture: NDArray[np.uint8], palette: Image.Image) -> NDArray[np.uint8]:
    quantized = Image.fromarray(picture).quantize(palette=palette, dither=Image.Dither.NONE)
    numbers = np.array(quantized)
    numbers[numbers >= PALETTE_COLORS] = 0  # unused entries of the palette repeat the first colour
    return numbers


def _encoded(indices: NDArray[np.uint8], palette: Image.Image, duration: int) -> bytes:
    """Return a GIF of one image, without its last byte; the duration is in 1/100 s."""
    image = Image.fromarray(indices)
    image.putpalette(palette.getpalette() or [])
    buffer = io.BytesIO()
    image.save(
        buffer,
        "GIF",
        duration=10 * duration,
        loop=0,
        comment=b"matrixworld",
        transparency=int(UNCHANGED),
        disposal=1,  # the next image is drawn over this one
        optimize=False,  # which would renumber the palette
    )
    return buffer.getvalue().removesuffix(TRAILER)


def _header_length(encoded: bytes) -> int:
    """Return the number of bytes before the image: signature, screen, palette, loop request."""
    flags = encoded[10]
    length = 13 + (3 << ((flags & 7) + 1) if flags & 0x80 else 0)
    while encoded[length : length + 2] in (b"!\xff", b"!\xfe"):  # application, comment
        length += 2
        while encoded[length]:  # blocks, each led by its length, up to an empty one
            length += 1 + encoded[length]
        length += 1
    return length


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
