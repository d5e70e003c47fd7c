"""The paper's three schedules by hand."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld.coevolution import SCHEDULES, TEAMS, Alternating, available

# The paper's pseudo-code, generations 1 to 3 with four epochs each, by hand:
# schedule: {k: (opponents of the pursuers, generations of e; of the evaders, generations of p)}
BY_HAND = {
    "specialist-specialist": {
        1: ([0, 0, 0, 0], [1, 1, 1, 1]),
        2: ([1, 1, 1, 1], [2, 2, 2, 2]),
        3: ([2, 2, 2, 2], [3, 3, 3, 3]),
    },
    "generalist-specialist": {
        1: ([0, 0, 0, 0], [1, 1, 1, 1]),
        2: ([0, 1, 0, 1], [2, 2, 2, 2]),
        3: ([0, 1, 2, 0], [3, 3, 3, 3]),
    },
    "generalist-generalist": {
        1: ([0, 0, 0, 0], [0, 1, 0, 1]),
        2: ([0, 1, 0, 1], [0, 1, 2, 0]),
        3: ([0, 1, 2, 0], [0, 1, 2, 3]),
    },
}


def opponents(name, team, k, epochs):
    """Return the opponents of a team in the first epochs of its generation k."""
    sampler, rng = SCHEDULES[name].new_sampler(team), np.random.default_rng(0)
    sampled = [sampler.sample(available(team, k), i, rng).tolist() for i in range(epochs)]
    assert all(len(each) == 1 for each in sampled)
    return [each[0] for each in sampled]


def test_a_schedule_has_the_name_that_the_paper_gives_it():
    assert [each.name for each in SCHEDULES.values()] == list(SCHEDULES) == list(BY_HAND)
    assert Alternating(pursuers_meet="latest").name == "alternating"
    # Several opponents in an epoch are no schedule of the paper.
    several = Alternating(pursuers_meet="latest", evaders_meet="latest", opponents=2)
    assert several.name == "alternating"


@pytest.mark.parametrize("name", BY_HAND)
@pytest.mark.parametrize("k", [1, 2, 3])
def test_schedule(name, k):
    met = tuple(opponents(name, team, k, 4) for team in TEAMS)
    assert met == BY_HAND[name][k]


def test_generation_zero_learns_nothing():
    with pytest.raises(ValueError, match="generation: expected at least 1, got 0"):
        available("pursuer", 0)
