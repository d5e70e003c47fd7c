"""Files that are either whole or refused.

A file is written under a temporary name in its directory, synced and renamed, so that a crash
leaves the old file or the new one. Each carries a SHA-256 of its content and of its owner's name,
so that a file of another run, or under another file's name, is refused too. Nothing is pickled.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
import sys
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Arrays = dict[str, NDArray[Any]]

CHECKSUM = "sha256"
TEMPORARY = ".tmp"

SEAL = b"sha256:"
SEAL_LENGTH = len(SEAL) + 64
NO_COMMENT = b"\0\0"
"""How a zip archive without a comment ends: with the comment's length."""

NO_MATCH = "altered or another run's, its checksum does not match its content"


class DamagedFileError(ValueError):
    """A file of a run is cut, altered or not of the expected form."""

    def __init__(self, path: Path, problem: str) -> None:
        super().__init__(f"{path}: {problem}")
        self.path = path


class OtherVersionError(ValueError):
    """A file of a run is whole, but of another version of the package."""


@contextmanager
def naming(path: Path) -> Iterator[None]:
    """Name the file in errors of the system that do not: a full disk does not say where."""
    try:
        yield
    except OSError as error:
        if error.filename is None:
            error.filename = str(path)
        raise


def replace_file(path: Path, content: bytes, *, keep_as: Path | None = None) -> None:
    """Write `content` to `path` in one step; an older file there is kept as `keep_as`."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}{TEMPORARY}")
    with naming(path):
        try:
            with open(temporary, "wb") as file:
                file.write(content)
                file.flush()
                os.fsync(file.fileno())
            if keep_as is not None and path.exists():
                os.replace(path, keep_as)
            os.replace(temporary, path)
        finally:
            temporary.unlink(missing_ok=True)
        sync_directory(path.parent)


def sync_directory(path: Path) -> None:
    """Make renames in a directory last through a power cut, where the system can."""
    if sys.platform == "win32":
        return
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def is_temporary(name: str) -> bool:
    """Whether a file is named like one that is being written."""
    return name.startswith(".") and name.endswith(TEMPORARY)


def remove_temporary_files(path: Path) -> None:
    """Remove what writers that were killed have left in a directory."""
    for left in path.iterdir():
        if is_temporary(left.name):
            left.unlink()


def save_arrays(
    path: Path, arrays: Mapping[str, ArrayLike], *, owner: str = "", keep_as: Path | None = None
) -> None:
    """Write named arrays as an .npz file that carries its checksum; TypeError on objects.

    `owner` says whose file it is; the same is expected on loading.
    """
    plain: dict[str, Any] = {name: np.asarray(array) for name, array in arrays.items()}
    for name, array in plain.items():
        if array.dtype.hasobject:
            raise TypeError(f"{name}: expected numbers or text, got dtype {array.dtype}")
    buffer = io.BytesIO()
    np.savez(buffer, **plain)
    replace_file(path, _signed(buffer.getvalue(), owner), keep_as=keep_as)


def load_arrays(path: Path, *, owner: str = "") -> Arrays:
    """Read what `save_arrays` wrote; DamagedFileError says which file is cut or altered."""
    content = path.read_bytes()
    body, seal = content[:-SEAL_LENGTH], content[-SEAL_LENGTH:]
    if not seal.startswith(SEAL):
        raise DamagedFileError(path, "cut or altered, its checksum is missing")
    if seal != _seal(body, owner):
        raise DamagedFileError(path, NO_MATCH)
    try:
        with np.load(io.BytesIO(content), allow_pickle=False) as file:
            return {name: file[name] for name in file.files}
    except (EOFError, ValueError, zipfile.BadZipFile) as error:
        raise DamagedFileError(path, f"not of the expected form ({error})") from error


def save_json(path: Path, values: Mapping[str, Any], *, owner: str = "") -> None:
    """Write a JSON object that carries its checksum (`owner` as in `save_arrays`)."""
    text = json.dumps({**values, CHECKSUM: json_digest(values, owner)}, indent=2, allow_nan=False)
    replace_file(path, text.encode() + b"\n")


def load_json(path: Path, *, owner: str = "") -> dict[str, Any]:
    """Read what `save_json` wrote; DamagedFileError says which file is cut or altered."""
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
    content = json.dumps(values, sort_keys=True).encode()
    return hashlib.sha256(owner.encode() + content).hexdigest()


def _signed(archive: bytes, owner: str) -> bytes:
    """Add the checksum to a zip archive as its comment, which every reader of zip files skips."""
    body = archive[: -len(NO_COMMENT)] + SEAL_LENGTH.to_bytes(2, "little")
    return body + _seal(body, owner)


def _seal(body: bytes, owner: str) -> bytes:
    digest = hashlib.sha256(owner.encode())
    digest.update(body)
    return SEAL + digest.hexdigest().encode()
