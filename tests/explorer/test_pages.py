"""Every page opens in a real browser, runs no script but its own, and becomes no other markup."""

import base64
import hashlib
import io
import json
import re
from html import unescape
from os.path import relpath
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import matrixworld as mw
from browser import DESKTOP, PHONE
from class_submissions import write_genomes
from class_tournament import results
from class_tournament.round_robin import play_class
from matrixworld.coevolution import evolve, open_run
from matrixworld.explorer import Playground
from matrixworld.explorer.evolve_page import evolve_page
from matrixworld.explorer.page import BUILT, PAGES, render_page, write_page
from matrixworld.explorer.playground import PIXELS, playground_page, shipped
from matrixworld.explorer.runs_page import explorer_page
from matrixworld.world.canvas import SMALLEST_NUMBERED, fitting_cell
from matrixworld.world.render import rgb
from tiny_race import tiny_race

REPOSITORY = Path(__file__).parents[2]
WEB = REPOSITORY / "web"
TOURNAMENT = "../tutorials/class_tournament/page"
SOURCES = ("src", TOURNAMENT, "build.mjs", "package.json", "package-lock.json", "tsconfig.json")
NAME = "<img src=x> &amp; \"'"
HOSTILE = "</script><script>document.title='owned'</script><img src=x onerror=alert(1)> & \u2028"


def page_of_a_class(folder):
    write_genomes(folder, 2)
    (folder / "genome 00.npz").rename(folder / f"{NAME}.npz")
    config = mw.WorldConfig("O", rows=9, cols=9, n_pursuers=3, n_evaders=2, max_steps=12)
    return results.class_page(play_class(folder, config, episodes=3, seed=1), title=NAME)


def page_of_a_run(folder):
    evolve(tiny_race(obstacles=0.15, max_steps=30), folder / NAME, threads=1)
    return explorer_page([open_run(folder / NAME)], note=f"Some runs are left out. {HOSTILE}")


MADE = {
    "class": page_of_a_class,
    "evolve": lambda folder: evolve_page(NAME),
    "explorer": page_of_a_run,
    "lesson": lambda folder: (REPOSITORY / "docs/lesson.html").read_text(encoding="utf-8"),
    "playground": lambda folder: playground_page("", shipped("SD"), NAME),
}
"""Each page with texts that would do harm as markup."""
FOLDERS = dict.fromkeys(PAGES, BUILT) | {"class": results.BUILT}
"""Where script and style sheet of each page are."""
WATCHED = (
    "while (matrixworldPlay.element.dataset.state === 'playing') matrixworldPlay.act(1);"
    " document.querySelectorAll('.play-buttons button')[1].click();"
)
TAB = "[...document.querySelectorAll('.tabs button')].find((b) => b.textContent === '{}').click()"
SCENE = TAB.format("Rules and conflicts") + "; "
BUTTON = "[...document.querySelectorAll('.top button')].find((b) => b.textContent === '{}').click()"
PRESS = "document.querySelector('{}').click()"
OPENED = {
    "evolve": [PRESS.format(".evolve"), "matrixworldEvolve.lanes[0].after.choose(0)"],
    "lesson": ["location.hash = '#votes'"],
    "explorer": [*(PRESS.format(name) for name in (".keys-button", ".to-play"))],
    "playground": [
        WATCHED,
        *map(TAB.format, ("One match", "A match from a file", "Rules and conflicts")),
        SCENE + BUTTON.format("?"),
    ],
}
"""What opens the dialogs of a page."""


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The pages, each made once."""
    return {name: make(tmp_path_factory.mktemp(name)) for name, make in MADE.items()}


GROUND = "getComputedStyle(document.body).getPropertyValue('--surface')"
PRINTED = f"""addEventListener('beforeprint', () => {{
  const boards = document.querySelectorAll('canvas.board');
  const board = [...boards].find((each) => each.offsetParent);
  const pixels = board?.getContext('2d').getImageData(0, 0, board.width, board.height).data;
  const white = pixels?.filter((value, at) => at % 4 === 0 && value > 250).length;
  window.printed = [{GROUND}, board ? white / (pixels.length / 4) : 1];
}})"""


@pytest.mark.slow
@pytest.mark.parametrize("page", MADE)
def test_a_page_opens_and_runs_no_script_but_its_own(browser, page, made, tmp_path):
    """On a phone and a desktop, light and dark; paper is light, and texts stay texts."""
    html, file = made[page], tmp_path / "page.html"
    write_page(file, html)
    for size, scheme in ((PHONE, "light"), (DESKTOP, "dark")):
        browser.prefer(prefers_color_scheme=scheme)
        browser.open(file, size)
        assert browser.js("document.documentElement.scrollWidth") <= size[0]
    assert browser.js("document.images.length") == 0
    assert browser.js("document.title") != "owned"
    dark = browser.js(GROUND)
    browser.driver.execute_script(PRINTED)
    browser.driver.execute_cdp_cmd("Page.printToPDF", {})
    surface, white = browser.js("window.printed")
    assert surface == "#ffffff"
    assert white > 0.3
    assert browser.js(GROUND) == dark
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    assert browser.js("document.querySelector('.top .tools').offsetParent") is None
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    assert browser.errors() == []
    assert "default-src 'none'" in unescape(html)  # nothing is loaded, and nothing sent
    added = "<script>document.title = 'owned'</script></body>"
    write_page(file, html.replace("</body>", added))
    browser.open(file)
    assert browser.js("document.title") != "owned"
    assert any("Content Security Policy" in error for error in browser.errors())


SHEETS = sorted((REPOSITORY / "docs" / "class_material").glob("*.html"))


@pytest.mark.slow
def test_each_sheet_for_a_class_is_a_page_of_paper(browser):
    pypdf = pytest.importorskip("pypdf")
    for file in SHEETS:
        browser.driver.get(file.as_uri())
        size = {"paperWidth": 8.27, "paperHeight": 11.69, "preferCSSPageSize": True}
        printed = browser.driver.execute_cdp_cmd("Page.printToPDF", size)
        pages = pypdf.PdfReader(io.BytesIO(base64.b64decode(printed["data"]))).pages
        assert len(pages) == browser.js("document.querySelectorAll('body > svg').length") > 0


@pytest.mark.nightly
@pytest.mark.parametrize("page", MADE)
def test_disabilities_hinder_no_reader(browser, page, made, tmp_path):
    """Contrast, labels and landmarks of a page and of its dialogs."""
    write_page(tmp_path / "page.html", made[page])
    assert browser.hindrances(tmp_path / "page.html", *OPENED.get(page, [])) == {}


def test_built_files_are_of_the_present_sources():
    """If this fails, run ``npm ci && npm run build`` in web/."""
    assert tuple(sorted(main.parent.name for main in WEB.glob("src/*/main.ts"))) == PAGES
    paths = [file for source in SOURCES for file in [WEB / source, *(WEB / source).rglob("*")]]
    names = {Path(relpath(path, WEB)).as_posix(): path for path in paths if path.is_file()}
    digest = hashlib.sha256()
    for name in sorted(names):
        content = hashlib.sha256(names[name].read_bytes()).hexdigest()
        digest.update(f"{name} {content}\n".encode())
    for file in (FOLDERS[page] / f"{page}.{suffix}" for page in MADE for suffix in ("js", "css")):
        first_line = file.read_text(encoding="utf-8").partition("\n")[0]
        assert f"sources {digest.hexdigest()} */" in first_line, file


@pytest.mark.parametrize("file", [*BUILT.iterdir(), *results.BUILT.iterdir()], ids=lambda p: p.name)
def test_no_built_file_ends_its_element_or_evaluates_text(file):
    text = file.read_text(encoding="utf-8").lower()
    for ends in ("</script", "<script", "<!--", "</style", "eval(", "new function", "import.meta"):
        assert ends not in text


@pytest.mark.parametrize("page", MADE)
def test_data_are_read_as_they_were_and_become_no_markup(page):
    folder = FOLDERS[page]
    hostile = render_page(page, HOSTILE, {"name": HOSTILE}, folder=folder)
    found = re.search(r'<script type="application/json" id="data">(.*)</script>', hostile)
    assert json.loads(found[1].partition("</script>")[0]) == {"name": HOSTILE}
    elements = re.compile(r"<[a-z/!][^>]*>", re.IGNORECASE)
    plain = render_page(page, "title", {"name": ""}, folder=folder)
    assert elements.findall(hostile) == elements.findall(plain)
    with pytest.raises(ValueError, match="JSON"):
        render_page(page, "title", {"rate": float("nan")}, folder=folder)


def picture(bundle):
    with Image.open(io.BytesIO(base64.b64decode(bundle["image/png"]))) as image:
        assert image.format == "PNG"
        return np.asarray(image.convert("RGB"))


def test_a_notebook_shows_the_page_in_a_frame_and_as_a_picture_of_its_scene():
    world = mw.World("SB", rows=3, cols=5, n_pursuers=2, n_evaders=1)
    world.reset(0, pursuers=[[0, 0], [0, 2]], evaders=[[2, 4]])
    before = world.scene()
    playground = Playground(world)
    world.step([mw.Action.SOUTH] * 3)
    bundle = playground._repr_mimebundle_()
    found = re.fullmatch(r'<iframe srcdoc="([^"]*)".*</iframe>', bundle["text/html"])
    assert found
    assert unescape(found[1]) == playground.html()
    cell = fitting_cell((3, 5), PIXELS, SMALLEST_NUMBERED)
    assert np.array_equal(picture(bundle), rgb(before, cell=cell, numbers=True))
