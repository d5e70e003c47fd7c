"""Noise vectors of mutations: windows of one long row of normal numbers."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.seeding import Purpose, keyed_generator
from matrixworld.coevolution.types import BoolArray, Genome, Indices, Rng

VECTORS_PER_TABLE = 256
MOST_EXTRA_NUMBERS = 2**24  # bound of the table's memory: 64 MiB beyond one noise vector


class Noise(NamedTuple):
    """The key of the noise vectors of a run, and the genes (genes,) that have none, if any."""

    key: NDArray[np.int64]
    fixed: BoolArray | None


def table_length(genes: int) -> int:
    """Return how many numbers the table of noise vectors for so many genes has."""
    return genes + min(VECTORS_PER_TABLE * genes, MOST_EXTRA_NUMBERS)


@lru_cache(maxsize=4)  # both teams of two runs; made again from its key where it is missing
def _table(key: tuple[int, ...], genes: int, sigma: float) -> Genome:
    seed, purpose, team = key
    rng = keyed_generator(seed, Purpose(purpose), team)
    numbers = rng.standard_normal(table_length(genes), dtype=np.float32)
    with np.errstate(over="ignore"):
        numbers *= np.float32(sigma)
    numbers.flags.writeable = False
    return numbers


def draw_windows(count: int, genes: int, rng: Rng) -> Indices:
    """Return where the windows of `count` noise vectors begin."""
    # The last window may end with the table, hence the endpoint.
    return rng.integers(0, table_length(genes) - genes, size=count, endpoint=True)


def noise_of(noise: Noise, windows: Indices, genes: int, sigma: float) -> list[Genome]:
    """Return noise vectors (genes,) float32 with standard deviation sigma, not to be written to."""
    # To draw a normal number for each gene of each candidate costs more time than all other work of
    # a learner. A window at a random place of a long shared table serves as well (Salimans et al.
    # 2017, section 2.1; for genetic algorithms Such et al. 2017, arXiv:1712.06567).
    table = _table(tuple(map(int, noise.key)), genes, sigma)
    vectors = [table[start : start + genes] for start in windows]
    if noise.fixed is None:
        return vectors
    return [np.where(noise.fixed, np.float32(0.0), vector) for vector in vectors]
