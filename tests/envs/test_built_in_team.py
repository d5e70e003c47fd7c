"""Environments that play one team themselves: scripts, held-out genomes, champions, functions."""

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import _core
from matrixworld.coevolution import TEAMS, held_out, open_run
from matrixworld.coevolution.types import other
from matrixworld.envs.single import MatrixWorldAEC
from rows import config_of, play_turns, random_team

TOGETHER = ["D", "R", "S", "SDB", "wall-R"]
IN_TURNS = ["TO", "swarm-D", "swarm-SD", "agents-R", "agents-S"]


def chosen(env, policy, agent):
    """Return what a policy chooses for an agent, with the random numbers of a rollout."""
    actions, i = np.zeros(env.config.n_agents, np.int64), env._index[agent]
    env.world.decide(policy, range(i, i + 1), actions)
    return int(actions[i])


def same(played, recorded):
    for name in ("positions", "alive", "rewards", "involved", "fault", "captured"):
        assert np.array_equal(getattr(played, name), getattr(recorded, name)), name


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("name", [*TOGETHER, *IN_TURNS])
def test_an_episode_is_the_engine_s(name, team):
    """Where the rules take turns, the built-in team sees what earlier turns did."""
    config = config_of(name, obstacles=0.1, max_steps=10, diagonal=team == "evader")
    both = random_team(config, 1, activation="tanh"), random_team(config, 2, memory="gru")
    scripts = mw.SCRIPTS[len(name) % 2 :: 2]
    pairs = [*((script, script) for script in scripts), both, both[::-1]]
    pairs.append((random_team(config, 3, sampled=False), "dodger"))
    for seed, (mine, theirs) in enumerate(pairs):
        sides = (theirs, mine) if team == "pursuer" else (mine, theirs)
        recorded = mw.record(config, *sides, seed=seed, episode=2)
        settings = {"record": True, f"{team}s": theirs}
        env = MatrixWorldAEC(config, **settings)
        assert env.possible_agents[0] == f"{other(team)}_0"
        env.reset(seed=seed, options={"episode": 2})
        paid = play_turns(env, lambda agent, _, env=env, mine=mine: chosen(env, mine, agent))
        same(env.recorded, recorded)
        # No reward is lost, whichever team's turn it was paid in.
        total = recorded.rewards.sum(axis=0, dtype=np.float64)[list(env._names)]
        np.testing.assert_allclose(list(paid.values()), total, atol=1e-4)
        if name in TOGETHER:
            env = mw.parallel_env(config, **settings)
            env.reset(seed=seed, options={"episode": 2})
            while env.agents:
                env.step({agent: chosen(env, mine, agent) for agent in env.agents})
            same(env.recorded, recorded)


def test_held_out_genomes_runs_and_policies_are_opponents(race):
    saved = open_run(race)
    config = saved.settings.game.world
    archive = saved.teams["evader"].genomes
    policy = saved.policy("evader", 1)
    for given, genomes in [
        (str(race), archive[-1:]),
        (race, archive[-1:]),
        (saved, archive),
        (saved.teams["evader"], archive),
        (policy, archive[1:2]),
        ([policy, race], archive[1:3]),
    ]:
        opponents = mw.parallel_env(config, evaders=given).opponents
        assert np.array_equal(np.concatenate([each.genomes for each in opponents]), genomes)
    [evolved] = mw.parallel_env("SB", pursuers="evolved-2").opponents
    assert np.array_equal(evolved.genomes, held_out("pursuer", "SB")["evolved-2"].genomes)


def test_a_function_gets_the_observations_of_living_agents():
    seen = []

    def north(observations):
        seen.append(observations)
        return [1] * len(observations)

    env = mw.parallel_env(config_of("D", rows=5, cols=5), evaders=north, record=True)
    env.reset(seed=0)
    while env.agents:
        env.step(dict.fromkeys(env.agents, 0))
    episode = env.recorded
    alive = episode.alive[:-1, 3:]
    assert [len(each) for each in seen] == alive.sum(axis=1).tolist()
    assert alive[-1].sum() < 4  # some have disappeared
    assert (episode.actions[:, 3:][alive] == 1).all()
    assert seen[0].dtype == np.uint8
    assert seen[0].shape == (4, 3, 5, 5)


def test_each_episode_draws_an_opponent_by_its_seed():
    league = ["still", "random", "fleer"]
    env = mw.parallel_env(config_of("R"), evaders=league)
    drawn = []
    for seed, episode in [(2**64 - 1, 2**63), (5, 2), *((seed, 0) for seed in range(300))]:
        env.reset(seed=seed, options={"episode": episode})
        # One draw of the engine's generator, with a purpose of its own.
        assert env.opponent == _core.philox([0, 0, 2**32, 0], [seed, episode])[0] * 3 >> 64
        drawn.append(env.opponent)
    assert np.bincount(drawn, minlength=3).min() > 70  # of 302, a third each
    env.reset(seed=5)
    env.reset()
    env.reset()
    assert env.opponent == drawn[1]  # episode 2 of seed 5, as drawn above


def test_opponents_that_are_set_play_from_the_next_episode_on():
    config = config_of("R")
    env, plain = mw.parallel_env(config, evaders="still"), mw.parallel_env(config)
    env.opponents = ["fleer", random_team(config, 1)]
    env.reset(seed=1)
    with pytest.raises(ValueError, match="evaders: expected one of random, "):
        env.opponents = "nobody"
    assert env.opponents[0] == "fleer"
    assert (plain.opponents, plain.opponent) == ((), None)
    with pytest.raises(ValueError, match="opponents: expected an environment that plays a team"):
        plain.opponents = "still"
