"""A sample of strong and different opponents (Rosin & Belew 1997)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution.opponents.samplers import check_available, check_count, checked_scores
from matrixworld.coevolution.types import Indices, State


def shared_sample(beats: ArrayLike, count: int, rng: np.random.Generator) -> Indices:
    """Return `count` opponents, greedily, that beat those whom few chosen ones beat.

    ::

        covered[k] = 0 for every individual k
        repeat count times:
            choose the j not yet chosen with the most  sum_k beats[j, k] / (1 + covered[k]),
            ties by lot
            covered[k] += beats[j, k]

    Source: Rosin & Belew 1997, "New methods for competitive coevolution", shared sampling.

    Parameters
    ----------
    beats : (m, n) numbers in [0, 1], how surely opponent j beats individual k of the last epoch.
    count : opponents to choose; all, if there are fewer.
    """
    matrix = np.asarray(beats, dtype=np.float64)
    if matrix.ndim != 2 or not ((matrix >= 0.0) & (matrix <= 1.0)).all():
        raise ValueError(f"beats: expected (m, n) numbers in [0, 1], got shape {matrix.shape}")
    lots = rng.permutation(len(matrix))
    in_order, covered = matrix[lots], np.zeros(matrix.shape[1])
    chosen: list[int] = []
    for _ in range(min(count, len(matrix))):
        value = (in_order / (1.0 + covered)).sum(axis=1)
        value[chosen] = -1.0
        chosen.append(int(np.argmax(value)))
        covered += in_order[chosen[-1]]
    return np.asarray(lots[chosen], dtype=np.intp)


class SharedSampling:
    """Strong and different opponents, by what each did when it was last met (Rosin & Belew 1997).

    An opponent that has not been met counts as beating everybody, so that it soon is; see
    `shared_sample` for the rule. A change in the number of candidates forgets what was seen.

    Parameters
    ----------
    count : opponents an epoch.
    """

    def __init__(self, count: int = 1) -> None:
        check_count("count", count)
        self.count = count
        self._beats = np.ones((0, 1))

    def choose(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the sample, the strongest first."""
        check_available(available)
        return shared_sample(self.beats(available), self.count, rng)

    def beats(self, available: int) -> NDArray[np.float64]:
        """Return how surely each opponent beats each candidate, (available, n)."""
        unmet = max(0, available - len(self._beats))
        return np.pad(self._beats[:available], ((0, unmet), (0, 0)), constant_values=1.0)

    def tell(self, met: Indices, scores: ArrayLike) -> None:
        """Take note of one minus the scores (n, c) for each opponent met."""
        index, values = checked_scores(met, scores)
        if self._beats.shape[1] != len(values):
            self._beats = np.ones((0, len(values)))
        self._beats = self.beats(max(len(self._beats), int(index.max()) + 1))
        self._beats[index] = 1.0 - values.T

    def state(self) -> State:
        """Return what each opponent did when it was last met."""
        return {"beats": self._beats.copy()}

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""
        self._beats = state["beats"].astype(np.float64)
