"""What tests of the command line share."""

import shutil
from pathlib import Path

import pytest


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run commands in a temporary directory."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture(autouse=True, scope="module")
def quick_jobs(no_processes: None) -> None:
    """Play jobs without worker processes, but in commands that tests start as programs."""


@pytest.fixture
def run(race: Path) -> Path:
    """A copy of the race in the working directory."""
    return Path(shutil.copytree(race, "run"))
