"""Files that are complete or refused: atomic writes and locks.

After a crash a directory holds the old file or the new one, never a part of one. Arrays are npz
files, whose zip format finds what is cut or altered. Nothing is pickled or unpickled.
"""

from __future__ import annotations

import io
import json
import os
import re
import secrets
import stat
import sys
import zipfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from importlib.util import find_spec
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import unmasked

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

# Both locks fail at once, instead of waiting, if another process holds them.
if sys.platform == "win32":
    import msvcrt

    def _lock(handle: int) -> None:
        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
elif find_spec("fcntl"):
    import fcntl

    def _lock(handle: int) -> None:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
else:

    def _lock(handle: int) -> None:
        """Do nothing: in a browser no other process sees the files."""


Arrays = dict[str, NDArray[Any]]

TEMPORARY = ".tmp"
"""Suffix of a file that is being written."""

LONGEST = 1000
"""Most characters of a message: it may quote what a file holds."""

KINDS = {stat.S_IFDIR: "a directory", stat.S_IFLNK: "a symbolic link", stat.S_IFIFO: "a FIFO"}
"""Kinds of files that are not regular, by their modes; all others are called devices."""

EXPANDS, MOST_SMALL = 100, 2**26
"""An archive may hold so many times its own bytes, and so many more."""


def load_toml(path: Path) -> dict[str, Any]:
    """Return the values of a TOML file."""
    values: dict[str, Any] = tomllib.loads(path.read_text(encoding="utf-8"))
    return values


class DamagedFileError(ValueError):
    """A file is cut, altered or not of the expected form: its path, and what is wrong with it."""

    def __init__(self, path: Path, problem: str) -> None:
        # All arguments, so that the error can be pickled: it may come from another process.
        super().__init__(path, problem)
        self.path = path

    def __str__(self) -> str:
        path, problem = self.args
        return f"{path}: {one_line(problem)}"


class ArraysOf(Arrays):
    """The arrays of a file: to ask for one that is missing is a DamagedFileError."""

    def __init__(self, path: Path, arrays: Arrays) -> None:
        super().__init__(arrays)
        self.path = path

    def __missing__(self, name: str) -> NDArray[Any]:
        got = ", ".join(self) or "none"
        raise DamagedFileError(self.path, f"expected an array {name!r}, got {got}")


class LockedError(RuntimeError):
    """Another process holds the lock of a directory."""


def one_line(text: object) -> str:
    """Return text that a file may have supplied as one line of printable characters."""
    line = printable(" ".join(str(text).split()))
    return line if len(line) <= LONGEST else f"{line[:LONGEST]} ..."


def sentence_of(error: BaseException) -> str:
    """Return the sentence of an error; that of the system begins with the file."""
    if not (isinstance(error, OSError) and error.strerror):
        return str(error)
    file = "" if error.filename is None else f"{os.fsdecode(error.filename)}: "
    return f"{file}{error.strerror[0].lower()}{error.strerror[1:]}"


def printable(text: object) -> str:
    """Return text in which escapes stand for what a terminal would obey or cannot show."""
    return "".join(
        c if c.isprintable() or c == "\n" else c.encode("unicode_escape").decode()
        for c in str(text)
    )


# Reading:


def check_regular(path: Path, mode: int) -> None:
    """Raise DamagedFileError unless a mode is that of a regular file."""
    if not stat.S_ISREG(mode):
        kind = KINDS.get(stat.S_IFMT(mode), "a device")
        raise DamagedFileError(path, f"expected a file, got {kind}")


def read_content(path: Path) -> bytes:
    """Return the content of a file; DamagedFileError for a directory, FIFO or device."""
    check_regular(path, path.stat().st_mode)
    return path.read_bytes()


def read_text(path: Path, kind: str) -> str:
    """Return the content of a text file in UTF-8, with newlines at the ends of lines."""
    try:
        return re.sub(r"\r\n?", "\n", read_content(path).decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        raise DamagedFileError(path, f"expected a {kind} file of text in UTF-8") from error


def read_json(path: Path, text: str | None = None) -> dict[str, Any]:
    """Return the object in a JSON file, or in a text that it holds, or raise DamagedFileError."""
    content = read_content(path) if text is None else text
    try:
        values = json.loads(content)
    except (RecursionError, ValueError) as error:
        raise DamagedFileError(path, f"cut or altered, expected JSON ({error})") from error
    if not isinstance(values, dict):
        got = type(values).__name__
        raise DamagedFileError(path, f"altered, expected a JSON object, got a {got}")
    return values


def load_arrays(path: Path, content: bytes | None = None) -> Arrays:
    """Return the arrays of an npz file, or of its content; DamagedFileError if it is altered."""
    read = read_archive(path, "npz file", np.lib.format.read_array, content)
    arrays = {name.removesuffix(".npy"): array for name, array in read.items()}
    for name in [name for name in arrays if name.endswith(TEXTS)]:
        lengths = arrays.pop(f"{name}{LENGTHS}", None)
        try:
            arrays[name.removesuffix(TEXTS)] = _split_texts(arrays.pop(name), lengths)
        except (MemoryError, ValueError) as error:
            raise DamagedFileError(path, f"altered, expected texts in {name} ({error})") from error
    return ArraysOf(path, arrays)


def read_archive(
    path: Path, kind: str, read: Callable[[Any], Any], content: bytes | None = None
) -> dict[str, Any]:
    """Return what `read` makes of each part of a zip archive, by the name of the part.

    DamagedFileError if it is cut, altered or encrypted, or if its parts are far larger than the
    archive.
    """
    content = read_content(path) if content is None else content
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            parts = archive.infolist()
            # An altered length in the directory of an archive swallows the entries behind it.
            end = content.rfind(b"PK\5\6")
            if len(parts) != int.from_bytes(content[end + 10 : end + 12], "little"):
                raise zipfile.BadZipFile(f"got {len(parts)} parts, not as many as it counts")
            size, most = sum(part.file_size for part in parts), MOST_SMALL + EXPANDS * len(content)
            if size > most:
                raise zipfile.BadZipFile(f"expected at most {most:,} bytes in it, got {size:,}")
            return {part.filename: read(archive.open(part)) for part in parts if not part.is_dir()}
    except Exception as error:  # zipfile and NumPy raise many kinds for a damaged archive
        raise DamagedFileError(path, f"cut, altered or not an {kind} ({error})") from error


# Writing:


def check_replaceable(path: Path) -> None:
    """Raise FileExistsError for a directory, symbolic link, FIFO or device, such as /dev/null."""
    if os.path.lexists(path) and not stat.S_ISREG(mode := path.lstat().st_mode):
        kind = KINDS.get(stat.S_IFMT(mode), "a device")
        raise FileExistsError(f"{path}: expected a file, got {kind}")


@contextmanager
def replacing(path: str | os.PathLike[str]) -> Iterator[BinaryIO]:
    """Yield a file to write to, which takes its name when it is complete and on the disk.

    An older file of that name is replaced in one step; the new file has its permissions.
    """
    target = Path(path)
    check_replaceable(target)
    # In the same directory: a rename is atomic within one file system only.
    temporary = target.with_name(f".{secrets.token_hex(8)}{TEMPORARY}")
    try:
        with open(temporary, "xb") as file:
            if target.exists():
                os.chmod(temporary, stat.S_IMODE(target.stat().st_mode))
            yield file
            # A rename may survive a power cut that the content does not.
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, target)
        _sync_directory(target.parent)
    except OSError as error:
        # System errors may lack the name, such as that of a full disk.
        if error.errno is not None and error.filename in (None, str(temporary)):
            raise OSError(error.errno, error.strerror, str(path)) from error
        raise
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)


def _sync_directory(path: Path) -> None:
    """Make renames in a directory survive a power cut, where the system can."""
    if sys.platform == "win32":
        return
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def remove_temporary_files(path: Path) -> None:
    """Remove the incomplete files that killed writers left in a directory."""
    for left in path.glob(f".*{TEMPORARY}"):
        left.unlink(missing_ok=True)


TEXTS = ".utf8"
LENGTHS = ".lengths"
"""Ends of the names of two arrays that hold one of genomes that are text, or any of two dimensions:
all texts without gaps, uint8, and how many bytes each takes, in the shape of the array. NumPy gives
every text the room of the longest."""


def _joined_texts(texts: NDArray[np.str_]) -> tuple[NDArray[np.uint8], NDArray[np.int64]]:
    """Return the bytes of texts, one after the other, and their lengths."""
    parts = [text.encode() for text in texts.ravel().tolist()]
    lengths = np.array([len(part) for part in parts], np.int64)
    return np.frombuffer(b"".join(parts), np.uint8), lengths.reshape(texts.shape)


def _split_texts(joined: NDArray[Any], lengths: NDArray[Any] | None) -> NDArray[np.str_]:
    """Return the texts that `_joined_texts` has joined; ValueError if the lengths do not fit."""
    if joined.dtype != np.uint8 or joined.ndim != 1 or lengths is None:
        raise ValueError(f"{joined.dtype} {joined.shape}, or no lengths")
    if lengths.dtype.kind not in "iu" or not lengths.ndim:
        raise ValueError(f"lengths {lengths.dtype} {lengths.shape}")
    content = joined.tobytes()
    # Each is bounded before they are added up, so that no sum is too large.
    fit = not lengths.size or 0 <= lengths.min() <= lengths.max() <= len(content)
    ends = np.cumsum(lengths.astype(np.int64)) if fit else np.array([-1])
    if (int(ends[-1]) if lengths.size else 0) != len(content) or b"\0" in content:
        raise ValueError(f"{len(content)} bytes of {lengths.size} texts")
    pairs = zip(ends.tolist(), lengths.ravel().tolist(), strict=True)
    texts = [content[end - length : end].decode() for end, length in pairs]
    return np.array(texts, np.str_).reshape(lengths.shape)


def save_arrays(path: Path, arrays: Mapping[str, ArrayLike]) -> None:
    """Write named arrays as an npz file; TypeError if one holds objects, which would be pickled."""
    plain: dict[str, Any] = {name: unmasked(name, array) for name, array in arrays.items()}
    for name in [
        name for name, array in plain.items() if array.dtype.kind == "U" and array.ndim > 1
    ]:
        joined, lengths = _joined_texts(plain.pop(name))
        plain |= {f"{name}{TEXTS}": joined, f"{name}{TEXTS}{LENGTHS}": lengths}
    objects = [name for name, array in plain.items() if array.dtype.hasobject]
    if objects:
        raise TypeError(f"{objects[0]}: expected numbers or text, got objects")
    with replacing(path) as file:
        np.savez(file, **plain)


def save_json(path: Path, values: Mapping[str, Any]) -> None:
    """Write a JSON object."""
    # NaN is not JSON: other programs could not read the file.
    text = json.dumps(values, indent=2, allow_nan=False)
    with replacing(path) as file:
        file.write(text.encode() + b"\n")


# Locks:


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Hold the lock file `path` inside the with block, or until the process ends."""
    check_replaceable(path)
    # The file is never removed: a process that still has it open would lock another file than one
    # that makes it anew.
    handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
    try:
        try:
            _lock(handle)
        except (BlockingIOError, PermissionError) as error:
            raise LockedError(f"{path.parent}: another process is running there") from error
        yield
    finally:
        os.close(handle)
