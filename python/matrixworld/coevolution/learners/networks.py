"""Networks that learn by gradients of PyTorch, with weights in the layout of a genome."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from itertools import pairwise
from math import sqrt
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.games.pursuit import Views
from matrixworld.coevolution.learners.optimizers import Adam
from matrixworld.coevolution.types import BoolArray, Genome, Rng

Tensor: TypeAlias = Any  # a ``torch.Tensor``: PyTorch may be missing where types are checked


class Inputs:
    """Rows (n, in) of zeros and ones that a network sees; ``inputs(weights)`` multiplies them."""

    # A view has few ones. The processor multiplies these alone, and keeps them sorted by row for
    # the products and by column for the gradient; PyTorch's own gradient sorts them each time.
    def __init__(self, rows: Views, torch: Any, device: Any) -> None:
        self.rows: int = len(rows)
        if device.type != "cpu":
            dense = torch.from_numpy(np.ascontiguousarray(rows)).to(device)
            self._product: Callable[[Tensor], Tensor] = lambda weights: dense.float() @ weights
            return
        by_row = _sparse(rows, torch)
        by_column = _sparse(rows.T, torch)

        class Product(torch.autograd.Function):  # type: ignore[misc]  # PyTorch may be missing
            @staticmethod
            def forward(_: Any, weights: Tensor) -> Tensor:
                return by_row @ weights

            @staticmethod
            def backward(_: Any, gradient: Tensor) -> Tensor:
                return by_column @ gradient

        self._product = Product.apply

    def __call__(self, weights: Tensor) -> Tensor:
        """Return the products (n, out) with weights (in, out)."""
        return self._product(weights)


def _sparse(rows: Views, torch: Any) -> Tensor:
    """Return rows (n, m) of zeros and ones as a sparse tensor of float32."""
    row, column = np.divmod(np.flatnonzero(np.ascontiguousarray(rows)), rows.shape[1])
    starts = np.searchsorted(row, np.arange(len(rows) + 1))
    parts = (starts, column, np.ones(len(column), np.float32))
    with warnings.catch_warnings():  # PyTorch calls this form a beta
        warnings.simplefilter("ignore", UserWarning)
        return torch.sparse_csr_tensor(*map(torch.from_numpy, parts), size=rows.shape)


class Trained(NamedTuple):
    """The weights (genes,) of a network, in the layout of a genome, and the averages of Adam."""

    weights: Genome
    adam: Adam

    @classmethod
    def start(cls, weights: Genome) -> Trained:
        """Return weights that have not learned yet."""
        return cls(weights, Adam.start(weights.size))


class Perceptron:
    """A network that learns by Adam; what is `fixed` (genes,) of its weights stays."""

    def __init__(
        self,
        trained: Trained,
        sizes: NDArray[np.int64],
        activation: str,
        rate: float,
        fixed: BoolArray | None = None,
    ) -> None:
        self.trained = trained
        self.sizes = tuple(map(int, sizes))
        self.activation = activation
        self.rate = rate
        self.fixed = fixed

    @property
    def weights(self) -> Genome:
        """The weights (genes,)."""
        return self.trained.weights

    def outputs(self, weights: Tensor, inputs: Inputs) -> Tensor:
        """Return the outputs (n, out) for inputs (n, in); `weights` is a tensor of the vector."""
        rows = None
        start = 0
        last = len(self.sizes) - 2
        for number, (n_in, n_out) in enumerate(pairwise(self.sizes)):
            middle = start + n_in * n_out
            end = middle + n_out
            matrix = weights[start:middle].view(n_in, n_out)
            rows = (inputs(matrix) if rows is None else rows @ matrix) + weights[middle:end]
            if number < last:
                rows = rows.relu() if self.activation == "relu" else rows.tanh()
            start = end
        return rows

    def ascend(self, gradient: Genome, share: float = 1.0) -> None:
        """Make one step of Adam, at a share of the learning rate."""
        if self.fixed is not None:
            gradient = np.where(self.fixed, np.float32(0.0), gradient)
        change, adam = self.trained.adam.step(gradient, share * self.rate)
        self.trained = Trained(self.weights + change, adam)


def orthogonal(sizes: tuple[int, ...], rng: Rng, *, head: float = 1.0) -> Genome:
    """Return orthogonal matrices and biases of 0, in the layout of a genome: Saxe et al. 2014.

    The last layer is scaled by `head`, the others by the square root of 2.
    """
    parts = []
    for number, (n_in, n_out) in enumerate(pairwise(sizes)):
        q, r = np.linalg.qr(rng.standard_normal((max(n_in, n_out), min(n_in, n_out))))
        q *= np.sign(np.diag(r))
        matrix = q if n_in >= n_out else q.T
        scale = head if number == len(sizes) - 2 else sqrt(2.0)
        parts += [scale * matrix.ravel(), np.zeros(n_out)]
    return np.concatenate(parts).astype(np.float32)
