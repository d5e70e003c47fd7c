"""Policies outside of rollouts act as they do inside, with the same random numbers."""

from __future__ import annotations

from typing import Any, get_args

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import _core
from matrixworld.play import MOMENT, decide
from matrixworld.play.draws import below, philox
from matrixworld.play.scripts import ROWS
from matrixworld.policy import Script
from rows import config_of


def play(config: mw.WorldConfig, teams: dict[range, Any], seed: int, episode: int) -> mw.Episode:
    """Return an episode in which both teams decide turn by turn."""
    world = mw.World(config)
    world.reset(seed, episode=episode)
    recorder = mw.Recorder(world)
    while not (world.terminated or world.truncated):
        actions = np.zeros((1, config.n_agents), np.int64)
        first = True
        while first or world.turn:
            first = False
            moment = {name: array[None] for name, array in world.read(*MOMENT).items()}
            for team, policy in teams.items():
                turn = world.actors
                acting = range(max(team.start, turn.start), min(team.stop, turn.stop))
                decide(policy, config, moment, acting, actions)
            world.play_turn(actions[0])
        recorder.note(actions[0])
    return recorder.episode()


def genomes(config: mw.WorldConfig, seed: int, **fields: Any) -> mw.Population:
    network = mw.Network.for_config(config, (6, 5), **fields)
    return mw.Population(network.initial(np.random.default_rng(seed), 0.5, 1.0), network)


def same_as_recorded(config: mw.WorldConfig, pursuers: Any, evaders: Any, seed: int) -> None:
    """Compare with the engine's own episode. Agents that a turn removed have no action after it."""
    teams = {
        range(config.n_pursuers): pursuers,
        range(config.n_pursuers, config.n_agents): evaders,
    }
    recorded = mw.record(config, pursuers, evaders, seed=seed, episode=3)
    played = play(config, teams, seed, 3)
    for name in ("positions", "rewards", "involved", "captured"):
        assert np.array_equal(getattr(played, name), getattr(recorded, name))


def test_every_script_has_a_row() -> None:
    assert tuple(ROWS) == get_args(Script)


@pytest.mark.parametrize("script", mw.SCRIPTS)
@pytest.mark.parametrize("name", ["R", "SDB", "TO", "swarm-SD"])
def test_scripts_act_as_in_rollouts(script: Any, name: str) -> None:
    walls = {"obstacles": 0.2}
    for seed, changes in enumerate([walls, {"fov": 1}, {"diagonal": True, "rows": 14} | walls]):
        config = config_of(name, max_steps=14, **changes)
        same_as_recorded(config, script, "random", seed)
        same_as_recorded(config, "clumsy-chaser", script, seed + 100)


@pytest.mark.parametrize("sampled", [True, False])
@pytest.mark.parametrize("activation", ["relu", "tanh"])
@pytest.mark.parametrize("name", ["D", "S", "SB", "TO", "swarm-D", "agents-SD"])
def test_networks_act_as_in_rollouts(name: str, activation: str, sampled: bool) -> None:
    config = config_of(name, obstacles=0.1, max_steps=14)
    fields = {"activation": activation, "sampled": sampled}
    for seed in range(2):
        pursuers, evaders = (genomes(config, 2 * seed + team, **fields) for team in range(2))
        same_as_recorded(config, pursuers, evaders, seed)


def test_random_numbers_are_the_engine_s() -> None:
    rng = np.random.default_rng(0)
    counters = rng.integers(0, 2**64, (4, 50), np.uint64)
    keys = rng.integers(0, 2**64, (2, 50), np.uint64)
    expected = [
        _core.philox(c.tolist(), k.tolist()) for c, k in zip(counters.T, keys.T, strict=True)
    ]
    assert philox(tuple(counters), tuple(keys)).T.tolist() == expected
    words = counters[0]
    assert below(words, 9).tolist() == [int(word) * 9 >> 64 for word in words]
    halves = (words >> np.uint64(32)).astype(np.uint32)
    assert below(halves, 5).tolist() == [int(word) * 5 >> 32 for word in halves]


@pytest.mark.parametrize(
    ("answer", "error", "message"),
    [
        ([0.5] * 3, TypeError, "actions of the policy: expected integers"),
        ([0, 1], ValueError, r"actions of the policy: expected shape \(3,\), got \(2,\)"),
        ([0, 5, 0], ValueError, "actions of the policy: expected 0 to 4, got 5"),
        ([0, 0, -1], ValueError, "actions of the policy: expected 0 to 4, got -1"),
    ],
)
def test_wrong_answers_of_a_callable_are_refused(answer: Any, error: Any, message: str) -> None:
    config = config_of("O")
    world = mw.World(config)
    moment = {name: array[None] for name, array in world.read(*MOMENT).items()}
    actions = np.full((1, config.n_agents), 7)
    with pytest.raises(error, match=message):
        decide(lambda seen: answer, config, moment, range(3), actions)
    assert (actions == 7).all()
