"""For all folders of tests: options for slow ones, settings of random ones, a finished race."""

import os
from itertools import compress

import pytest
from hypothesis import HealthCheck, settings

from matrixworld.coevolution.jobs.job import create_job, job_of
from matrixworld.coevolution.saved_run import finish
from slow import PARTS, part_of
from tiny_race import LONG, MEMORY, SCHEDULES, played, tiny_race

SLOW = [HealthCheck.too_slow, HealthCheck.data_too_large]
settings.register_profile(
    "ci",  # derandomized: the same examples in every run
    max_examples=40,
    derandomize=True,
    database=None,
    deadline=None,
    suppress_health_check=SLOW,
)
# pytest --hypothesis-profile=long tests/contract/test_reference.py
settings.register_profile(
    "long", max_examples=5000, database=None, deadline=None, suppress_health_check=SLOW
)


def pytest_addoption(parser):
    parser.addoption("--slow", action="store_true", help="run the tests that are marked as slow")
    parser.addoption("--nightly", action="store_true", help="run all tests")
    told = f"run a part of the nightly tests, 0 to {PARTS - 1}, and all others"
    parser.addoption("--nightly-part", type=int, choices=range(PARTS), metavar="N", help=told)


def pytest_collection_modifyitems(config, items):
    part = config.getoption("--nightly-part", None)
    if part is not None:
        left_out = ["nightly" in item.keywords and part_of(item.nodeid) != part for item in items]
        config.hook.pytest_deselected(items=[*compress(items, left_out)])
        items[:] = [item for item, out in zip(items, left_out, strict=True) if not out]
    nightly = part is not None or config.getoption("--nightly", False)
    run = {"nightly": nightly, "slow": nightly or config.getoption("--slow", False)}
    for item in items:
        for mark in run:
            if mark in item.keywords and not run[mark]:
                item.add_marker(pytest.mark.skip(reason=f"{mark}: give --{mark}"))


def pytest_configure(config):
    if not config.getoption("--hypothesis-profile"):
        settings.load_profile("ci")
    # The root of all `tmp_path`: files of runs are synced, which takes milliseconds on a disk.
    if MEMORY:
        os.environ.setdefault("PYTEST_DEBUG_TEMPROOT", MEMORY)
    # Tests of a file share what they play: each file is of one worker of pytest-xdist.
    if getattr(config.option, "dist", None) == "load":
        config.option.dist = "loadfile"


@pytest.fixture(scope="session")
def race(tmp_path_factory):
    """A finished race; not to be changed."""
    directory = tmp_path_factory.mktemp("race") / "run"
    played(tiny_race(), directory)
    return directory


@pytest.fixture(scope="session")
def seeds(tmp_path_factory):
    """A job of two schedules with seeds 0 to 3, of which 3 has not begun; not to be changed."""
    root = tmp_path_factory.mktemp("seeds") / "job"
    job = job_of([tiny_race(**LONG, schedule=name, seed=n) for name in SCHEDULES for n in range(4)])
    create_job(job, root)
    for name, race in job.items():
        if race.seed < 3:
            finish(root / name, threads=1)
    return root
