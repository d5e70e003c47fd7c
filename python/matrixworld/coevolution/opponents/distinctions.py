"""Who dominates whom, and which tests show it. Everything works on outcomes (n, m) alone."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.types import FloatArray, Indices

Mask = NDArray[np.bool_]


def distinctions(outcomes: FloatArray) -> Mask:
    """Return (n, n, m): whether test t shows that a does better than b, at [a, b, t]."""
    return outcomes[:, np.newaxis] > outcomes[np.newaxis]


def superseded(outcomes: FloatArray) -> Mask:
    """Return (n, n): whether b makes a superfluous, at [a, b].

    It does when it dominates a (nowhere worse, somewhere better), or when both have the same
    outcomes and b comes first.
    """
    better = distinctions(outcomes).any(axis=2)
    equal = ~better & ~better.T
    earlier = np.tri(len(outcomes), k=-1, dtype=np.bool_)
    return np.asarray(~better & (better.T | (equal & earlier)))


def front(outcomes: FloatArray) -> Indices:
    """Return the rows that none supersedes: non-dominated, the first of each that are equal."""
    return np.flatnonzero(~superseded(outcomes).any(axis=1))


def fewest_tests(needed: Mask) -> list[int]:
    """Return tests such that every pair that some test tells apart is told apart by one of them.

    ::

        while pairs are left: take the test that tells most of them apart, the first of equals

    Parameters
    ----------
    needed : (pairs, m), which tests tell each pair apart.
    """
    chosen: list[int] = []
    left = needed[needed.any(axis=1)]
    while len(left):
        chosen.append(int(np.argmax(left.sum(axis=0))))
        left = left[~left[:, chosen[-1]]]
    return chosen
