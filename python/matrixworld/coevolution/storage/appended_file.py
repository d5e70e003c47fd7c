"""Files that only grow: what a checkpoint has counted stays as it is, and is checked.

The log and the genomes of a run are such files. A checkpoint states how many bytes of each belong
to it, and their checksum. What follows them was written by a process that was stopped before its
next checkpoint; it is not read, and removed when the run is resumed. A file that grows costs the
same for every generation, while one that is written whole costs more for each.
"""

from __future__ import annotations

import hashlib
import os
from pathlib import Path
from typing import NamedTuple

from matrixworld._util.files import NO_LINK, check_replaceable, naming
from matrixworld._util.reading import DamagedFileError, read_content


class Position(NamedTuple):
    """How much of a file a checkpoint has counted.

    Parameters
    ----------
    length : int
        Number of bytes, without the head of the file.
    checksum : str
        SHA-256 of these bytes, in hexadecimal.
    """

    length: int
    checksum: str


class AppendedFile:
    """A file that grows, identified by the length and the SHA-256 of its content.

    Parameters
    ----------
    path : Path
        The file; it may not exist yet.
    kind : str
        Key in `matrixworld._util.reading.LIMITS`.
    head : int, optional
        Bytes at the begin of the file that are no content, because they are rewritten. By default
        none.
    """

    def __init__(self, path: Path, kind: str, head: int = 0) -> None:
        self.path, self.kind, self.head = path, kind, head
        self._length = 0
        self._digest = hashlib.sha256()

    @property
    def position(self) -> Position:
        """Length and checksum of the content."""
        return Position(self._length, self._digest.hexdigest())

    def append(self, content: bytes, *, head: bytes = b"") -> None:
        """Append content, and the head before it if it is given, and sync the file."""
        check_replaceable(self.path)
        with naming(self.path), open(self.path, "ab", opener=_opener) as file:
            file.write(head + content)
            file.flush()
            os.fsync(file.fileno())
        # Last: after a failed write, length and checksum are still those of intact content.
        self._digest.update(content)
        self._length += len(content)

    def rewrite_head(self, head: bytes) -> None:
        """Replace the head in place, in one write, and sync the file."""
        check_replaceable(self.path)
        # Not buffered: one system call, which is not interrupted, within one sector of a disk.
        with naming(self.path), open(self.path, "r+b", buffering=0, opener=_opener) as file:
            file.write(head)
            os.fsync(file.fileno())

    def read(self, position: Position) -> bytes:
        """Return the content up to a position.

        Raises
        ------
        DamagedFileError
            If the file is shorter, or the content has another checksum.
        """
        expected = self.head + position.length
        content = read_content(self.path, self.kind, expected) if self.path.exists() else b""
        if len(content) < expected:
            raise too_short(self.path, expected, len(content))
        content = content[self.head :]
        if hashlib.sha256(content).hexdigest() != position.checksum:
            problem = "altered or from another run, its checksum is not the one in the checkpoint"
            raise DamagedFileError(self.path, problem)
        return content

    def truncate(self, position: Position) -> None:
        """Remove everything after a position; DamagedFileError as `read`."""
        content = self.read(position)
        if check_replaceable(self.path):
            with naming(self.path):
                os.truncate(self.path, self.head + position.length)
        self._length, self._digest = position.length, hashlib.sha256(content)


def too_short(path: Path, expected: int, found: int) -> DamagedFileError:
    """Return the error for a file with fewer bytes than its checkpoint has counted."""
    problem = f"cut or older than the checkpoint: expected {expected} bytes, got {found}"
    return DamagedFileError(path, problem)


def _opener(path: str, flags: int) -> int:
    # Not through a symbolic link, which may point to any file of the user.
    return os.open(path, flags | NO_LINK, 0o666)
