"""The playground plays as the package does: the drawings of the contract tests, and examples."""

from __future__ import annotations

import runpy
from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from browser import Browser
from drawing import Case, actions_of, begin
from matrixworld.explorer.scenes import GALLERY, Example, drawn_world, scene_link
from playground_page import PlaygroundPage, decided, state_of

CONTRACT = Path(__file__).parents[1] / "contract"


def drawn_cases() -> list[Case]:
    """Return every case of the contract tests that is drawn."""
    names = [runpy.run_path(str(file)) for file in sorted(CONTRACT.glob("test_*.py"))]
    tuples = [value for each in names for value in each.values() if isinstance(value, tuple)]
    return [case for cases in tuples for case in cases if isinstance(case, Case)]


CASES = drawn_cases()


def start_world(
    config: mw.WorldConfig, pursuers: list, evaders: list, obstacles: np.ndarray
) -> mw.World:
    world = mw.World(config)
    world.reset(0, pursuers=pursuers, evaders=evaders, obstacles=obstacles)
    return world


@pytest.fixture(scope="module")
def page(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> PlaygroundPage:
    browser.prefer(prefers_reduced_motion="reduce")  # pictures of motion take time
    return PlaygroundPage(browser, tmp_path_factory.mktemp("playground") / "playground.html")


def play(
    page: PlaygroundPage, commands: list[int | str] | list[int], *worlds: mw.World
) -> list[int | str]:
    """Play a step in the page and in worlds, compare all, and return what agents do next."""
    for world in worlds:
        if not world.terminated:
            world.step(decided(world, commands), explain=True)
    for world, shown in zip(worlds, page.play(commands, len(worlds)), strict=True):
        assert shown == state_of(world)
    return [each if isinstance(each, str) else 0 for each in commands]


def test_there_are_cases_of_every_kind() -> None:
    assert len(CASES) > 100
    assert {type(case.rules) for case in CASES} == {str, mw.Rules}


@pytest.mark.parametrize("case", CASES, ids=[case.name for case in CASES])
def test_drawings_of_the_contract_tests(page: PlaygroundPage, case: Case) -> None:
    world, letters = begin(start_world, case)
    page.load(scene_link(world))
    for step in case.plays:
        play(page, actions_of(step.moves, letters), world)
    assert page.browser.errors() == []


@pytest.mark.parametrize("example", GALLERY, ids=[example.title for example in GALLERY])
def test_examples(page: PlaygroundPage, example: Example) -> None:
    world = drawn_world(example.rules, example.drawing)
    page.browser.js(
        "[...document.querySelectorAll('.gallery button')]"
        ".find((each) => each.textContent === arguments[0]).click()",
        example.title,
    )
    others = [drawn_world(rules, example.drawing) for rules in [example.compare] if rules]
    commands = example.commands
    for _ in range(4):
        if not world.terminated:
            commands = play(page, commands, world, *others)
    assert page.browser.errors() == []


@pytest.mark.parametrize("variant", mw.VARIANTS)
def test_a_world_goes_on_in_the_page(page: PlaygroundPage, variant: str) -> None:
    """Agents are gone or share cells, evaders are captured, and scripts draw random numbers."""
    config = mw.WorldConfig(
        variant, rows=7, cols=6, n_pursuers=6, n_evaders=4, fov=5, obstacles=0.1, diagonal=True
    )
    world = mw.World(config)
    world.reset(5, episode=3)
    commands = ["random"] * 3 + ["clumsy-chaser"] * 3 + ["clumsy-fleer", "dodger", "random", 5]
    for _ in range(8):
        if not world.terminated:
            world.step(decided(world, commands))
    page.load(scene_link(world, commands))
    for _ in range(6):
        if not world.terminated:
            commands = play(page, commands, world)
    assert page.browser.errors() == []
