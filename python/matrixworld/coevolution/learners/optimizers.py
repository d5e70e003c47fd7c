"""Steps of gradient ascent: Adam, and classical momentum."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np

from matrixworld._util.checks import check_integer, check_number, shown
from matrixworld.coevolution.types import Genome, State


class Optimizer(Protocol):
    """The interface of optimizers: turn gradients into changes of a genome."""

    updates: int
    """Steps made."""

    def step(self, gradient: Genome, rate: float) -> Genome:
        """Return the change (size,) float32 for one `gradient` at learning rate `rate`."""

    def state(self) -> State:
        """Return all that changes, as plain arrays."""

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""


class Adam:
    """Adam's step, in ascent, on float32 arrays of shape (size,).

    Parameters
    ----------
    size : int
        Length of a gradient.
    beta1, beta2 : float, optional
        Decay of the moving averages of the gradient and of its square.
    epsilon : float, optional
        Added to the denominator.

    References
    ----------
    Kingma & Ba 2015, "Adam: a method for stochastic optimization", algorithm 1.
    """

    def __init__(
        self, size: int, *, beta1: float = 0.9, beta2: float = 0.999, epsilon: float = 1e-8
    ) -> None:
        check_integer("size", size, 1)
        check_momentum("beta1", beta1)
        check_momentum("beta2", beta2)
        check_number("epsilon", epsilon, least=0.0)
        self.beta1: float = beta1
        self.beta2: float = beta2
        self.epsilon: float = epsilon
        self.mean: Genome = np.zeros(size, dtype=np.float32)
        self.square: Genome = np.zeros(size, dtype=np.float32)
        self.updates: int = 0

    def step(self, gradient: Genome, rate: float) -> Genome:
        """Return the change (size,) float32 for one `gradient` at learning rate `rate`."""
        self.updates += 1
        # In place, and in float32 throughout: both averages are as long as the genome.
        self.mean += (1 - self.beta1) * (gradient - self.mean)
        self.square += (1 - self.beta2) * (gradient * gradient - self.square)
        # Both averages start at zero; the divisions correct their bias in the first steps.
        mean = self.mean / (1 - self.beta1**self.updates)
        square = self.square / (1 - self.beta2**self.updates)
        change: Genome = rate * mean / (np.sqrt(square) + self.epsilon)
        return change

    def state(self) -> State:
        """Return both moving averages and the number of steps."""
        return {
            "adam_mean": self.mean.copy(),
            "adam_square": self.square.copy(),
            "updates": np.array(self.updates),
        }

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        self.mean = state["adam_mean"].astype(np.float32)
        self.square = state["adam_square"].astype(np.float32)
        self.updates = int(state["updates"])


class Momentum:
    """Classical momentum, in ascent, on float32 arrays of shape (size,).

    Parameters
    ----------
    size : int
        Length of a gradient.
    momentum : float, optional
        Share of the last step that is kept, in [0, 1).

    Raises
    ------
    ValueError
        If `momentum` is out of range.

    Notes
    -----
    ``v = momentum * v + rate * gradient``; the change is v. Unlike with Adam, the length of a step
    follows that of the gradient.

    References
    ----------
    Polyak 1964; as written by Sutskever et al. 2013, "On the importance of initialization and
    momentum in deep learning", equations 1 and 2.
    """

    def __init__(self, size: int, *, momentum: float = 0.9) -> None:
        check_integer("size", size, 1)
        check_momentum("momentum", momentum)
        self.momentum: float = momentum
        self.velocity: Genome = np.zeros(size, dtype=np.float32)
        self.updates: int = 0

    def step(self, gradient: Genome, rate: float) -> Genome:
        """Return the change (size,) float32 for one `gradient` at learning rate `rate`."""
        self.updates += 1
        self.velocity *= np.float32(self.momentum)
        self.velocity += np.float32(rate) * gradient
        # A copy: the next step changes the velocity in place.
        change: Genome = self.velocity.copy()
        return change

    def state(self) -> State:
        """Return the velocity and the number of steps."""
        return {"velocity": self.velocity.copy(), "updates": np.array(self.updates)}

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        self.velocity = state["velocity"].astype(np.float32)
        self.updates = int(state["updates"])


def check_momentum(name: str, momentum: Any) -> None:
    """Raise ValueError unless a number, a share of the past that is kept, is in [0, 1)."""
    if check_number(name, momentum, least=0.0) >= 1.0:
        raise ValueError(f"{name}: expected a number below 1, got {shown(momentum)}")
