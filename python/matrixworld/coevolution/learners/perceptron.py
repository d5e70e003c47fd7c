"""Networks of an actor-critic learner, whose weights are genomes that the engine plays."""

from __future__ import annotations

from itertools import pairwise
from math import sqrt
from typing import Any, TypeAlias

import numpy as np

from matrixworld.coevolution.learners.optimizers import Adam
from matrixworld.coevolution.types import BoolArray, Genome

Tensor: TypeAlias = Any
"""A ``torch.Tensor``: PyTorch may be missing where types are checked."""


class Perceptron:
    """A network whose weights are one vector, in the layout of a genome, and which learns by Adam.

    Parameters
    ----------
    weights : ndarray of float32, shape (genes,)
        Weights to start from.
    sizes : tuple of int
        Sizes of the layers, inputs and outputs included.
    activation : str
        Activation of the hidden layers: relu or tanh.
    rate : float
        Learning rate.
    fixed : ndarray of bool, shape (genes,), optional
        Weights that do not change. By default none.
    """

    def __init__(
        self,
        weights: Genome,
        sizes: tuple[int, ...],
        activation: str,
        rate: float,
        fixed: BoolArray | None = None,
    ) -> None:
        self.weights, self.sizes, self.activation, self.rate = weights, sizes, activation, rate
        self.fixed = fixed
        self.adam = Adam(len(weights))

    def outputs(self, weights: Tensor, rows: Tensor) -> Tensor:
        """Return the outputs (n, out) for inputs (n, in); `weights` is a tensor of the vector."""
        start, last = 0, len(self.sizes) - 2
        for number, (n_in, n_out) in enumerate(pairwise(self.sizes)):
            middle, end = start + n_in * n_out, start + (n_in + 1) * n_out
            rows = rows @ weights[start:middle].view(n_in, n_out) + weights[middle:end]
            if number < last:
                rows = rows.relu() if self.activation == "relu" else rows.tanh()
            start = end
        return rows

    def ascend(self, gradient: Genome) -> None:
        """Make one step of Adam."""
        if self.fixed is not None:
            gradient = np.where(self.fixed, np.float32(0.0), gradient)
        # A new array: archives keep a reference to the genome of their generation.
        self.weights = self.weights + self.adam.step(gradient, self.rate)


def orthogonal(sizes: tuple[int, ...], rng: np.random.Generator, *, head: float = 1.0) -> Genome:
    """Return untrained weights: orthogonal matrices, and biases of 0.

    Parameters
    ----------
    sizes : tuple of int
        Sizes of the layers, inputs and outputs included.
    rng : numpy.random.Generator
        Draws the matrices.
    head : float, optional
        Scale of the last layer; that of the others is the square root of 2.

    Returns
    -------
    ndarray of float32, shape (genes,)
        The weights, in the layout of a genome.

    References
    ----------
    Saxe, A., McClelland, J. and Ganguli, S. (2014). Exact solutions to the nonlinear dynamics of
    learning in deep linear neural networks. ICLR.
    """
    parts = []
    for number, (n_in, n_out) in enumerate(pairwise(sizes)):
        large, small = max(n_in, n_out), min(n_in, n_out)
        q, r = np.linalg.qr(rng.standard_normal((large, small)))
        q *= np.sign(np.diag(r))
        matrix = q if n_in >= n_out else q.T
        scale = head if number == len(sizes) - 2 else sqrt(2.0)
        parts += [scale * matrix.ravel(), np.zeros(n_out)]
    return np.concatenate(parts).astype(np.float32)
