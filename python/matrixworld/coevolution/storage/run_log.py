"""log.csv: one row per epoch, appended, and truncated to the checkpoint on resume."""

from __future__ import annotations

import csv
import hashlib
import io
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.files import NO_LINK, check_replaceable, naming
from matrixworld.reading import DamagedFileError, read_content

Row = dict[str, Any]

COLUMNS: dict[str, type] = {
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

`opponent` is the opponent's generation (-1: several opponents); `fitness_*` are over the
candidates of the epoch; `capture_rate`, `length` and `*_faults` (agent-steps at fault in a
collision) are means over its episodes; `matches` and `steps` are the training episodes and world
steps played so far in the run; matches after the last epoch of a generation, which choose its
champion, count in the row of that epoch.
"""

SEVERAL = -1
"""Value of `opponent` in an epoch with several opponents."""


class RunLog:
    """The log of a run: a CSV file identified by its length and the SHA-256 of its content.

    Parameters
    ----------
    path : Path
        The file; it may not exist yet.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._length = 0
        self._digest = hashlib.sha256()

    @property
    def length(self) -> int:
        """Number of bytes written."""
        return self._length

    @property
    def checksum(self) -> str:
        """SHA-256 of the bytes written, in hexadecimal."""
        return self._digest.hexdigest()

    def append(self, rows: Sequence[Row]) -> None:
        """Append rows, with the header before the first one, and sync the file."""
        text = io.StringIO()
        # The same line ends on all systems, so that checksums are the same, too.
        writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
        if not self._length:
            writer.writeheader()
        writer.writerows({name: _written(value) for name, value in row.items()} for row in rows)
        content = text.getvalue().encode()
        check_replaceable(self.path)
        with naming(self.path), open(self.path, "ab", opener=_opener) as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        # Last: after a failed write, length and checksum are still those of intact rows.
        self._digest.update(content)
        self._length += len(content)

    def truncate(self, length: int, checksum: str) -> None:
        """Remove everything after the first `length` bytes.

        Raises
        ------
        DamagedFileError
            If these bytes are not there or do not have `checksum`.
        """
        content = _checked(self.path, length, checksum)
        if check_replaceable(self.path):
            os.truncate(self.path, length)
        self._length, self._digest = length, hashlib.sha256(content)


def _checked(path: Path, length: int, checksum: str) -> bytes:
    """Return the first `length` bytes of a log; DamagedFileError unless they have `checksum`."""
    content = read_content(path, "log", length) if path.exists() else b""
    if len(content) < length:
        raise DamagedFileError(
            path, f"cut or older than the checkpoint: expected {length} bytes, got {len(content)}"
        )
    if hashlib.sha256(content).hexdigest() != checksum:
        raise DamagedFileError(path, "altered, its checksum is not the one in the checkpoint")
    return content


def _opener(path: str, flags: int) -> int:
    # Not through a symbolic link, which may point to any file of the user.
    return os.open(path, flags | NO_LINK, 0o666)


def _written(value: Any) -> str:
    # Nine digits identify every float32.
    return f"{value:.9g}" if isinstance(value, float) else str(value)


def read_log(path: Path, length: int, checksum: str) -> dict[str, NDArray[Any]]:
    """Return the columns of the first `length` bytes of a log as arrays.

    Parameters
    ----------
    path : Path
        The file.
    length : int
        Bytes to read; a run that is still training may have appended more.
    checksum : str
        SHA-256 of these bytes, in hexadecimal.

    Returns
    -------
    dict of str to ndarray, each of shape (rows,)
        One array for each of `COLUMNS`.

    Raises
    ------
    DamagedFileError
        If the bytes do not have `checksum` or are not rows of a log.
    """
    # Bytes that are not text are not refused here, but below, as rows that cannot be read.
    text = _checked(path, length, checksum).decode(errors="replace")
    try:
        rows = list(csv.DictReader(io.StringIO(text, newline="")))
        return {
            name: np.array([kind(row[name]) for row in rows], dtype=kind)
            for name, kind in COLUMNS.items()
        }
    except (KeyError, OverflowError, TypeError, ValueError, csv.Error) as error:
        raise DamagedFileError(path, f"altered, cannot be read as a log ({error})") from error
