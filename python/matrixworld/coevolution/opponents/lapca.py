"""LAPCA: the layered Pareto-coevolution archive (de Jong 2007)."""

from __future__ import annotations

import numpy as np

from matrixworld.coevolution.opponents.distinctions import distinctions, fewest_tests, front
from matrixworld.coevolution.opponents.pareto import Archive
from matrixworld.coevolution.opponents.samplers import check_count
from matrixworld.coevolution.types import FloatArray, Indices


class LAPCA(Archive):
    """The first layers of candidates, and the tests that tell neighbours apart.

    ::

        C = archived and new candidates;  T = archived and new tests
        of candidates with equal outcomes on T keep the oldest
        F1 = candidates of C that none dominates on T;  F2 = those of C - F1;  ... up to `layers`
        candidates = F1 + ... + Fn
        tests = as few as the greedy choice finds, archived ones first, such that of any two
                candidates of one layer or of neighbouring layers, whatever T shows to be better
                about either, a test kept shows

    Source: de Jong 2007, "A monotonic archive for Pareto-coevolution", Evolutionary Computation
    15(1). Tests are dropped, so it is bounded in practice and not strictly monotone; the more
    layers, the closer it is to `IPCA`.

    Parameters
    ----------
    layers : of candidates, the best first.
    """

    def __init__(self, layers: int) -> None:
        check_count("layers", layers)
        super().__init__()
        self.layers = layers

    def select(self, outcomes: FloatArray, archived: tuple[int, int]) -> tuple[Indices, Indices]:
        """Return the candidates and tests to keep."""
        layer = layers_of(outcomes)
        rows = np.flatnonzero((layer >= 0) & (layer < self.layers))
        near = np.abs(layer[rows, np.newaxis] - layer[rows]) <= 1
        shown = distinctions(outcomes[rows])[near]
        old = fewest_tests(shown[:, : archived[1]])
        left = shown[~shown[:, old].any(axis=1), archived[1] :]
        new = [archived[1] + test for test in fewest_tests(left)]
        return rows, np.sort(np.array(old + new, dtype=np.intp))


def layers_of(outcomes: FloatArray) -> Indices:
    """Return the layer (n,) of each candidate from 0, the best; -1: its outcomes came before."""
    layer = np.full(len(outcomes), -1, dtype=np.intp)
    left = np.sort(np.unique(outcomes, axis=0, return_index=True)[1])
    for number in range(len(outcomes)):
        best = left[front(outcomes[left])]
        layer[best] = number
        left = np.setdiff1d(left, best)
    return layer
