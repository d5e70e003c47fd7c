"""Files that somebody made to do harm, or that are no files at all."""

from __future__ import annotations

import io
import json
import os
import socket
import struct
import zipfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from matrixworld._util import files
from matrixworld._util.reading import LIMITS, UNPACKED

Attack = Callable[[Path], None]


def fifo(path: Path) -> None:
    os.mkfifo(path)


def directory(path: Path) -> None:
    path.mkdir()


def endless_device(path: Path) -> None:
    path.symlink_to("/dev/zero")


def listening_socket(path: Path) -> None:
    # A relative name, because the length of a socket's name is limited.
    here = os.getcwd()
    os.chdir(path.parent)
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(path.name)
    os.chdir(here)


def larger_than(kind: str) -> Attack:
    """Return an attack: a file without content that claims more bytes than the limit."""

    def sparse(path: Path) -> None:
        path.touch()
        os.truncate(path, LIMITS[kind] + 1)

    return sparse


NOT_FILES: dict[str, Attack] = {
    "FIFO": fifo,
    "directory": directory,
    "device": endless_device,
    "socket": listening_socket,
}


# JSON:


def nested(depth: int) -> str:
    return '{"a": ' + "[" * depth + "]" * depth + "}"


JSON_ATTACKS: dict[str, Attack] = {
    "nested 100,000 deep": lambda path: _written(path, nested(100_000).encode()),
    "nested 900 deep": lambda path: _written(path, nested(900).encode()),
    "list": lambda path: _written(path, b"[[1, 2]]"),
    "not text": lambda path: _written(path, b"\xff\xfe\x00{"),
    "number of 5,000 digits": lambda path: _written(path, b'{"a": ' + b"9" * 5000 + b"}"),
    "too large": larger_than("JSON"),
}


# npz:


def npy(shape: object, dtype: str = "<f4", data: bytes = b"") -> bytes:
    """Return an npy file whose header claims a shape and a dtype."""
    text = f"{{'descr': {dtype!r}, 'fortran_order': False, 'shape': {shape}, }}"
    header = text.encode().ljust(117) + b"\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + data


def npz(
    members: Mapping[str, bytes], compression: int = zipfile.ZIP_DEFLATED, name: str = "{}.npy"
) -> bytes:
    """Return an npz file of npy files."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", compression, compresslevel=1) as archive:
        for member, content in members.items():
            archive.writestr(name.format(member), content)
    return buffer.getvalue()


def bomb(compression: int = zipfile.ZIP_DEFLATED) -> bytes:
    """Return an npz file that expands to a little more than the limit."""
    buffer = io.BytesIO()
    with (
        zipfile.ZipFile(buffer, "w", compression, compresslevel=1) as archive,
        archive.open("payoff.npy", "w", force_zip64=True) as file,
    ):
        file.write(npy((UNPACKED // 4,)))
        for _ in range(UNPACKED // 2**22):
            file.write(bytes(2**22))
    return buffer.getvalue()


NPZ_CONTENTS: dict[str, bytes] = {
    "zip bomb": bomb(),
    "header of 8 TB": npz({"payoff": npy((2_000_000, 1_000_000))}),
    "header of 10**60 numbers": npz({"payoff": npy((10**30, 10**30))}),
    "negative sizes": npz({"payoff": npy((-2, -3), data=bytes(24))}),
    "long header": npz({"payoff": npy("-" * 9000 + "1")}),
    "nothing but dimensions": npz({"payoff": npy((10**18,), "|V0")}),
    "pickled": npz({"payoff": npy((1,), "|O", b"\x80\x04N.")}),
    "dates": npz({"payoff": npy((1,), "<M8[s]", bytes(8))}),
    "not an array": npz({"payoff": b"text"}),
    "lzma": npz({"payoff": npy((2, 2), data=bytes(16))}, zipfile.ZIP_LZMA),
    "20,000 members": npz({str(number): b"" for number in range(20_000)}, zipfile.ZIP_STORED),
    "no members": npz({}),
}

NPZ_ATTACKS: dict[str, Attack] = {
    **{
        name: lambda path, content=content: _written(path, content)  # type: ignore[misc]
        for name, content in NPZ_CONTENTS.items()
    },
    "too large": larger_than("npz"),
}

NPY_ATTACKS: dict[str, Attack] = {
    "empty": lambda path: _written(path, b""),
    "npz file": NPZ_ATTACKS["zip bomb"],
    "header of 8 TB": lambda path: _written(path, npy((2_000_000, 1_000_000))),
    "long header": lambda path: _written(path, npy("-" * 9000 + "1")),
    "pickled": lambda path: _written(path, npy((1,), "|O", b"\x80\x04N.")),
    "too large": larger_than("npy"),
}


def _written(path: Path, content: bytes) -> None:
    path.write_bytes(content)


# With the right checksum, as somebody can make it who reads the package:


def sealed(path: Path, content: bytes, owner: str) -> None:
    """Write an npz file with the checksum of an owner."""
    path.write_bytes(files._sealed(content, owner))


def forge(path: Path, owner: str, change: Callable[[dict[str, Any]], object]) -> None:
    """Change the arrays or the JSON object in a file, and give it the right checksum."""
    load, save = (
        (files.load_json, files.save_json)
        if path.suffix == ".json"
        else (files.load_arrays, files.save_arrays)
    )
    values: dict[str, Any] = dict(load(path, owner=owner))
    change(values)
    save(path, values, owner=owner)  # type: ignore[operator]


def nested_with_checksum(depth: int) -> bytes:
    values = json.loads(nested(depth))
    return json.dumps({**values, files.CHECKSUM: files.json_digest(values)}).encode()


@contextmanager
def little_memory(most: int = 100 * 2**20) -> Iterator[None]:
    """Check that Python and NumPy take no more memory inside the with block."""
    import tracemalloc

    tracemalloc.start()
    try:
        yield
        assert tracemalloc.get_traced_memory()[1] < most
    finally:
        tracemalloc.stop()


def random_npz(path: Path, seed: int) -> None:
    """Write an npz file with random bytes altered, also in headers and in the directory."""
    rng = np.random.default_rng(seed)
    content = bytearray(npz({"payoff": npy((3, 3), data=bytes(36))}, zipfile.ZIP_STORED))
    for place in rng.integers(len(content), size=rng.integers(1, 4)):
        content[place] = rng.integers(256)
    path.write_bytes(bytes(content))
