"""Quick jobs, and worlds of cases; what other folders of tests need, too, is in `shared`."""

import pytest

import matrixworld as mw
from executors import jobs_in_threads
from reference import ReferenceWorld

pytest_plugins = ["shared"]


@pytest.fixture(scope="module")
def no_processes():
    """Play jobs in threads."""
    with jobs_in_threads():
        yield


def start_engine(config, pursuers, evaders, obstacles):
    world = mw.World(config)
    world.reset(seed=0, pursuers=pursuers, evaders=evaders, obstacles=obstacles)
    return world


def start_reference(config, pursuers, evaders, obstacles):
    world = ReferenceWorld(config)
    world.place(pursuers, evaders, obstacles)
    return world


@pytest.fixture(params=[start_reference, start_engine], ids=["reference", "engine"])
def start(request):
    """Begins an episode, in turn in the slow world and in the compiled one."""
    return request.param
