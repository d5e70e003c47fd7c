"""Seeds of training matches, against numpy.random.SeedSequence."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from matrixworld.coevolution.seeding import Phase, evaluation_seed, training_seeds

LARGEST = 2**64 - 1


@pytest.mark.parametrize("key", [(5, 3, 2, Phase.EVADERS_LEARN, 17), (LARGEST, 0, 0, 1, 0)])
def test_training_seeds_are_the_words_of_a_seed_sequence(key):
    words = np.random.SeedSequence([int(number) for number in key]).generate_state(9, np.uint64)
    assert training_seeds(*key, 9).tolist() == words.tolist()


@pytest.mark.parametrize("count", [0, 1, 1000])
def test_a_seed_does_not_depend_on_how_many_there_are(count):
    seeds = training_seeds(0, 1, 2, Phase.ARCHIVE, 3, count)
    assert seeds.dtype == np.uint64
    assert seeds.tolist() == training_seeds(0, 1, 2, Phase.ARCHIVE, 3, 1000)[:count].tolist()


def test_seeds_of_all_matches_differ():
    keys = itertools.product(range(3), range(3), range(3), Phase, range(3))
    seeds = [seed for key in keys for seed in training_seeds(*key, 5).tolist()]
    seeds += [evaluation_seed(*key) for key in itertools.product(range(3), repeat=3)]
    assert len(set(seeds)) == len(seeds) == 3**4 * len(Phase) * 5 + 3**3
