"""The page of a class in a real browser."""

from __future__ import annotations

from pathlib import Path

import pytest

from browser import DESKTOP, PHONE, Browser, browser, data_of
from class_submissions import write_genomes
from matrixworld import WorldConfig
from matrixworld.classroom import play_class, standings
from matrixworld.classroom.page import Tables, class_page
from matrixworld.classroom.tournament import ClassResult
from matrixworld.coevolution.types import TEAMS
from matrixworld.explorer.page import write_page

__all__ = ["browser"]

HOSTILE = "<img src=x onerror=document.title='owned'>"


@pytest.fixture(scope="module", params=["O", "TO"])
def played(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> tuple[ClassResult, Tables]:
    """A class of genomes: of a game in one turn, and of one in which the teams take turns."""
    directory = tmp_path_factory.mktemp("class")
    write_genomes(directory, 3)
    (directory / f"{HOSTILE}.txt").write_text("no submission")
    (directory / "genome 00.npz").rename(directory / f"{HOSTILE}.npz")
    config = WorldConfig(request.param, rows=9, cols=9, n_pursuers=3, n_evaders=2, max_steps=12)
    result = play_class(directory, config, episodes=3, seed=1)
    return result, {team: standings(result, team) for team in TEAMS}


@pytest.fixture(scope="module")
def page(played: tuple[ClassResult, Tables], tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("page") / "class.html"
    write_page(file, class_page(*played, title=f"class {HOSTILE}"))
    return file


@pytest.mark.parametrize("size", [DESKTOP, PHONE])
def test_every_cell_is_played_again_as_in_the_tournament(
    browser: Browser, page: Path, played: tuple[ClassResult, Tables], size: tuple[int, int]
) -> None:
    browser.open(page, size)
    rows, columns, _ = played[0].capture_rates.shape
    assert browser.js("document.querySelectorAll('.matrix rect[data-pair]').length") == (
        rows * columns
    )
    browser.js("document.querySelector('.matrix').focus()")
    seen = set()
    for row in range(rows):
        for _ in range(columns):
            seen.add(browser.js("document.getElementById('match').dataset.played"))
            assert browser.js("document.querySelector('.check').dataset.equal") == "true"
            browser.press("\ue014" if row % 2 == 0 else "\ue012")  # right, left
        browser.press("\ue015")  # down
    assert seen == {f"{g} {h}" for g in range(rows) for h in range(columns)}
    assert browser.errors() == []
    # Nothing is wider than the window.
    assert browser.js("document.documentElement.scrollWidth <= innerWidth")


def test_tables_and_refusals_show_what_was_found(
    browser: Browser, page: Path, played: tuple[ClassResult, Tables]
) -> None:
    """And a click on an opponent in a table plays that match."""
    browser.open(page, DESKTOP)
    text = browser.js("document.body.innerText")
    for team in TEAMS:
        for standing in played[1][team]:
            assert f"{standing.score.value:.2f}" in text
    assert "expected a file that ends in .py or .npz" in text
    # Names are text, whatever they hold.
    assert HOSTILE in browser.js("document.querySelector('.standings').textContent")
    assert browser.js("document.title") == f"class {HOSTILE} - matrixworld"
    assert browser.js("document.images.length") == 0
    last = played[1]["evader"][-1]
    browser.js(
        "[...document.querySelectorAll('.standings')][1]"
        ".querySelector('tbody tr:last-child .to-match').click()"
    )
    pair = f"{last.best} {last.number}"
    assert browser.js("document.getElementById('match').dataset.played") == pair
    browser.wait("matrixworldClass.step > 0")
    assert browser.errors() == []


def test_a_page_without_room_keeps_the_best_and_worst_matches(
    played: tuple[ClassResult, Tables], browser: Browser, tmp_path: Path
) -> None:
    result, tables = played
    whole = sum(-(-actions.size // 3) for actions in result.recordings.values())
    page = tmp_path / "small.html"
    write_page(page, class_page(result, tables, title="small", most=whole // 2))
    steps = data_of(page)["steps"]
    first = tables["pursuer"][0]
    assert steps[first.number][first.best] == len(result.recordings[first.number, first.best])
    missing = [(g, h) for g, row in enumerate(steps) for h, n in enumerate(row) if n < 0]
    assert missing
    browser.open(page, DESKTOP)
    for g, h in [missing[0], (first.number, first.best)]:
        cell = f"document.querySelector('rect[data-pair=\"{g} {h}\"]')"
        x, y = browser.js(f"(box => [box.x + 2, box.y + 2])({cell}.getBoundingClientRect())")
        click = f"new MouseEvent('click', {{bubbles: true, clientX: {x}, clientY: {y}}})"
        browser.js(f"{cell}.dispatchEvent({click})")
        kept = (g, h) not in missing
        assert ("holds no recording" in browser.js("document.body.innerText")) is not kept
        if kept:
            assert browser.js("document.querySelector('.check').dataset.equal") == "true"
    assert browser.errors() == []
