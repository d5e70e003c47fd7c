"""What tests of the command line share."""

import shutil
from pathlib import Path

import pytest
from click.testing import Result

from command_line import JOB, matrixworld_command, words
from executors import jobs_in_threads
from matrixworld.cli import evolve


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run commands in a temporary directory."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture(autouse=True, scope="module")
def quick_jobs(no_processes: None) -> None:
    """Play jobs without worker processes, but in commands that tests start as programs."""


@pytest.fixture
def undrawn(monkeypatch: pytest.MonkeyPatch) -> None:
    """Draw no figures and write no page, in tests of something else."""
    monkeypatch.setattr(evolve, "draw", lambda *args: None)


@pytest.fixture
def run(race: Path) -> Path:
    """A copy of the race in the working directory."""
    return Path(shutil.copytree(race, "run"))


@pytest.fixture(scope="session")
def main_job(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Result]:
    """A tiny main job, not to be changed: its directory, and what ``evolve`` told of it there."""
    folder = tmp_path_factory.mktemp("main")
    with pytest.MonkeyPatch.context() as patch, jobs_in_threads():
        patch.chdir(folder)
        told = matrixworld_command("evolve", "--out", "main job", *words(JOB), "--threads", 1)
    return folder / "main job", told
