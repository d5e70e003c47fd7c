"""Policies outside of rollouts act as they do inside, with the same random numbers."""

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from rows import config_of, random_team


def same_as_recorded(config: mw.WorldConfig, pursuers: Any, evaders: Any, seed: int) -> None:
    """Compare an episode in which both teams decide turn by turn with the engine's own.

    Agents that a turn removed have no action after it.
    """
    teams = {range(config.n_pursuers): pursuers, range(config.n_pursuers, config.n_agents): evaders}
    world = mw.World(config)
    world.reset(seed, episode=3)
    recorder = mw.Recorder(world)
    while not (world.terminated or world.truncated):
        actions = np.zeros(config.n_agents, np.int64)
        for _ in range(world.n_turns):
            for team, policy in teams.items():
                turn = world.actors
                acting = range(max(team.start, turn.start), min(team.stop, turn.stop))
                if acting:
                    world.decide(policy, acting, actions)
            world.play_turn(actions)
        recorder.note(actions)
    recorded = mw.record(config, pursuers, evaders, seed=seed, episode=3)
    for name in ("positions", "rewards", "involved", "captured"):
        assert np.array_equal(getattr(recorder.episode(), name), getattr(recorded, name))


@pytest.mark.parametrize("script", mw.SCRIPTS)
@pytest.mark.parametrize("name", ["R", "SDB", "TO", "swarm-SD"])
def test_scripts_act_as_in_rollouts(script: Any, name: str) -> None:
    walls = {"obstacles": 0.2}
    narrow = {"fov": 5 if script.startswith("careful-") else 1}
    for seed, changes in enumerate([walls, narrow, {"diagonal": True, "rows": 14} | walls]):
        config = config_of(name, max_steps=14, **changes)
        same_as_recorded(config, script, "random", seed)
        same_as_recorded(config, "clumsy-chaser", script, seed + 100)


@pytest.mark.parametrize("sampled", [True, False])
@pytest.mark.parametrize(
    ("activation", "memory"), [("relu", "none"), ("tanh", "none"), ("tanh", "gru")]
)
@pytest.mark.parametrize("name", ["D", "S", "SB", "TO", "swarm-D", "agents-SD"])
def test_networks_act_as_in_rollouts(
    name: str, activation: str, memory: str, sampled: bool
) -> None:
    config = config_of(name, obstacles=0.1, max_steps=14)
    fields = {"hidden": (6, 5), "activation": activation, "memory": memory, "sampled": sampled}
    for seed in range(2):
        pursuers, evaders = (random_team(config, 2 * seed + team, **fields) for team in range(2))
        same_as_recorded(config, pursuers, evaders, seed)


@pytest.mark.parametrize("name", ["D", "SB", "TO", "agents-R"])
def test_worlds_of_a_batch_decide_as_single_worlds(name: str) -> None:
    """Each with the policy that was chosen for it, for any number of threads."""
    config = config_of(name, obstacles=0.1, max_steps=9)
    league = [
        "hunter",
        random_team(config, 1),
        None,
        random_team(config, 2, sampled=False),
        "random",
        random_team(config, 3, memory="gru"),
    ]
    n_worlds = 60  # ten for each of the league
    place = np.random.default_rng(0).integers(len(league), size=n_worlds)
    batches = [mw.Batch(n_worlds, config, threads=threads) for threads in (1, 3)]
    for batch in batches:
        batch.reset(5)
    agents = range(config.n_pursuers, config.n_agents)
    for _ in range(11):  # two steps more than an episode has
        expected = np.full((n_worlds, config.n_agents), 7)
        for world, row in enumerate(expected):
            if league[place[world]] is not None:
                batches[0].world(world).decide(league[place[world]], agents, row)
        for batch in batches:
            # No legal action: what is not written stays visible.
            actions = np.full_like(expected, 7)
            batch.decide(league, place, agents, actions)
            assert np.array_equal(actions, expected)
            assert (actions[:, : config.n_pursuers] == 7).all()
            batch.step(actions % 5)
    assert (expected == 7).all()  # nobody decides in an episode that has ended
