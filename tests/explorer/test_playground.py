"""The playground in a browser: keys, pointer, links, steps back and forth, and hostile links."""

import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote, unquote

import numpy as np
import pytest

import matrixworld as mw
from browser import DESKTOP, LAPTOP, PHONE, Browser
from matrixworld.explorer import Playground
from matrixworld.explorer.playground import GALLERY, Example, drawn_world, scene_link
from slow import quickly

SHOW = """
const done = arguments[1], loaded = () => setTimeout(() => done(true));
history.replaceState(null, "", "#");  // or an address that does not change would load nothing
addEventListener("hashchange", loaded, { once: true });
location.hash = arguments[0];
"""
"""Show a scene, as a click on a link to it does."""

PLAY = """
const [commands, places] = arguments;
document.querySelectorAll(".agents select").forEach((choice, agent) => {
  if (choice.disabled || commands === null) return;
  choice.value = String(commands[agent]);
  choice.dispatchEvent(new Event("change"));
});
document.getElementById("step").click();
const kinds = ["obstacle", "teammate", "adversary"].map((kind) => `.line-${kind} .line-text`);
return places.map((place) => {
  const game = playground.games[place], part = document.querySelectorAll(".story-part")[place];
  const moment = game.recording.moments.at(-1), outcome = game.outcomes.at(-1);
  const read = (selector) => [...part.querySelectorAll(selector)].map((each) => each.textContent);
  return {
    positions: [...moment.positions], alive: [...moment.alive].map(Boolean),
    captured: [...moment.captured].map(Boolean), ever: [...moment.everCaptured].map(Boolean),
    captors: [...outcome.captors], rewards: [...outcome.rewards],
    ended: outcome.terminated, truncated: outcome.truncated,
    sentences: read(kinds.join(", ")), blame: read(".line-blame"),
  };
});
"""
"""Choose what agents do next in their table, press Step, and return what the page then shows."""


class PlaygroundPage:
    """The page in a browser."""

    def __init__(self, browser: Browser, file: Path) -> None:
        self.browser = browser
        Playground().save(file)
        browser.open(file)

    def load(self, scene: str) -> None:
        """Show a scene as a click on a link to it does."""
        self.browser.driver.execute_async_script(SHOW, f"#{quote(scene, safe='=&._,x+-')}")

    def play(self, commands: Sequence[int | str] | None = None, boards: int = 1) -> list[Any]:
        """Play a step and return what each board and its words then show."""
        return self.browser.driver.execute_script(PLAY, commands, list(range(boards)))

    def press(self, name: str) -> None:
        """Press the button of this name."""
        self.browser.js(
            "[...document.querySelectorAll('button')]"
            ".find((each) => each.textContent === arguments[0]).click()",
            name,
        )

    def message(self) -> str:
        """Return what the page tells its reader."""
        return self.browser.js("document.querySelector('.message').textContent")

    def scene(self) -> str:
        """Return the scene in the address, which follows the page after 0.1 s."""
        time.sleep(0.25)
        return unquote(self.browser.js("location.hash.slice(1)"))


def state_of(world: mw.World) -> dict[str, Any]:
    """Return the same of a world whose last step kept its conflicts."""
    conflicts = world.conflicts
    return {
        "positions": world.last_positions.ravel().tolist(),
        "alive": world.alive.tolist(),
        "captured": world.captured.tolist(),
        "ever": world.ever_captured.tolist(),
        "captors": world.captors.tolist(),
        "rewards": world.rewards.tolist(),
        "ended": world.terminated,
        "truncated": world.truncated,
        "sentences": [f"{conflict}." for conflict in conflicts],
        "blame": [blame(world, conflict) for conflict in conflicts],
    }


def blame(world: mw.World, conflict: mw.Conflict) -> str:
    """Return the sentence about the agents at fault."""
    names = [world.config.agent_name(agent) for agent in conflict.at_fault]
    return f"At fault: {' and '.join(names)}." if names else "Nobody is at fault."


def decided(world: mw.World, commands: list[int | str]) -> np.ndarray:
    """Return the actions that commands lead to, as scripts decide at this moment."""
    actions = np.array([0 if isinstance(each, str) else each for each in commands])
    first = world.config.n_pursuers
    for agent, command in enumerate(commands):
        if isinstance(command, str):
            team = range(first) if agent < first else range(first, len(commands))
            chosen = actions.copy()
            world.decide(command, team, chosen)
            actions[agent] = chosen[agent]
    return actions


SCENE = "rules=SB&size=3x5&pursuers=0.0_0.2&evaders=2.4&next=240"
AXIS = 28  # pixels for the numbers of rows and columns
UP, RIGHT, DOWN, LEFT = "\ue013", "\ue014", "\ue015", "\ue012"
ENTER, BACKSPACE, HOME, DELETE, CONTROL = "\ue007", "\ue003", "\ue011", "\ue017", "\ue009"


@pytest.fixture(scope="module")
def opened(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> PlaygroundPage:
    return PlaygroundPage(browser, tmp_path_factory.mktemp("playground") / "playground.html")


@pytest.fixture
def page(opened: PlaygroundPage) -> Iterator[PlaygroundPage]:
    opened.load(SCENE)
    opened.browser.js("(playground.mode = 'act', playground.selected = 0)")
    yield opened
    assert opened.browser.errors() == []


def board(page: PlaygroundPage, *names: str) -> Any:
    """Return parts of the present scene."""
    return page.browser.js(f"(({{{', '.join(names)}}}) => [{', '.join(names)}])(playground.scene)")


def cells(page: PlaygroundPage) -> list[list[int]]:
    """Return where agents are at present."""
    return page.browser.js(
        "playground.game.scene().pursuers.concat(playground.game.scene().evaders)"
        ".map(({ cell }) => cell)"
    )


def drag(page: PlaygroundPage, *path: tuple[int, int]) -> None:
    """Press the pointer on the first cell, go through the others, and let it go on the last."""
    page.browser.wait("playground.player.arrived")
    box = "document.querySelector('canvas.board').getBoundingClientRect().toJSON()"
    board = page.browser.js(box)
    rows, cols = page.browser.js("[playground.scene.rows, playground.scene.cols]")
    side = min((board["width"] - AXIS) / (cols + 0.24), (board["height"] - AXIS) / (rows + 0.24))
    left = board["left"] + (board["width"] - cols * side + AXIS) / 2
    top = board["top"] + (board["height"] - rows * side + AXIS) / 2
    page.browser.drag(*((left + (c + 0.5) * side, top + (r + 0.5) * side) for r, c in path))


# Keys:


def test_keys_play_a_whole_step(page: PlaygroundPage) -> None:
    page.browser.press(DOWN, "n", LEFT, "n", UP)
    assert board(page, "next") == [[3, 4, 1]]
    page.browser.press(ENTER)
    assert cells(page) == [[1, 0], [0, 1], [1, 4]]
    page.browser.press(BACKSPACE)
    assert cells(page) == [[0, 0], [0, 2], [2, 4]]
    assert board(page, "next") == [[3, 4, 1]], "stepping again does the same"


def test_a_digit_changes_the_rules_and_plays_the_same_moves_again(page: PlaygroundPage) -> None:
    page.browser.press(ENTER)
    assert cells(page)[:2] == [[0, 0], [0, 2]]
    for key, expected in (("5", [[0, 1], [0, 1]]), ("6", [[0, 0], [0, 2]])):  # -S and -SB
        page.browser.press(key)
        assert cells(page)[:2] == expected
        assert "both headed for (0, 1)" in page.browser.js(
            "document.querySelector('.story').textContent"
        )


def test_back_and_forth_over_several_steps(page: PlaygroundPage) -> None:
    moves = [DOWN, RIGHT, DOWN]
    for key in moves:
        page.browser.press(key, ENTER)
    after = cells(page)
    played = board(page, "played")
    page.browser.press(BACKSPACE, BACKSPACE, ENTER, ENTER)
    assert (cells(page), board(page, "played")) == (after, played)
    page.browser.press(HOME)
    assert board(page, "played") == [[]]
    page.browser.press(ENTER, ENTER, ENTER)
    assert (cells(page), board(page, "played")) == (after, played)


def test_another_move_forgets_the_steps_that_were_taken_back(page: PlaygroundPage) -> None:
    page.browser.press(DOWN, ENTER, DOWN, ENTER, BACKSPACE, BACKSPACE, RIGHT, ENTER, ENTER)
    assert board(page, "played") == [[[2, 4, 0], [0, 0, 0]]]


@pytest.mark.slow
def test_undo_and_redo(page: PlaygroundPage) -> None:
    start = page.scene()
    page.browser.press(DOWN, ENTER, "5")
    end = page.scene()
    for _ in range(3):
        page.press("Undo")
    assert page.scene() == start
    from selenium.webdriver import ActionChains

    for _ in range(3):
        ActionChains(page.browser.driver).key_down(CONTROL).send_keys("y").key_up(CONTROL).perform()
    assert page.scene() == end


@pytest.mark.slow
def test_run_stops_at_the_end_of_the_episode(page: PlaygroundPage) -> None:
    page.load("rules=O&size=1x6&pursuers=0.0&evaders=0.5&next=cb")  # a chaser, one that stays
    page.browser.press(" ")
    page.browser.wait("!playground.running && playground.game.over")
    assert "The episode has ended: no evader is left." in page.browser.js(
        "document.querySelector('.story').textContent"
    )
    page.browser.press(ENTER)
    assert "The episode has ended" in page.message()


def test_building_by_keys(page: PlaygroundPage) -> None:
    page.browser.press("m")
    page.browser.js("document.querySelector('canvas.board').focus()")
    page.browser.press(DOWN, " ", RIGHT, ENTER)
    assert board(page, "walls") == [[5, 6]]
    page.browser.press(ENTER)
    assert board(page, "walls") == [[5]]
    page.browser.press("+", "-")
    assert len(board(page, "pursuers")[0]) == 3
    assert len(board(page, "evaders")[0]) == 2
    page.browser.press(DELETE)
    assert len(board(page, "evaders")[0]) == 1


# Pointer:


def test_dragging_gives_moves(page: PlaygroundPage) -> None:
    drag(page, (0, 0), (1, 0))
    assert board(page, "next") == [[3, 4, 0]]
    drag(page, (2, 4))
    drag(page, (1, 4))  # a cell beside the chosen agent
    assert board(page, "next") == [[3, 4, 1]]


def test_building_by_pointer(page: PlaygroundPage) -> None:
    page.press("Build")
    drag(page, (0, 0), (1, 0), (2, 1))
    assert cells(page)[0] == [2, 1]
    drag(page, (1, 1), (1, 2), (1, 3))
    assert board(page, "walls") == [[6, 7, 8]]
    drag(page, (1, 2), (1, 3))
    assert board(page, "walls") == [[6]]
    drag(page, (2, 1), (1, 1), (0, 2))
    assert cells(page)[0] == [2, 1], "neither obstacles nor agents give way"
    page.press("Undo")
    assert board(page, "walls") == [[6, 7, 8]], "a drag is one change"


# Links:


@pytest.mark.parametrize(
    "scene",
    [
        SCENE,
        "rules=simultaneous.bounce.reach.disappear.bounce.occupation.false&others=D"
        "&rewards=1_-2_0.5_-1e-7_-3,-4,0_-5_0_0.25_INVOLVED_true&size=4x3&diagonal=1&fov=3&limit=9"
        "&seed=18446744073709551615.7.2&walls=0.1_3.2&pursuers=1.1_1.1_0.0x&evaders=2.2c_0.2e_3.0cx"
        "&played=08c000_a00000&next=00012f",
        *(example.scene for example in GALLERY),
    ],
)
def test_links_hold_the_whole_scene(page: PlaygroundPage, scene: str) -> None:
    page.load(scene)
    page.press("Share")
    code, link = page.browser.js(
        "[...document.querySelectorAll('.copy input')].reverse().map((each) => each.value)"
    )
    page.browser.js("document.querySelector('dialog[open]').close()")
    assert (code, link.split("#")[1]) == (f"#{scene}", scene)
    assert page.message() == ""


@pytest.mark.parametrize(
    ("scene", "message"),
    [
        ("nonsense", "link: expected parts rules, "),
        ("rules=O&rules=O", "rules: expected it once"),
        ("rules=__proto__&size=2x2&pursuers=0.0&evaders=0.1", "rules: expected D, R, B, "),
        ("rules=O&size=2&pursuers=0.0&evaders=0.1", "size: expected rows and columns"),
        ("rules=O&size=2x65&pursuers=0.0&evaders=0.1", "size: expected a number from 1 to 64"),
        ("rules=O&size=2x2&pursuers=0.2&evaders=0.1", "pursuers: expected cells of a 2 x 2 grid"),
        ("rules=O&size=2x2&pursuers=0.0c&evaders=0.1", "pursuers: expected no captured pursuer"),
        ("rules=O&size=2x2&evaders=0.1", "pursuers: expected 1 to 100 agents"),
        ("rules=O&size=2x2&pursuers=0.0&evaders=0.1&next=05", "next: expected actions 0 to 4"),
        ("rules=O&size=2x2&pursuers=0.0&evaders=0.1&next=0", "next: expected 2 characters"),
        ("rules=O&size=2x2&pursuers=0.0&evaders=0.1&next=0~", "next: expected actions 0 to 4"),
        ("rules=O&size=2x2&pursuers=0.0&evaders=0.1&fov=4", "fov: expected an odd number"),
        ("rules=O&size=2x2&pursuers=0.0&evaders=0.1&seed=1e9.0.0", "seed: expected seed.episode"),
        (f"rules=O&size=2x2&pursuers=0.0&evaders=0.1&seed={2**64}.0.0", "numbers below 2^64"),
        ("rules=O&rewards=1_2&size=2x2&pursuers=0.0&evaders=0.1", "rewards: expected paper, "),
        ("rules=O&size=1x1&pursuers=0.0&evaders=0.0", "expected"),  # the engine has no room
        ("rules=<img src=x onerror=alert(1)>", "rules: expected D, R, B, "),
        ("%E0%A4%A", "link: expected parts"),
        ("played=" + "9" * 30_000, "at most 20000 characters"),
    ],
)
def test_bad_links_are_told_and_change_nothing(
    page: PlaygroundPage, scene: str, message: str
) -> None:
    before = page.browser.js("playground.scene === (window.kept = playground.scene)")
    page.load(scene)
    assert before
    assert page.browser.js("playground.scene === window.kept")
    assert message in page.message()
    assert page.browser.js("document.querySelectorAll('img').length") == 0


def test_a_page_opened_by_a_bad_link_begins_with_the_first_example(page: PlaygroundPage) -> None:
    page.browser.js("location.hash = 'rules=X'")
    page.browser.reload()
    assert "This link holds no scene. rules: expected D, R, B, " in page.message()
    assert page.browser.js("playground.example.title") == GALLERY[0].title


def test_a_reload_shows_the_same_scene(page: PlaygroundPage) -> None:
    page.browser.press(DOWN, ENTER, "5")
    before = page.scene(), cells(page)
    page.browser.reload()
    assert (page.scene(), cells(page)) == before


# Looks:


@pytest.mark.slow
@pytest.mark.parametrize("size", [DESKTOP, LAPTOP, PHONE])
def test_nothing_is_cut_off_and_nothing_jumps(page: PlaygroundPage, size: tuple[int, int]) -> None:
    page.browser.resize(*size)
    page.load(GALLERY[1].scene)
    places = (
        "['#step', '.rules', '.story'].map((name) => "
        "document.querySelector(name).getBoundingClientRect().toJSON())"
    )
    before = page.browser.js(places)
    page.play()
    # On a phone the words follow the board and grow with what happens; the rules follow them.
    kept = 1 if size == PHONE else 3
    assert page.browser.js(places)[:kept] == before[:kept]
    for example in GALLERY:
        page.load(example.scene)
        page.play()
        assert page.browser.js("document.documentElement.scrollWidth") == size[0], example.title
    page.browser.resize(*LAPTOP)


def test_what_is_allowed_but_costs_is_told_with_its_sum(page: PlaygroundPage) -> None:
    """Sharing a cell under -S: nobody is stopped, and both pay."""
    page.load(next(each.scene for each in GALLERY if each.title == "Share a cell?"))
    page.browser.press(ENTER)
    read = "[...document.querySelectorAll('{}')].map((each) => each.textContent || each.title)"
    assert page.browser.js(read.format(".story-part strong")) == ["Allowed, but it costs: −12."]
    sums = page.browser.js(read.format(".reward").replace("textContent || each.", ""))
    assert sums[2:4] == ["−12 collision, −0.05 step"] * 2
    page.load("rules=S&size=3x4&walls=1.0&pursuers=0.2&evaders=0.0_2.3&next=400")
    page.browser.press(ENTER)
    assert page.browser.js(read.format(".reward:not([hidden]) .sum")) == [
        "+10 capture, +0.1 neighbour, −0.05 step",
        "−10 capture, −0.1 neighbour, −0.05 step",
        "",
    ]


def test_the_caption_of_an_example_leaves_with_its_start(page: PlaygroundPage) -> None:
    caption = "document.querySelector('.example-text').textContent"
    page.load(GALLERY[0].scene)
    page.browser.press(ENTER, "6")  # what agents do and the rules are what captions speak of
    assert page.browser.js(caption).startswith("Two pursuers head")
    page.browser.press("m", "+")
    assert page.browser.js(caption).startswith("A scene of your own")
    page.press("Undo")
    assert page.browser.js(caption).startswith("Two pursuers head")


def test_pages_without_motion_show_steps_at_once(page: PlaygroundPage) -> None:
    page.browser.prefer(prefers_reduced_motion="reduce")
    page.browser.reload()
    page.browser.press(ENTER)
    assert page.browser.js("playground.player.time") == 1
    page.browser.prefer()


def test_readers_of_the_page_hear_what_happened(page: PlaygroundPage) -> None:
    page.browser.press(ENTER)
    heard = page.browser.js("document.querySelector('.story [role=status]').textContent")
    assert heard == (
        "Step 1. pursuer_0 and pursuer_1 both headed for (0, 1): both bounce. "
        "At fault: pursuer_0 and pursuer_1."
    )
    unnamed = page.browser.js(
        "[...document.querySelectorAll('button, select, input, canvas')]"
        ".filter((each) => each.checkVisibility())"
        ".filter((each) => !each.textContent && !each.ariaLabel && !each.labels?.length).length"
    )
    assert unnamed == 0


@pytest.mark.slow
def test_readers_with_disabilities_are_not_hindered(browser: Browser, tmp_path: Path) -> None:
    Playground().save(tmp_path / "page.html")
    buttons = ("Share", "Keys")
    find = "[...document.querySelectorAll('.top button')].find((b) => b.textContent === '{}')"
    scripts = [f"{find.format(name)}.click()" for name in buttons]
    assert browser.hindrances(tmp_path / "page.html", *scripts) == {}


# The same as in the package:


@pytest.fixture(scope="module")
def still(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> PlaygroundPage:
    """The page without motion, whose pictures take time."""
    browser.prefer(prefers_reduced_motion="reduce")
    return PlaygroundPage(browser, tmp_path_factory.mktemp("still") / "playground.html")


def play(
    still: PlaygroundPage, commands: list[int | str] | list[int], *worlds: mw.World
) -> list[int | str]:
    """Play a step in the page and in worlds, compare all, and return what agents do next."""
    for world in worlds:
        if not world.terminated:
            world.step(decided(world, commands), explain=True)
    for world, shown in zip(worlds, still.play(commands, len(worlds)), strict=True):
        assert shown == state_of(world)
    return [each if isinstance(each, str) else 0 for each in commands]


@pytest.mark.parametrize("example", GALLERY, ids=[example.title for example in GALLERY])
def test_examples(still: PlaygroundPage, example: Example) -> None:
    world = drawn_world(example.rules, example.drawing)
    still.browser.js(
        "[...document.querySelectorAll('.gallery button')]"
        ".find((each) => each.textContent === arguments[0]).click()",
        example.title,
    )
    others = [drawn_world(rules, example.drawing) for rules in [example.compare] if rules]
    commands = example.commands
    for _ in range(4):
        if not world.terminated:
            commands = play(still, commands, world, *others)
    assert still.browser.errors() == []


OWN = mw.Rules(mw.Interaction.AGENT_TURNS, teammate=mw.Outcome.DISAPPEAR)
"""Rules without a name, which a link spells out."""


@quickly("rules", [*mw.VARIANTS, OWN], lambda rules: rules in ("O", "SDB", OWN))
def test_a_world_goes_on_in_the_page(still: PlaygroundPage, rules: str | mw.Rules) -> None:
    """Agents are gone or share cells, evaders are captured, and scripts draw random numbers."""
    config = mw.WorldConfig(
        rules, rows=7, cols=6, n_pursuers=6, n_evaders=4, fov=5, obstacles=0.1, diagonal=True
    )
    world = mw.World(config)
    world.reset(5, episode=3)
    commands = ["random"] * 3 + ["clumsy-chaser"] * 3 + ["clumsy-fleer", "dodger", "random", 5]
    for _ in range(8):
        if not world.terminated:
            world.step(decided(world, commands))
    still.load(scene_link(world, commands))
    for _ in range(6):
        if not world.terminated:
            commands = play(still, commands, world)
    assert still.browser.errors() == []
