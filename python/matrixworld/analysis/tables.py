"""Payoffs in CSV files: a matrix, or one line for each pair or episode."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path

import numpy as np

from matrixworld._util.reading import DamagedFileError, read_text
from matrixworld.analysis.payoff import Rates

Line = tuple[int, list[str]]
"""Line number in the file, from 1, and cells."""

_LONG = ("pursuer", "evader", "capture_rate")
_KEYS = ("run", "pursuer", "evader", "episode")


def read_table(path: Path) -> tuple[Rates, bool]:
    """Read the capture rates of a CSV file.

    Parameters
    ----------
    path : pathlib.Path
        The file. Empty lines and lines that begin with ``#`` are skipped.

    Returns
    -------
    rates : ndarray of float64
        Shape (n, m) or (runs, n, m); with episodes one more dimension, the last.
    episodes : bool
        Whether the last dimension is episodes.

    Raises
    ------
    ValueError
        If the file has another format; the message names file and line. As DamagedFileError if it
        is not a regular file, not text, or has more than 64 MiB.
    FileNotFoundError
        If the file does not exist.

    Notes
    -----
    The file has one of two formats:

    - A matrix: line g holds the capture rates of pursuers g against evaders 0, 1, ... A first line
      that is not numbers is a header. If its first cell is empty, the first cell of each line is a
      label.
    - One line for each pair: a header with ``pursuer, evader, capture_rate`` in any order, and
      ``run`` or ``episode`` if there are several. Generations, runs and episodes are whole numbers
      and are sorted; every combination has one line. Other columns are ignored.
    """
    lines = _lines(path)
    names = [cell.lower() for cell in lines[0][1]]
    if set(_LONG) <= set(names):
        return _long(path, names, lines[1:])
    return _matrix(path, lines), False


def _lines(path: Path) -> list[Line]:
    # utf-8-sig: spreadsheets write a byte order mark.
    text = io.StringIO(read_text(path, "CSV", encoding="utf-8-sig"), newline="")
    try:
        rows = [(i, [cell.strip() for cell in row]) for i, row in enumerate(csv.reader(text), 1)]
    except csv.Error as error:
        raise DamagedFileError(path, f"expected a CSV file of text, got: {error}") from error
    # Line numbers of the file are kept for error messages.
    kept = [(i, row) for i, row in rows if any(row) and not row[0].startswith("#")]
    if not kept:
        raise ValueError(f"{path}: expected a table of capture rates, got no lines")
    return kept


def _matrix(path: Path, lines: list[Line]) -> Rates:
    header = lines[0][1]
    labelled = header[0] == ""
    # A header is recognised by a cell that is not a number.
    body = lines if all(_is_number(cell) for cell in header) else lines[1:]
    if not body:
        raise ValueError(f"{path}: expected lines of capture rates, got a header only")
    width = len(body[0][1])
    for number, row in body:
        if len(row) != width:
            raise ValueError(
                f"{path}, line {number}: expected {width} cells as in the lines before, "
                f"got {len(row)}"
            )
    start = 1 if labelled else 0
    return np.array([[_number(path, i, cell) for cell in row[start:]] for i, row in body])


def _long(path: Path, names: list[str], lines: list[Line]) -> tuple[Rates, bool]:
    keys = [key for key in _KEYS if key in names]
    places, place = [names.index(key) for key in keys], names.index("capture_rate")
    found: dict[tuple[int, ...], float] = {}
    for number, row in lines:
        if len(row) != len(names):
            raise ValueError(
                f"{path}, line {number}: expected {len(names)} cells as in the header, "
                f"got {len(row)}"
            )
        key = tuple(_whole(path, number, row[i]) for i in places)
        if key in found:
            raise ValueError(
                f"{path}, line {number}: expected {_combination(keys, key)} once, got it twice"
            )
        found[key] = _number(path, number, row[place])
    return _cube(path, keys, found), "episode" in keys


def _cube(path: Path, keys: list[str], found: dict[tuple[int, ...], float]) -> Rates:
    if not found:
        raise ValueError(f"{path}: expected lines of capture rates, got a header only")
    # Numbers of generations may start anywhere; their ranks are the indices.
    axes, inverse = zip(
        *(np.unique(column, return_inverse=True) for column in np.array(list(found)).T), strict=True
    )
    cube = np.full([len(axis) for axis in axes], np.nan)
    # A mask of its own, so that missing combinations are found without looking for NaN.
    given = np.zeros(cube.shape, dtype=bool)
    cube[inverse], given[inverse] = list(found.values()), True
    missing = np.argwhere(~given)
    if len(missing):
        key = tuple(int(axis[i]) for axis, i in zip(axes, missing[0], strict=True))
        raise ValueError(
            f"{path}: expected a line for every combination, got none for {_combination(keys, key)}"
        )
    return cube


def _combination(keys: list[str], key: tuple[int, ...]) -> str:
    return ", ".join(f"{name} {value}" for name, value in zip(keys, key, strict=True))


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True


def _number(path: Path, line: int, cell: str) -> float:
    if not _is_number(cell):
        raise ValueError(f"{path}, line {line}: expected a capture rate, got {cell!r}")
    # Checked here as well as in `check_rates`, where the line number is not known any more.
    value = float(cell)
    if math.isnan(value) or not 0.0 <= value <= 1.0:
        raise ValueError(f"{path}, line {line}: expected a capture rate in [0, 1], got {cell}")
    return value


def _whole(path: Path, line: int, cell: str) -> int:
    try:
        return int(cell)
    except ValueError:
        raise ValueError(f"{path}, line {line}: expected a whole number, got {cell!r}") from None
