"""Named inputs and the policies that rate moves by them, against slow versions in Python."""

import numpy as np
import pytest

import matrixworld as mw
from inputs import all_slow_inputs
from rows import NAMES, config_of, random_actions

VIEWS = (1, 3, 5, 7, 9, 11)


@pytest.mark.parametrize("obstacles", [0.0, 0.15])
@pytest.mark.parametrize("name", NAMES)
def test_inputs_are_those_of_the_slow_version(name: str, obstacles: float) -> None:
    """In all variants, with and without diagonal moves, in views of all sizes."""
    for number, fov in enumerate(VIEWS):
        config = config_of(name, obstacles=obstacles, fov=fov, diagonal=number % 2 == 0)
        world = mw.World(config)
        world.reset(NAMES.index(name), episode=number)
        for actions in random_actions(number, config.n_actions, 15, config.n_agents):
            np.testing.assert_array_equal(world.inputs(), all_slow_inputs(world))
            if world.terminated or world.truncated:
                break
            world.step(actions)


def test_inputs_among_many_agents() -> None:
    """More agents than a view is compared with at once, and than fit two words of bits."""
    for name, n in (("R", 40), ("B", 30), ("S", 90)):
        config = config_of(name, rows=20, cols=21, n_pursuers=n, n_evaders=60, obstacles=0.1, fov=7)
        world = mw.World(config)
        for actions in random_actions(n, 5, 4, config.n_agents):
            np.testing.assert_array_equal(world.inputs(), all_slow_inputs(world))
            world.step(actions)
