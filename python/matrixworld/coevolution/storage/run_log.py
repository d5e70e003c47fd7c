"""log.csv: one row per epoch, appended, and cut back to the checkpoint on resume."""

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

from matrixworld.coevolution.storage.files import DamagedFileError, naming

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

`opponent` is the generation met (-1: several); `fitness_*` are over the epoch's candidates,
`capture_rate`, `length` and `*_faults` (agent-steps at fault in a collision) means over its
episodes; `matches` and `steps` are the episodes and world steps played so far in training.
"""


SEVERAL = -1
"""In the log, the opponent of candidates that met several."""


class RunLog:
    """The log of a run: a CSV file known by its length and the SHA-256 of its content."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._length = 0
        self._digest = hashlib.sha256()

    @property
    def length(self) -> int:
        """Bytes written."""
        return self._length

    @property
    def checksum(self) -> str:
        """SHA-256 of the bytes written."""
        return self._digest.hexdigest()

    def append(self, rows: Sequence[Row]) -> None:
        """Add rows, with the header before the first, and sync them to the disk."""
        text = io.StringIO()
        writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
        if not self._length:
            writer.writeheader()
        writer.writerows({name: _written(value) for name, value in row.items()} for row in rows)
        content = text.getvalue().encode()
        with naming(self.path), open(self.path, "ab") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        self._digest.update(content)
        self._length += len(content)

    def cut_back(self, length: int, checksum: str) -> None:
        """Drop all after `length` bytes; DamagedFileError unless those have `checksum`."""
        content = _checked(self.path, length, checksum)
        if self.path.exists():
            os.truncate(self.path, length)
        self._length, self._digest = length, hashlib.sha256(content)


def _checked(path: Path, length: int, checksum: str) -> bytes:
    """Return the first `length` bytes of a log; DamagedFileError unless they have `checksum`."""
    content = path.read_bytes()[:length] if path.exists() else b""
    if len(content) < length:
        raise DamagedFileError(path, f"cut: expected {length} bytes, got {len(content)}")
    if hashlib.sha256(content).hexdigest() != checksum:
        raise DamagedFileError(path, "altered, its checksum is not the checkpoint's")
    return content


def _written(value: Any) -> str:
    return f"{value:.9g}" if isinstance(value, float) else str(value)


def read_log(path: Path, length: int, checksum: str) -> dict[str, NDArray[Any]]:
    """Return the columns of the first `length` bytes of a log as arrays.

    DamagedFileError unless those have `checksum` and are rows of a log.
    """
    text = _checked(path, length, checksum).decode(errors="replace")
    rows = list(csv.DictReader(io.StringIO(text, newline="")))
    try:
        return {
            name: np.array([kind(row[name]) for row in rows], dtype=kind)
            for name, kind in COLUMNS.items()
        }
    except (KeyError, TypeError, ValueError) as error:
        raise DamagedFileError(path, f"altered, cannot be read as a log ({error})") from error
