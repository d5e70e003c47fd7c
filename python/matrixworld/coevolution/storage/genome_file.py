"""pursuers.npy and evaders.npy: the genomes of a team, one row per generation, appended.

The format of NumPy's npy files allows an array to grow along its first axis: the head of the file
states the shape, and has room for a larger one. A new generation is appended behind the others, and
then the head is rewritten in place. Every reader of npy files sees complete generations only,
because the head counts a genome after it is on the disk.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from matrixworld._util.reading import read_content
from matrixworld.coevolution.storage.appended_file import AppendedFile, Position
from matrixworld.coevolution.types import Genome, Genomes

DTYPE = np.dtype("<f4")
HEAD = 128
"""Bytes of the head. They hold every shape that fits on a disk, and are a multiple of 64."""
PREFIX = b"\x93NUMPY\x01\x00" + (HEAD - 10).to_bytes(2, "little")
"""Begin of an npy file of version 1.0, whose head ends after `HEAD` bytes."""


class GenomePosition(NamedTuple):
    """Which genomes of a file a checkpoint has counted.

    Parameters
    ----------
    genomes : int
        Number of genomes.
    genes : int
        Numbers of each genome.
    checksum : str
        SHA-256 of the genomes, in hexadecimal.
    """

    genomes: int
    genes: int
    checksum: str

    @property
    def in_bytes(self) -> Position:
        """The same position, in bytes after the head."""
        return Position(self.genomes * self.genome_size, self.checksum)

    @property
    def genome_size(self) -> int:
        """Bytes of a genome."""
        return self.genes * DTYPE.itemsize


class GenomeFile:
    """The genomes of one team. A team that a script plays has no file.

    Parameters
    ----------
    path : Path
        The file; it may not exist yet.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._file = AppendedFile(path, "npy", HEAD)
        self._count, self._genes = 0, 0

    @property
    def position(self) -> GenomePosition:
        """Number of genomes, their size, and their checksum."""
        return GenomePosition(self._count, self._genes, self._file.position.checksum)

    def append(self, genomes: Genomes | Sequence[Genome]) -> None:
        """Append genomes, arrays (genes,) float32, and count them in the head."""
        if not len(genomes):
            return
        rows = np.asarray(genomes, dtype=DTYPE)
        genes = rows.shape[1]
        self._file.append(rows.tobytes(), head=b"" if self._count else head_of(0, genes))
        self._count, self._genes = self._count + len(rows), genes
        self._file.rewrite_head(head_of(self._count, genes))

    def read(self, position: GenomePosition) -> Genomes:
        """Return the genomes (genomes, genes) float32 up to a position.

        Raises
        ------
        DamagedFileError
            If the file holds fewer genomes, or others.
        """
        shape = position.genomes, position.genes
        content = self._file.read(position.in_bytes) if position.genomes else b""
        # A copy, which can be changed and has the byte order of this machine.
        return np.frombuffer(content, DTYPE).reshape(shape).astype(np.float32)

    def head(self) -> bytes:
        """Return the head of the file; DamagedFileError if it is no regular file."""
        return read_content(self.path, self._file.kind, HEAD)

    def truncate(self, position: GenomePosition) -> None:
        """Remove the genomes after a position; DamagedFileError as `read`."""
        self.read(position)
        self._count, self._genes = position.genomes, position.genes
        if position.genomes:
            # The head first: it must never count a genome that is not there.
            head = head_of(position.genomes, position.genes)
            if self.head() != head:
                self._file.rewrite_head(head)
            self._file.truncate(position.in_bytes)


def file_size(position: GenomePosition) -> int:
    """Return the bytes of a file that ends at a position; 0 without genomes."""
    return HEAD + position.in_bytes.length if position.genomes else 0


def head_of(count: int, genes: int) -> bytes:
    """Return the head of an npy file of `count` genomes."""
    text = f"{{'descr': '<f4', 'fortran_order': False, 'shape': ({count}, {genes}), }}"
    return PREFIX + text.encode().ljust(HEAD - len(PREFIX) - 1) + b"\n"
