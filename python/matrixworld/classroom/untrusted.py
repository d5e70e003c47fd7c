"""Files that strangers hand in: limits that are checked before anything is read or expanded.

A file may be no regular file, of any size, and hold anything. Nothing is unpickled, and nothing is
allocated that a file merely claims to hold.
"""

from __future__ import annotations

import io
import math
import os
import stat
import zipfile
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import IO, Any, Literal

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.files import DamagedFileError

MOST_BYTES = {"genome": 8 * 2**20, "program": 2**18}
"""Most bytes of a file: a default genome has 48 kB, one with the published layers 1 MB."""
MOST_UNPACKED = 256 * 2**20
"""Most bytes of the arrays in a compressed file."""
MOST_MEMBERS = 100
"""Most arrays in a file; a genome's has seven."""

_COMPRESSIONS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)  # others may need any memory
_ENTRY = b"PK\x01\x02"  # begin of an entry in the directory of a zip archive
_HEADERS: dict[tuple[int, int], Any] = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}
_NOT_REGULAR = {
    stat.S_IFDIR: "a directory",
    stat.S_IFLNK: "a symbolic link",
    stat.S_IFIFO: "a FIFO",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}
_UNREADABLE = (
    AttributeError,  # another format of NumPy, up to Python 3.10
    EOFError,
    KeyError,
    NotImplementedError,  # another version of the zip format
    OSError,
    OverflowError,
    RecursionError,
    RuntimeError,  # an altered flag of the zip archive
    TypeError,  # another format of NumPy, from Python 3.11 on
    ValueError,
    zipfile.BadZipFile,
    zlib.error,
)
"""What zipfile and NumPy raise while they read a damaged file."""

Form = tuple[str, int]
"""Kinds of dtypes, as ``dtype.kind``, and number of dimensions that an array may have."""


def kind_of_file(mode: int) -> str:
    """Return what a file of a mode is, such as "a FIFO"; empty for a regular one."""
    return "" if stat.S_ISREG(mode) else _NOT_REGULAR.get(stat.S_IFMT(mode), "something else")


def read_content(path: Path, kind: Literal["genome", "program"]) -> bytes:
    """Return the content of a file.

    DamagedFileError if it is not regular or too large, OSError if it cannot be opened.
    """
    # Before it is opened, too: a socket cannot be opened, and opening a device can have effects.
    _check_regular(path, path.stat())
    # Another file may take the name in between, and opening a FIFO must not wait for its writer.
    flags = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
    with open(os.open(path, flags), "rb") as file:
        status = os.fstat(file.fileno())
        _check_regular(path, status)
        most = MOST_BYTES[kind]
        if status.st_size > most:
            raise DamagedFileError(
                path, f"expected at most {most:,} bytes ({kind}), got {status.st_size:,}"
            )
        return file.read(status.st_size)


def _check_regular(path: Path, status: os.stat_result) -> None:
    found = kind_of_file(status.st_mode)
    if found:
        raise DamagedFileError(path, f"expected a regular file, got {found}")


def read_arrays(path: Path, content: bytes, forms: Mapping[str, Form]) -> dict[str, NDArray[Any]]:
    """Return the arrays of these names and forms in the content of an npz file.

    DamagedFileError if one is missing or of another form, or if the file is damaged or too large.
    """
    try:
        if content.count(_ENTRY) > MOST_MEMBERS:
            raise ValueError(f"expected at most {MOST_MEMBERS} arrays, got more")
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            # The archive's directory tells the sizes, and zipfile expands no more than it tells.
            size = sum(member.file_size for member in archive.infolist())
            if size > MOST_UNPACKED:
                raise ValueError(
                    f"expected arrays of at most {MOST_UNPACKED:,} bytes, got {size:,}"
                )
            return {name: _array(archive, name, form) for name, form in forms.items()}
    except _UNREADABLE as error:
        raise DamagedFileError(path, f"cut, altered or not an npz file ({error})") from error


def _array(archive: zipfile.ZipFile, name: str, form: Form) -> NDArray[Any]:
    """Return an array, whose header is checked first."""
    if f"{name}.npy" not in archive.namelist():
        there = ", ".join(each.removesuffix(".npy") for each in archive.namelist())
        raise ValueError(f"expected an array {name!r}, got {there}")
    member = archive.getinfo(f"{name}.npy")
    if member.compress_type not in _COMPRESSIONS:
        raise ValueError(f"{name}: expected deflate or no compression")
    with archive.open(member) as file:
        shape, dtype = _header(file)
        if dtype.kind not in form[0] or len(shape) != form[1]:
            raise ValueError(
                f"{name}: expected dtype of kind {form[0]} and {form[1]} dimensions, got dtype "
                f"{dtype} and shape {shape}"
            )
        # A header may claim any shape: NumPy would allocate it before it reads the numbers.
        claimed, held = math.prod(shape) * dtype.itemsize, member.file_size - file.tell()
        if claimed != held:
            raise ValueError(f"{name}: expected {claimed:,} bytes, got {held:,}")
        file.seek(0)
        array: NDArray[Any] = np.lib.format.read_array(file, allow_pickle=False)
        return array


def _header(file: IO[bytes]) -> tuple[tuple[int, ...], np.dtype[Any]]:
    """Return shape and dtype of an array from its header."""
    version = np.lib.format.read_magic(file)
    if version not in _HEADERS:
        raise ValueError(f"expected an array of version 1.0 or 2.0, got {version}")
    try:
        shape, _, dtype = _HEADERS[version](file)
    except MemoryError:  # of Python's parser, in which the header is deeper than its stack
        raise ValueError("expected the header of an array, got deeper nested text") from None
    return shape, dtype
