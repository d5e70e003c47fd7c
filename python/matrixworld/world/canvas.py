"""What pictures are drawn with: sizes and places in pixels, and small anti-aliased shapes.

A shape is a mask through which a colour is painted. It is drawn once, `OVERSAMPLING` times too
large, then reduced and kept. A frame then costs a few pastes instead of many drawings.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import ClassVar

from PIL import Image, ImageDraw, ImageFont

from matrixworld._util.checks import check_integer

OVERSAMPLING = 8  # Pillow draws without smooth edges; reducing a large drawing makes them
FIELD_PIXELS = 720  # wanted length of the longer side of the field
LARGEST_CELL = 48
SMALLEST_NUMBERED = 20  # cell size in pixels below which the number of an agent is unreadable
NARROWEST = 464  # leaves room for the title above a small grid
LARGEST_SIDE = 8192  # of a picture

Point = tuple[float, float]


def fitting_cell(shape: tuple[int, ...], pixels: int, least: int = 1) -> int:
    """Return the cell size with which the longer side of the field has about so many pixels."""
    return min(max(pixels // max(shape), least), LARGEST_CELL)


@dataclass(frozen=True)
class Layout:
    """Sizes of a picture of rows x cols cells, with `cell` pixels per cell."""

    margin: ClassVar[int] = 12
    header: ClassVar[int] = 38
    text: ClassVar[int] = 16  # font size

    rows: int
    cols: int
    cell: int

    @classmethod
    def of(cls, shape: tuple[int, int], cell: int | None = None, *, least: int = 1) -> Layout:
        """Return the layout with a given cell size, or with one that suits the grid."""
        rows, cols = shape
        given = fitting_cell(shape, FIELD_PIXELS, least) if cell is None else cell
        chosen = check_integer("cell", given)
        if not least <= chosen <= LARGEST_SIDE // max(rows, cols):
            expected = f"{least} to {LARGEST_SIDE // max(rows, cols)} pixels"
            raise ValueError(f"cell: expected {expected} for {rows} x {cols} cells, got {chosen}")
        return cls(rows, cols, chosen)

    @property
    def width(self) -> int:
        """Width of the whole picture, even, as video needs it."""
        wide = max(self.cols * self.cell + 2 * self.margin, NARROWEST)
        return wide + wide % 2

    @property
    def height(self) -> int:
        """Height of the whole picture, even."""
        high = self.header + self.rows * self.cell + self.margin
        return high + high % 2

    @property
    def field(self) -> tuple[int, int, int, int]:
        """Left and top of the grid, and the first pixels right of it and below it."""
        left = (self.width - self.cols * self.cell) // 2
        return left, self.header, left + self.cols * self.cell, self.header + self.rows * self.cell

    def centre(self, row: float, col: float) -> Point:
        """Return x and y of the middle of a cell."""
        left, top, _, _ = self.field
        return left + (col + 0.5) * self.cell, top + (row + 0.5) * self.cell


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


def _ring(thickness: float, draw: ImageDraw.ImageDraw, size: int) -> None:
    draw.ellipse((0, 0, size - 1, size - 1), outline=255, width=max(1, round(size * thickness)))


def _triangle(draw: ImageDraw.ImageDraw, size: int) -> None:
    """Draw it pointing up, with round corners and its centre of mass near the middle."""
    radius = size * 0.09
    top, bottom = size * 0.03 + radius, size * 0.93 - radius
    corners = [(size / 2, top), (size - radius, bottom), (radius, bottom)]
    # Pillow has no round corners: thick lines along the sides end in discs.
    draw.polygon(corners, fill=255)
    draw.line([*corners, corners[0]], fill=255, width=round(2 * radius))
    for x, y in corners:
        draw.ellipse((x - radius, y - radius, x + radius, y + radius), fill=255)


def _cross(draw: ImageDraw.ImageDraw, size: int) -> None:
    near, far, width = size * 0.18, size * 0.82, round(size * 0.17)
    draw.line((near, near, far, far), fill=255, width=width)
    draw.line((near, far, far, near), fill=255, width=width)


def _burst(outline: bool, draw: ImageDraw.ImageDraw, size: int) -> None:
    """Draw a star of eight rays."""
    middle, corners = size / 2, []
    for corner in range(16):
        reach = middle * (0.95 if corner % 2 == 0 else 0.6)
        angle = math.pi * corner / 8
        corners.append((middle + reach * math.sin(angle), middle - reach * math.cos(angle)))
    if outline:
        width = max(1, round(size * 0.028))
        draw.line([*corners, corners[0]], fill=255, width=width, joint="curve")
    else:
        draw.polygon(corners, fill=255)


_SHAPES: dict[str, Callable[[ImageDraw.ImageDraw, int], None]] = {
    "disc": partial(_ring, 0.5),
    "ring": partial(_ring, 0.11),
    "thick ring": partial(_ring, 0.2),
    "triangle": _triangle,
    "cross": _cross,
    "burst": partial(_burst, False),
    "burst outline": partial(_burst, True),
}
