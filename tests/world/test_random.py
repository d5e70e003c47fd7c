"""Random numbers: the generator against NumPy's, and what a reset does with it."""

import itertools

import numpy as np
import pytest
from scipy import stats

import matrixworld as mw
from matrixworld import _core

WORD = 2**64
KEYS = [(0, 0), (1, 0), (0, 1), (2**64 - 1, 2**63), (0x123456789ABCDEF, 0xFEDCBA987654321)]
COUNTERS = [(1, 0, 0, 0), (0, 1, 0, 0), (7, 500, 2, 0), (3, 2, 1, 2**64 - 1), (0, 0, 0, 0)]


def by_numpy(counter: tuple[int, ...], key: tuple[int, ...]) -> list[int]:
    """NumPy counts up before its first block."""
    number = sum(word * WORD**i for i, word in enumerate(counter)) - 1
    before = [(number % WORD**4) // WORD**i % WORD for i in range(4)]
    generator = np.random.Philox(counter=np.array(before, np.uint64), key=np.array(key, np.uint64))
    return [int(word) for word in generator.random_raw(4)]


@pytest.mark.parametrize("key", KEYS)
@pytest.mark.parametrize("counter", COUNTERS)
def test_philox_is_that_of_numpy(counter: tuple[int, ...], key: tuple[int, ...]) -> None:
    assert _core.philox(counter, key) == by_numpy(counter, key)


N_WORLDS = 6000


def starts(config: mw.WorldConfig, *buffers: str) -> dict[str, np.ndarray]:
    """Buffers of many worlds after a reset, of neighbouring seeds."""
    specs = mw.array_specs(config)
    arrays = {name: np.zeros((N_WORLDS, *specs[name][0]), specs[name][1]) for name in buffers}
    return mw.Batch(N_WORLDS, config, buffers=arrays).reset(11)


def is_uniform(numbers: np.ndarray, n: int) -> bool:
    return bool(stats.chisquare(np.bincount(numbers, minlength=n)).pvalue > 1e-3)


def test_agents_start_apart_and_know_nothing_of_each_other() -> None:
    """Ordered pairs of distinct cells are equally likely, so each agent starts anywhere, too."""
    config = mw.WorldConfig(rows=2, cols=4, n_pursuers=2, n_evaders=2)
    places = starts(config, "positions")["positions"] @ [config.cols, 1]
    for one in range(4):
        for other in range(one):
            first, second = places[:, one], places[:, other]
            assert (first != second).all()
            rank = second - (second > first)  # among the seven cells that are left
            assert is_uniform(first * 7 + rank, 56)


def test_obstacles_of_a_density_lie_anywhere() -> None:
    config = mw.WorldConfig(rows=4, cols=5, n_pursuers=1, n_evaders=1, obstacles=0.25)
    arrays = starts(config, "positions", "state")
    ground = arrays["state"][:, 2].reshape(N_WORLDS, 20)
    assert (ground.sum(axis=1) == 5).all()
    assert stats.chisquare(ground.sum(axis=0)).pvalue > 1e-3
    places = arrays["positions"] @ [5, 1]
    assert not np.take_along_axis(ground, places, axis=1).any()


def test_seeds_and_episodes_are_told_apart() -> None:
    world = mw.World(rows=40, cols=40)
    drawn = set()
    for seed, episode in itertools.product((0, 1, 2**32, 2**64 - 1), repeat=2):
        world.reset(seed, episode=episode)
        drawn.add(world.positions.tobytes())
    assert len(drawn) == 16
