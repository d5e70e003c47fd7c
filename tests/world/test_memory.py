"""Networks that remember, against NumPy; whose state is whose, and when.

NumPy is compared with the GRUs of PyTorch and ONNX in ``tests/clients``.
After a change of what they compute, run
``PYTHONPATH=tests/support python tests/world/test_memory.py`` to write the golden file anew.
"""

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from rows import config_of, random_genome, random_team

GOLDEN = Path(__file__).parent / "golden_memory.txt"


def decide(world, team):
    actions = np.zeros(world.config.n_agents, np.int64)
    for agents in (range(world.config.n_pursuers), range(world.config.n_pursuers, len(actions))):
        world.decide(team, agents, actions)
    return actions


@pytest.mark.parametrize("hidden", [(1,), (5, 3), (20,), (33, 4)])
def test_the_engine_agrees_with_numpy(hidden):
    """Each agent's state, along an episode in which agents disappear."""
    config = config_of("D", n_pursuers=4, n_evaders=4, max_steps=9, obstacles=0.1)
    team = random_team(config, 3, hidden=hidden, memory="gru")
    network, [genome] = team.policy, team.genomes
    world = mw.World(config)
    for seed in (1, 2):  # a reset makes all agents forget
        world.reset(seed)
        states = np.zeros((8, hidden[0]), np.float32)
        while not (world.terminated or world.truncated):
            alive = world.alive
            outputs = world._core.logits(network.core, genome)
            expected, states[alive] = network.advance(genome, world.views()[alive], states[alive])
            np.testing.assert_allclose(outputs, expected, atol=2e-5)
            world.step(decide(world, team))
    assert not world.alive.all()


def remembered(world, size):
    """Return what is kept for each agent, (A, 2, size): before and after its last decision."""
    snapshot = world._core.snapshot()
    kept = np.zeros((world.config.n_agents, 2, size), np.float32)
    kept[snapshot["memory_sizes"] > 0] = snapshot["memories"].reshape(-1, 2, size)
    return kept


def test_memory_belongs_to_the_agents_of_a_world():
    config = config_of("D", rows=12, cols=12, max_steps=40)
    team = random_team(config, 5, hidden=(8,), memory="gru")
    world = mw.World(config)
    for _ in range(6):
        world.step(decide(world, team))
    first = decide(world, team)
    kept = remembered(world, 8)
    assert kept[world.alive].any(axis=(1, 2)).all()
    assert not kept[~world.alive].any()
    # To ask again changes nothing, nor does a policy that remembers nothing.
    world.decide("random", range(3), np.zeros(7, np.int64))
    assert np.array_equal(decide(world, team), first)
    assert np.array_equal(remembered(world, 8), kept)
    # Copies remember, and go on for themselves.
    twins = copy.deepcopy(world), pickle.loads(pickle.dumps(world))  # noqa: S301
    for each in (world, *twins):
        each.step(decide(each, team))
    for twin in twins:
        assert np.array_equal(remembered(twin, 8), remembered(world, 8))
    twins[0].step(np.zeros(7, np.int64))
    twins[0].reset(1)
    assert not remembered(twins[0], 8).any()
    assert remembered(world, 8).any()
    # A state of another length begins with zeros.
    world.decide(random_team(config, 5, hidden=(3,), memory="gru"), range(3), first)
    kept = np.asarray(world._core.snapshot()["memory_sizes"])
    assert set(kept[:3][world.alive[:3]]) == {3}
    assert set(kept[3:][world.alive[3:]]) == {8}


def golden():
    config = config_of("O", max_steps=8)
    network = mw.Network.for_config(config, (3,), memory="gru")
    team = mw.Population(random_genome(network, 2, 0.9), network)
    world = mw.World(config)
    world.reset(4)
    text = "gru, agents of Pursuit-Evasion-O, seed 4\n"
    while not (world.terminated or world.truncated):
        actions = decide(world, team)
        state = " ".join(map(float.hex, remembered(world, 3)[1, 1].tolist()))
        acting = " ".join(np.where(world.alive, actions.astype(str), "-"))
        text += f"  {acting}   pursuer_1 {state}\n"
        world.step(actions)
    return text


def test_golden_playthroughs():
    assert golden() == GOLDEN.read_text(encoding="utf-8")


if __name__ == "__main__":
    GOLDEN.write_text(golden(), encoding="utf-8")
