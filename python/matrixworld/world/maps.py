"""Obstacle maps: from arrays, rows of text, and MovingAI ``.map`` files."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from os import PathLike, fspath
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import shown
from matrixworld._util.files import read_text

MapLike: TypeAlias = "NDArray[np.bool_] | Sequence[str] | str | PathLike[str]"
"""An obstacle map in any form that `read_map` takes."""

FREE = ".GS"
"""Characters of passable terrain (ground, swamp) in a map."""
BLOCKED = "#@OTW"
"""Characters of impassable terrain: walls, out of bounds, trees, water."""


def read_map(source: MapLike) -> NDArray[np.bool_]:
    """Return an obstacle map as a new bool array (rows, cols), True where an obstacle is.

    Parameters
    ----------
    source : array_like of bool, str, sequence of str, or path
        An array of shape (rows, cols) of bools, or of 0 and 1; rows of text with the characters of
        `FREE` and `BLOCKED`, or all rows as one text; or the path of a MovingAI ``.map`` file.

    Raises
    ------
    ValueError, TypeError, FileNotFoundError
        If the map is empty, its rows differ in length, or a character is unknown.

    References
    ----------
    N. R. Sturtevant (2012). Benchmarks for grid-based pathfinding. IEEE Transactions on
    Computational Intelligence and AI in Games 4(2).

    Examples
    --------
    >>> from matrixworld import read_map
    >>> read_map(["..#", "#.."])
    array([[False, False,  True],
           [ True, False, False]])
    """
    if isinstance(source, str) and "\n" in source:
        return _from_rows(source.strip().splitlines(), "map")
    if isinstance(source, str | PathLike):
        return _from_file(Path(fspath(source)))
    if isinstance(source, Sequence) and all(isinstance(row, str) for row in source):
        return _from_rows(list(source), "map")
    array = np.array(None)
    with suppress(ValueError):  # of rows of different lengths
        array = np.asanyarray(source)
    if array.ndim == 0 or array.dtype.kind in "OUS":
        raise TypeError(f"map: expected a path, rows of text or an array, got {shown(source)}")
    return _from_array(array)


def _from_array(array: NDArray[Any]) -> NDArray[np.bool_]:
    if array.dtype.kind not in "biu" or isinstance(array, np.ma.MaskedArray):
        raise TypeError(f"map: expected dtype bool, or 0 and 1, got {array.dtype}")
    if array.ndim != 2 or array.size == 0:
        raise ValueError(f"map: expected shape (rows, cols), got {array.shape}")
    unknown = array[(array != 0) & (array != 1)]
    if unknown.size:
        raise ValueError(f"map: expected 0 (free) or 1 (obstacle), got {unknown[0]}")
    return array.astype(np.bool_)  # a copy: the caller may change its array later


def _from_rows(rows: list[str], name: str) -> NDArray[np.bool_]:
    rows = [row.strip() for row in rows]  # programs leave blanks at the ends of lines
    if not rows or not rows[0]:
        raise ValueError(f"{name}: expected at least one row of at least one cell, got {rows!r}")
    for number, row in enumerate(rows):
        if len(row) != len(rows[0]):
            raise ValueError(
                f"{name}, row {number}: expected {len(rows[0])} cells as in row 0, got {len(row)}"
            )
        unknown = set(row) - set(FREE + BLOCKED)
        if unknown:
            raise ValueError(
                f"{name}, row {number}: expected {FREE!r} (free) or {BLOCKED!r} (obstacle), "
                f"got {sorted(unknown)}"
            )
    return np.array([[cell in BLOCKED for cell in row] for row in rows])


def _from_file(path: Path) -> NDArray[np.bool_]:
    lines = [line.strip() for line in read_text(path, "map").splitlines()]
    lines = [line for line in lines if line]
    header = dict(line.split(maxsplit=1) for line in lines[:3] if len(line.split()) > 1)
    if lines[3:4] != ["map"] or set(header) != {"type", "height", "width"}:
        raise ValueError(
            f"{path}: expected a MovingAI map (lines type, height, width and map), got {lines[:4]}"
        )
    array = _from_rows(lines[4:], str(path))
    sizes = header["height"], header["width"]
    if [int(size) if size.isdecimal() else size for size in sizes] != list(array.shape):
        expected = ", ".join(sizes)
        raise ValueError(f"{path}: expected ({expected}) cells as in its header, got {array.shape}")
    return array
