"""Obstacle maps: from arrays, rows of text, and MovingAI ``.map`` files."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike, fspath
from pathlib import Path
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

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
    source : ndarray of bool, sequence of str, or path
        A NumPy array of dtype bool and shape (rows, cols); rows of text with the characters of
        `FREE` and `BLOCKED`; or the path of a MovingAI ``.map`` file.

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
    if isinstance(source, np.ndarray):
        return _from_array(source)
    if isinstance(source, str | PathLike):
        return _from_file(Path(fspath(source)))
    if isinstance(source, Sequence) and all(isinstance(row, str) for row in source):
        return _from_rows(list(source), "map")
    raise TypeError(f"map: expected a bool array, rows of text or a path, got {source!r}")


def _from_array(array: NDArray[np.bool_]) -> NDArray[np.bool_]:
    if array.dtype != np.bool_:
        raise TypeError(f"map: expected dtype bool, got {array.dtype}")
    if array.ndim != 2 or array.size == 0:
        raise ValueError(f"map: expected shape (rows, cols), got {array.shape}")
    return np.array(array, np.bool_)  # a copy: the caller may change its array later


def _from_rows(rows: list[str], name: str) -> NDArray[np.bool_]:
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
    # A character beyond ASCII is replaced, and then reported as unknown with the number of its row.
    lines = read_text(path, "map", encoding="ascii", errors="replace").rstrip().splitlines()
    header = dict(line.split(maxsplit=1) for line in lines[:3] if len(line.split()) > 1)
    if lines[3:4] != ["map"] or set(header) != {"type", "height", "width"}:
        raise ValueError(
            f"{path}: expected a MovingAI map (lines type, height, width and map), got {lines[:4]}"
        )
    array = _from_rows(lines[4:], str(path))
    expected = f"({header['height'].strip()}, {header['width'].strip()})"
    if str(array.shape) != expected:
        raise ValueError(f"{path}: expected {expected} cells as in its header, got {array.shape}")
    return array
