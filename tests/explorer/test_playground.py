"""The playground: scenes as text, and in a browser what worlds do and what a person plays.

The match that a person plays is that of `World`, of the file, and of the link.
"""

from pathlib import Path
from urllib.parse import quote

import numpy as np
import pytest

import matrixworld as mw
from command_line import matrixworld_command
from matrixworld import Episode, Matches, World, WorldConfig, record, rollout
from matrixworld.coevolution import TEAMS
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.explorer import Playground, explore
from matrixworld.explorer.page import write_page
from matrixworld.explorer.playground import of_run, playground_page, scene_link, shipped
from matrixworld.world.policy import Population
from scripts import wait_until

DOCS = Path(__file__).parents[2] / "docs"


def small_world():
    world = mw.World("SB", rows=2, cols=4, n_pursuers=2, n_evaders=1)
    world.reset(0, pursuers=[[0, 0], [0, 2]], evaders=[[1, 3]])
    return world


def test_defaults_are_left_out():
    link = "rules=SB&size=2x4&pursuers=0.0_0.2&evaders=1.3"
    assert scene_link(small_world()) == link
    assert scene_link(small_world(), np.array([2, 4, 0])) == f"{link}&next=240"


def test_all_settings_are_in_the_link():
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


@pytest.mark.parametrize(
    ("call", "field"),
    [
        (lambda: scene_link(small_world(), [0, "chase", 0]), "actions"),
        (lambda: scene_link(small_world(), compare="X"), "variant"),
        (lambda: scene_link(mw.World("O", rows=65)), "world, rows"),
        (lambda: Playground(actions=[0]), "world"),
    ],
)
def test_bad_arguments_are_refused(call, field):
    with pytest.raises((TypeError, ValueError), match=f"^{field}: expected"):
        call()


def test_a_link_and_a_page_for_notebooks(tmp_path):
    playground = Playground(small_world(), [2, 4, "fleer"])
    assert playground.url("docs/playground.html") == f"docs/playground.html#{playground.scene}"
    playground.save(tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert playground.scene.replace("&", "\\u0026") in page
    with pytest.raises(FileExistsError, match="force=True replaces it"):
        playground.save(tmp_path / "page.html")


def test_the_page_in_docs_is_the_present_one():
    kept = (DOCS / "playground.html").read_text(encoding="utf-8")
    assert kept == Playground().html(), "run python docs/make_pages.py"


# ---- In a real browser ---------------------------------------------------------------------------

SHOW = """
const done = arguments[1], loaded = () => setTimeout(() => done(true));
history.replaceState(null, "", "#");  // or an address that does not change would load nothing
addEventListener("hashchange", loaded, { once: true });
location.hash = arguments[0];
"""
"""Show a scene, as a click on a link to it does."""

SCENE = "rules=SB&size=3x5&pursuers=0.0_0.2&evaders=2.4&next=240"
UP, RIGHT, DOWN, LEFT = "\ue013", "\ue014", "\ue015", "\ue012"
ENTER, BACKSPACE, HOME = "\ue007", "\ue003", "\ue011"


class PlaygroundPage:
    def __init__(self, browser, file):
        self.browser = browser
        browser.prefer(prefers_reduced_motion="reduce")
        Playground().save(file)
        browser.open(file)

    def load(self, scene):
        self.browser.driver.execute_async_script(SHOW, f"#{quote(scene, safe='=&._,x+-')}")

    def text(self, selector):
        return self.browser.js(f"document.querySelector('{selector}').textContent")

    def scene(self, *names):
        return self.browser.js(f"(s => [{', '.join(f's.{n}' for n in names)}])(playground.scene)")

    def cells(self):
        return self.browser.js(
            "playground.game.scene().pursuers.concat(playground.game.scene().evaders)"
            ".map(({ cell }) => cell)"
        )


@pytest.fixture(scope="module")
def opened(browser, tmp_path_factory):
    return PlaygroundPage(browser, tmp_path_factory.mktemp("playground") / "playground.html")


@pytest.fixture
def page(opened):
    opened.load(SCENE)
    opened.browser.js("(playground.mode = 'act', playground.selected = 0)")
    yield opened
    assert opened.browser.errors() == []


@pytest.mark.nightly
def test_keys_move_step_and_change_the_rules(page):
    """Back and forth, and the same moves again under other rules."""
    press = page.browser.press
    press(DOWN, "n", LEFT, "n", UP)
    assert page.scene("next") == [[3, 4, 1]]
    press(ENTER)
    assert page.cells() == [[1, 0], [0, 1], [1, 4]]
    press(BACKSPACE)
    assert (page.cells(), page.scene("next")) == ([[0, 0], [0, 2], [2, 4]], [[3, 4, 1]])
    press("p", "p", RIGHT, ENTER)
    assert page.cells()[:2] == [[0, 0], [0, 2]]
    assert page.text(".story [role=status]") == (
        "Step 1. pursuer_0 and pursuer_1 both headed for (0, 1): both bounce. "
        "At fault: pursuer_0 and pursuer_1."
    )
    press("5")  # -S
    assert page.cells()[:2] == [[0, 1], [0, 1]]
    press(HOME)
    assert page.scene("played") == [[]]
    press(ENTER)
    assert page.cells()[:2] == [[0, 1], [0, 1]]
    # The address follows, and is all that a page needs.
    page.browser.wait("location.hash.includes('rules=S&') && location.hash.includes('played=')")
    kept = page.cells()
    page.browser.reload()
    assert page.cells() == kept


@pytest.mark.nightly
@pytest.mark.parametrize(
    "scene",
    [
        "nonsense",
        "rules=__proto__&size=2x2&pursuers=0.0&evaders=0.1",
        "rules=O&size=2x65&pursuers=0.0&evaders=0.1",
        "rules=O&size=1x1&pursuers=0.0&evaders=0.0",  # the engine has no room
        "rules=<img src=x onerror=alert(1)>",
        "%E0%A4%A",
        "played=" + "9" * 30_000,
    ],
)
def test_bad_links_are_told_and_change_nothing(page, scene):
    page.browser.js("window.kept = playground.scene")
    page.load(scene)
    assert page.browser.js("playground.scene === window.kept")
    assert "expected" in page.text(".message")
    assert page.browser.js("document.querySelectorAll('img').length") == 0


# ---- A person plays ----------------------------------------------------------------------------

PLAYED = "document.querySelector('#match').dataset.played"
IN_EXPLORER, IN_PAGE = "window.matrixworldExplorer.playing", "window.matrixworldPlay"
LETTERS = dict(enumerate(" wdsaeczq"))
ARROWS = {0: " ", 1: "\ue013", 2: "\ue014", 3: "\ue015", 4: "\ue012"}


@pytest.fixture(scope="module")
def races(job):
    return explore(*(run.path for run in job.values())).path


@pytest.fixture(scope="module")
def own(tmp_path_factory):
    file = tmp_path_factory.mktemp("play") / "playground.html"
    write_page(file, playground_page("", shipped("SD")))
    return file


def take_over(browser, page, run, g, h, step=0):
    address = f"#run={run}&pursuers={g}&evaders={h}&step={step}"
    browser.open(page)
    browser.driver.execute_script(f"location.hash = '{address}'")
    browser.wait(f"{PLAYED} === '{run} {g} {h} 0 ' && matrixworldExplorer.step === {step}")
    browser.press("t")
    browser.wait(f"{IN_EXPLORER} && document.querySelector('.take-over').open")


def play_on(browser, keys, seed, view=IN_EXPLORER):
    rng = np.random.default_rng(seed)
    while browser.js(f"{view}.element.dataset.state") == "playing":
        browser.press(keys[int(rng.choice(list(keys)))])


def shown(browser, view=IN_EXPLORER):
    return browser.js(
        f"(({{live, played}}) => ({{seat: played?.seat, moves: played?.moves,"
        " actions: live.actions.map((each) => Array.from(each)),"
        " positions: live.recording.moments.map((each) => Array.from(each.positions)),"
        f" captured: live.recording.moments.map((each) => Array.from(each.captured))}}))({view})"
    )


def decided(world, policies, seat, hand):
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


def generation(run, team, number):
    population = run.teams[team]
    assert isinstance(population, Population)
    return Population(population.genomes[number], population.policy)


@pytest.mark.nightly
@pytest.mark.parametrize(("number", "keys"), [(0, ARROWS), (1, LETTERS)])
def test_a_match_played_by_keys_is_that_of_the_world_of_its_file_and_of_its_link(
    browser, races, own, job, tmp_path, number, keys
):
    """The person's keys are its actions; networks decide as `World.decide` does."""
    allow = {"behavior": "allow", "downloadPath": str(tmp_path)}
    browser.driver.execute_cdp_cmd("Browser.setDownloadBehavior", allow)
    run, g, h, step = [*job.values()][number], 2, 1, 3
    take_over(browser, races, number, g, h, step)
    play_on(browser, keys, number)
    played = shown(browser)
    world = World(run.settings.game.world)
    world.reset(evaluation_seed(run.settings.seed, g, h))
    before = run.record(g, h).actions[:step, played["seat"]]
    assert played["moves"][:step] == before.tolist()
    assert len(played["actions"]) == len(played["moves"]) > step
    policies = {"pursuer": generation(run, "pursuer", g), "evader": generation(run, "evader", h)}
    for moment, move in enumerate(played["moves"]):
        alive = world.alive.copy()
        actions = decided(world, policies, played["seat"], move)
        assert np.array(played["actions"][moment])[alive].tolist() == actions[alive].tolist()
        assert played["positions"][moment + 1] == world.last_positions.ravel().tolist()
        assert played["captured"][moment + 1] == world.captured.astype(int).tolist()
    press_button(browser, "Save")
    wait_until(lambda: [*tmp_path.glob("*.npz")], "a file of the match", 10)
    [file] = tmp_path.glob("*.npz")
    episode = Episode.load(file)
    assert (episode.seat, episode.length) == (played["seat"], len(played["moves"]))
    assert WorldConfig.from_json(episode.config) == run.settings.game.world
    press_button(browser, "Link")
    link = browser.js("document.querySelector('.play-ending input').value")
    browser.driver.get("about:blank")
    browser.driver.get(link)
    browser.wait(f"{IN_EXPLORER} && {IN_EXPLORER}.element.dataset.state === 'ended'")
    assert shown(browser) == played
    # The page of its own opens files that it or Python saved, and no others.
    browser.open(own)
    press_button(browser, "A match from a file")
    opens = browser.driver.find_element("css selector", "input[type=file]")
    other = record(WorldConfig("SB", rows=9, cols=7, obstacles=0.2), "chaser", "fleer", seed=3)
    other.save(tmp_path / "python.npz")
    for path, expected in ((file, episode), (tmp_path / "python.npz", other)):
        opens.send_keys(str(path))
        browser.wait(f"{IN_PAGE}.live.length === {expected.length}")
        positions = np.array(shown(browser, IN_PAGE)["positions"])
        assert positions.tolist() == expected.last_positions.reshape(len(positions), -1).tolist()
    (tmp_path / "cut.npz").write_bytes(file.read_bytes()[:-50])
    opens.send_keys(str(tmp_path / "cut.npz"))
    told = "document.querySelector('.setup .problem').innerText"
    browser.wait(f"{told}.startsWith('cut.npz holds no match: ')")
    assert browser.errors() == []


def press_button(browser, text):
    browser.driver.find_element("xpath", f"//button[text()='{text}']").click()


def test_rounds_are_harder_and_harder_and_standing_still_wins_none():
    """What docs/pages.md says of "Can you escape it?", from any starts."""
    rates = {
        evader: [
            1.0 - rollout(world, pursuers, evader, Matches.of(0, 0, [1]), episodes=100).capture_rate
            for world, pursuers in shipped("O").rounds
        ]
        for evader in ("dodger", "still", "random")
    }
    first, second, third = (float(rate.mean()) for rate in rates["dodger"])
    assert first > 0.7 > second > 0.35 > third > 0.05
    assert max(float(rate.mean()) for rate in rates["still"] + rates["random"]) < 0.1


def test_a_run_gives_its_generations_to_the_page(job):
    opponents = of_run(job["race"])
    assert opponents.world == job["race"].settings.game.world
    for team in TEAMS:
        players = opponents.players[team]
        assert [*players] == [f"generation {number}" for number in range(3)]
        last = players["generation 2"]
        assert np.array_equal(last.genomes, generation(job["race"], team, 2).genomes)
    assert '"usual":2' in playground_page("", opponents)


def test_the_command_writes_it(job, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert matrixworld_command("playground", "sb", "--no-open").output == "playground.html\n"
    page = (tmp_path / "playground.html").read_text(encoding="utf-8")
    assert page == playground_page("", shipped("SB"))
    run = job["race"].path
    matrixworld_command("playground", run, "--no-open")
    assert "generation 2" in (run / "playground.html").read_text(encoding="utf-8")
