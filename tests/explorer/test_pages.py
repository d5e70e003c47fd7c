"""Pages as files, in notebooks and behind links, whatever text they hold."""

import base64
import hashlib
import html
import io
import json
import re
import runpy
import shutil
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import matrixworld as mw
from matrixworld._util import colors
from matrixworld._util.files import DamagedFileError
from matrixworld.coevolution import start
from matrixworld.episodes.canvas import SMALLEST_NUMBERED, fitting_cell
from matrixworld.episodes.render import rgb
from matrixworld.explorer import Explorer, Playground, explore
from matrixworld.explorer.page import BUILT, render_page
from matrixworld.explorer.playground import GALLERY, PIXELS, page_data, scene_link
from matrixworld.world.policy import SCRIPTS
from tiny_race import tiny_race

SUFFIXES = ("js", "css")
PAGES = ("explorer", "playground", "class", "play", "lesson")
REPOSITORY = Path(__file__).parents[2]
WEB = REPOSITORY / "web"
SOURCES = ("src", "build.mjs", "package.json", "package-lock.json", "tsconfig.json")
HOSTILE = "</script><script>document.title='owned'</script><img src=x onerror=alert(1)> & \u2028"


def source_digest() -> str:
    """Return the digest of the sources, as ``web/build.mjs`` computes it."""
    paths = [file for source in SOURCES for file in [WEB / source, *(WEB / source).rglob("*")]]
    names = {path.relative_to(WEB).as_posix(): path for path in paths if path.is_file()}
    digest = hashlib.sha256()
    for name in sorted(names):
        content = hashlib.sha256(names[name].read_bytes()).hexdigest()
        digest.update(f"{name} {content}\n".encode())
    return digest.hexdigest()


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_built_files_are_of_the_present_sources(page: str, suffix: str) -> None:
    first_line = (BUILT / f"{page}.{suffix}").read_text(encoding="utf-8").partition("\n")[0]
    assert f"sources {source_digest()} */" in first_line, "run npm ci && npm run build in web/"


@pytest.mark.parametrize("page", PAGES)
def test_data_are_read_as_they_were_and_become_no_markup(page: str) -> None:
    hostile = render_page(page, HOSTILE, {"name": HOSTILE})
    found = re.search(r'<script type="application/json" id="data">(.*)</script>', hostile)
    assert json.loads(found[1].partition("</script>")[0]) == {"name": HOSTILE}
    assert elements(hostile) == elements(render_page(page, "title", {"name": ""}))


def elements(page: str) -> list[str]:
    """Return the tags of a page with their attributes."""
    return re.findall(r"<[a-z/!][^>]*>", page, re.IGNORECASE)


def test_numbers_that_are_not_json_are_refused() -> None:
    with pytest.raises(ValueError, match="JSON"):
        render_page("explorer", "title", {"rate": float("nan")})


# ---- In notebooks and scripts --------------------------------------------------------------------


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
    with pytest.raises(ValueError, match="runs: expected 1 to 12 finished runs, got 0"):
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


# ---- Scenes of the playground as text ------------------------------------------------------------


def small_world(rules: mw.Rules | str = "SB", **changes: object) -> mw.World:
    world = mw.World(rules, rows=2, cols=4, n_pursuers=2, n_evaders=1, **changes)
    world.reset(0, pursuers=[[0, 0], [0, 2]], evaders=[[1, 3]])
    return world


def test_defaults_are_left_out() -> None:
    link = "rules=SB&size=2x4&pursuers=0.0_0.2&evaders=1.3"
    assert scene_link(small_world()) == link
    assert scene_link(small_world(), np.array([2, 4, 0])) == f"{link}&next=240"


def test_all_settings_are_in_the_link() -> None:
    rules = mw.Rules(mw.Interaction.SWARM_TURNS, teammate=mw.Outcome.DISAPPEAR)
    rewards = mw.Rewards(pursuer_capture=0.1, pursuer_collide=(-1, -2.5, 0), capture_repeats=True)
    world = mw.World(
        rules, obstacles=["..#", "..."], n_pursuers=1, n_evaders=2, fov=3, diagonal=True,
        max_steps=40, rewards=rewards,
    )  # fmt: skip
    world.reset(2**64 - 1, episode=7, pursuers=[[0, 0]], evaders=[[1, 0], [1, 2]])
    world.step([3, 0, 1])  # the pursuer catches an evader; the other one enters an obstacle
    assert scene_link(world, ["random", 8, 0], compare="-D") == (
        "rules=swarm_turns.bounce.disappear.disappear.reach.occupation.false&others=D"
        "&rewards=0.1_-10_0.1_-0.1_-1,-2.5,0_-12_-0.05_-0.05_FAULT_true&size=2x3&diagonal=1&fov=3"
        "&limit=40&seed=18446744073709551615.7.1&walls=0.2&pursuers=1.0&evaders=1.0cx_1.2&next=a80"
    )


def test_an_ended_episode_stays_ended() -> None:
    world = mw.World("S", rows=1, cols=2, n_pursuers=1, n_evaders=1)
    world.reset(pursuers=[[0, 0]], evaders=[[0, 1]])
    world.step([0, 0])
    assert world.terminated
    assert scene_link(world).endswith("&ended=1&pursuers=0.0&evaders=0.1c")


def in_a_round() -> mw.World:
    world = small_world("TO")
    world.play_turn([0, 0, 0])
    return world


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: scene_link(small_world(), [0, 0]), r"actions: expected 3 \(agents\), got 2"),
        (lambda: scene_link(small_world(), [0, 5, 0]), "actions: expected 0 to 4, got 5"),
        (lambda: scene_link(small_world(), [0, "chase", 0]), "actions: expected .*, got 'chase'"),
        (lambda: scene_link(small_world(), compare="X"), "variant: expected one of"),
        (lambda: scene_link("SB"), "world: expected"),
        (lambda: scene_link(mw.World("O", rows=65)), "world, rows: expected 1 to 64, got 65"),
        (
            lambda: scene_link(mw.World("O", n_evaders=101)),
            "world, n_evaders: expected 1 to 100, got 101",
        ),
        (lambda: scene_link(in_a_round()), "world: expected the end of a round, got turn 1"),
        (lambda: Playground(actions=[0]), "world: expected a world together with actions"),
    ],
)
def test_bad_arguments_are_refused(call: Callable[[], object], message: str) -> None:
    with pytest.raises((TypeError, ValueError), match=f"^{message}"):
        call()


def test_the_page_documents_every_field_and_script() -> None:
    data = page_data()
    assert [field["name"] for field in data["fields"]] == list(mw.Rules.__dataclass_fields__)
    for field in data["fields"]:
        assert field["text"].endswith(".")
        known = {value["name"] for value in field["values"]}
        assert {str(rules[field["name"]]).lower() for rules in data["variants"].values()} <= {
            name.lower() for name in known
        }
    assert [script["name"] for script in data["scripts"]] == list(SCRIPTS)
    assert all(script["text"] for script in data["scripts"])
    assert len({example.title for example in GALLERY}) == len(GALLERY)


def test_the_board_has_the_colours_of_the_package() -> None:
    sheet = (REPOSITORY / "web" / "src" / "board" / "board.css").read_text(encoding="utf-8")
    light = dict(re.findall(r"--([\w-]+): (#\w{6});", sheet.partition("}")[0]))
    expected = {
        "board-paper": colors.PAPER,
        "board-line": colors.GRID,
        "board-ink": colors.INK,
        "board-muted": colors.MUTED,
        "board-obstacle": colors.OBSTACLE,
        "pursuer": colors.PURSUER,
        "evader": colors.EVADER,
        "capture": colors.CAPTURE,
        "collision": colors.COLLISION,
    }
    assert {name: light[name].upper() for name in expected} == expected


def test_a_link_and_a_page_for_notebooks(tmp_path: Path) -> None:
    playground = Playground(small_world(), [2, 4, "fleer"])
    assert playground.url("docs/playground.html") == f"docs/playground.html#{playground.scene}"
    playground.save(tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert playground.scene.replace("&", "\\u0026") in page
    with pytest.raises(FileExistsError, match="force=True replaces it"):
        playground.save(tmp_path / "page.html")


def test_the_page_in_docs_is_the_present_one() -> None:
    kept = (REPOSITORY / "docs" / "playground.html").read_text(encoding="utf-8")
    assert kept == Playground().html(), "run python docs/make_pages.py"


def test_the_example_of_the_documentation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = (REPOSITORY / "docs" / "playground.md").read_text(encoding="utf-8")
    found = re.search(r"^```python\n(.*?)^```", text, re.M | re.S)
    monkeypatch.chdir(tmp_path)
    names: dict[str, Playground] = {}
    exec(found[1], names)
    assert names["playground"].scene.endswith("&next=24d")
    assert (tmp_path / "lesson.html").is_file()
    link = re.search(r"playground\.html#([^)]*)", text)
    assert link[1] == GALLERY[0].scene
