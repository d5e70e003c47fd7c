"""Files that are complete or refused: atomic writes, checksums and locks.

`replacing` writes a file under a temporary name in the same directory, syncs and renames it. After
a crash the directory holds the old file or the new one, never a part of one. `save_arrays` and
`save_json` add a SHA-256 of the content and of the owner's name, so that loading refuses a file
that is cut or altered, that belongs to another run, or that has another file's name. Nothing is
pickled.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
import sys
import zipfile
import zlib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import ArrayLike, NDArray

# Both locks fail at once, instead of waiting, if another process holds them.
if sys.platform == "win32":
    import msvcrt

    def _lock(handle: int) -> None:
        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
else:
    import fcntl

    def _lock(handle: int) -> None:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)


Arrays = dict[str, NDArray[Any]]

CHECKSUM = "sha256"
"""Key of the checksum in a JSON object."""
TEMPORARY = ".tmp"
"""Suffix of a file that is being written."""

SEAL = b"sha256:"
SEAL_LENGTH = len(SEAL) + 64
NO_COMMENT = b"\0\0"
"""Last two bytes of a zip archive without a comment: the length of the comment."""

NO_MATCH = "altered or from another run, its checksum does not match its content"

UNREADABLE = (
    AttributeError,  # another format of NumPy, up to Python 3.10
    EOFError,
    KeyError,
    OSError,
    RuntimeError,  # an altered flag of the zip archive
    TypeError,  # another format of NumPy, from Python 3.11 on
    ValueError,  # pickled objects, among others
    zipfile.BadZipFile,
    zlib.error,
)
"""What NumPy raises while it reads a damaged .npz file."""


class DamagedFileError(ValueError):
    """A file is cut, altered or not of the expected form.

    Parameters
    ----------
    path : Path
        The file.
    problem : str
        What is wrong with it.
    """

    def __init__(self, path: Path, problem: str) -> None:
        super().__init__(f"{path}: {problem}")
        self.path = path


class LockedError(RuntimeError):
    """Another process holds the lock of a directory."""


# Writing:


@contextmanager
def naming(path: Path) -> Iterator[None]:
    """Add the file's name to system errors that lack it, such as that of a full disk."""
    try:
        yield
    except OSError as error:
        if error.filename is None:
            error.filename = str(path)
        raise


@contextmanager
def replacing(path: str | os.PathLike[str], *, keep_as: Path | None = None) -> Iterator[BinaryIO]:
    """Yield a file to write to, which takes its name when it is complete and on the disk.

    Parameters
    ----------
    path : path-like
        Name of the file; an older file of that name is replaced in one step.
    keep_as : Path, optional
        New name of the older file. By default it is lost.
    """
    target = Path(path)
    # In the same directory, because a rename is atomic within one file system only. The number of
    # the process separates writers that do not lock the directory.
    temporary = target.with_name(f".{target.name}.{os.getpid()}{TEMPORARY}")
    with naming(target):
        try:
            with open(temporary, "wb") as file:
                yield file
                # The content must be on the disk before the name is: a rename may survive a power
                # cut that the content does not.
                file.flush()
                os.fsync(file.fileno())
            # After a crash between these two renames there is no `target`, but there is `keep_as`.
            if keep_as is not None and target.exists():
                os.replace(target, keep_as)
            os.replace(temporary, target)
        finally:
            temporary.unlink(missing_ok=True)
        _sync_directory(target.parent)


def _sync_directory(path: Path) -> None:
    """Make renames in a directory survive a power cut, where the system can."""
    if sys.platform == "win32":
        return
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def is_temporary(name: str) -> bool:
    """Return whether `name` is that of a file that is being written."""
    return name.startswith(".") and name.endswith(TEMPORARY)


def remove_temporary_files(path: Path) -> None:
    """Remove the incomplete files that killed writers left in a directory."""
    for left in path.iterdir():
        if is_temporary(left.name):
            left.unlink()


# Arrays:


def save_arrays(
    path: Path, arrays: Mapping[str, ArrayLike], *, owner: str = "", keep_as: Path | None = None
) -> None:
    """Write named arrays as an .npz file that carries its checksum.

    Parameters
    ----------
    path : Path
        The file.
    arrays : mapping of str to array_like
        Arrays of numbers or text, by name.
    owner : str, optional
        Name of the owner, such as a run. Loading requires the same.
    keep_as : Path, optional
        As in `replacing`.

    Raises
    ------
    TypeError
        If an array holds objects, which would be pickled.
    """
    plain: dict[str, Any] = {name: np.asarray(array) for name, array in arrays.items()}
    for name, array in plain.items():
        if array.dtype.hasobject:
            raise TypeError(f"{name}: expected numbers or text, got dtype {array.dtype}")
    buffer = io.BytesIO()
    np.savez(buffer, **plain)
    with replacing(path, keep_as=keep_as) as file:
        file.write(_sealed(buffer.getvalue(), owner))


def load_arrays(path: Path, *, owner: str = "") -> Arrays:
    """Return the arrays that `save_arrays` wrote for the same owner.

    Raises
    ------
    DamagedFileError
        If the file is cut, altered or of another owner.
    """
    content = path.read_bytes()
    # Checked before NumPy parses anything: an altered byte may still be a readable array.
    body, seal = content[:-SEAL_LENGTH], content[-SEAL_LENGTH:]
    if not seal.startswith(SEAL):
        raise DamagedFileError(path, "cut or altered, its checksum is missing")
    if seal != _seal(body, owner):
        raise DamagedFileError(path, NO_MATCH)
    return _arrays_of(path, content)


def read_arrays(path: Path) -> Arrays:
    """Return the arrays of any .npz file, with a checksum or without.

    Raises
    ------
    DamagedFileError
        If the file cannot be read without unpickling.
    """
    return _arrays_of(path, path.read_bytes())


def _arrays_of(path: Path, content: bytes) -> Arrays:
    # From memory: NumPy leaves a damaged file open.
    try:
        with np.load(io.BytesIO(content), allow_pickle=False) as file:
            return {name: file[name] for name in file.files}
    except UNREADABLE as error:
        raise DamagedFileError(path, f"cut, altered or not an npz file ({error})") from error


def _sealed(archive: bytes, owner: str) -> bytes:
    """Add the checksum to a zip archive as its comment, which every reader of zip files skips."""
    body = archive[: -len(NO_COMMENT)] + SEAL_LENGTH.to_bytes(2, "little")
    return body + _seal(body, owner)


def _seal(body: bytes, owner: str) -> bytes:
    digest = hashlib.sha256(owner.encode())
    digest.update(body)
    return SEAL + digest.hexdigest().encode()


# JSON:


def save_json(path: Path, values: Mapping[str, Any], *, owner: str = "") -> None:
    """Write a JSON object that carries its checksum; `owner` is as in `save_arrays`."""
    # NaN is not JSON: other programs could not read the file.
    text = json.dumps({**values, CHECKSUM: json_digest(values, owner)}, indent=2, allow_nan=False)
    with replacing(path) as file:
        file.write(text.encode() + b"\n")


def load_json(path: Path, *, owner: str = "") -> dict[str, Any]:
    """Return the object that `save_json` wrote for the same owner.

    Raises
    ------
    DamagedFileError
        If the file is cut, altered or of another owner.
    """
    try:
        values = json.loads(path.read_bytes())
    except ValueError as error:
        raise DamagedFileError(path, f"cut or altered, cannot be read ({error})") from error
    if not isinstance(values, dict):
        raise DamagedFileError(path, "altered, expected a JSON object")
    if values.pop(CHECKSUM, None) != json_digest(values, owner):
        raise DamagedFileError(path, NO_MATCH)
    return values


def json_digest(values: Mapping[str, Any], owner: str = "") -> str:
    """Return the checksum, 64 hexadecimal digits, of a JSON object of `owner`."""
    # Of the values only: their order and the layout of the file may change.
    content = json.dumps(values, sort_keys=True).encode()
    return hashlib.sha256(owner.encode() + content).hexdigest()


# Locks:


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Hold the lock file `path` inside the with block.

    Raises
    ------
    LockedError
        If another process holds it.

    Notes
    -----
    The system releases the lock when the process ends, even if it is killed.
    """
    # The file is never removed: a process that still has it open would lock another file than one
    # that makes it anew.
    handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
    try:
        try:
            _lock(handle)
        except (BlockingIOError, PermissionError) as error:
            raise LockedError(f"{path.parent}: another process is running there") from error
        except OSError as error:
            error.filename = str(path)  # a file system without locks does not name the file
            raise
        yield
    finally:
        os.close(handle)
