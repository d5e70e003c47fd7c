"""The seeds of numpy.random.SeedSequence for many keys that differ in their last number.

One SeedSequence a match would take several hundredths of the time of a race. Its arithmetic, which
NumPy promises to keep, is that of M. E. O'Neill, "Developing a seed_seq Alternative" (2015): a pool
of four words of 32 bits takes up the words of a key one after the other.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from matrixworld.checks import SEED_MAX, check_integer

POOL_WORDS = 4
WORD_BITS = 32
SHIFT = np.uint32(16)
INIT_A, MULT_A = 0x43B0D7E5, 0x931E8875
INIT_B, MULT_B = 0x8B51F9DD, 0x58F38DED
MIX_LEFT, MIX_RIGHT = np.uint32(0xCA01F9DD), np.uint32(0x4973F715)

Words = NDArray[np.uint32]


def seeds_of_keys(key: Sequence[int], count: int) -> NDArray[np.uint64]:
    """Return ``match_seed(*key, i)`` for i from 0 to `count` - 1, (count,) uint64.

    Raises ValueError for numbers below 0 and for a key that does not fill the pool, which four
    numbers always do; TypeError for what is not an integer.
    """
    numbers = [check_integer("match seed", number, 0, SEED_MAX) for number in key]
    n_words = sum(max(1, -(-number.bit_length() // WORD_BITS)) for number in numbers)
    if n_words < POOL_WORDS:
        raise ValueError(f"key: expected at least {POOL_WORDS} numbers, got {len(numbers)}")
    # Each of the first words is hashed once for every word of the pool, and so is each later one.
    n_hashes = POOL_WORDS * n_words
    pool = np.random.SeedSequence(numbers).pool[:2, np.newaxis]  # a seed is made of two words
    last = _hashed(np.arange(count, dtype=np.uint32), INIT_A, MULT_A, n_hashes)
    low, high = _hashed(_mixed(pool, last), INIT_B, MULT_B, 0).astype(np.uint64)
    seeds: NDArray[np.uint64] = low | high << WORD_BITS
    return seeds


def _hashed(values: Words, init: int, factor: int, n_before: int) -> Words:
    """Two hashes in turn (2, n) of values (n,) or (2, n), after `n_before` others."""
    powers = [init * pow(factor, n_before + i, 2**WORD_BITS) % 2**WORD_BITS for i in range(3)]
    constants = np.array(powers, np.uint32)[:, np.newaxis]
    return _folded((values ^ constants[:2]) * constants[1:])


def _mixed(left: Words, right: Words) -> Words:
    return _folded(MIX_LEFT * left - MIX_RIGHT * right)


def _folded(words: Words) -> Words:
    folded: Words = words ^ words >> SHIFT
    return folded
