"""Experience: transitions of a team's agents are those of the matches that `rollout` plays."""

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.coevolution.types import TEAMS, Team, other
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
def test_the_matches_are_those_of_a_rollout(team: Team, opponents, worlds: int) -> None:
    found = experience(CONFIG, team, OWN, opponents, CHOSEN, SEEDS, worlds=worlds, threads=1)
    others = 0 if isinstance(opponents, str) else CHOSEN
    sides = (OWN, opponents) if team == "pursuer" else (opponents, OWN)
    indices = (0, others) if team == "pursuer" else (others, 0)
    scores = rollout(CONFIG, *sides, Matches.of(*indices, SEEDS), episodes=worlds)
    side = TEAMS.index(team)
    np.testing.assert_array_equal(
        found.acted.sum(axis=(0, 2)), scores.agent_steps[..., side].ravel()
    )
    lengths = found.acted.any(axis=2).sum(axis=0)
    assert (lengths <= scores.length.ravel()).all()
    returns = (scores.pursuer_return, scores.evader_return)[side]
    world = np.nonzero(found.acted)[1]
    earned = np.bincount(world, weights=found.rewards.astype(float), minlength=len(SEEDS) * worlds)
    np.testing.assert_allclose(earned, returns.ravel(), rtol=1e-6)
    faults = np.bincount(world, weights=found.costs, minlength=len(SEEDS) * worlds)
    np.testing.assert_array_equal(faults, scores.faults[:, :, side].sum(axis=2).ravel())


def test_states_are_kept_if_asked_for() -> None:
    found = experience(CONFIG, "evader", OWN, "random", CHOSEN, SEEDS, states=True, threads=1)
    world = World(CONFIG)
    world.reset(seed=int(SEEDS[2]))
    assert found.states is not None
    assert found.states.shape == (len(found.acted), 4, 3 * 49)
    np.testing.assert_array_equal(found.states[0, 2], world.state().ravel())
    assert experience(CONFIG, "evader", OWN, "still", CHOSEN, SEEDS).states is None


@pytest.mark.parametrize("name", ["TO", "swarm-D", "agents-S", "D"])
@pytest.mark.parametrize("team", ["pursuer", "evader"])
def test_agents_earn_what_comes_from_their_turn_to_their_next_one(name: str, team: Team) -> None:
    """Against single worlds that are played turn by turn."""
    config = config_of(name, max_steps=6)
    teams = {"pursuer": random_team(config, 3), "evader": random_team(config, 4)}
    pursuers, everyone = range(config.n_pursuers), range(config.n_agents)
    own = pursuers if team == "pursuer" else everyone[config.n_pursuers :]
    seeds = np.arange(8, dtype=np.uint64)
    found = experience(
        config, team, teams[team], teams[other(team)], np.zeros(8, int), seeds, threads=1
    )
    rows: dict[tuple[int, int, int], list[Any]] = {}  # step, episode, agent: [view, action, earned]
    ends = {}
    for w in range(8):
        world = mw.World(config)
        world.reset(w)
        while not (world.terminated or world.truncated):
            before = np.zeros(config.n_agents, np.float32)
            for _ in range(world.n_turns):
                actions, step = np.zeros(config.n_agents, np.int64), world.steps
                for a in world.actors:
                    one = teams["pursuer" if a in pursuers else "evader"]
                    world.decide(one, range(a, a + 1), actions)
                    if a in own and world.alive[a] and not world.terminated:
                        rows[step, w, a] = [world.views()[a].ravel(), actions[a], np.float32(0)]
                world.play_turn(actions)
                for a in own:  # to the last of its turns, if it has had one
                    last = max((key for key in rows if key[1:] == (w, a)), default=None)
                    if last:
                        rows[last][2] += world.rewards[a] - before[a]
                before = world.rewards.copy()
            if world.truncated:
                ends |= {(step, w, a): world.views()[a] for a in own if world.alive[a]}
    acted = [(t, w, a - own.start) for t, w, a in sorted(rows)]
    assert np.argwhere(found.acted).tolist() == [list(key) for key in acted]
    views, actions, earned = zip(*(rows[key] for key in sorted(rows)), strict=True)
    np.testing.assert_array_equal(found.views, views)
    np.testing.assert_array_equal(found.actions, actions)
    np.testing.assert_allclose(found.rewards, earned, atol=1e-6)
    last = [key for key in sorted(ends) if key in rows]
    assert np.argwhere(found.last).tolist() == [[t, w, a - own.start] for t, w, a in last]
    expected = np.array([ends[key].ravel() for key in last])
    np.testing.assert_array_equal(found.last_views, expected.reshape(found.last_views.shape))
