"""A person plays in a real browser: the match is that of `World`, of the file, and of the link."""

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from browser import Browser
from command_line import matrixworld_command
from matrixworld import Episode, World, WorldConfig, record
from matrixworld.coevolution import TEAMS, SavedRun, Team, evolve, open_run
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.explorer import explore
from matrixworld.explorer.page import write_page
from matrixworld.explorer.play_page import of_run, play_page, shipped
from matrixworld.world.policy import Population, TeamPolicy
from scripts import wait_until
from tiny_race import tiny_race

PLAYED = "document.querySelector('#match').dataset.played"
IN_EXPLORER, IN_PAGE = "window.matrixworldExplorer.playing", "window.matrixworldPlay"
LETTERS = dict(enumerate(" wdsaeczq"))
ARROWS = {0: " ", 1: "\ue013", 2: "\ue014", 3: "\ue015", 4: "\ue012"}


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> list[SavedRun]:
    """A race with obstacles, and one in which the teams take turns and move diagonally."""
    root = tmp_path_factory.mktemp("job")
    settings = {
        "race": tiny_race(obstacles=0.15, max_steps=30),
        "turns": tiny_race(rules="TO", diagonal=True, max_steps=20, schedule="hall-of-fame"),
    }
    for name, each in settings.items():
        evolve(each, root / name, threads=1)
    return [open_run(root / name) for name in settings]


@pytest.fixture(scope="module")
def page(job: list[SavedRun]) -> Path:
    return explore(*(run.path for run in job)).path


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("play") / "play.html"
    write_page(file, play_page("play", *shipped("SD")))
    return file


def take_over(browser: Browser, page: Path, run: int, g: int, h: int, step: int = 0) -> None:
    """Show a match, go to a step, and take an agent over."""
    address = f"#run={run}&pursuers={g}&evaders={h}&step={step}"
    browser.open(page)
    browser.driver.execute_script(f"location.hash = '{address}'")
    browser.wait(f"{PLAYED} === '{run} {g} {h} 0 ' && matrixworldExplorer.step === {step}")
    browser.press("t")
    browser.wait(f"{IN_EXPLORER} && document.querySelector('.take-over').open")


def moves_until_done(
    browser: Browser, keys: dict[int, str], seed: int, view: str = IN_EXPLORER
) -> None:
    """Press random keys until the match has ended for the person."""
    rng = np.random.default_rng(seed)
    while browser.js(f"{view}.element.dataset.state") == "playing":
        browser.press(keys[int(rng.choice(list(keys)))])


def shown(browser: Browser, view: str = IN_EXPLORER) -> dict[str, Any]:
    """Return what the page has played."""
    return browser.js(
        f"(({{live, played}}) => ({{seat: played?.seat, moves: played?.moves,"
        " actions: live.actions.map((each) => Array.from(each)),"
        " positions: live.recording.moments.map((each) => Array.from(each.positions)),"
        f" captured: live.recording.moments.map((each) => Array.from(each.captured))}}))({view})"
    )


def decided(
    world: World, policies: dict[Team, TeamPolicy], seat: int, hand: int | TeamPolicy
) -> NDArray[np.int64]:
    """Play a round turn by turn, slowly, and return the actions of all agents."""
    actions = np.zeros(world.config.n_agents, np.int64)
    first = world.config.n_pursuers
    while True:
        for agent in world.actors:
            own = hand if agent == seat else policies[TEAMS[agent >= first]]
            if isinstance(own, int):
                actions[agent] = own
            else:
                world.decide(own, range(agent, agent + 1), actions)
        world.play_turn(actions)
        if world.turn == 0:
            return actions


def generation(run: SavedRun, team: Team, number: int) -> Population:
    population = run.teams[team]
    assert isinstance(population, Population)
    return Population(population.genomes[number], population.network)


# ---- Taken over in the explorer ------------------------------------------------------------------


@pytest.mark.nightly
@pytest.mark.parametrize(("run", "keys"), [(0, ARROWS), (1, LETTERS)])
def test_a_match_played_by_keys_is_that_of_the_world(
    browser: Browser, page: Path, job: list[SavedRun], run: int, keys: dict[int, str]
) -> None:
    """The person's keys are its actions; networks decide as `World.decide` does."""
    g, h, step = 2, 1, 3
    take_over(browser, page, run, g, h, step)
    moves_until_done(browser, keys, run)
    played = shown(browser)
    world = World(job[run].settings.world)
    world.reset(evaluation_seed(job[run].settings.seed, g, h))
    before = job[run].record(g, h).actions[:step, played["seat"]]
    assert played["moves"][:step] == before.tolist()
    assert len(played["actions"]) == len(played["moves"]) > step
    policies: dict[Team, TeamPolicy] = {
        team: generation(job[run], team, number) for team, number in zip(TEAMS, (g, h), strict=True)
    }
    for moment, move in enumerate(played["moves"]):
        alive = world.alive.copy()
        actions = decided(world, policies, played["seat"], move)
        assert np.array(played["actions"][moment])[alive].tolist() == actions[alive].tolist()
        assert played["positions"][moment + 1] == world.last_positions.ravel().tolist()
        assert played["captured"][moment + 1] == world.captured.astype(int).tolist()
    assert browser.errors() == []


@pytest.mark.nightly
def test_files_and_links_hold_the_match(
    browser: Browser, page: Path, own: Path, job: list[SavedRun], tmp_path: Path
) -> None:
    """And the page of its own opens files that it or Python saved, and no others."""
    allow = {"behavior": "allow", "downloadPath": str(tmp_path)}
    browser.driver.execute_cdp_cmd("Browser.setDownloadBehavior", allow)
    take_over(browser, page, 1, 0, 2, 2)
    moves_until_done(browser, LETTERS, 1)
    played = shown(browser)
    press_button(browser, "Save")
    wait_until(lambda: [*tmp_path.glob("*.npz")], "a file of the match", 10)
    [file] = tmp_path.glob("*.npz")
    episode = Episode.load(file)
    assert (episode.seat, episode.length) == (played["seat"], len(played["moves"]))
    assert WorldConfig.from_json(episode.config) == job[1].settings.world
    press_button(browser, "Link")
    link = browser.js("document.querySelector('.play-ending input').value")
    browser.driver.get("about:blank")
    browser.driver.get(link)
    browser.wait(f"{IN_EXPLORER} && {IN_EXPLORER}.element.dataset.state === 'ended'")
    assert shown(browser) == played
    browser.open(own)
    opens = browser.driver.find_element("css selector", "input[type=file]")
    other = record(WorldConfig("SB", rows=9, cols=7, obstacles=0.2), "chaser", "fleer", seed=3)
    other.save(tmp_path / "python.npz")
    for path, expected in ((file, episode), (tmp_path / "python.npz", other)):
        opens.send_keys(str(path))
        browser.wait(f"{IN_PAGE}.live.length === {expected.length}")
        positions = np.array(shown(browser, IN_PAGE)["positions"])
        assert positions.tolist() == expected.last_positions.reshape(len(positions), -1).tolist()
    (tmp_path / "cut.npz").write_bytes(file.read_bytes()[:-50])
    dataclasses.replace(other, actions=np.zeros_like(other.actions)).save(tmp_path / "altered.npz")
    for name in ("cut", "altered"):
        opens.send_keys(str(tmp_path / f"{name}.npz"))
        told = "document.querySelector('.setup .problem').innerText"
        browser.wait(f"{told}.startsWith('{name}.npz holds no match: ')")
    assert browser.errors() == []


def press_button(browser: Browser, text: str) -> None:
    browser.driver.find_element("xpath", f"//button[text()='{text}']").click()


# ---- The page of its own -------------------------------------------------------------------------


@pytest.mark.nightly
def test_escape_has_three_rounds_and_a_score(browser: Browser, own: Path) -> None:
    browser.open(own)
    lasted = []
    for turn in range(3):
        title = browser.js("document.querySelector('.play h2').innerText")
        assert f"Round {turn + 1} of 3" in title
        moves_until_done(browser, ARROWS, turn, IN_PAGE)
        lasted.append(browser.js(f"{IN_PAGE}.live.length"))
        press_button(browser, "Watch it")  # which counts nothing again
        browser.press("\ue010")
        browser.wait(f"{IN_PAGE}.player.step === {lasted[-1]}")
        if turn < 2:
            browser.click(".play-ending > .primary")
    score = browser.js("document.querySelector('.play-score').textContent")
    assert score == f"Your score: {sum(lasted)} of 180"
    assert browser.errors() == []


@pytest.mark.nightly
def test_the_form_shows_the_game_that_runs(browser: Browser, own: Path) -> None:
    browser.open(own)
    form = (
        "((all) => all.map((each) => each.offsetParent && each.selectedOptions[0].textContent))"
        "([...document.querySelectorAll('.setup select')])"
    )
    assert browser.js(form) == ["Can you escape it?", None, None, None]
    browser.js("location.hash = '#pursuers=1&evaders=5&seed=7&seat=0&moves=12'")
    browser.wait(f"{IN_PAGE}.live.length === 2")
    assert browser.js(form) == ["One match", "a pursuer", "clumsy chaser", "fleer"]
    pictures = "[...document.querySelectorAll('.about svg')].map((each) => each.innerHTML)"
    chaser, fleer = browser.js(pictures)
    assert chaser != fleer
    assert browser.errors() == []


def test_a_run_gives_its_generations_to_the_page(job: list[SavedRun]) -> None:
    config, players = of_run(job[0])
    assert config == job[0].settings.world
    for team in TEAMS:
        assert [*players[team]] == [f"generation {number}" for number in range(3)]
        last = players[team]["generation 2"]
        assert np.array_equal(last.genomes, generation(job[0], team, 2).genomes)
    assert '"usual":2' in play_page("play", config, players)


def test_the_command_writes_the_page(
    job: list[SavedRun], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert matrixworld_command("play", "sb", "--no-open").output == "play.html\n"
    page = (tmp_path / "play.html").read_text(encoding="utf-8")
    assert page == play_page("matrixworld play", *shipped("SB"))
    run = job[0].path
    matrixworld_command("play", run, "--no-open")
    assert "generation 2" in (run / "play.html").read_text(encoding="utf-8")
