"""The playground: scenes as text, and in a browser what the package's worlds do."""

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np
import pytest

import matrixworld as mw
from browser import Browser
from matrixworld.explorer import Playground
from matrixworld.explorer.playground import GALLERY, page_data, scene_link
from matrixworld.world.policy import SCRIPTS

DOCS = Path(__file__).parents[2] / "docs"

# ---- Scenes as text ------------------------------------------------------------------------------


def small_world(rules: mw.Rules | str = "SB") -> mw.World:
    world = mw.World(rules, rows=2, cols=4, n_pursuers=2, n_evaders=1)
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


def in_a_round() -> mw.World:
    world = small_world("TO")
    world.play_turn([0, 0, 0])
    return world


@pytest.mark.parametrize(
    ("call", "field"),
    [
        (lambda: scene_link(small_world(), [0, 0]), "actions"),
        (lambda: scene_link(small_world(), [0, "chase", 0]), "actions"),
        (lambda: scene_link(small_world(), compare="X"), "variant"),
        (lambda: scene_link("SB"), "world"),
        (lambda: scene_link(mw.World("O", rows=65)), "world, rows"),
        (lambda: scene_link(in_a_round()), "world"),
        (lambda: Playground(actions=[0]), "world"),
    ],
)
def test_bad_arguments_are_refused(call: Callable[[], object], field: str) -> None:
    with pytest.raises((TypeError, ValueError), match=f"^{field}: expected"):
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


def test_a_link_and_a_page_for_notebooks(tmp_path: Path) -> None:
    playground = Playground(small_world(), [2, 4, "fleer"])
    assert playground.url("docs/playground.html") == f"docs/playground.html#{playground.scene}"
    playground.save(tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert playground.scene.replace("&", "\\u0026") in page
    with pytest.raises(FileExistsError, match="force=True replaces it"):
        playground.save(tmp_path / "page.html")


def test_the_page_in_docs_is_the_present_one() -> None:
    kept = (DOCS / "playground.html").read_text(encoding="utf-8")
    assert kept == Playground().html(), "run python docs/make_pages.py"


def test_the_example_of_the_documentation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = (DOCS / "pages.md").read_text(encoding="utf-8")
    found = re.search(r"^```python\n(from matrixworld.explorer.*?)^```", text, re.M | re.S)
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {"mw": mw}
    exec(found[1], names)
    assert names["playground"].scene.endswith("&next=24d")
    link = re.search(r"playground\.html#([^)]*)", text)
    assert link[1] == GALLERY[0].scene


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
ENTER, BACKSPACE, HOME, DELETE = "\ue007", "\ue003", "\ue011", "\ue017"


class PlaygroundPage:
    """The page in a browser, without motion, whose pictures take time."""

    def __init__(self, browser: Browser, file: Path) -> None:
        self.browser = browser
        browser.prefer(prefers_reduced_motion="reduce")
        Playground().save(file)
        browser.open(file)

    def load(self, scene: str) -> None:
        """Show a scene as a click on a link to it does."""
        self.browser.driver.execute_async_script(SHOW, f"#{quote(scene, safe='=&._,x+-')}")

    def text(self, selector: str) -> str:
        """Return the text of an element."""
        return self.browser.js(f"document.querySelector('{selector}').textContent")

    def scene(self, *names: str) -> Any:
        """Return parts of the present scene."""
        return self.browser.js(
            f"(scene => [{', '.join(f'scene.{n}' for n in names)}])(playground.scene)"
        )

    def cells(self) -> list[list[int]]:
        """Return where agents are at present."""
        return self.browser.js(
            "playground.game.scene().pursuers.concat(playground.game.scene().evaders)"
            ".map(({ cell }) => cell)"
        )


@pytest.fixture(scope="module")
def opened(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> PlaygroundPage:
    return PlaygroundPage(browser, tmp_path_factory.mktemp("playground") / "playground.html")


@pytest.fixture
def page(opened: PlaygroundPage) -> Iterator[PlaygroundPage]:
    opened.load(SCENE)
    opened.browser.js("(playground.mode = 'act', playground.selected = 0)")
    yield opened
    assert opened.browser.errors() == []


@pytest.mark.nightly
def test_keys_move_step_and_change_the_rules(page: PlaygroundPage) -> None:
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
def test_bad_links_are_told_and_change_nothing(page: PlaygroundPage, scene: str) -> None:
    page.browser.js("window.kept = playground.scene")
    page.load(scene)
    assert page.browser.js("playground.scene === window.kept")
    assert "expected" in page.text(".message")
    assert page.browser.js("document.querySelectorAll('img').length") == 0


WHOLE = (
    "rules=simultaneous.bounce.reach.disappear.bounce.occupation.false&others=D"
    "&rewards=1_-2_0.5_-1e-7_-3,-4,0_-5_0_0.25_INVOLVED_true&size=4x3&diagonal=1&fov=3&limit=9"
    "&seed=18446744073709551615.7.2&walls=0.1_3.2&pursuers=1.1_1.1_0.0x&evaders=2.2c_0.2e_3.0cx"
    "&played=08c000_a00000&next=00012f"
)


@pytest.mark.nightly
@pytest.mark.parametrize("scene", [WHOLE, GALLERY[0].scene])
def test_links_hold_the_whole_scene(page: PlaygroundPage, scene: str) -> None:
    page.load(scene)
    share = "[...document.querySelectorAll('button')].find((b) => b.textContent === 'Share')"
    page.browser.js(f"{share}.click()")
    links = page.browser.js("[...document.querySelectorAll('.copy input')].map((e) => e.value)")
    page.browser.js("document.querySelector('dialog[open]').close()")
    assert [link.partition("#")[2] for link in links] == [scene] * 2
    assert page.text(".message") == ""
