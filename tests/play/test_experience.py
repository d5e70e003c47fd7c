"""Experience: transitions of a team's agents are those of the matches that `rollout` plays."""

import hashlib

import numpy as np
import pytest

from matrixworld.coevolution.types import TEAMS, other
from matrixworld.play.experience import experience
from matrixworld.play.rollout import Matches, rollout
from matrixworld.world.config import WorldConfig
from matrixworld.world.world import World
from rows import config_of, random_team

CONFIG = WorldConfig("D", rows=7, cols=7, n_pursuers=3, n_evaders=4, fov=5, max_steps=25)
OWN, OTHERS = random_team(CONFIG, 0, hidden=(6,)), random_team(CONFIG, 1, 2, 3, hidden=(6,))
SEEDS = np.array([3, 2**63, 9, 11], np.uint64)
CHOSEN = np.array([0, 2, 1, 2])


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("opponents", [OTHERS, "random"], ids=["genomes", "script"])
@pytest.mark.parametrize("worlds", [1, 3])
def test_the_matches_are_those_of_a_rollout(team, opponents, worlds):
    found = experience(CONFIG, team, OWN, opponents, CHOSEN, SEEDS, worlds=worlds, threads=1)
    others = 0 if isinstance(opponents, str) else CHOSEN
    sides = (OWN, opponents) if team == "pursuer" else (opponents, OWN)
    indices = (0, others) if team == "pursuer" else (others, 0)
    scores = rollout(CONFIG, *sides, Matches.of(*indices, SEEDS), episodes=worlds)
    side = TEAMS.index(team)
    np.testing.assert_array_equal(found.acted.sum((0, 2)), scores.agent_steps[..., side].ravel())
    lengths = found.acted.any(axis=2).sum(axis=0)
    assert (lengths <= scores.length.ravel()).all()
    returns = (scores.pursuer_return, scores.evader_return)[side]
    world = np.nonzero(found.acted)[1]
    earned = np.bincount(world, weights=found.rewards.astype(float), minlength=len(SEEDS) * worlds)
    np.testing.assert_allclose(earned, returns.ravel(), rtol=1e-6)
    faults = np.bincount(world, weights=found.costs, minlength=len(SEEDS) * worlds)
    np.testing.assert_array_equal(faults, scores.faults[:, :, side].sum(axis=2).ravel())


def test_states_are_kept_if_asked_for():
    found = experience(CONFIG, "evader", OWN, "random", CHOSEN, SEEDS, states=True, threads=1)
    world = World(CONFIG)
    world.reset(seed=int(SEEDS[2]))
    assert found.states is not None
    assert found.states.shape == (len(found.acted), 4, 3 * 49)
    np.testing.assert_array_equal(found.states[0, 2], world.state().ravel())
    assert experience(CONFIG, "evader", OWN, "still", CHOSEN, SEEDS).states is None


DIGESTS = {
    "TO": ("acd360af", "d5b4e966"),
    "swarm-D": ("fa6ca3e8", "8a2c1bf5"),
    "agents-S": ("146b2435", "a441d53b"),
    "D": ("7af0aca4", "97d4ec41"),
}
"""Digests of transitions, by rules and team. Single worlds that were played turn by turn by a test
that stood here at commit 8e1a8000 have given the same."""


@pytest.mark.parametrize("name", DIGESTS)
def test_agents_earn_what_comes_from_their_turn_to_their_next_one(name):
    config, seeds = config_of(name, max_steps=6), np.arange(8, dtype=np.uint64)
    teams = {"pursuer": random_team(config, 3), "evader": random_team(config, 4)}
    digests = []
    for team in TEAMS:
        sides = teams[team], teams[other(team)]
        found = experience(config, team, *sides, np.zeros(8, int), seeds, threads=1)
        digest = hashlib.sha256(np.round(found.rewards * 1000).astype(np.int32).tobytes())
        for array in (found.acted, found.views, found.actions, found.last, found.last_views):
            digest.update(array.astype(np.uint8).tobytes())
        digests.append(digest.hexdigest()[:8])
    assert tuple(digests) == DIGESTS[name]
