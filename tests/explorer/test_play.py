"""A person plays in a real browser: the match is that of `World`, of the file, and of the link."""

import dataclasses
import re
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from browser import PHONE, Browser
from command_line import matrixworld_command
from matrixworld import Episode, World, WorldConfig, record
from matrixworld.cli import explore as explore_cli
from matrixworld.coevolution import TEAMS, SavedRun, Team, held_out, open_run, start
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.episodes.record import record_actions
from matrixworld.explorer import explore
from matrixworld.explorer.page import write_page
from matrixworld.explorer.play_page import play_page, shipped
from matrixworld.world.policy import Population, TeamPolicy
from tiny_race import tiny_race

PLAYED = "document.querySelector('#match').dataset.played"
IN_EXPLORER, IN_PAGE = "window.matrixworldExplorer.playing", "window.matrixworldPlay"
KEYPAD = {0: "\ue01f", 1: "\ue022", 3: "\ue01c", 5: "\ue023", 7: "\ue01b", 8: "\ue021"}
"""Keys 5, 8, 2, 9, 1 and 7 of a numeric keypad, by the action that lies there."""
LETTERS = dict(enumerate("swdxaeczq"))
ARROWS = {0: " ", 1: "\ue013", 2: "\ue014", 3: "\ue015", 4: "\ue012"}
ESCAPE = "\ue00c"


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> list[SavedRun]:
    """A race with obstacles, and one in which the teams take turns and move diagonally."""
    root = tmp_path_factory.mktemp("job")
    settings = {
        "race": tiny_race(obstacles=0.15, max_steps=30),
        "turns": tiny_race(rules="TO", diagonal=True, max_steps=20, schedule="hall-of-fame"),
    }
    for name, each in settings.items():
        start(each, root / name, threads=1).run()
    return [open_run(root / name) for name in settings]


@pytest.fixture(scope="module")
def page(job: list[SavedRun]) -> Path:
    return explore(*(run.files.path for run in job)).path


@pytest.fixture(scope="module")
def downloads(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("downloads")
    allow = {"behavior": "allow", "downloadPath": str(folder)}
    browser.driver.execute_cdp_cmd("Browser.setDownloadBehavior", allow)
    return folder


def take_over(browser: Browser, page: Path, run: int, g: int, h: int, step: int = 0) -> None:
    """Show a match, go to a step, and take an agent over."""
    address = f"#run={run}&pursuers={g}&evaders={h}&step={step}"
    browser.open(page)
    browser.driver.execute_script(f"location.hash = '{address}'")
    browser.wait(f"{PLAYED} === '{run} {g} {h} 0 ' && matrixworldExplorer.step === {step}")
    browser.press("t")
    browser.wait(f"{IN_EXPLORER} && document.querySelector('.take-over').open")


def moves_until_done(
    browser: Browser, keys: dict[int, str], rng: np.random.Generator, view: str = IN_EXPLORER
) -> None:
    """Press random keys until the match has ended for the person."""
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


def policies_of(run: SavedRun, g: int, h: int) -> dict[Team, TeamPolicy]:
    found: dict[Team, TeamPolicy] = {}
    for team, generation in zip(TEAMS, (g, h), strict=True):
        population = run.teams[team]
        assert isinstance(population, Population)
        found[team] = Population(population.genomes[generation], population.network)
    return found


@pytest.mark.parametrize(("run", "keys"), [(0, ARROWS), (1, LETTERS), (1, KEYPAD)])
def test_a_match_played_by_keys_is_that_of_the_world(
    browser: Browser, page: Path, job: list[SavedRun], run: int, keys: dict[int, str]
) -> None:
    """The person's keys are its actions; networks decide as `World.decide` does."""
    g, h, step = 2, 1, 3
    take_over(browser, page, run, g, h, step)
    moves_until_done(browser, keys, np.random.default_rng(run))
    played = shown(browser)
    world = World(job[run].settings.world)
    world.reset(evaluation_seed(job[run].settings.seed, g, h))
    before = job[run].record(g, h).actions[:step, played["seat"]]
    assert played["moves"][:step] == before.tolist()
    assert len(played["actions"]) == len(played["moves"]) > step
    for moment, move in enumerate(played["moves"]):
        policies = policies_of(job[run], g, h)
        alive = world.alive.copy()
        actions = decided(world, policies, played["seat"], move)
        assert np.array(played["actions"][moment])[alive].tolist() == actions[alive].tolist()
        assert played["positions"][moment + 1] == world.last_positions.ravel().tolist()
        assert played["captured"][moment + 1] == world.captured.astype(int).tolist()
    assert browser.errors() == []


def test_generations_in_the_same_seat(browser: Browser, page: Path, job: list[SavedRun]) -> None:
    """The table at the end has what each generation makes of the same match from the same step."""
    g, h, step = 1, 2, 2
    take_over(browser, page, 0, g, h, step)
    moves_until_done(browser, ARROWS, np.random.default_rng(5))
    browser.wait("!document.querySelector('.play-ending').textContent.includes('…')")
    texts = browser.js(
        "Array.from(document.querySelectorAll('.play-ending tr'), (e) => e.innerText)"
    )
    rows = [text.split("\t") for text in texts]
    played, run = shown(browser), job[0]
    seat, population = played["seat"], run.teams["evader"]
    assert isinstance(population, Population)
    lasted = {}
    for generation in range(3):
        world = World(run.settings.world)
        world.reset(evaluation_seed(run.settings.seed, g, h))
        hand = Population(population.genomes[generation], population.network)
        evader = seat - run.settings.world.n_pursuers
        while not (world.terminated or world.truncated or world.captured[evader]):
            own = played["moves"][world.steps] if world.steps < step else hand
            decided(world, policies_of(run, g, h), seat, own)
        lasted[f"generation {generation}"] = str(world.steps)
    assert {row[0]: row[-1] for row in rows} == {"You": str(len(played["moves"])), **lasted}


def press_button(browser: Browser, text: str) -> None:
    browser.driver.find_element("xpath", f"//button[text()='{text}']").click()


def saved(browser: Browser, folder: Path) -> Path:
    """Press Save and return the file."""
    for file in folder.iterdir():
        file.unlink()  # the browser may replace a file of the same name
    press_button(browser, "Save")
    deadline = time.monotonic() + 20
    while not (found := [*folder.glob("*.npz")]):
        assert time.monotonic() < deadline
        time.sleep(0.02)
    return found[0]


def same(first: Episode, second: Episode) -> bool:
    fields = [each.name for each in dataclasses.fields(Episode)]
    return all(np.array_equal(getattr(first, name), getattr(second, name)) for name in fields)


@pytest.mark.slow
@pytest.mark.parametrize("run", [0, 1])
def test_a_file_is_an_episode_and_replays_bit_for_bit(
    browser: Browser, page: Path, job: list[SavedRun], downloads: Path, run: int, tmp_path: Path
) -> None:
    take_over(browser, page, run, 0, 2)
    moves_until_done(browser, ARROWS, np.random.default_rng(run))
    played = shown(browser)
    file = saved(browser, downloads)
    episode = Episode.load(file)
    assert (episode.seat, episode.length) == (played["seat"], len(played["moves"]))
    config = WorldConfig.from_json(episode.config)
    assert config == job[run].settings.world
    seed = evaluation_seed(job[run].settings.seed, 0, 2)
    again = record_actions(config, episode.actions, seed=seed)
    assert same(episode, dataclasses.replace(again, seat=played["seat"]))
    # Its own start leads to the same, without the seed.
    cells, first = episode.positions[0], config.n_pursuers
    starts = {"pursuers": cells[:first], "evaders": cells[first:], "obstacles": episode.map}
    assert same(again, record_actions(config, episode.actions, **starts))
    matrixworld_command("replay", file, "--out", tmp_path / "match.gif")
    with Image.open(tmp_path / "match.gif") as image:
        assert image.n_frames == episode.length + 1
    episode.save(tmp_path / "again.npz")
    assert same(episode, Episode.load(tmp_path / "again.npz"))


@pytest.mark.slow
def test_a_link_holds_the_match(browser: Browser, page: Path) -> None:
    take_over(browser, page, 1, 1, 0, 2)
    moves_until_done(browser, LETTERS, np.random.default_rng(2))
    played = shown(browser)
    press_button(browser, "Link")
    link = browser.js("document.querySelector('.play-ending input').value")
    browser.driver.get("about:blank")
    browser.driver.get(link)
    browser.wait(f"{IN_EXPLORER} && {IN_EXPLORER}.element.dataset.state === 'ended'")
    assert shown(browser) == played
    for wrong in ("seat=99", "moves=0129", "from=400", "moves="):
        browser.driver.get("about:blank")
        browser.driver.get(re.sub(rf"{wrong.partition('=')[0]}=\w*", wrong, link))
        browser.wait(PLAYED)
        assert not browser.js("document.querySelector('.take-over').open")
    assert browser.errors() == []


@pytest.mark.slow
def test_again_begins_where_the_person_took_over(browser: Browser, page: Path) -> None:
    take_over(browser, page, 0, 2, 2, 4)
    before = shown(browser)
    moves_until_done(browser, ARROWS, np.random.default_rng(1))
    browser.click(".play-ending .primary")
    assert shown(browser) == before
    browser.press(ESCAPE)
    browser.wait("!document.querySelector('.take-over').open")
    browser.press("w")  # the match is left
    assert browser.js(f"{IN_EXPLORER}.played") is None


# ---- The page of its own


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("play") / "play.html"
    write_page(file, play_page("play", *shipped("SD")))
    return file


@pytest.mark.slow
def test_escape_has_three_rounds_and_a_score(browser: Browser, own: Path) -> None:
    browser.open(own)
    lasted = []
    for turn in range(3):
        assert f"Round {turn + 1} of 3" in browser.js(
            "document.querySelector('.play h2').innerText"
        )
        config = browser.js(f"{IN_PAGE}.live.config")
        assert (config["n_evaders"], config["n_pursuers"]) == (1, 8)
        moves_until_done(browser, ARROWS, np.random.default_rng(turn), IN_PAGE)
        lasted.append(browser.js(f"{IN_PAGE}.live.length"))
        if turn < 2:
            browser.click(".play-ending > .primary")
    assert browser.js("document.querySelector('.play-score').textContent") == (
        f"Your score: {sum(lasted)} of 180"
    )
    assert browser.errors() == []


def begin(browser: Browser, **choices: str) -> None:
    """Choose by label, and press Play."""
    for label, text in choices.items():
        browser.js(
            "((choice) => { choice.value = Array.from(choice.options)"
            ".find((each) => each.text === arguments[1]).value; })"
            "([...document.querySelectorAll('.setup label')]"
            ".find((each) => each.textContent.startsWith(arguments[0])).querySelector('select'))",
            label.replace("_", " "), text,
        )  # fmt: skip
    browser.click(".setup .primary")


def test_shipped_networks_decide_as_in_python(browser: Browser, own: Path) -> None:
    browser.open(own)
    begin(browser, You_are="a pursuer", Pursuers="evolved-2", Evaders="evolved-1")
    for key in "wdxa":
        browser.press(key)
    played = shown(browser, IN_PAGE)
    seed = int(browser.js(f"String({IN_PAGE}.played.seed)"))
    config, players = shipped("SD")
    world = World(config)
    world.reset(seed)
    policies: dict[Team, TeamPolicy] = {
        "pursuer": players["pursuer"]["evolved-2"], "evader": held_out("evader", "SD")["evolved-1"]
    }  # fmt: skip
    for actions, move in zip(played["actions"], (1, 2, 3, 4), strict=True):
        assert actions == decided(world, policies, 0, move).tolist()


def open_file(browser: Browser, file: Path) -> None:
    browser.driver.find_element("css selector", "input[type=file]").send_keys(str(file))


@pytest.mark.slow
def test_files_open_in_the_page(
    browser: Browser, own: Path, downloads: Path, tmp_path: Path
) -> None:
    """Those that the page has saved, those of Python, and no others."""
    browser.open(own)
    begin(browser, Pursuers="surrounder")
    moves_until_done(browser, ARROWS, np.random.default_rng(0), IN_PAGE)
    before = shown(browser, IN_PAGE)
    file = saved(browser, downloads)
    state, told = (
        f"{IN_PAGE}.element.dataset.state",
        "document.querySelector('.setup .problem').innerText",
    )
    open_file(browser, file)
    browser.wait(f"{state} === 'watched'")
    after = shown(browser, IN_PAGE)
    assert [after[name] for name in ("actions", "positions")] == [
        before[name] for name in ("actions", "positions")
    ]
    episode = record(WorldConfig("SB", rows=9, cols=7, obstacles=0.2), "chaser", "fleer", seed=3)
    episode.save(tmp_path / "python.npz")
    open_file(browser, tmp_path / "python.npz")
    browser.wait(f"{IN_PAGE}.live.length === {episode.length}")
    positions = np.array(shown(browser, IN_PAGE)["positions"])
    assert positions.tolist() == episode.last_positions.reshape(len(positions), -1).tolist()
    (tmp_path / "cut.npz").write_bytes(file.read_bytes()[:-50])
    moved = dataclasses.replace(episode, actions=np.zeros_like(episode.actions))
    moved.save(tmp_path / "altered.npz")
    for name, says in (("cut", "invalid zip data"), ("altered", "expected the moves")):
        open_file(browser, tmp_path / f"{name}.npz")
        browser.wait(f"{told}.startsWith('{name}.npz holds no match: {says}')")
    assert browser.errors() == []


def test_fingers_move_and_fog_hides(browser: Browser, own: Path) -> None:
    """The pad, a swipe, and a tap on the board, on a phone; and what fog covers is not drawn."""
    browser.open(own, PHONE)
    browser.click(".play-pad [aria-label=east]")
    box = browser.js(
        "(({left, top, width}) => [left, top, width])"
        "(document.querySelector('.play canvas').getBoundingClientRect())"
    )
    middle = [box[0] + box[2] / 2, box[1] + box[2] / 2]
    browser.drag((middle[0], middle[1]), (middle[0] - 60, middle[1] + 5))
    row, col = np.array(shown(browser, IN_PAGE)["positions"][-1]).reshape(-1, 2)[-1]
    cell = box[2] / 20
    below = row < 10
    browser.drag((box[0] + (col + 0.5) * cell, box[1] + (row + (5.5 if below else -4.5)) * cell))
    assert shown(browser, IN_PAGE)["moves"] == [2, 4, 3 if below else 1]
    assert browser.js("document.documentElement.scrollWidth") <= PHONE[0]
    pixels = (
        "(() => { const canvas = document.querySelector('.play canvas');"
        " return new Set(new Uint32Array(canvas.getContext('2d')"
        ".getImageData(0, arguments[0], canvas.width, 8).data.buffer)).size; })()"
    )
    far = int(box[2] * (0.9 if below else 0.1))
    time.sleep(0.5)
    assert browser.js(pixels, far) > 3
    browser.js("document.querySelector('.play-choice input').click()")
    browser.wait(f"{pixels.replace('arguments[0]', str(far))} <= 3")


def test_a_pace_repeats_the_last_move(browser: Browser, own: Path) -> None:
    browser.open(own)
    browser.js(
        "((choice) => { choice.value = '8'; choice.dispatchEvent(new Event('change')); })"
        "(document.querySelector('.play-choice select'))"
    )
    browser.press("a")
    browser.wait(f"{IN_PAGE}.played.moves.length >= 3")
    browser.press("s")
    browser.wait(f"{IN_PAGE}.played.moves.at(-1) === 0")
    moves: Sequence[int] = browser.js(f"{IN_PAGE}.played.moves")
    assert moves[:3] == [4, 4, 4]


@pytest.mark.slow
def test_nothing_hinders_readers_with_disabilities(browser: Browser, own: Path, page: Path) -> None:
    end = "while (matrixworldPlay.element.dataset.state === 'playing') matrixworldPlay.act(1);"
    watched = f"{end} document.querySelectorAll('.play-buttons button')[1].click();"
    assert browser.hindrances(own, end, watched) == {}
    assert browser.hindrances(page, "document.querySelector('.to-play').click();") == {}


def test_the_command_writes_the_page(
    job: list[SavedRun], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    opened: list[str] = []
    monkeypatch.setattr(explore_cli.webbrowser, "open", lambda url: opened.append(url) or True)
    result = matrixworld_command("play", "sb")
    page = tmp_path / "play.html"
    assert (result.output, opened) == ("play.html\n", [page.as_uri()])
    assert page.read_text(encoding="utf-8") == play_page("matrixworld play", *shipped("SB"))
    run = job[0].files.path
    matrixworld_command("play", run, "--no-open")
    assert "generation 2" in (run / "play.html").read_text(encoding="utf-8")
    page.write_text("mine")
    assert "--force" in matrixworld_command("play", "O", code=2).output
    episode = tmp_path / "match.npz"
    record("O", "chaser", "fleer", seed=0).save(episode)
    assert "got a file" in matrixworld_command("play", episode, code=2).output
