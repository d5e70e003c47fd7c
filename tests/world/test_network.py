"""The compiled network against NumPy, its samples, and the kernels of each instruction set."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from scipy import stats
from scipy.special import softmax

import matrixworld as mw
from matrixworld import _core
from rows import random_genome

HIDDEN = [(), (1,), (7,), (16,), (32,), (64, 64), (40, 30, 20)]
"""Hidden layers that fill a processor's vectors, fall short of them and go beyond them."""
LEVELS = {"base": "kernels_base", "x86-64-v3": "kernels_v3", "x86-64-v4": "kernels_v4"}


def assert_agrees(world, network, seed):
    genome = random_genome(network, seed)
    expected = network.logits(genome, world.views()[world.alive])
    found = world._core.logits(network.core, genome)
    assert found.dtype == np.float32
    scale = max(1.0, float(np.abs(expected).max()))  # float32: the error grows with the numbers
    np.testing.assert_allclose(found, expected, rtol=1e-4, atol=1e-5 * scale)


@pytest.mark.parametrize("activation", ["relu", "tanh"])
@pytest.mark.parametrize("hidden", HIDDEN)
def test_shapes(hidden, activation):
    for number, (fov, diagonal) in enumerate([(5, False), (11, True), (13, False)]):
        world = mw.World(rows=9, cols=14, fov=fov, diagonal=diagonal, obstacles=0.2)
        network = mw.Network.for_config(world.config, hidden, activation=activation)
        assert_agrees(world, network, number)


# Up to views much larger than the grid.
@pytest.mark.parametrize("fov", [1, 5, 11, 15, 57, 61])
@pytest.mark.parametrize("shape", [(7, 6), (1, 40), (33, 2), (20, 24)])
def test_every_place_in_every_view(shape, fov):
    """Wherever an agent stands, it sees the border that belongs to that place."""
    rows, cols = shape
    n_evaders = rows * cols // 3  # the grid is full: somebody stands on each cell
    n_pursuers = rows * cols - n_evaders
    world = mw.World(rows=rows, cols=cols, n_pursuers=n_pursuers, n_evaders=n_evaders, fov=fov)
    assert_agrees(world, mw.Network.for_config(world.config, (9,)), fov)


@pytest.mark.parametrize(
    ("name", "side", "n"), [("D", 8, 15), ("R", 8, 20), ("R", 12, 50), ("R", 18, 100)]
)
def test_after_deaths_and_with_shared_cells(name, side, n):
    config = {"rows": side, "cols": side, "n_pursuers": n, "n_evaders": n}
    world = mw.World(name, fov=7, obstacles=0.1, **config)
    network = mw.Network.for_config(world.config, (12, 12))
    rng = np.random.default_rng(1)
    for step in range(4):
        world.step(rng.integers(0, 5, world.config.n_agents))
        assert_agrees(world, network, step)
    assert world.alive.all() == (name == "R")
    living = world.positions[world.alive]
    assert name == "D" or len(np.unique(living, axis=0)) < len(living)


def test_a_genome_is_read_layer_by_layer():
    network = mw.Network((4,), fov=1, n_actions=5)
    genome = np.arange(network.genome_size, dtype=np.float32)
    (first, bias), (last, head) = network.layers(genome)
    assert network.sizes == (3, 4, 5)
    assert network.genome_size == 3 * 4 + 4 + 4 * 5 + 5
    np.testing.assert_array_equal(first, [[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10, 11]])
    np.testing.assert_array_equal(bias, [12, 13, 14, 15])
    assert last.shape == (4, 5)
    assert last[0, 0] == 16
    np.testing.assert_array_equal(head, [36, 37, 38, 39, 40])
    assert np.shares_memory(last, genome)


def sealed(steps, *, diagonal=False):
    cells = ["##########", "#.##.#.###", "##########", "#.###.####", "##########"]
    return mw.WorldConfig(
        "SB", obstacles=cells, n_pursuers=4, n_evaders=1, fov=5, diagonal=diagonal, max_steps=steps
    )


@pytest.mark.parametrize("diagonal", [False, True])
@pytest.mark.parametrize("activation", ["relu", "tanh"])
def test_sampled_actions_follow_the_softmax(activation, diagonal):
    steps = 4000  # so many that a wrong share of some percent shows
    config = sealed(steps, diagonal=diagonal)
    network = mw.Network.for_config(config, (8,), activation=activation)
    genome = random_genome(network, 5, scale=0.6)
    episode = mw.record(config, mw.Population(genome, network), "still", seed=3)
    world = mw.World(config)
    world.reset(3)
    np.testing.assert_array_equal(episode.positions[-1], world.positions)
    expected = softmax(network.logits(genome, world.views()[:4]).astype(float), axis=1)
    for agent in range(4):
        counts = np.bincount(episode.actions[:, agent], minlength=config.n_actions)
        assert stats.chisquare(counts, steps * expected[agent]).pvalue > 1e-3


@pytest.mark.parametrize(
    ("outputs", "sampled", "taken"),
    [
        ([-3e38, 0, -200, 3e4, 3e4], True, {3, 4}),
        ([0, 1, 0, 1, 1], False, {1}),  # the first of the largest
    ],
)
def test_extreme_and_equal_outputs(outputs, sampled, taken):
    config = sealed(300)
    network = mw.Network.for_config(config, (), sampled=sampled)
    genome = np.zeros(network.genome_size, np.float32)
    genome[-5:] = outputs  # the biases: whatever agents see, these are the outputs
    actions = mw.record(config, mw.Population(genome, network), "still", seed=0).actions[:, :4]
    assert set(np.unique(actions)) == taken


def test_kernels_are_those_that_are_asked_for():
    asked = os.environ.get("MATRIXWORLD_KERNELS")
    assert asked is None or _core.kernel_level() == LEVELS[asked]


@pytest.mark.slow
def test_every_instruction_set_gives_the_same_bits():
    """The fingerprint of play and golden states of memory; networks as NumPy computes them."""
    levels, folder = list(LEVELS.values()), Path(__file__).parents[1]
    files = ("contract/test_fingerprint.py", "world/test_memory.py", "world/test_network.py")
    lower = levels[: levels.index(_core.kernel_level())]  # this processor has these, too
    for level in (level for level, name in LEVELS.items() if name in lower):
        env = os.environ | {"PYTEST_ADDOPTS": "", "MATRIXWORLD_KERNELS": level}
        command = [sys.executable, "-m", "pytest", "-q", *(folder / file for file in files)]
        done = subprocess.run(command, env=env, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout


def test_other_floats_are_copied_to_float32():
    network = mw.Network((4,), fov=3)
    double = np.random.default_rng(0).normal(size=(2, network.genome_size))
    found = mw.Population(double, network).genomes
    np.testing.assert_array_equal(found, double.astype(np.float32))
    single = found.copy()
    assert mw.Population(single, network).genomes is single  # without a copy
    with pytest.raises(ValueError, match="expected finite numbers, got inf"):
        mw.Population(1e300 * double, network)
