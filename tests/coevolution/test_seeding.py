"""Seeds in bulk, against numpy.random.SeedSequence."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import match_seed
from matrixworld.coevolution import training_seeds
from matrixworld.coevolution.seed_sequence import seeds_of_keys
from matrixworld.coevolution.seeding import Phase

COUNT = 9
EDGES = [0, 1, 2**32 - 1, 2**32, 2**63, 2**64 - 1]


def by_numpy(key):
    """A SeedSequence for each number that comes last."""
    sequences = (np.random.SeedSequence([*key, last]) for last in range(COUNT))
    return [int(sequence.generate_state(1, np.uint64)[0]) for sequence in sequences]


@pytest.mark.parametrize("edge", EDGES)
@pytest.mark.parametrize("length", [4, 5, 8])
def test_seeds_of_keys_at_the_edges(edge, length):
    for place in range(length):
        key = [1] * length
        key[place] = edge
        assert seeds_of_keys(key, COUNT).tolist() == by_numpy(key)
    assert seeds_of_keys([edge] * length, COUNT).tolist() == by_numpy([edge] * length)


def test_seeds_of_keys_of_random_numbers():
    rng = np.random.default_rng(0)
    for _ in range(500):
        shifts = rng.integers(64, size=rng.integers(4, 9))
        key = [int(rng.integers(2**64, dtype=np.uint64)) >> int(shift) for shift in shifts]
        assert seeds_of_keys(key, COUNT).tolist() == by_numpy(key)


def test_a_key_of_long_numbers_may_be_short():
    assert seeds_of_keys([2**63, 2**32], COUNT).tolist() == by_numpy([2**63, 2**32])


@pytest.mark.parametrize("count", [0, 1, 1000])
def test_seeds_of_keys_by_count(count):
    seeds = seeds_of_keys((0, 1, 2, 3), count)
    assert seeds.dtype == np.uint64
    assert seeds.shape == (count,)
    assert seeds.tolist() == [match_seed(0, 1, 2, 3, last) for last in range(count)]


def test_seeds_of_keys_refuse_bad_keys():
    with pytest.raises(ValueError, match="expected at least 4 numbers, got 3"):
        seeds_of_keys((1, 2, 3), COUNT)
    with pytest.raises(ValueError, match="match seed: expected 0 to 18446744073709551615, got -1"):
        seeds_of_keys((1, 2, 3, -1), COUNT)
    with pytest.raises(TypeError, match="expected an integer, got 1.0"):
        seeds_of_keys((1, 2, 3, 1.0), COUNT)


def test_training_seeds_are_match_seeds():
    phase = Phase.EVADERS_LEARN
    seeds = training_seeds(5, 3, 2, phase, 17, COUNT)
    assert seeds.tolist() == [match_seed(5, 3, 2, phase, 17, last) for last in range(COUNT)]
