"""A table of normal numbers from which noise vectors are cut."""

from __future__ import annotations

import numpy as np

from matrixworld._util.checks import check_integer, check_number
from matrixworld.coevolution.types import BoolArray, Genome

VECTORS_PER_TABLE = 256
MOST_EXTRA_NUMBERS = 2**24
"""Bound of the table's memory: 64 MiB beyond one noise vector."""


def table_size(genes: int) -> int:
    """Return the numbers of the table for noise vectors of a length."""
    return genes + min(VECTORS_PER_TABLE * genes, MOST_EXTRA_NUMBERS)


class NoiseTable:
    """Noise vectors as windows of one long row of normal numbers.

    To draw a normal number for each gene of each candidate costs more time than all other work of a
    learner. A window at a random place of a long shared table serves as well and costs nothing.

    Parameters
    ----------
    size : int
        Length of a noise vector (genes), at least 1.
    rng : numpy.random.Generator
        Generator that fills the table.
    sigma : float
        Standard deviation of the numbers, in units of the genes, above 0.
    fixed : ndarray of bool, shape (size,), optional
        Genes without noise. By default none.

    Raises
    ------
    ValueError
        If `size` or `sigma` is out of range.

    References
    ----------
    Salimans et al. 2017, "Evolution strategies as a scalable alternative to reinforcement
    learning", arXiv:1703.03864, section 2.1. For genetic algorithms: Such et al. 2017, "Deep
    neuroevolution", arXiv:1712.06567.
    """

    def __init__(
        self,
        size: int,
        rng: np.random.Generator,
        *,
        sigma: float,
        fixed: BoolArray | None = None,
    ) -> None:
        check_integer("size", size, 1)
        check_number("sigma", sigma, least=0.0, positive=True)
        self.size: int = size
        self.sigma: float = sigma
        self._fixed = fixed
        self._numbers = rng.standard_normal(table_size(size), dtype=np.float32)
        self._numbers *= np.float32(sigma)
        # Views of the table leave this class, so nothing may write to it.
        self._numbers.flags.writeable = False

    def draw(self, count: int, rng: np.random.Generator) -> list[Genome]:
        """Return `count` noise vectors (size,) float32, not to be written to."""
        # The last window may end with the table, hence the endpoint.
        starts = rng.integers(0, len(self._numbers) - self.size, size=count, endpoint=True)
        windows = [self._numbers[start : start + self.size] for start in starts]
        if self._fixed is None:
            return windows
        return [np.where(self._fixed, np.float32(0.0), window) for window in windows]
