"""Random numbers of matches: each match has its own, so that no other match changes its result."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_integer, shown
from matrixworld.coevolution.types import FloatArray, Rng, Seeds


class MatchDraws:
    """Generators of matches: one that is set anew, in a tenth of the time that a new one takes.

    Both words of a key have 64 bits.
    """

    def __init__(self) -> None:
        self._bits = np.random.Philox(key=np.zeros(2, np.uint64))
        self._rng = np.random.Generator(self._bits)
        self._state: Any = self._bits.state  # as of its beginning, but for the key

    def of(self, seed: int, episode: int) -> Rng:
        """Return the generator of a match and episode, which the next call sets anew."""
        self._state["state"]["key"] = np.array([seed, episode], np.uint64)
        self._bits.state = self._state
        return self._rng


def _mixed(words: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """Return 64-bit words in which every bit depends on all bits: the end of SplitMix64.

    Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators", OOPSLA.
    """
    words = (words ^ (words >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    words = (words ^ (words >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return np.asarray(words ^ (words >> np.uint64(31)))


GOLDEN = np.uint64(0x9E3779B97F4A7C15)  # the step of SplitMix64: 2^64 by the golden ratio, odd
EPISODE = np.uint64(0xD1342543DE82EF95)  # an odd step between episodes


def episode_seeds(seeds: Seeds, episodes: range) -> Seeds:
    """Return the seeds (M * N,) of N episodes of M matches, those of a match together."""
    episode = np.array(episodes, np.uint64) * EPISODE
    return _mixed(seeds[:, np.newaxis] + episode).ravel()


def uniforms(seeds: ArrayLike, count: int) -> FloatArray:
    """Return random numbers for the matches of a game that plays all of them at once.

    The numbers of a match are those of SplitMix64 that begins from its seed, so they do not depend
    on which other matches are played.

    Parameters
    ----------
    seeds : array_like of uint64
        Seeds (M,) of matches, as `play` gets them.
    count : int
        Numbers of each match.

    Returns
    -------
    ndarray of float64
        Numbers (M, count), uniform in [0, 1).

    Raises
    ------
    TypeError, ValueError
        If the seeds are no integers from 0 in one dimension, or `count` is less than 1.

    Examples
    --------
    >>> import numpy as np
    >>> from matrixworld.coevolution import uniforms
    >>> uniforms(np.array([7, 8], np.uint64), 3).shape
    (2, 3)
    """
    check_integer("count", count, 1)
    words = np.asarray(seeds)
    if words.ndim != 1 or words.dtype.kind not in "iu" or (words.size and words.min() < 0):
        raise ValueError(f"seeds: expected integers (M,) from 0, got {shown(seeds)}")
    steps = np.arange(1, count + 1, dtype=np.uint64) * GOLDEN
    bits = _mixed(_mixed(words.astype(np.uint64))[:, np.newaxis] + steps)
    return np.asarray((bits >> np.uint64(11)) * 2.0**-53)
