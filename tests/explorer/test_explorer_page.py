"""The data of the explorer are those of the run, and so are its matches in a real browser."""

import base64
import json
import re
import shutil
import time
import zlib
from functools import partial
from html import unescape
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image, ImageSequence

from browser import DESKTOP, LAPTOP, PHONE, READY, Browser
from matrixworld import World, WorldConfig, analysis
from matrixworld.analysis.cycles import Checkerboard
from matrixworld.analysis.words import all_results, headline_numbers
from matrixworld.coevolution import TEAMS, SavedRun, open_run, start
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.explorer import explore
from matrixworld.explorer.page import write_page
from matrixworld.explorer.runs_page import (
    archives_of,
    explorer_page,
    guided_minute,
    heading,
    kept_generations,
    packed,
    run_data,
    training_curve,
)
from tiny_race import tiny_race, tiny_single

Job = dict[str, SavedRun]
CELLS = 10
HOME, END, ESCAPE = "\ue011", "\ue010", "\ue00c"
LEFT, UP, RIGHT, DOWN = "\ue012", "\ue013", "\ue014", "\ue015"
PLAYED = "document.querySelector('#match').dataset.played"

# What a test reads of the match that is shown.
MATCH = """(() => {
  const match = window.matrixworldExplorer.match;
  const at = match.length * match.n_agents;
  return {
    length: match.length,
    rate: match.statistics.capture_rate,
    last: Array.from(match.last_positions.subarray(2 * at)),
    captured: Array.from(match.ever_captured.subarray(match.length * match.config.n_evaders)),
    conflicts: Array.from({length: match.length}, (_, i) => match.conflicts(i + 1))
      .map((step) => step.map((conflict) => conflict.text)),
  };
})()"""


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> Job:
    """Three runs of different worlds: obstacles, diagonal moves and turns, and a single team."""
    root = tmp_path_factory.mktemp("job")
    settings = {
        "race": tiny_race(obstacles=0.15, max_steps=30),
        "turns": tiny_race(rules="TO", diagonal=True, max_steps=20, schedule="hall-of-fame"),
        "single": tiny_single(team="evader", opponent="chaser"),
    }
    for name, each in settings.items():
        start(each, root / name, threads=1).run()
    return {name: open_run(root / name) for name in settings}


@pytest.fixture(scope="module")
def page(job: Job) -> Path:
    return explore(*(run.files.path for run in job.values())).path


@pytest.fixture
def opened(browser: Browser, page: Path) -> Browser:
    return show(browser, page)


def show(browser: Browser, page: Path, size: tuple[int, int] = LAPTOP) -> Browser:
    """Open a page and wait for its first match."""
    browser.open(page, size)
    browser.wait(PLAYED)
    return browser


def select(
    browser: Browser, run: int, pursuer: int, evader: int, episode: int = 0
) -> dict[str, Any]:
    """Click a run and a cell, choose an episode, and return the match that the page plays."""
    browser.click(f".race:nth-child({run + 1})")
    click_cell(browser, pursuer, evader)
    for _ in range(episode):
        browser.press("n")
    browser.wait(f"{PLAYED} === '{run} {pursuer} {evader} {episode} '")
    match: dict[str, Any] = browser.js(MATCH)
    return match


def click_cell(browser: Browser, pursuer: int, evader: int) -> None:
    place = """(() => {
      const [g, h] = arguments, canvas = document.querySelector('#matrix canvas');
      const [rows, columns] = window.matrixworldExplorer.shape;
      canvas.scrollIntoView({block: 'center', behavior: 'instant'});
      const { left, top, width, height } = canvas.getBoundingClientRect();
      return [left + (h + .5) / columns * width, top + (rows - g - .5) / rows * height];
    })()"""
    browser.drag(browser.js(place, pursuer, evader))


def random_matches(job: Job) -> list[tuple[int, int, int, int]]:
    """Draw matches of all runs: run, generations, episode."""
    rng = np.random.default_rng(3)
    shapes = [(3, 3), (3, 3), (1, 4)]
    runs = [number % len(job) for number in range(CELLS)]
    return [(r, *map(int, rng.integers(0, [*shapes[r], 3]))) for r in runs]


def test_clicks_play_the_matches_of_the_run(opened: Browser, job: Job) -> None:
    """In the same steps, with the package's words for conflicts; and the page confirms the cell."""
    runs, seen = list(job.values()), 0
    for number, g, h, episode in random_matches(job):
        played = select(opened, number, g, h, episode)
        expected = runs[number].record(g, h, episode)
        assert played["length"] == expected.length
        assert played["last"] == expected.last_positions[-1].ravel().tolist()
        assert played["captured"] == expected.ever_captured[-1].astype(int).tolist()
        for step, texts in enumerate(played["conflicts"], 1):
            assert texts == [conflict.text for conflict in expected.explain(step)]
            seen += len(texts)
    assert seen > 20
    select(opened, 0, 2, 1)
    opened.wait("document.querySelector('.check').dataset.equal === 'true'")
    payoff = job["race"].payoff()
    assert opened.js("document.querySelector('.check').title") == (
        f"Played here: capture rate {payoff.capture_rates[2, 1, 0]:.3f} in "
        f"{payoff.lengths[2, 1, 0]} steps. The cell says {payoff.capture_rate[2, 1]:.3f}."
    )
    assert opened.errors() == []


def test_the_page_says_if_its_matches_differ(browser: Browser, job: Job, tmp_path: Path) -> None:
    html = explorer_page([job["race"]])
    seed = f'"{run_data("race", job["race"])["seeds"][2][2]}"'
    assert html.count(seed) == 1
    write_page(tmp_path / "other.html", html.replace(seed, '"1"'))
    browser.open(tmp_path / "other.html")
    browser.wait("document.querySelector('.check').textContent.includes('differs')")


@pytest.mark.slow
def test_keys(opened: Browser) -> None:
    select(opened, 0, 1, 1)
    opened.wait("window.matrixworldExplorer.step > 0")  # a click plays the match
    # Space is for the player, not for a tab.
    assert opened.js("document.activeElement === document.body")
    opened.press(" ", HOME)
    opened.wait("window.matrixworldExplorer.step === 0")
    opened.press(RIGHT, RIGHT)
    opened.wait("window.matrixworldExplorer.step === 2")
    opened.press("p", "E")
    opened.wait(f"{PLAYED} === '0 2 0 0 '")
    opened.press("n", "n", "N")
    opened.wait(f"{PLAYED} === '0 2 0 1 '")
    opened.press("m", DOWN, RIGHT)
    opened.wait(f"{PLAYED} === '0 1 1 0 '")
    # Charts whose generations can be chosen take the focus and the same keys.
    charts = "[...document.querySelectorAll('.chart[tabindex], .triangle[tabindex]')]"
    assert opened.js(f"{charts}.length") == 5
    for chart, cell in enumerate(("2 1", "2 2", "2 1", "2 2")):
        opened.js(f"{charts}[{chart}].focus()")
        opened.press(*((UP,), (RIGHT,), (LEFT,), (UP,))[chart])
        opened.wait(f"{PLAYED} === '0 {cell} 0 '")
    opened.js("document.activeElement.blur()")
    opened.press("P", "E")
    opened.wait(f"{PLAYED} === '0 1 1 0 '")
    opened.press("r")
    opened.wait(f"{PLAYED}.match(/^0 1 1 0 [0-9]+$/) !== null")
    opened.press("o")
    opened.wait(f"{PLAYED} === '0 1 1 0 '")
    opened.press("?")
    opened.wait("document.querySelector('dialog.help').open")
    opened.press(ESCAPE)
    opened.wait("!document.querySelector('dialog.help').open")
    opened.press("2")
    opened.wait(f"{PLAYED} === '1 1 1 0 '")
    opened.press("d")
    opened.wait("['light', 'dark'].includes(document.documentElement.dataset.theme)")
    assert opened.errors() == []


def test_an_agent_shows_its_view_and_the_answer_of_its_network(opened: Browser, job: Job) -> None:
    select(opened, 0, 2, 2)
    opened.press(HOME, "a")
    name = "document.querySelector('.inspector h3').textContent"
    assert opened.js(name) == "pursuer_0"
    run = job["race"]
    world = World(run.settings.world)
    world.reset(evaluation_seed(run.settings.seed, 2, 2))
    population = run.teams["pursuer"]
    logits = population.network.logits(population.genomes[2], world.views()[:1])[0].astype(float)
    expected = np.exp(logits - logits.max()) / np.exp(logits - logits.max()).sum()
    shown = opened.js(
        "Array.from(document.querySelectorAll('.action .numbers')).map((e) => +e.textContent)"
    )
    np.testing.assert_allclose(shown, expected, atol=0.0051)


def test_a_checkerboard_plays_four_matches(
    browser: Browser, job: Job, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    board = Checkerboard((0, 2), (1, 0), 0.4)
    found = "matrixworld.explorer.runs_page.strongest_checkerboards"
    monkeypatch.setattr(found, lambda matrix, **options: [board])
    write_page(tmp_path / "board.html", explorer_page([job["race"]]))
    show(browser, tmp_path / "board.html")
    browser.driver.execute_script("document.querySelector('.miniature').click()")
    assert browser.js("document.querySelectorAll('dialog.four canvas').length") == 4
    browser.press(ESCAPE)
    browser.wait("document.querySelectorAll('dialog.four canvas').length === 0")
    assert browser.errors() == []


@pytest.mark.slow
def test_readers_with_disabilities_are_not_hindered(
    browser: Browser, job: Job, tmp_path: Path
) -> None:
    """Contrast, labels and landmarks of the page and of its dialogs."""
    page = tmp_path / "page.html"
    write_page(page, explorer_page(list(job.values()), note="Some runs are left out."))
    press = "document.querySelector('{}').click()".format
    assert (
        browser.hindrances(
            page,
            *map(press, (".keys-button", ".miniature", ".begin-minute", ".to-share", ".to-play")),
        )
        == {}
    )


@pytest.mark.parametrize("size", [DESKTOP, PHONE])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_is_wider_than_the_window(
    browser: Browser, page: Path, size: tuple[int, int], scheme: str
) -> None:
    browser.prefer(prefers_color_scheme=scheme)
    show(browser, page, size)
    assert browser.js("document.documentElement.scrollWidth") <= size[0]
    assert browser.errors() == []


def test_the_page_introduces_itself(opened: Browser) -> None:
    """It says what it shows, and plays the whole first match in about 12 s."""
    assert opened.js("document.querySelector('h1').textContent") == "Three runs"
    opened.wait("window.matrixworldExplorer.step > 2", 3)
    length, pace = opened.js(
        "[window.matrixworldExplorer.match.length, window.matrixworldExplorer.pace]"
    )
    assert pace == max(2, length / 12)
    after, before = (
        f"window.matrixworldExplorer.match.ever_captured.slice({at})" for at in ("3", "0, -3")
    )
    changes = f"Array.from({after}).filter((now, i) => now > Array.from({before})[i]).length"
    assert 0 < opened.js("document.querySelectorAll('.captures i').length") <= opened.js(changes)


def test_the_guided_minute_drives_the_page(opened: Browser, job: Job) -> None:
    stops = run_data("race", job["race"])["findings"]["guided_minute"]
    bar, four = "document.querySelector('.guided')", "document.querySelector('dialog.four').open"
    opened.click(".begin-minute")
    for number, stop in enumerate(stops, 1):
        assert opened.js(f"{bar}.querySelector('p').textContent") == f"{number} of 5 {stop['text']}"
        opened.wait(f"{PLAYED} === '0 {stop['pursuer']} {stop['evader']} 0 '")
        assert opened.js(four) is (stop["shows"] == "checkerboard")
        opened.driver.execute_script(f"{bar}.querySelectorAll('button')[1].click()")
    assert opened.js(f"{bar}.hidden")
    opened.press("3")  # a team alone is not judged
    assert opened.js("document.querySelector('.begin-minute').hidden")
    assert opened.errors() == []


@pytest.mark.slow
def test_a_match_is_saved_as_a_gif_of_ten_seconds(opened: Browser, tmp_path: Path) -> None:
    opened.prefer(prefers_color_scheme="light")
    where = {"behavior": "allow", "downloadPath": str(tmp_path)}
    opened.driver.execute_cdp_cmd("Browser.setDownloadBehavior", where)
    opened.click(".to-share")
    assert opened.js("document.querySelector('.share input').value === location.href")
    opened.click(".save-gif")
    opened.wait("document.querySelector('.share [role=status]').textContent.startsWith('Saved')")
    file = tmp_path / "pursuers-2-evaders-2.gif"
    deadline = time.monotonic() + 20
    while not file.exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    with Image.open(file) as film:
        pictures = list(ImageSequence.all_frames(film, lambda frame: frame.convert("RGB")))
        seconds = sum(frame.info["duration"] for frame in ImageSequence.Iterator(film)) / 1000
        assert (film.size, seconds) == ((480, 480), 10)
    assert pictures[0].tobytes() != pictures[-1].tobytes()
    assert {(213, 94, 0), (0, 114, 178)} <= {color for _, color in pictures[0].getcolors()}
    assert opened.errors() == []


def test_the_page_does_not_jump_when_the_match_arrives(opened: Browser) -> None:
    shift = opened.driver.execute_async_script(
        """const done = arguments[0]; let sum = 0;
        new PerformanceObserver((list) => { for (const e of list.getEntries()) sum += e.value; })
          .observe({type: 'layout-shift', buffered: true});
        setTimeout(() => done(sum), 300);"""
    )
    assert shift < 0.02


def test_texts_from_files_stay_texts(browser: Browser, job: Job, tmp_path: Path) -> None:
    name = "<img src=x onerror=document.title='owned'> &amp; \"'"
    source = job["race"].files.path
    shutil.copytree(source, tmp_path / name)
    show(browser, explore(tmp_path / name).path)
    assert browser.js("document.querySelector('footer').textContent").startswith(name)
    assert browser.js("document.title").startswith(name)
    assert browser.js("document.images.length") == 0
    assert browser.errors() == []


def test_a_page_with_an_altered_script_does_not_run(
    browser: Browser, page: Path, tmp_path: Path
) -> None:
    added = "<script>document.title = 'owned'</script></body>"
    html = page.read_text().replace("</body>", added)
    assert "default-src 'none'" in unescape(html)  # nothing is loaded, and nothing sent
    write_page(tmp_path / "altered.html", html)
    browser.open(tmp_path / "altered.html")
    assert browser.js("document.title") != "owned"
    assert any("Content Security Policy" in error for error in browser.errors())


@pytest.mark.slow
def test_a_finger_chooses_in_a_loupe_and_sees_the_board(browser: Browser, tmp_path: Path) -> None:
    start(tiny_race(generations=14), tmp_path / "run", threads=1).run()
    browser.driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True})
    try:
        show(browser, explore(tmp_path / "run").path, PHONE)
        click_cell(browser, 13, 5)
        cells = "[...document.querySelectorAll('.loupe button')].map((each) => each.ariaLabel)"
        rates = open_run(tmp_path / "run").payoff().capture_rate
        assert browser.js(cells)[:49] == [
            f"{rates[g, h]:.2f}: pursuers {g} against evaders {h}"
            for g in range(14, 7, -1)
            for h in range(2, 9)
        ]
        assert browser.js("document.querySelector('.loupe button').clientHeight") > 30
        browser.click(".loupe button[aria-label$='pursuers 10 against evaders 4']")
        browser.wait(f"{PLAYED} === '0 10 4 0 '")
        browser.wait(
            "(({top, bottom}) => top >= 0 && bottom <= innerHeight)"
            "(document.querySelector('#match canvas.board').getBoundingClientRect())"
        )
        assert browser.js("document.querySelector('.loupe')") is None
        assert browser.errors() == []
    finally:
        browser.driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})


def test_reduced_motion_shows_moments_only(browser: Browser, page: Path) -> None:
    browser.prefer(prefers_reduced_motion="reduce")
    show(browser, page)
    click_cell(browser, 1, 1)
    browser.wait(f"{PLAYED} === '0 1 1 0 '")
    # A click plays no motion picture to readers who asked for none; steps jump.
    assert browser.js("window.matrixworldExplorer.step") == 0
    browser.press(RIGHT)
    assert browser.js("window.matrixworldExplorer.step") == 1
    browser.prefer(prefers_reduced_motion="no-preference")


@pytest.mark.slow
def test_a_step_opens_in_the_playground(opened: Browser, job: Job) -> None:
    browser = opened
    select(browser, 0, 1, 2)
    browser.press(HOME, RIGHT, RIGHT, RIGHT)
    here = browser.driver.current_window_handle
    browser.press("g")
    browser.driver.switch_to.window(browser.driver.window_handles[-1])
    try:
        browser.wait(READY)
        scene = browser.js(
            "(({pursuers, evaders, next}) => ({cells: [...pursuers, ...evaders].map((a) => a.cell),"
            " next}))(window.playground.scene)"
        )
        episode = job["race"].record(1, 2)
        assert scene["cells"] == episode.last_positions[2].tolist()
        assert scene["next"] == episode.actions[2].tolist()
        # The networks of the match come along: they decide as in the match.
        browser.js("playground.selected = null")
        browser.js("document.querySelector('.agents-card > button').click()")
        assert browser.js("playground.scene.next.every((each) => each === 'champion')")
        for moment in (3, 4, 5):
            browser.js("playground.step()")
            cells = browser.js("Array.from(playground.game.recording.moments.at(-1).positions)")
            assert cells == episode.last_positions[moment].ravel().tolist()
        told = "document.querySelector('.message').textContent"
        browser.js("playground.change({ ...playground.scene, diagonal: true })")
        assert "expected" in browser.js(told)
        assert not browser.js("playground.scene.diagonal")
        assert browser.errors() == []
    finally:
        browser.driver.close()
        browser.driver.switch_to.window(here)


def test_an_address_leads_to_a_match_and_its_step(opened: Browser) -> None:
    browser = opened
    browser.driver.execute_script("location.hash = '#run=1&pursuers=2&evaders=0&episode=1&step=4'")
    browser.wait(f"{PLAYED} === '1 2 0 1 '")
    assert browser.js("window.matrixworldExplorer.step") == 4
    browser.press(RIGHT)
    address = "#run=1&pursuers=2&evaders=0&episode=1&step=5"
    assert browser.js("location.hash") == address
    browser.driver.refresh()
    browser.wait(f"document.body.dataset.ready === 'true' && {PLAYED} === '1 2 0 1 '")
    assert browser.js("window.matrixworldExplorer.step") == 5
    browser.driver.execute_script("location.hash = '#run=7&pursuers=-1&evaders=%3Cimg%3E&seed=x'")
    browser.wait("location.hash.startsWith('#run=1&pursuers=2&evaders=0')")
    assert browser.errors() == []


@pytest.mark.parametrize("damage", ["missing", "cut", "no base64", "a NaN"])
def test_damaged_genomes_are_told_where_the_match_would_be(
    browser: Browser, job: Job, tmp_path: Path, damage: str
) -> None:
    start, genomes, end = re.split(
        r'(?<=id="genomes-0-evader">)([^<]+)', explorer_page([job["race"]]), maxsplit=1
    )
    nan = packed(np.full_like(job["race"].teams["evader"].genomes, np.nan))
    damaged = {
        "missing": "",
        "cut": genomes[:-40],
        "no base64": f"!{genomes[1:]}",
        "a NaN": base64.b64encode(nan).decode(),
    }
    write_page(tmp_path / "page.html", start + damaged[damage] + end)
    browser.open(tmp_path / "page.html")
    problem = browser.js("document.querySelector('#match .problem').textContent")
    assert problem.startswith("The page is damaged: it does not hold the ")
    assert problem.endswith(" numbers of the evaders' genomes. Write it again from its run.")
    assert browser.errors() == []


def test_a_generation_whose_genome_is_not_there_is_explained(
    browser: Browser, job: Job, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    population = job["race"].teams["pursuer"]
    few = partial(archives_of, most=4 * population.genomes[0].nbytes)
    monkeypatch.setattr("matrixworld.explorer.runs_page.archives_of", few)
    write_page(tmp_path / "page.html", explorer_page([job["race"]]))
    browser.open(tmp_path / "page.html")
    browser.wait(f"{PLAYED} === '0 2 2 0 '")
    problem = "document.querySelector('#match .problem').textContent"
    assert browser.js(problem) == ""
    browser.press("P")
    browser.wait(f"{problem} !== ''")
    assert browser.js(problem).startswith("The page holds no genome of pursuers 1")
    assert browser.js(problem).endswith("Choose a generation of 0, 2.")
    browser.press("P")
    browser.wait(f"{PLAYED} === '0 0 2 0 '")
    assert browser.js(problem) == ""
    assert browser.errors() == []


# ---- The data of a page -----------------------------------------------------------------------


@pytest.fixture(scope="module", params=["race", "turns"])
def race(request: pytest.FixtureRequest, job: Job) -> SavedRun:
    return job[request.param]


def as_read(run: SavedRun) -> dict[str, Any]:
    """Return the data of a run as the page reads them."""
    plain: dict[str, Any] = json.loads(json.dumps(run_data("a run", run), allow_nan=False))
    return plain


def test_results_seeds_and_world_are_those_of_the_evaluation(race: SavedRun) -> None:
    data, payoff, settings = as_read(race), race.payoff(), race.settings
    assert data["payoff"]["first"] == [0, 0]
    assert data["payoff"]["capture_rate"] == payoff.capture_rate.tolist()
    rates = np.array(data["payoff"]["capture_rates"], np.float32)
    np.testing.assert_array_equal(rates, payoff.capture_rates)
    np.testing.assert_array_equal(data["payoff"]["lengths"], payoff.lengths)
    assert [[int(seed) for seed in row] for row in data["seeds"]] == [
        [evaluation_seed(settings.seed, g, h) for h in range(3)] for g in range(3)
    ]
    assert WorldConfig.from_json(data["world"]).to_json() == settings.world.to_json()
    shown = {each["name"]: each["value"] for each in data["settings"]}
    assert shown["world.rows"] == "6"
    assert not {"learner", "seed"} & shown.keys()


def test_pages_are_entitled_in_words(job: Job) -> None:
    assert heading([job["race"]] * 3) == "Three races: predators and prey"
    assert heading([job["turns"]]) == "One race: cops and robbers"
    assert heading([job["race"], job["turns"]]) == "Two races"
    assert heading([job["single"]]) == "One run: predators and prey"


def test_verdicts_are_those_of_the_commands(race: SavedRun) -> None:
    found = as_read(race)["findings"]
    judgement = analysis.judge(race.payoff().capture_rates, per_episode=True)
    assert found["headline"] == analysis.headline(judgement)
    assert found["numbers"] == headline_numbers(judgement)
    assert [tuple(row) for row in found["table"]] == analysis.judgement_table(judgement)
    assert found["reasons"] == analysis.explain(judgement).splitlines()
    # Its numbers as a game, and the dots of the panel, are those of `judge --all`.
    results = all_results(analysis.read_payoffs(race.payoff().capture_rates, per_episode=True))
    assert found["spinning_top"] == results["runs"][0]["spinning_top"]
    assert found["ratings"]["pursuers"]["high"] == results["ratings"]["pursuers"]["high"][0]
    row = analysis.MEASURES["middle_intransitivity"]
    assert f"{row.label}: {row.shown(row.of(race.payoff().capture_rate))}" in found["game"]


def test_the_guided_minute_says_what_cells_and_the_judgement_say(race: SavedRun) -> None:
    payoff = race.payoff()
    matrix, found = payoff.capture_rate, as_read(race)["findings"]
    stops = found["guided_minute"]
    judgement = analysis.judge(payoff.capture_rates, per_episode=True)
    for stop, condition in zip(stops[2:4], ("forgetting", "intransitivity"), strict=True):
        verdict = judgement.headline[condition].verdict
        assert stop["text"].endswith(f"The judgement on {condition}: {verdict}.")
    assert found["headline"] in stops[4]["text"]
    # What is said of a pair is in its cell, which is the match that is shown.
    for stop in stops[:2]:
        assert f"{matrix[stop['pursuer'], stop['evader']]:.0%} of" in stop["text"]
    assert [(stop["pursuer"], stop["evader"]) for stop in stops[:2]] == [(0, 0), (2, 2)]


@pytest.mark.parametrize("forgets", [True, False])
def test_the_guided_minute_shows_the_largest_loss_if_there_is_one(forgets: bool) -> None:
    """Later pursuers capture fewer, of early evaders above all; or both teams grow stronger."""
    g, h = np.mgrid[0:12, 0:12] / 24
    matrix = 0.6 - g * (1 - h) if forgets else 0.5 + g - h
    judgement = analysis.judge(matrix)
    shown = guided_minute(matrix, judgement, (), (range(12), range(12)))[2]
    assert ("lost most" in shown.text) is forgets
    if forgets:
        assert (shown.pursuer, shown.evader) == (11, 0)
        assert "pursuers 11 capture 14% of them, pursuers 0 60%" in shown.text
    # Verdicts of the windows that differ are told apart.
    for window, findings in judgement.windows.items():
        assert findings["forgetting"].verdict in shown.text, window


def test_genomes_are_exact(race: SavedRun) -> None:
    archives = archives_of([race, race])
    for team in TEAMS:
        for number, teams in enumerate(archives.teams):
            assert teams[team]["genomes"] == f"genomes-{number}-{team}"
            population = race.teams[team]
            planes = zlib.decompress(archives.blobs[f"genomes-{number}-{team}"])
            places = np.frombuffer(planes, np.uint8).reshape(4, -1).T
            joined = np.ascontiguousarray(places).view("<u4").reshape(population.genomes.shape)
            bits = np.bitwise_xor.accumulate(joined, axis=0)
            np.testing.assert_array_equal(bits, population.genomes.view("<u4"))
            assert teams[team]["kept"] == [0, 1, 2]


def test_a_limit_of_size_keeps_some_generations_of_all_runs(race: SavedRun) -> None:
    population = race.teams["pursuer"]
    # Room for two of the three generations of both teams.
    archives = archives_of([race], most=4 * population.genomes[0].nbytes)
    assert archives.step == 2
    assert [archives.teams[0][team]["kept"] for team in TEAMS] == [[0, 2], [0, 2]]
    assert kept_generations(6, 2) == [0, 2, 4, 5]  # the last one, too


def test_a_single_team_has_one_cell_at_its_last_generation(job: Job) -> None:
    data, payoff = as_read(job["single"]), job["single"].payoff()
    assert (data["payoff"]["shape"], data["payoff"]["first"]) == ([1, 4], [0, 3])
    assert data["payoff"]["capture_rate"] == payoff.capture_rate.tolist()
    assert data["findings"] is None
    [teams] = archives_of([job["single"]]).teams
    assert [teams[team]["script"] for team in TEAMS] == ["chaser", None]


def test_a_long_training_curve_has_means_of_neighbouring_epochs(
    monkeypatch: pytest.MonkeyPatch, job: Job
) -> None:
    single = job["single"]
    log = single.files.log()
    whole = training_curve(log, single.settings)
    assert whole["epochs"] == 1
    np.testing.assert_allclose(whole["capture_rate"], log["capture_rate"], atol=1e-4)
    monkeypatch.setattr("matrixworld.explorer.runs_page.MOST_POINTS", 2)
    short = training_curve(log, single.settings)
    means = [log["capture_rate"][:3].mean(), log["capture_rate"][3:].mean()]
    assert short["epochs"] == 3
    np.testing.assert_allclose(short["capture_rate"], means, atol=1e-4)
