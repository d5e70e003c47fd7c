"""Shared sampling: strong opponents that differ from each other (Rosin & Belew 1997)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.opponents.samplers import check_available, check_count, checked_scores
from matrixworld.coevolution.types import FloatArray, Indices, State


def shared_sample(beats: ArrayLike, count: int, rng: np.random.Generator) -> Indices:
    """Return a greedy sample of opponents, each of which beats what few others in it beat.

    ::

        covered[k] = 0 for every individual k
        repeat count times:
            choose the j not yet chosen with the most  sum_k beats[j, k] / (1 + covered[k]);
            decide ties at random
            covered[k] += beats[j, k]

    Parameters
    ----------
    beats : array_like of float, shape (m, n)
        How surely opponent j beats individual k of the last epoch, in [0, 1].
    count : int
        Opponents to choose; all, if there are fewer.
    rng : numpy.random.Generator
        Decides ties.

    Returns
    -------
    ndarray of intp, shape (min(count, m),)
        Opponents in the order chosen.

    Raises
    ------
    ValueError
        If `beats` has another number of axes or a value outside [0, 1].

    References
    ----------
    Rosin & Belew 1997, "New methods for competitive coevolution", Evolutionary Computation 5(1).
    """
    matrix = np.asarray(beats, dtype=np.float64)
    if matrix.ndim != 2 or not ((matrix >= 0.0) & (matrix <= 1.0)).all():
        raise ValueError(f"beats: expected (m, n) numbers in [0, 1], got shape {matrix.shape}")
    # argmax takes the first of equals, so a random order of the rows decides ties at random.
    order = rng.permutation(len(matrix))
    shuffled, covered = matrix[order], np.zeros(matrix.shape[1])
    chosen: list[int] = []
    for _ in range(min(count, len(matrix))):
        value = (shuffled / (1.0 + covered)).sum(axis=1)
        # Below every value, so that no opponent is chosen twice.
        value[chosen] = -1.0
        chosen.append(int(np.argmax(value)))
        covered += shuffled[chosen[-1]]
    return np.asarray(order[chosen], dtype=np.intp)


class SharedSampling:
    """A sampler of strong and different opponents, by the last scores against each.

    The rule is that of `shared_sample`. An opponent without scores counts as beating every
    candidate, so that it is soon sampled. If the number of candidates changes, all scores are
    forgotten.

    Parameters
    ----------
    count : int, optional
        Opponents an epoch; all, if fewer are available.
    """

    def __init__(self, count: int = 1) -> None:
        check_count("count", count)
        self.count = count
        self._beats = np.ones((0, 1))

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the sample, the strongest first."""
        check_available(available)
        return shared_sample(self.beats(available), self.count, rng)

    def beats(self, available: int) -> FloatArray:
        """Return how surely each opponent beats each candidate, (available, n)."""
        unknown = max(0, available - len(self._beats))
        return np.pad(self._beats[:available], ((0, unknown), (0, 0)), constant_values=1.0)

    def tell(self, opponents: Indices, scores: ArrayLike) -> None:
        """Record one minus the scores (n, c) for each opponent."""
        index, values = checked_scores(opponents, scores)
        # Columns are candidates; with another number of them old scores fit none.
        if self._beats.shape[1] != len(values):
            self._beats = np.ones((0, len(values)))
        self._beats = self.beats(max(len(self._beats), int(index.max()) + 1))
        self._beats[index] = 1.0 - values.T

    def state(self) -> State:
        """Return how surely each opponent beat each candidate when last sampled."""
        return {"beats": self._beats.copy()}

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        self._beats = state["beats"].astype(np.float64)
