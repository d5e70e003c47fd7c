"""Files that are complete or refused: atomic writes, checksums and locks.

`replacing` writes a file under a temporary name in the same directory, syncs and renames it. After
a crash the directory holds the old file or the new one, never a part of one. `save_arrays` and
`save_json` add a SHA-256 of the content and of the owner's name, so that loading refuses a file
that is cut or altered, that belongs to another run, or that has another file's name. Nothing is
pickled. Limits of what is read are in `matrixworld._util.reading`.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
import secrets
import stat
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.reading import (
    LIMITS,
    Arrays,
    DamagedFileError,
    kind_of_file,
    parse_npz,
    read_content,
    read_json,
)

# Both locks fail at once, instead of waiting, if another process holds them.
if sys.platform == "win32":
    import msvcrt

    def _lock(handle: int) -> None:
        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
else:
    import fcntl

    def _lock(handle: int) -> None:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)


CHECKSUM = "sha256"
"""Key of the checksum in a JSON object."""
TEMPORARY = ".tmp"
"""Suffix of a file that is being written."""

SEAL = b"sha256:"
SEAL_LENGTH = len(SEAL) + 64
NO_COMMENT = b"\0\0"
"""Last two bytes of a zip archive without a comment: the length of the comment."""

NO_MATCH = "altered or from another run, its checksum does not match its content"

NO_LINK = getattr(os, "O_NOFOLLOW", 0)
"""Flag to open a file, but not through a symbolic link, where the system has it."""
PERMISSIONS = 0o777
"""Bits of a file's mode that are its permissions."""


class LockedError(RuntimeError):
    """Another process holds the lock of a directory."""


# Writing:


def check_replaceable(path: Path) -> os.stat_result | None:
    """Return the status of a regular file, None if there is no file of that name.

    Raises
    ------
    FileExistsError
        If the name is that of a directory, symbolic link, FIFO or device. None of them is replaced
        or written to: in a directory by others a link may point to any file of the user.
    """
    try:
        status = path.lstat()
    except FileNotFoundError:
        return None
    found = kind_of_file(status.st_mode)
    if found:
        raise FileExistsError(f"{path}: expected a file, got {found}")
    return status


@contextmanager
def naming(path: Path, temporary: Path | None = None) -> Iterator[None]:
    """Add the file's name to system errors that lack it, such as that of a full disk.

    Parameters
    ----------
    path : Path
        The file.
    temporary : Path, optional
        Another name of it, which tells the user nothing.
    """
    try:
        yield
    except OSError as error:
        # An error without a number has a message of the package, which names the file.
        if error.errno is not None and error.filename in (None, str(temporary or path)):
            error.filename, error.filename2 = str(path), None
        raise


@contextmanager
def replacing(path: str | os.PathLike[str], *, keep_as: Path | None = None) -> Iterator[BinaryIO]:
    """Yield a file to write to, which takes its name when it is complete and on the disk.

    Parameters
    ----------
    path : path-like
        Name of the file; an older file of that name is replaced in one step. The new file has its
        permissions.
    keep_as : Path, optional
        New name of the older file. By default it is lost.

    Raises
    ------
    FileExistsError
        If the name is that of a directory, symbolic link, FIFO or device.
    """
    target = Path(path)
    older = check_replaceable(target)
    # In the same directory, because a rename is atomic within one file system only. The name is
    # random, so that writers do not share it, and nobody can put a link there before.
    temporary = target.with_name(f".{secrets.token_hex(8)}{TEMPORARY}")
    with naming(target, temporary):
        # x: a file that must not exist, not even as a link. Its mode is 0o666 without the umask.
        made = open(temporary, "xb")  # noqa: SIM115, closed below, but not removed if it exists
        try:
            with made as file:
                if older is not None:
                    os.chmod(temporary, older.st_mode & PERMISSIONS)
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
        # A directory of such a name is not from this package.
        if is_temporary(left.name) and not stat.S_ISDIR(left.lstat().st_mode):
            left.unlink(missing_ok=True)


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
    ValueError
        If the file would be larger than what is read.
    """
    plain: dict[str, Any] = {name: np.asarray(array) for name, array in arrays.items()}
    for name, array in plain.items():
        if array.dtype.hasobject:
            raise TypeError(f"{name}: expected numbers or text, got dtype {array.dtype}")
    buffer = io.BytesIO()
    np.savez(buffer, **plain)
    _check_size(path, "npz", buffer.tell())
    with replacing(path, keep_as=keep_as) as file:
        file.write(_sealed(buffer.getvalue(), owner))


def load_arrays(path: Path, *, owner: str = "") -> Arrays:
    """Return the arrays that `save_arrays` wrote for the same owner.

    Raises
    ------
    DamagedFileError
        If the file is cut, altered or of another owner.
    """
    content = read_content(path, "npz")
    # Checked before NumPy parses anything: an altered byte may still be a readable array.
    body, seal = content[:-SEAL_LENGTH], content[-SEAL_LENGTH:]
    if not seal.startswith(SEAL):
        raise DamagedFileError(path, "cut or altered, its checksum is missing")
    if seal != _seal(body, owner):
        raise DamagedFileError(path, NO_MATCH)
    return parse_npz(path, content)


def _check_size(path: Path, kind: str, size: int) -> None:
    """Raise ValueError if a file to write would be larger than what is read."""
    if size > LIMITS[kind]:
        raise ValueError(f"{path}: expected at most {LIMITS[kind]:,} bytes ({kind}), got {size:,}")


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
    content = text.encode() + b"\n"
    _check_size(path, "JSON", len(content))
    with replacing(path) as file:
        file.write(content)


def load_json(path: Path, *, owner: str = "") -> dict[str, Any]:
    """Return the object that `save_json` wrote for the same owner.

    Raises
    ------
    DamagedFileError
        If the file is cut, altered or of another owner.
    """
    values = read_json(path)
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
    check_replaceable(path)
    # The file is never removed: a process that still has it open would lock another file than one
    # that makes it anew.
    handle = os.open(path, os.O_RDWR | os.O_CREAT | NO_LINK, 0o644)
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
