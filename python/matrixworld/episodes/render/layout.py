"""Sizes and places in a picture, in pixels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from matrixworld._util.checks import check_integer, shown

FIELD_PIXELS = 720  # wanted length of the longer side of the field
LARGEST_CELL = 48
SMALLEST_NUMBERED = 20  # cell size in pixels below which the number of an agent is unreadable
NARROWEST = 464  # leaves room for the title above a small grid
LARGEST_SIDE = 8192  # of a picture
MOST_PIXELS = 2**26  # of a picture: 200 MB
MOST_ANIMATED = 2**34  # pixels of all frames: minutes of work, hours on the largest grids


def check_pixels(what: str, pixels: int, most: int) -> None:
    """Raise ValueError if pictures together have more pixels than they may."""
    if pixels > most:
        raise ValueError(f"{what}: expected at most {most:,} pixels in all, got {shown(pixels)}")


def fitting_cell(shape: tuple[int, ...], pixels: int, least: int = 1) -> int:
    """Return the cell size with which the longer side of the field has about so many pixels."""
    return min(max(pixels // max(shape), least), LARGEST_CELL)


@dataclass(frozen=True)
class Layout:
    """Sizes of a picture.

    Parameters
    ----------
    rows, cols : int
        Cells of the grid.
    cell : int
        Pixels per cell.
    """

    margin: ClassVar[int] = 12
    header: ClassVar[int] = 38
    text: ClassVar[int] = 16  # font size

    rows: int
    cols: int
    cell: int

    @classmethod
    def of(cls, shape: tuple[int, int], cell: int | None = None, *, least: int = 1) -> Layout:
        """Return the layout with a given cell size, or with one that suits the grid.

        Raises ValueError if the cell is below the least or the picture would be too large.
        """
        rows, cols = shape
        chosen = fitting_cell(shape, FIELD_PIXELS, least) if cell is None else cell
        if not least <= check_integer("cell", chosen) <= LARGEST_SIDE // max(rows, cols):
            raise ValueError(
                f"cell: expected {least} to {LARGEST_SIDE // max(rows, cols)} pixels "
                f"for {rows} x {cols} cells, got {chosen}"
            )
        return cls(rows, cols, chosen)

    @property
    def pixels(self) -> int:
        """Pixels of the whole picture."""
        return self.width * self.height

    @property
    def width(self) -> int:
        """Width of the whole picture; even, because video needs it."""
        wide = max(self.cols * self.cell + 2 * self.margin, NARROWEST)
        return wide + wide % 2

    @property
    def height(self) -> int:
        """Height of the whole picture; even, because video needs it."""
        high = self.header + self.rows * self.cell + self.margin
        return high + high % 2

    @property
    def field(self) -> tuple[int, int, int, int]:
        """Left and top of the grid, and the first pixels right of it and below it."""
        left = (self.width - self.cols * self.cell) // 2
        return left, self.header, left + self.cols * self.cell, self.header + self.rows * self.cell

    @property
    def agent(self) -> int:
        """Diameter of an agent: most of a cell, but never too small to see."""
        return max(4, round(self.cell * 0.86))

    @property
    def halo(self) -> int:
        """Width of the light border around an agent."""
        return 1 if self.cell >= 8 else 0

    @property
    def stroke(self) -> int:
        """Width of an outline."""
        return 2 if self.cell >= 12 else 1

    def centre(self, row: int, col: int) -> tuple[float, float]:
        """Return x and y of the middle of a cell."""
        left, top, _, _ = self.field
        return left + (col + 0.5) * self.cell, top + (row + 0.5) * self.cell

    def box(self, row0: int, col0: int, row1: int, col1: int) -> tuple[int, int, int, int]:
        """Return left, top, right and bottom of a range of cells, cut to the grid."""
        left, top, right, bottom = self.field
        return (
            max(left, left + col0 * self.cell),
            max(top, top + row0 * self.cell),
            min(right, left + (col1 + 1) * self.cell),
            min(bottom, top + (row1 + 1) * self.cell),
        )
