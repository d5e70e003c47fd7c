"""Networks that remember, against slow loops in double precision; whose state is whose, and when.

After a change of what they compute, run
``PYTHONPATH=tests/support python tests/world/test_memory.py`` to write the golden file anew.
"""

from __future__ import annotations

import copy
import math
import pickle
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from rows import config_of, random_genome, random_team

GOLDEN = Path(__file__).parent / "golden_memory.txt"


def logistic(x: float) -> float:
    return 1 / (1 + math.exp(-x)) if x > -700 else 0.0


def next_state(network: mw.Network, genome: np.ndarray, x: np.ndarray, h: np.ndarray) -> list:
    """Return what an agent remembers next, unit by unit, from the layout that is documented."""
    n, first = network.hidden[0], (network.sizes[0] + 1) * network.hidden[0]
    weights = genome[first : first + 2 * n * 3 * n].astype(float).reshape(2 * n, 3 * n)
    bias = genome[first + 2 * n * 3 * n :][: 3 * n].astype(float)
    from_x = [bias[j] + sum(x[i] * weights[i, j] for i in range(n)) for j in range(3 * n)]
    from_h = [sum(h[i] * weights[n + i, j] for i in range(n)) for j in range(3 * n)]
    found = []
    for j in range(n):
        r, z = (logistic(from_x[k] + from_h[k]) for k in (j, n + j))
        c = math.tanh(from_x[2 * n + j] + r * from_h[2 * n + j])
        found.append(z * h[j] + (1 - z) * c)
    return found


def slow_answer(
    network: mw.Network, genome: np.ndarray, view: np.ndarray, h: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the outputs for a view, and the next state."""
    plain = mw.Network(network.hidden, fov=network.fov, n_actions=network.n_actions)
    inputs, n = network.sizes[:2]
    first = genome[: (inputs + 1) * n].astype(float)
    x = np.maximum(view.ravel() @ first[:-n].reshape(inputs, n) + first[-n:], 0)
    h = np.array(next_state(network, genome, x, h))
    y = h
    later = genome[network.genome_size - plain.genome_size + (inputs + 1) * n :].astype(float)
    for n_in, n_out in zip(network.sizes[1:], network.sizes[2:], strict=False):
        y = y @ later[: n_in * n_out].reshape(n_in, n_out) + later[n_in * n_out :][:n_out]
        later = later[(n_in + 1) * n_out :]
        y = np.maximum(y, 0) if len(later) else y
    return y, h


def decide(world: mw.World, team: mw.Population) -> np.ndarray:
    """Return the actions of all agents."""
    actions = np.zeros(world.config.n_agents, np.int64)
    for agents in (range(world.config.n_pursuers), range(world.config.n_pursuers, len(actions))):
        world.decide(team, agents, actions)
    return actions


@pytest.mark.parametrize("hidden", [(1,), (5, 3), (20,), (33, 4)])
def test_engine_and_numpy_agree_with_slow_loops(hidden: tuple[int, ...]) -> None:
    """Each agent's state, along an episode in which agents disappear."""
    config = config_of("D", n_pursuers=4, n_evaders=4, max_steps=9, obstacles=0.1)
    team = random_team(config, 3, hidden=hidden, memory="gru")
    network, [genome] = team.network, team.genomes
    world = mw.World(config)
    for seed in (1, 2):  # a reset makes all agents forget
        world.reset(seed)
        states = np.zeros((8, hidden[0]))
        fast = np.zeros((8, hidden[0]), np.float32)
        while not (world.terminated or world.truncated):
            alive = np.flatnonzero(world.alive)
            outputs = world._core.logits(network.core, genome)
            in_numpy, fast[alive] = network.advance(genome, world.views()[alive], fast[alive])
            for place, agent in enumerate(alive):
                y, states[agent] = slow_answer(network, genome, world.views()[agent], states[agent])
                np.testing.assert_allclose(outputs[place], y, atol=2e-5)
                np.testing.assert_allclose(in_numpy[place], y, atol=2e-5)
            np.testing.assert_allclose(fast[alive], states[alive], atol=1e-5)
            world.step(decide(world, team))
    assert not world.alive.all()


def remembered(world: mw.World, size: int) -> np.ndarray:
    """Return what is kept for each agent, (A, 2, size): before and after its last decision."""
    snapshot = world._core.snapshot()
    kept = np.zeros((world.config.n_agents, 2, size), np.float32)
    kept[snapshot["memory_sizes"] > 0] = snapshot["memories"].reshape(-1, 2, size)
    return kept


def remembered_sizes(world: mw.World) -> np.ndarray:
    return np.asarray(world._core.snapshot()["memory_sizes"])


def test_memory_belongs_to_the_agents_of_a_world() -> None:
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
    kept = remembered_sizes(world)
    assert set(kept[:3][world.alive[:3]]) == {3}
    assert set(kept[3:][world.alive[3:]]) == {8}


def playthrough() -> Iterator[str]:
    """Yield an episode: actions, and an agent's state as hexadecimal floats."""
    config = config_of("O", max_steps=8)
    network = mw.Network.for_config(config, (3,), memory="gru")
    team = mw.Population(random_genome(network, 2, 0.9), network)
    world = mw.World(config)
    world.reset(4)
    yield "gru, agents of Pursuit-Evasion-O, seed 4"
    while not (world.terminated or world.truncated):
        actions = decide(world, team)
        state = remembered(world, 3)[1, 1].tolist()
        acting = [
            "-" if not alive else str(a) for a, alive in zip(actions, world.alive, strict=True)
        ]
        yield f"  {' '.join(acting)}   pursuer_1 {' '.join(map(float.hex, state))}"
        world.step(actions)


def golden() -> str:
    return "".join(f"{line}\n" for line in playthrough())


def test_golden_playthroughs() -> None:
    """Every bit of the states, on every machine."""
    assert golden() == GOLDEN.read_text(encoding="utf-8")


if __name__ == "__main__":
    GOLDEN.write_text(golden(), encoding="utf-8")
