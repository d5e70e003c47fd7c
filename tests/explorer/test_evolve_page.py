"""The page on which a race evolves: one file, and a race that can be watched and changed."""

import time
import webbrowser
from pathlib import Path

import numpy as np
import pytest

from browser import LAPTOP, Browser
from command_line import matrixworld_command
from matrixworld import Matches, Population, Rating, WorldConfig, rollout
from matrixworld.explorer.evolve_page import PAGE, evolve_page

DOCS = Path(__file__).parents[2] / "docs"
MOST = 1_000_000
"""Bytes of the page."""
SMALL = "#population=8&steps=30&pursuers=2&evaders=2&seed=3&walls=60.61.62"


def test_the_page_is_small_and_that_of_docs_is_the_present_one() -> None:
    page = evolve_page()
    assert len(page.encode()) <= MOST
    assert (DOCS / PAGE).read_text(encoding="utf-8") == page, "run python docs/make_pages.py"


def test_evolve_writes_and_names_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(webbrowser, "open", lambda address: True)
    monkeypatch.chdir(tmp_path)
    assert matrixworld_command("evolve", "--page").output == f"{PAGE}\n"
    assert Path(PAGE).read_text(encoding="utf-8") == evolve_page()


STATE = "document.body.dataset.state"
NEWEST = "matrixworldEvolve.lanes[0].newestGeneration"
DRAW_WALLS = "document.querySelector('.doings [aria-pressed=false]:not(.side)').click()"
FACTS = "document.querySelector('.facts').textContent"


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("evolve") / PAGE
    file.write_text(evolve_page(), encoding="utf-8")
    return file


def opened(browser: Browser, page: Path, settings: str, size: tuple[int, int]) -> None:
    browser.resize(*size)
    browser.driver.get("about:blank")  # another address after the # loads no page
    browser.driver.get(page.as_uri() + settings)
    browser.wait("document.body.dataset.ready === 'true'")


@pytest.mark.slow
def test_a_race_evolves_is_changed_and_plays_its_matches(browser: Browser, page: Path) -> None:
    opened(browser, page, SMALL, LAPTOP)
    assert browser.js(STATE) == "waiting"
    browser.wait("matrixworldEvolve.lanes[0].newest.player.step > 2")  # a chase runs already
    began = time.monotonic()
    browser.click(".evolve")
    browser.wait(f"{NEWEST} >= 1")
    first = time.monotonic() - began
    browser.wait(f"{STATE} === 'ended'", 120)
    assert browser.js(NEWEST) == 15
    assert first < 20  # a second on a machine that does nothing else
    assert "forgetting" in browser.js("document.querySelector('.measures').textContent")
    # A click on a cell plays its match.
    box = "document.querySelector('.matrix canvas').getBoundingClientRect()"
    browser.drag(tuple(browser.js(f"(box => [box.left + 9, box.top + 9])({box})")))
    browser.wait("document.querySelector('.check').textContent === 'As in the evaluation'")
    assert browser.js("document.querySelector('.match-title').textContent").startswith(
        "Pursuers of generation 15 against evaders of generation 0"
    )
    browser.driver.execute_script("document.querySelector('dialog[open]').close()")
    # The mask ends all collisions at once, and walls play the matrix again.
    browser.driver.execute_script("document.querySelector('.controls [type=checkbox]').click()")
    browser.wait(f"/\\D0 collisions/.test({FACTS})")
    browser.driver.execute_script(DRAW_WALLS)
    box = "document.querySelector('.chase canvas').getBoundingClientRect()"
    left, top, width = browser.js(f"(box => [box.left, box.top, box.width])({box})")
    cells = [(left + width * (column + 0.5) / 12, top + width * 2.5 / 12) for column in (3, 4, 5)]
    browser.drag(*cells)
    world = "matrixworldEvolve.lanes[0].settings.world"
    browser.wait(f"{world}.obstacles[2] === '...###......'")
    assert browser.js(f"{world}.obstacles[5]") == "###........."  # those of the link
    assert "walls=27.28.29.60.61.62" in browser.js("location.hash")
    assert browser.errors() == []


@pytest.mark.nightly
def test_weights_can_be_dragged(browser: Browser, page: Path) -> None:
    """Without weights all allowed moves are equally good, in Python as on the page."""
    opened(browser, page, "#population=8&steps=30&pursuers=2&evaders=2&seed=3&ratings=1", LAPTOP)
    browser.click(".evolve")
    browser.wait(f"{STATE} === 'ended'", 120)
    told = "document.querySelector('.weights-card [role=status]').textContent"
    evolved = browser.js(told)
    assert evolved.endswith("% are caught")
    browser.driver.execute_script(
        "for (const bar of document.querySelectorAll('.weights-card input')) {"
        " bar.value = 0; bar.dispatchEvent(new Event('input')); }"
    )
    world = WorldConfig.from_json(browser.js("matrixworldEvolve.lanes[0].settings.world"))
    policy = Rating.for_config(world)
    team = Population(np.zeros(policy.genome_size, np.float32), policy)
    rate = rollout(world, team, team, Matches.of(0, 0, [3]), episodes=20).capture_rate.mean()
    both = f"Yours: {int(100 * rate + 0.5)} % are caught; as evolved: {evolved.split(' are')[0]}"
    assert browser.js(told) == both
    browser.driver.execute_script("document.querySelector('.weights-card button').click()")
    assert browser.js(told) == evolved
    assert browser.violations() == browser.errors() == []


@pytest.mark.slow
def test_a_wall_that_would_cut_off_a_cell_is_refused(browser: Browser, page: Path) -> None:
    opened(browser, page, "#population=8&walls=12.13", LAPTOP)
    browser.driver.execute_script(DRAW_WALLS)
    told = "document.querySelector('.chase > [role=status]').textContent"
    rows = "matrixworldEvolve.lanes[0].settings.world.obstacles"
    browser.wait("matrixworldEvolve.lanes[0].newest.player.step > 0")
    box = "document.querySelector('.chase canvas').getBoundingClientRect()"
    left, top, width = browser.js(f"(box => [box.left, box.top, box.width])({box})")
    for col, sentence in ((2, "Nobody may be walled in"), (3, "")):  # the first cuts off a corner
        browser.drag((left + width * (col + 0.5) / 12, top + width * 0.5 / 12))
        browser.wait(f"{told}.slice(0, 23) === '{sentence}'")
    browser.wait(f"{rows}[0] === '...#........' && {rows}[1] === '##..........'")
    assert browser.errors() == []
