"""The paper's three schedules by hand, and a race that climbs with every sampler."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld.coevolution import SCHEDULES, TEAMS, Alternating, available
from matrixworld.coevolution.opponents import ArchiveSampler
from matrixworld.coevolution.schedules import ARCHIVES, SAMPLERS
from matrixworld.coevolution.types import other

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


# A transitive race with perfect learners: every sampler must let it climb.
#
# A pursuer of strength s beats the evaders below s. In each generation a team becomes just strong
# enough to beat the strongest opponent that it has met, and is never weaker than before. The newest
# opponent is always the strongest, so a race climbs one step in each generation in which the team
# meets it.


GENERATIONS, EPOCHS = 20, 20


class Ladder:
    """A race of strengths, with the samplers of both teams and the generations that they met."""

    def __init__(self, name: str, count: int) -> None:
        schedule = Alternating(pursuers_meet=name, evaders_meet=name, opponents=count)
        self.samplers = {team: schedule.new_sampler(team) for team in TEAMS}
        self.strengths = {team: np.zeros(1, dtype=int) for team in TEAMS}
        self.met_newest = 0

    def payoff(self, team, own, opponents):
        """Return 1 for each win (n, m) of generations `own` over `opponents`."""
        mine = self.strengths[team][own][:, np.newaxis]
        theirs = self.strengths[other(team)][opponents]
        # Of equals the evader wins.
        return (mine > theirs if team == "pursuer" else mine >= theirs).astype(float)

    def learn(self, team, generation, rng):
        sampler, n = self.samplers[team], available(team, generation)
        before = available(team, generation - 1) if generation > 1 else 0
        if isinstance(sampler, ArchiveSampler):
            sampler.update(
                np.array([generation - 1]),
                np.arange(before, n),
                lambda candidates, tests: self.payoff(team, candidates, tests),
            )
        met = set()
        for epoch in range(EPOCHS):
            opponents = sampler.sample(n, epoch, rng)
            # Two candidates, so that fitness differs: the team itself, and a beginner.
            scores = self.payoff(team, [-1, 0], opponents)
            sampler.tell(opponents, scores)
            met |= set(opponents.tolist())
        self.met_newest += n - 1 in met
        strongest = self.strengths[other(team)][sorted(met)].max()
        reached = max(self.strengths[team][-1], strongest + (team == "pursuer"))
        self.strengths[team] = np.append(self.strengths[team], reached)


def climbed(name, count, seed=0):
    """Return the race after all generations."""
    race, rng = Ladder(name, count), np.random.default_rng(seed)
    for generation in range(1, GENERATIONS + 1):
        for team in TEAMS:
            race.learn(team, generation, rng)
    return race


@pytest.mark.parametrize("count", [1, 2, 4])
@pytest.mark.parametrize("name", SAMPLERS)
def test_a_transitive_race_climbs_with_every_sampler(name, count):
    races = [climbed(name, count, seed) for seed in range(3)]
    top = [race.strengths["evader"][-1] for race in races]
    # With the newest opponent in every generation it climbs to 20.
    assert min(top) >= 10
    assert np.mean(top) >= 12
    if name in ARCHIVES:
        # Archives lose no newest opponent.
        assert races[0].met_newest == 2 * GENERATIONS
        assert races[0].strengths["evader"].tolist() == list(range(GENERATIONS + 1))
