"""Animated GIFs and MP4 films, written frame by frame."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageColor

from matrixworld._util import colors
from matrixworld._util.checks import check_real
from matrixworld.version import imported

Draw = Callable[[int], NDArray[np.uint8]]
"""Takes a time and returns a frame, uint8 (height, width, 3); all have the same, even sides."""

PALETTE_COLORS = 128  # pictures have few hues and their blends; fewer colours compress better
TOO_CLOSE = 8  # levels; Pillow's coarse look-up could confuse a colour this near with one of ours
UNCHANGED = np.uint8(255)  # palette index of a pixel that stays as it was, written as transparent
SAMPLES = 8  # frames looked at to choose the palette
SLOWEST, FASTEST = 0.1, 50.0  # frames per second; most viewers slow down faster animations
LONGEST_HOLD = 600.0  # seconds; the format has 16 bits for hundredths
TRAILER = b";"  # the last byte of a GIF

# A browser can start before it has the whole file.
FORMAT = ("-f", "mp4", "-movflags", "+faststart", "-metadata", "comment=matrixworld")
QUALITY = ("-crf", "16", "-tune", "animation")
# Without these tags browsers guess the colour space from the height of the film.
COLOURS = (
    "-vf",
    "scale=out_color_matrix=bt709:out_range=tv,"
    "setparams=colorspace=bt709:color_primaries=bt709:color_trc=bt709",
)


def write_gif(file: BinaryIO, draw: Draw, times: Sequence[int], *, fps: float, hold: float) -> None:
    """Write an endless animation with one frame for each time, and the last one `hold` s longer.

    Durations are rounded to hundredths of a second. Pillow would keep all frames in memory to write
    such a file. Here it encodes one frame at a time, each as a file of its own, whose header is cut
    off except for the first.
    """
    looked_at = np.unique(np.linspace(0, len(times) - 1, SAMPLES).round().astype(int))
    palette = _palette([draw(times[i]) for i in looked_at])
    durations = [round(100 / fps)] * len(times)
    durations[-1] += round(100 * hold)
    shown: NDArray[np.uint8] | None = None
    for time, duration in zip(times, durations, strict=True):
        wanted = _indices(draw(time), palette)
        changes = wanted if shown is None else np.where(wanted == shown, UNCHANGED, wanted)
        encoded = _encoded(changes, palette, duration)
        file.write(encoded if shown is None else encoded[_header_length(encoded) :])
        shown = wanted
    file.write(TRAILER)


def check_timing(*, fps: float, hold: float) -> None:
    """Raise ValueError if fps or hold is out of range."""
    if not SLOWEST <= check_real("fps", fps) <= FASTEST:
        raise ValueError(f"fps: expected {SLOWEST:g} to {FASTEST:g} a second, got {fps}")
    if not 0 <= check_real("hold", hold) <= LONGEST_HOLD:
        raise ValueError(f"hold: expected 0 to {LONGEST_HOLD:g} seconds, got {hold}")


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
    writer = imageio_ffmpeg.write_frames(
        file.name,
        (width, height),
        fps=fps,
        quality=None,
        macro_block_size=2,  # the least that yuv420p needs; a larger one would rescale frames
        ffmpeg_log_level="error",
        output_params=[*FORMAT, *QUALITY, *COLOURS],
    )
    writer.send(None)
    try:
        for time in times:
            writer.send(draw(time).tobytes())
        for _ in range(round(hold * fps)):
            writer.send(last.tobytes())
    finally:
        writer.close()
