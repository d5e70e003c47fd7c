"""Small anti-aliased shapes, as masks through which a colour is painted.

A shape is drawn once, `OVERSAMPLING` times too large, then reduced and kept. A frame then costs a
few pastes instead of many drawings.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache

from PIL import Image, ImageDraw, ImageFont

OVERSAMPLING = 8  # Pillow draws without smooth edges; reducing a large drawing makes them
Point = tuple[float, float]


@lru_cache(maxsize=1024)
def shape(name: str, size: int, opacity: float = 1.0) -> Image.Image:
    """Return the mask of a shape: ``size x size`` pixels, 255 times the opacity inside."""
    large = Image.new("L", (size * OVERSAMPLING, size * OVERSAMPLING), 0)
    _SHAPES[name](ImageDraw.Draw(large), size * OVERSAMPLING)
    return large.reduce(OVERSAMPLING).point([round(opacity * level) for level in range(256)])


def stamp(
    canvas: Image.Image, name: str, colour: str, centre: Point, size: int, opacity: float = 1.0
) -> None:
    """Paint a shape in a colour onto the canvas, centred on a point in pixels."""
    corner = (round(centre[0] - size / 2), round(centre[1] - size / 2))
    canvas.paste(colour, corner, shape(name, size, opacity))


@lru_cache(maxsize=64)
def font(size: float) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    """Return the font of Pillow, the same on every machine; the size is in pixels."""
    return ImageFont.load_default(size)


def _disc(draw: ImageDraw.ImageDraw, size: int) -> None:
    draw.ellipse((0, 0, size - 1, size - 1), fill=255)


def _ring(draw: ImageDraw.ImageDraw, size: int) -> None:
    draw.ellipse((0, 0, size - 1, size - 1), outline=255, width=max(1, round(size * 0.11)))


def _thick_ring(draw: ImageDraw.ImageDraw, size: int) -> None:
    draw.ellipse((0, 0, size - 1, size - 1), outline=255, width=max(1, round(size * 0.2)))


def _square(draw: ImageDraw.ImageDraw, size: int) -> None:
    draw.rounded_rectangle((0, 0, size - 1, size - 1), radius=size * 0.12, fill=255)


def _triangle(draw: ImageDraw.ImageDraw, size: int) -> None:
    """Draw it pointing up, with round corners and its centre of mass near the middle."""
    radius = size * 0.09
    corners = [
        (size / 2, size * 0.03 + radius),
        (size - radius, size * 0.93 - radius),
        (radius, size * 0.93 - radius),
    ]
    _rounded_polygon(draw, corners, radius)


def _rounded_polygon(draw: ImageDraw.ImageDraw, corners: list[Point], radius: float) -> None:
    # Pillow has no round corners: thick lines along the sides end in discs.
    draw.polygon(corners, fill=255)
    draw.line([*corners, corners[0]], fill=255, width=round(2 * radius))
    for x, y in corners:
        draw.ellipse((x - radius, y - radius, x + radius, y + radius), fill=255)


def _cross(draw: ImageDraw.ImageDraw, size: int) -> None:
    near, far, width = size * 0.18, size * 0.82, round(size * 0.17)
    draw.line((near, near, far, far), fill=255, width=width)
    draw.line((near, far, far, near), fill=255, width=width)


def _burst(draw: ImageDraw.ImageDraw, size: int) -> None:
    """Draw a star of eight rays."""
    draw.polygon(_burst_corners(size), fill=255)


def _burst_outline(draw: ImageDraw.ImageDraw, size: int) -> None:
    corners = _burst_corners(size)
    draw.line([*corners, corners[0]], fill=255, width=max(1, round(size * 0.028)), joint="curve")


def _burst_corners(size: int) -> list[Point]:
    middle, corners = size / 2, []
    for corner in range(16):
        reach = middle * (0.95 if corner % 2 == 0 else 0.6)
        angle = math.pi * corner / 8
        corners.append((middle + reach * math.sin(angle), middle - reach * math.cos(angle)))
    return corners


_SHAPES: dict[str, Callable[[ImageDraw.ImageDraw, int], None]] = {
    "disc": _disc,
    "ring": _ring,
    "thick ring": _thick_ring,
    "square": _square,
    "triangle": _triangle,
    "cross": _cross,
    "burst": _burst,
    "burst outline": _burst_outline,
}
