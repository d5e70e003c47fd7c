"""For all folders of tests: options for slow ones, settings of random ones, a finished race."""

import os
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from tiny_race import MEMORY, played, tiny_race

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


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--slow", action="store_true", help="run the tests that are marked as slow")
    parser.addoption("--nightly", action="store_true", help="run all tests")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    nightly = config.getoption("--nightly", False)
    run = {"nightly": nightly, "slow": nightly or config.getoption("--slow", False)}
    for item in items:
        for mark in run:
            if mark in item.keywords and not run[mark]:
                item.add_marker(pytest.mark.skip(reason=f"{mark}: give --{mark}"))


def pytest_configure(config: pytest.Config) -> None:
    if not config.getoption("--hypothesis-profile"):
        settings.load_profile("ci")
    # The root of all `tmp_path`: files of runs are synced, which takes milliseconds on a disk.
    if MEMORY:
        os.environ.setdefault("PYTEST_DEBUG_TEMPROOT", MEMORY)
    # Tests of a file share what they play: each file is of one worker of pytest-xdist.
    if getattr(config.option, "dist", None) == "load":
        config.option.dist = "loadfile"


@pytest.fixture(scope="session")
def race(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A finished race; not to be changed."""
    directory = tmp_path_factory.mktemp("race") / "run"
    played(tiny_race(), directory)
    return directory
