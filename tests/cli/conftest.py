"""What tests of the command line share."""

import shutil
from pathlib import Path

import pytest
from matplotlib.figure import Figure
from PIL import Image

from command_line import JOB, matrixworld_command, words
from executors import jobs_in_threads


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def keep_pictures_small(patch):
    """Save a grey point in place of each figure: what figures show is tested in tests/plots."""
    save = Figure.savefig

    def saved(figure, file, **look):
        if look["format"] == "png":
            Image.new("L", (1, 1)).save(file, "PNG")
        else:
            save(figure, file, **look)

    patch.setattr(Figure, "savefig", saved)


@pytest.fixture(autouse=True, scope="module")
def quick_jobs(no_processes):
    """Play jobs without worker processes, but in commands that tests start as programs."""
    with pytest.MonkeyPatch.context() as patch:
        keep_pictures_small(patch)
        yield


@pytest.fixture
def undrawn(monkeypatch):
    """Draw no figures and write no page, in tests of something else."""
    monkeypatch.setattr("matrixworld.cli.report.draw", lambda *args: None)


@pytest.fixture
def run(race):
    return Path(shutil.copytree(race, "run"))


@pytest.fixture(scope="session")
def main_job(tmp_path_factory):
    """A tiny main job, not to be changed: its directory, and what ``evolve`` told of it there."""
    folder = tmp_path_factory.mktemp("main")
    with pytest.MonkeyPatch.context() as patch, jobs_in_threads():
        patch.chdir(folder)
        keep_pictures_small(patch)
        told = matrixworld_command("evolve", "--out", "main job", *words(JOB), "--threads", 1)
    return folder / "main job", told
