"""Pages in notebooks and scripts: `explore`, frames, and pictures where no frame can be shown."""

from __future__ import annotations

import base64
import html
import io
import re
import runpy
import shutil
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import matrixworld as mw
from matrixworld._util.files import DamagedFileError
from matrixworld.coevolution import start
from matrixworld.episodes.render import rgb
from matrixworld.episodes.render.canvas import SMALLEST_NUMBERED, fitting_cell
from matrixworld.explorer import Explorer, Playground, explore
from matrixworld.explorer.playground import PIXELS
from tiny_race import tiny_race

REPOSITORY = Path(__file__).parents[2]


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


def test_an_unfinished_or_damaged_run_leaves_no_page(run: Path, tmp_path: Path) -> None:
    start(tiny_race(), tmp_path / "unfinished")
    shutil.copytree(run, tmp_path / "damaged", ignore=shutil.ignore_patterns("explorer.html"))
    genomes = tmp_path / "damaged" / "stage-0001.npz"
    genomes.write_bytes(genomes.read_bytes()[:-80])
    for name, error in (("unfinished", FileNotFoundError), ("damaged", DamagedFileError)):
        with pytest.raises(error):
            explore(tmp_path / name)
        assert not (tmp_path / name / "explorer.html").exists()


def test_reading_a_run_imports_no_code_of_its_learner(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = tiny_race(learner="own_code:HillClimber", settings={"sigma": 0.2})
    start(settings, tmp_path / "run", threads=1).run()
    monkeypatch.delitem(sys.modules, "own_code")
    explore(tmp_path / "run")
    assert "own_code" not in sys.modules


def picture(bundle: dict[str, str]) -> np.ndarray:
    """Return the pixels of the picture in an output."""
    with Image.open(io.BytesIO(base64.b64decode(bundle["image/png"]))) as image:
        assert image.format == "PNG"
        return np.asarray(image.convert("RGB"))


def test_the_picture_of_a_playground_is_the_scene_of_its_world() -> None:
    world = mw.World("SB", rows=3, cols=5, n_pursuers=2, n_evaders=1)
    world.reset(0, pursuers=[[0, 0], [0, 2]], evaders=[[2, 4]])
    before = world.scene()
    playground = Playground(world)
    world.step([mw.Action.SOUTH] * 3)
    bundle = playground._repr_mimebundle_()
    assert "<iframe srcdoc=" in bundle["text/html"]
    drawn = picture(bundle)
    cell = fitting_cell((3, 5), PIXELS, SMALLEST_NUMBERED)
    assert np.array_equal(drawn, rgb(before, cell=cell, numbers=True))
    assert not np.array_equal(drawn, rgb(world.scene(), cell=cell, numbers=True))


@pytest.mark.parametrize("side", [1, 2, 64])
def test_pictures_of_small_and_large_worlds(side: int) -> None:
    world = mw.World("O", rows=side, cols=max(2, side), n_pursuers=1, n_evaders=1)
    assert 100 < max(picture(Playground(world)._repr_mimebundle_()).shape) < 2000


def test_a_playground_without_a_world_shows_the_first_example() -> None:
    assert picture(Playground()._repr_mimebundle_()).size


def test_a_notebook_that_is_kept_shows_the_picture_and_no_frame() -> None:
    """The formatter of a notebook, and then the script that runs and keeps the notebooks."""
    formatters = pytest.importorskip("IPython.core.formatters")
    drop_frame = runpy.run_path(str(REPOSITORY / "tutorials" / "run.py"))["drop_frame"]
    data, metadata = formatters.DisplayFormatter().format(Playground())
    assert {"text/html", "image/png", "text/plain"} == data.keys()
    output: dict[str, Any] = {"data": data, "metadata": metadata}
    drop_frame(output)
    assert output["data"].keys() == {"image/png", "text/plain"}


def test_the_picture_of_an_explorer_is_a_match_of_the_run(run: Path, tmp_path: Path) -> None:
    page = explore(run, file=tmp_path / "page.html")
    bundle = page._repr_mimebundle_()
    height, width, _ = picture(bundle).shape
    assert width > 2 * height
    assert Explorer(page.path)._repr_mimebundle_().keys() == {"text/html"}
