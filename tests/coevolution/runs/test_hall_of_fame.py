"""Simultaneous co-evolution with halls of fame."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import coevolution
from matrixworld.coevolution.runs.race import HallOfFameRace, pairings, table_of_individuals
from tiny_race import hall_of_fame


@pytest.mark.parametrize("groups", [1, 3, 6])
def test_all_individuals_have_the_same_number_of_opponents(groups):
    pairs = pairings(np.tile(np.arange(groups), 6 // groups), 3, (1, 2), np.random.default_rng(0))
    assert len(pairs.pursuer) == len(pairs.evader) == len(pairs.group) == 6 * (3 + 1 + 2)
    for individual in range(6):
        opponents = pairs.evader[pairs.pursuer == individual]
        assert sorted(opponents[opponents >= 6]) == [6, 7]
        assert (opponents < 6).sum() == 3
        opponents = pairs.pursuer[pairs.evader == individual]
        assert sorted(opponents[opponents >= 6]) == [6]
        assert (opponents < 6).sum() == 3
    assert not ((pairs.pursuer >= 6) & (pairs.evader >= 6)).any()
    # Each round of opponents has its own seeds: one for each group of individuals.
    assert np.array_equal(np.unique(pairs.group), np.arange(6 * groups))


def test_mirrored_individuals_meet_the_same_opponents_on_the_same_seeds():
    mirrored = np.tile(np.arange(4), 2)  # 0 and 4 are a pair, 1 and 5, ...
    pairs = pairings(mirrored, 4, (1, 1), np.random.default_rng(3))

    def met(individual):
        chosen = pairs.pursuer == individual
        return sorted(zip(pairs.evader[chosen], pairs.group[chosen], strict=True))

    for one in range(4):
        first, second = met(one), met(one + 4)
        assert [evader for evader, _ in first] == [evader for evader, _ in second]
        assert {group for _, group in first} == {group for _, group in second}
        living = [evader for evader, _ in first if evader < 8]
        # Whole pairs of evaders, too.
        assert sorted((evader + 4) % 8 for evader in living) == living


def test_individuals_of_one_group_meet_opponents_of_their_own():
    pairs = pairings(np.zeros(6, dtype=int), 3, (0, 0), np.random.default_rng(0))
    rounds = pairs.evader.reshape(3, 6) - pairs.pursuer.reshape(3, 6)
    # Permutations, not rotations: in each round the distances differ.
    assert all(len(set(each % 6)) > 1 for each in rounds)


def test_matches_as_a_table_of_individuals():
    own, opponents = np.array([0, 1, 1, 3, 0, 0]), np.array([1, 0, 2, 1, 1, 3])
    values = np.array([1.0, 2.0, 4.0, 9.0, 5.0, 7.0])
    table = table_of_individuals(own, opponents, 2, values)
    assert np.array_equal(
        table, [[np.nan, 3.0, np.nan, 7.0], [2.0, np.nan, 4.0, np.nan]], equal_nan=True
    )


def test_race(tmp_path):
    race = coevolution.start(hall_of_fame(), tmp_path / "run")
    assert isinstance(race, HallOfFameRace)
    payoff = race.run()
    assert payoff.capture_rate.shape == (4, 4)
    archive = race.files.archive()
    assert archive["pursuer"].shape == archive["evader"].shape == (4, race.network.genome_size)
    log = race.files.log()
    assert log["team"].tolist() == ["pursuer", "evader"] * 6
    assert log["generation"].tolist() == [1] * 4 + [2] * 4 + [3] * 4
    per_epoch = [4 * (2 + 2 * hall) for hall in (1, 2, 2) for _ in range(2)]
    assert log["matches"][::2].tolist() == np.cumsum(per_epoch).tolist()
    assert race.phase_rates().shape == (3, 2)
