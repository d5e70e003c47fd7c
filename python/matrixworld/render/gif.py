"""Pictures as an animated GIF, written frame by frame."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageColor

from matrixworld import colors

Draw = Callable[[int], NDArray[np.uint8]]

PALETTE_COLORS = 128  # few hues and their blends; fewer colours compress better
TOO_CLOSE = 8  # levels; Pillow looks colours up coarsely, so a near one could stand in for ours
UNCHANGED = np.uint8(255)  # palette index of a pixel that stays as it was, written as transparent
SAMPLES = 8  # frames looked at to choose the palette
SLOWEST, FASTEST = 0.1, 50.0  # frames per second; most viewers slow down what is faster
LONGEST_HOLD = 600.0  # seconds; the format has 16 bits for hundredths
TRAILER = b";"  # the last byte of a GIF


def write_gif(file: BinaryIO, draw: Draw, times: Sequence[int], *, fps: float, hold: float) -> None:
    """Write an endless animation whose frames are ``draw(t)``, one for each of the times.

    Every ``draw(t)`` gives ``(height, width, 3)`` uint8 of one size. All frames share a palette.
    The last is shown `hold` seconds longer. Durations are rounded to hundredths of a second.

    Pillow would keep all frames in memory to write such a file; here it encodes one at a time,
    and what it wrote before the first image is left out of all but the first.

    Raises ValueError for no times, and for fps and hold (seconds) out of range.
    """
    check_timing(times, fps=fps, hold=hold)
    palette = _palette([draw(times[i]) for i in _spread(len(times))])
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


def check_timing(times: Sequence[int], *, fps: float, hold: float) -> None:
    """Raise ValueError for no times, and for fps and hold that no viewer would show."""
    if len(times) == 0:
        raise ValueError("times: expected at least one, got none")
    if not SLOWEST <= fps <= FASTEST:
        raise ValueError(f"fps: expected {SLOWEST:g} to {FASTEST:g} a second, got {fps}")
    if not 0 <= hold <= LONGEST_HOLD:
        raise ValueError(f"hold: expected 0 to {LONGEST_HOLD:g} seconds, got {hold}")


def _indices(picture: NDArray[np.uint8], palette: Image.Image) -> NDArray[np.uint8]:
    """The picture in the numbers of the palette, of which the unused ones repeat the first."""
    quantized = Image.fromarray(picture).quantize(palette=palette, dither=Image.Dither.NONE)
    numbers = np.array(quantized)
    numbers[numbers >= PALETTE_COLORS] = 0
    return numbers


def _encoded(indices: NDArray[np.uint8], palette: Image.Image, duration: int) -> bytes:
    """A GIF of one image, shown for hundredths of a second, without the byte that ends it."""
    image = Image.fromarray(indices)
    image.putpalette(palette.getpalette() or [])
    buffer = io.BytesIO()
    image.save(
        buffer,
        "GIF",
        duration=10 * duration,
        loop=0,
        transparency=int(UNCHANGED),
        disposal=1,  # the next image is drawn over this one
        optimize=False,  # which would renumber the palette
    )
    return buffer.getvalue().removesuffix(TRAILER)


def _header_length(encoded: bytes) -> int:
    """Bytes before the image: signature, screen, palette, and the request to loop."""
    flags = encoded[10]
    length = 13 + (3 << ((flags & 7) + 1) if flags & 0x80 else 0)
    while encoded[length : length + 2] in (b"!\xff", b"!\xfe"):  # application, comment
        length += 2
        while encoded[length]:  # blocks, each led by its length, up to an empty one
            length += 1 + encoded[length]
        length += 1
    return length


def _spread(count: int) -> list[int]:
    return sorted(set(np.linspace(0, count - 1, SAMPLES).round().astype(int).tolist()))


def _palette(pictures: list[NDArray[np.uint8]]) -> Image.Image:
    """The most useful colours of some pictures, the project's own exactly, 256 in all."""
    names = [*colors.TEAMS, colors.PAPER, colors.GRID, colors.INK, colors.OBSTACLE]
    exact = np.array([ImageColor.getrgb(name) for name in names])
    together = Image.fromarray(np.concatenate(pictures)).quantize(PALETTE_COLORS - len(exact))
    common = np.array(together.getpalette()).reshape(-1, 3)
    distance = np.abs(common[:, None] - exact).max(axis=2).min(axis=1)
    values = np.concatenate([exact, common[distance > TOO_CLOSE]])[:PALETTE_COLORS]
    filled = np.concatenate([values, np.repeat(exact[:1], 256 - len(values), axis=0)])
    palette = Image.new("P", (1, 1))
    palette.putpalette(filled.ravel().tolist())
    return palette
