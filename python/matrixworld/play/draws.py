"""The engine's random numbers, for many agents at once (``cpp/grid/random.hpp``).

Philox4x64-10 (Salmon et al. 2011, "Parallel random numbers: as easy as 1, 2, 3") makes four numbers
of 64 bits from a key, here (seed, episode), and a counter, here (index, step, purpose, 0). Nothing
is carried from one draw to the next, so draws of a moment do not depend on other moments.
"""

from __future__ import annotations

from enum import IntEnum
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Words = NDArray[np.uint64]

_MULTIPLIERS = (0xD2E7470EE14C6C93, 0xCA5A826395121157)
_WEYL = (0x9E3779B97F4A7C15, 0xBB67AE8584CAA73B)
_ROUNDS = 10
_LOW = np.uint64(0xFFFFFFFF)
_HALF = np.uint64(32)
_AGENTS_PER_BLOCK = 8
"""A block has four words of 64 bits; each agent gets 32 bits of it."""


class Purpose(IntEnum):
    """What numbers are drawn for. The engine has the small ones."""

    DECIDE = 2
    WALK = 3
    OPPONENT = 2**32


class Moments(NamedTuple):
    """Seed, episode and step of n moments, each uint64 of shape (n,)."""

    seed: Words
    episode: Words
    step: Words


def philox(counter: tuple[Words, Words, Words, Words], key: tuple[Words, Words]) -> Words:
    """Return the four numbers of each counter and key, uint64 of shape (4, n)."""
    c0, c1, c2, c3 = counter
    k0, k1 = key
    for _ in range(_ROUNDS):
        high0, low0 = _product(_MULTIPLIERS[0], c0)
        high1, low1 = _product(_MULTIPLIERS[1], c2)
        c0, c1, c2, c3 = high1 ^ c1 ^ k0, low1, high0 ^ c3 ^ k1, low0
        k0, k1 = k0 + np.uint64(_WEYL[0]), k1 + np.uint64(_WEYL[1])
    return np.stack([c0, c1, c2, c3])


def _product(factor: int, words: Words) -> tuple[Words, Words]:
    """Return the upper and the lower 64 bits of a product; NumPy has only the lower ones."""
    high, low = np.uint64(factor >> 32), np.uint64(factor & 0xFFFFFFFF)
    left, right = words >> _HALF, words & _LOW
    middle = high * right + ((low * right) >> _HALF)
    other = low * left + (middle & _LOW)
    return high * left + (middle >> _HALF) + (other >> _HALF), words * np.uint64(factor)


def _blocks(at: Moments, index: NDArray[Any], step: NDArray[Any], purpose: Purpose) -> Words:
    kind = np.full(index.shape, int(purpose), np.uint64)
    counter = (index.astype(np.uint64), step.astype(np.uint64), kind, np.zeros_like(kind))
    return philox(counter, (at.seed, at.episode))


def decision_draws(at: Moments, agents: NDArray[Any]) -> NDArray[np.uint32]:
    """Return 32 random bits for the decision of each agent at its moment, shape (n,)."""
    words = _blocks(at, agents // _AGENTS_PER_BLOCK, at.step, Purpose.DECIDE)
    pairs = words[agents % _AGENTS_PER_BLOCK // 2, np.arange(len(agents))]
    bits = np.where(agents % 2, pairs >> _HALF, pairs & _LOW)
    return np.asarray(bits, np.uint32)


def stride_draws(at: Moments, agents: NDArray[Any], stride: int) -> Words:
    """Return 64 random bits for each agent, the same during `stride` steps, shape (n,)."""
    return np.asarray(_blocks(at, agents, at.step // np.uint64(stride), Purpose.WALK)[0])


def episode_draws(seed: Words, episode: Words) -> Words:
    """Return 64 random bits for each episode, shape (n,); they choose its opponent."""
    at = Moments(seed, episode, np.zeros_like(seed))
    return np.asarray(_blocks(at, at.step, at.step, Purpose.OPPONENT)[0])


def below(bits: NDArray[Any], n: int | NDArray[Any]) -> NDArray[np.int64]:
    """Return integers in [0, n) from 32 or 64 random bits, as the engine does; n below 2**32.

    The upper half of the product bits * n (Lemire 2019, "Fast random integer generation in an
    interval").
    """
    factor = np.asarray(n, np.uint64)
    words = bits.astype(np.uint64)
    if bits.dtype == np.uint32:
        return np.asarray((words * factor) >> _HALF, np.int64)
    carried = ((words & _LOW) * factor) >> _HALF
    return np.asarray(((words >> _HALF) * factor + carried) >> _HALF, np.int64)


def unit(bits: NDArray[np.uint32]) -> NDArray[np.float32]:
    """Return floats in [0, 1) from the upper 24 of 32 random bits, as many as a float holds."""
    return np.asarray((bits >> np.uint32(8)) * np.float32(2.0**-24), np.float32)
