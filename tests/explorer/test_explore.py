"""`explore`, for notebooks and scripts."""

from __future__ import annotations

import html
import re
import shutil
import sys
from pathlib import Path

import pytest

from matrixworld._util.files import DamagedFileError
from matrixworld.coevolution import start
from matrixworld.explorer import explore
from tiny_race import tiny_race


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("races") / "run"
    start(tiny_race(), directory, threads=1).run()
    return directory


def test_a_notebook_shows_the_page_in_a_frame(run: Path, tmp_path: Path) -> None:
    page = explore(run, file=tmp_path / "page.html")
    assert page.path == tmp_path / "page.html"
    found = re.fullmatch(
        r'<iframe srcdoc="([^"]*)".*</iframe>', page._repr_mimebundle_()["text/html"]
    )
    assert found
    assert html.unescape(found[1]) == page.path.read_text(encoding="utf-8")


def test_a_page_that_exists_is_kept(run: Path) -> None:
    first = explore(run)
    assert first.path == run.absolute() / "explorer.html"
    before = first.path.read_bytes()
    with pytest.raises(FileExistsError, match="force=True replaces it"):
        explore(run)
    assert first.path.read_bytes() == before
    explore(run, force=True)


def test_the_number_of_runs_is_checked(run: Path) -> None:
    with pytest.raises(ValueError, match="runs: expected 1 to 12 run directories, got 0"):
        explore()
    with pytest.raises(ValueError, match="got 13"):
        explore(*[run] * 13)


def test_an_unfinished_run_leaves_no_page(tmp_path: Path) -> None:
    start(tiny_race(), tmp_path / "run")
    with pytest.raises(FileNotFoundError):
        explore(tmp_path / "run")
    assert not (tmp_path / "run" / "explorer.html").exists()


def test_a_damaged_run_leaves_no_page(run: Path, tmp_path: Path) -> None:
    shutil.copytree(run, tmp_path / "copy", ignore=shutil.ignore_patterns("explorer.html"))
    genomes = tmp_path / "copy" / "stage-0001.npz"
    genomes.write_bytes(genomes.read_bytes()[:-80])
    with pytest.raises(DamagedFileError):
        explore(tmp_path / "copy")
    assert not (tmp_path / "copy" / "explorer.html").exists()


def test_reading_a_run_imports_no_code_of_its_learner(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = tiny_race(learner="own_code:HillClimber", learner_settings={"sigma": 0.2})
    start(settings, tmp_path / "run", threads=1).run()
    monkeypatch.delitem(sys.modules, "own_code")
    explore(tmp_path / "run")
    assert "own_code" not in sys.modules
