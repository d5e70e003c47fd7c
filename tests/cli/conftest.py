"""What tests of the command line share."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from matrixworld.coevolution import start
from tiny_race import tiny_race


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run commands in a temporary directory."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture(autouse=True, scope="module")
def quick_jobs(no_processes: None) -> None:
    """Play jobs without worker processes, but in commands that tests start as programs."""


@pytest.fixture(scope="session")
def race(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A finished race; not to be changed."""
    directory = tmp_path_factory.mktemp("race") / "run"
    start(tiny_race(), directory, threads=1).run()
    return directory


@pytest.fixture
def run(race: Path) -> Path:
    """A copy of the race in the working directory."""
    return Path(shutil.copytree(race, "run"))
