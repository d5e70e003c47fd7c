"""Files that others may have made: limits that are checked before anything is read or expanded.

Every reader of the package begins with one of four functions. `read_content` refuses what is not a
regular file, or is too large for its kind; `read_json`, `read_text` and `read_npz` call it.
`check_arrays` then compares names, dtypes and shapes of arrays with what a file has to hold. All
of them raise `DamagedFileError`. Nothing is unpickled.
"""

from __future__ import annotations

import io
import json
import math
import os
import stat
import zipfile
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

Arrays = dict[str, NDArray[Any]]

MIB = 2**20

LIMITS = {
    "JSON": 16 * MIB,  # 3 kB for settings; a byte for each cell of a fixed map: 4000 x 4000 cells
    "map": 16 * MIB,  # the same map in a file
    "CSV": 64 * MIB,  # 25 races of 31 x 31 pairs with 100 episodes each, one line an episode
    "log": 4096 * MIB,  # 110 bytes an epoch: 39 million epochs
    "npy": 4096 * MIB,  # 14 MB for 300 generations of a team
    "npz": 4096 * MIB,  # 8 MB for the payoff of 100 generations with 100 episodes of each pair
    "genome": 8 * MIB,  # 48 kB for a default genome; 1 MB with the published hidden layers
    "program": MIB // 4,  # a policy that a student wrote takes some kB
}
"""Most bytes of a file, by kind: about a thousand times what the package's own runs write."""
UNPACKED = 256 * MIB
"""Most bytes of the arrays in a compressed npz file; files with larger ones are not compressed."""
MEMBERS = 10_000
"""Most arrays in an npz file. A checkpoint has about a hundred."""
DEPTH = 64
"""Most levels of lists and objects in a JSON file. Those of the package have six."""

KINDS = "biufcSU"
"""Kinds of dtypes that are read: numbers and text."""
COMPRESSIONS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
"""The ways in which NumPy writes npz files; others may need memory without limit."""
ENTRY = b"PK\x01\x02"
"""Begin of an entry in the directory of a zip archive. Data hold it by chance once in 4 GiB."""
HEADERS: dict[tuple[int, int], Any] = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}
"""Readers of the header of an array, by its version."""

NOT_REGULAR = {
    stat.S_IFDIR: "a directory",
    stat.S_IFLNK: "a symbolic link",
    stat.S_IFIFO: "a FIFO",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}

UNREADABLE = (
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
"""What zipfile and NumPy raise while they read a damaged npz file."""

LONGEST = 1000
"""Most characters of a message: it may quote what a file holds."""


class DamagedFileError(ValueError):
    """A file is cut, altered, too large or not of the expected form.

    Parameters
    ----------
    path : Path
        The file.
    problem : str
        What is wrong with it.
    """

    def __init__(self, path: Path, problem: str) -> None:
        # All arguments, so that the error can be pickled: it may come from another process.
        super().__init__(path, problem)
        self.path = path

    def __str__(self) -> str:
        path, problem = self.args
        return f"{path}: {one_line(problem)}"


def one_line(text: object) -> str:
    """Return text that a file may have supplied as one line of printable characters."""
    line = "".join(c if c.isprintable() else "?" for c in " ".join(str(text).split()))
    return line if len(line) <= LONGEST else f"{line[:LONGEST]} ..."


def kind_of_file(mode: int) -> str:
    """Return what a file is that is not a regular one, such as "a FIFO"; empty for a regular one.

    Parameters
    ----------
    mode : int
        ``st_mode`` of the file.
    """
    return "" if stat.S_ISREG(mode) else NOT_REGULAR.get(stat.S_IFMT(mode), "something else")


# Any file:


def read_content(path: Path, kind: str, size: int | None = None, start: int = 0) -> bytes:
    """Return the content of a regular file.

    Parameters
    ----------
    path : Path
        The file.
    kind : str
        Key in `LIMITS`.
    size : int, optional
        Bytes to read. By default all.
    start : int, optional
        Bytes before them that are not read. By default none.

    Raises
    ------
    DamagedFileError
        If it is not a regular file, or if there are more bytes to read than the limit.
    OSError
        If it cannot be opened.
    """
    # Before it is opened, too: a socket cannot be opened, and opening a device can have effects.
    _check_regular(path, path.stat())
    # Another file may take the name in between, and opening a FIFO must not wait for its writer.
    flags = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
    with open(os.open(path, flags), "rb") as file:
        status = os.fstat(file.fileno())
        _check_regular(path, status)
        there = max(0, status.st_size - start)
        wanted = there if size is None else min(size, there)
        if wanted > LIMITS[kind]:
            raise DamagedFileError(
                path, f"expected at most {LIMITS[kind]:,} bytes ({kind}), got {wanted:,}"
            )
        file.seek(min(start, status.st_size))
        return file.read(wanted)


def _check_regular(path: Path, status: os.stat_result) -> None:
    found = kind_of_file(status.st_mode)
    if found:
        raise DamagedFileError(path, f"expected a regular file, got {found}")


def read_text(path: Path, kind: str, *, encoding: str, errors: str = "strict") -> str:
    """Return the content of a text file; DamagedFileError as `read_content`, or if it is no text.

    Parameters
    ----------
    path, kind
        As in `read_content`.
    encoding, errors : str
        As in `bytes.decode`.
    """
    try:
        return read_content(path, kind).decode(encoding, errors)
    except UnicodeDecodeError as error:
        raise DamagedFileError(path, f"expected a {kind} file of text, got: {error}") from error


# JSON:


def read_json(path: Path) -> dict[str, Any]:
    """Return the object in a JSON file; DamagedFileError if there is none, or beyond a limit."""
    return parse_json(path, read_content(path, "JSON"))


def parse_json(path: Path, text: str | bytes) -> dict[str, Any]:
    """Return the object in a JSON text that the file `path` holds, as `read_json`."""
    try:
        values = json.loads(text)
    except (RecursionError, ValueError) as error:
        raise DamagedFileError(path, f"cut or altered, expected JSON ({error})") from error
    if not isinstance(values, dict):
        problem = f"altered, expected a JSON object, got a {type(values).__name__}"
        raise DamagedFileError(path, problem)
    # Deeper values would end every function that walks through them with a RecursionError.
    level: list[Any] = [values]
    for _ in range(DEPTH):
        level = [item for each in level for item in _items(each)]
        if not level:
            return values
    raise DamagedFileError(path, f"expected at most {DEPTH} levels of lists and objects, got more")


def _items(value: Any) -> list[Any]:
    if isinstance(value, dict):
        return list(value.values())
    return value if isinstance(value, list) else []


# Arrays:


def read_npz(path: Path) -> Arrays:
    """Return the arrays of an npz file, with a checksum or without.

    Raises
    ------
    DamagedFileError
        If it is damaged, needs unpickling, or exceeds a limit.
    """
    return parse_npz(path, read_content(path, "npz"))


def parse_npz(path: Path, content: bytes) -> Arrays:
    """Return the arrays in the content of an npz file `path`, as `read_npz`."""
    # From memory: the file may be replaced while it is read.
    try:
        if content.count(ENTRY) > MEMBERS:
            raise ValueError(f"expected at most {MEMBERS:,} arrays, got more")
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            members = archive.infolist()
            _check_members(members, max(UNPACKED, len(content)))
            return {each.filename.removesuffix(".npy"): _array(archive, each) for each in members}
    except UNREADABLE as error:
        problem = f"cut, altered or not an npz file ({error})"
        raise DamagedFileError(path, problem) from error


def _check_members(members: list[zipfile.ZipInfo], most: int) -> None:
    """Raise ValueError if the members of a zip archive would expand to more than `most` bytes."""
    for member in members:
        if member.compress_type not in COMPRESSIONS:
            raise ValueError(f"{member.filename}: expected deflate or no compression")
    # The directory of the archive tells the sizes, and zipfile expands no more than it tells.
    size = sum(member.file_size for member in members)
    if size > most:
        raise ValueError(
            f"expected arrays of at most {most:,} bytes, got {size:,}; larger ones must not be "
            f"compressed"
        )


def _array(archive: zipfile.ZipFile, member: zipfile.ZipInfo) -> NDArray[Any]:
    """Return the array in a member of a zip archive, whose header is checked first."""
    with archive.open(member) as file:
        shape, dtype = _header(file)
        if dtype.kind not in KINDS or not dtype.itemsize:
            raise ValueError(f"{member.filename}: expected numbers or text, got dtype {dtype}")
        # A header may claim any shape: NumPy would allocate it before it reads the numbers.
        claimed, held = math.prod(shape) * dtype.itemsize, member.file_size - file.tell()
        if claimed != held:
            raise ValueError(f"{member.filename}: expected {claimed:,} bytes, got {held:,}")
        file.seek(0)
        array: NDArray[Any] = np.lib.format.read_array(file, allow_pickle=False)
        return array


def _header(file: IO[bytes]) -> tuple[tuple[int, ...], np.dtype[Any]]:
    """Return shape and dtype of an array from its header."""
    version = np.lib.format.read_magic(file)
    if version not in HEADERS:
        raise ValueError(f"expected an array of version 1.0 or 2.0, got {version}")
    try:
        shape, _, dtype = HEADERS[version](file)
    except MemoryError:  # of Python's parser, in which the header is deeper than its stack
        raise ValueError("expected the header of an array, got deeper nested text") from None
    return shape, dtype


Form = tuple[str, str]
"""Kinds of dtypes and axes of an array: ``("f", "G H 2")``."""


def check_arrays(path: Path, arrays: Mapping[str, NDArray[Any]], forms: Mapping[str, Form]) -> None:
    """Raise DamagedFileError unless a file holds arrays of some names, dtypes and shapes.

    Parameters
    ----------
    path : Path
        The file.
    arrays : mapping of str to ndarray
        What it holds. Further arrays are ignored.
    forms : mapping of str to tuple
        For each name the kinds of dtypes that are allowed (as ``dtype.kind``), and the axes,
        separated by spaces. An axis that is a number has this size; one that is a letter has the
        same size wherever the letter stands.
    """
    sizes: dict[str, int] = {}
    for name, (kinds, axes) in forms.items():
        if name not in arrays:
            raise DamagedFileError(path, f"expected an array {name!r}, got {', '.join(arrays)}")
        array, letters = arrays[name], axes.split()
        known = array.shape if len(letters) == array.ndim else (-1,) * len(letters)
        shape = tuple(
            int(letter) if letter.isdigit() else sizes.setdefault(letter, size)
            for letter, size in zip(letters, known, strict=True)
        )
        if array.dtype.kind not in kinds or array.shape != shape:
            raise DamagedFileError(
                path,
                f"{name}: expected dtype of kind {kinds} and shape ({', '.join(letters)}), got "
                f"{array.dtype} and {array.shape}",
            )
