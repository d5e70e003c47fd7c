"""log.csv: one row per epoch, appended, and truncated to the checkpoint on resume."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.reading import DamagedFileError, read_content
from matrixworld.coevolution.storage.appended_file import AppendedFile, Position

Row = dict[str, Any]

COLUMNS: dict[str, type] = {
    "stage": int,
    "generation": int,
    "team": str,
    "epoch": int,
    "opponent": int,
    "fitness_mean": float,
    "fitness_std": float,
    "fitness_best": float,
    "capture_rate": float,
    "length": float,
    "pursuer_faults": float,
    "evader_faults": float,
    "matches": int,
    "steps": int,
}
"""Columns of the log and their types.

`stage` counts the stages of the run from 1, and a checkpoint is saved at the end of each;
`opponent` is the opponent's generation (-1: several opponents); `fitness_*` are over the candidates
of the epoch; `capture_rate`, `length` and `*_faults` (agent-steps at fault in a collision) are
means over its episodes; `matches` and `steps` are the training episodes and world steps played so
far in the run; matches after the last epoch of a generation, which choose its champion, count in
the row of that epoch.
"""

HEADER = ",".join(COLUMNS).encode() + b"\n"

SEVERAL = -1
"""Value of `opponent` in an epoch with several opponents."""


class RunLog:
    """The log of a run: a CSV file that grows.

    Parameters
    ----------
    path : Path
        The file; it may not exist yet.
    """

    def __init__(self, path: Path) -> None:
        self._file = AppendedFile(path, "log")

    @property
    def position(self) -> Position:
        """Length and checksum of the bytes written."""
        return self._file.position

    def append(self, rows: Sequence[Row]) -> None:
        """Append rows, with the header before the first one, and sync the file."""
        text = io.StringIO()
        # The same line ends on all systems, so that checksums are the same, too.
        writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
        if not self.position.length:
            writer.writeheader()
        writer.writerows({name: _written(value) for name, value in row.items()} for row in rows)
        self._file.append(text.getvalue().encode())

    def check(self, position: Position) -> None:
        """Raise DamagedFileError unless the log up to a position is what was written."""
        self._file.read(position)

    def truncate(self, position: Position) -> None:
        """Remove everything after a position; DamagedFileError as `check`."""
        self._file.truncate(position)


def rows_after(path: Path, position: Position) -> bytes:
    """Return the rows of a log after a position, without the header; the last may be cut.

    Parameters
    ----------
    path : Path
        The file; without it there are no rows.
    position : Position
        As of a checkpoint.
    """
    after = read_content(path, "log", start=position.length) if path.exists() else b""
    if position.length:
        return after
    # A part of the header holds no row.
    return b"" if HEADER.startswith(after) else after.removeprefix(HEADER)


def _written(value: Any) -> str:
    # Nine digits identify every float32.
    return f"{value:.9g}" if isinstance(value, float) else str(value)


def read_log(path: Path, position: Position) -> dict[str, NDArray[Any]]:
    """Return the columns of a log up to a position as arrays.

    Parameters
    ----------
    path : Path
        The file.
    position : Position
        Bytes to read, and their checksum; a run that is still training may have appended more.

    Returns
    -------
    dict of str to ndarray, each of shape (rows,)
        One array for each of `COLUMNS`.

    Raises
    ------
    DamagedFileError
        If the bytes do not have the checksum or are not rows of a log.
    """
    # Bytes that are not text are not refused here, but below, as rows that cannot be read.
    text = AppendedFile(path, "log").read(position).decode(errors="replace")
    try:
        rows = list(csv.DictReader(io.StringIO(text, newline="")))
        return {
            name: np.array([kind(row[name]) for row in rows], dtype=kind)
            for name, kind in COLUMNS.items()
        }
    except (KeyError, OverflowError, TypeError, ValueError, csv.Error) as error:
        raise DamagedFileError(path, f"altered, cannot be read as a log ({error})") from error
