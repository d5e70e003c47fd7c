"""Scenes of the playground as text, and what the page knows of the package."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from matrixworld._util import colors
from matrixworld.explorer import Playground
from matrixworld.explorer.playground import page_data
from matrixworld.explorer.scenes import GALLERY, scene_link
from matrixworld.world.policy import SCRIPTS

REPOSITORY = Path(__file__).parents[2]


def small_world(rules: mw.Rules | str = "SB", **changes: object) -> mw.World:
    world = mw.World(rules, rows=2, cols=4, n_pursuers=2, n_evaders=1, **changes)
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


def test_an_ended_episode_stays_ended() -> None:
    world = mw.World("S", rows=1, cols=2, n_pursuers=1, n_evaders=1)
    world.reset(pursuers=[[0, 0]], evaders=[[0, 1]])
    world.step([0, 0])
    assert world.terminated
    assert scene_link(world).endswith("&ended=1&pursuers=0.0&evaders=0.1c")


def in_a_round() -> mw.World:
    world = small_world("TO")
    world.play_turn([0, 0, 0])
    return world


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: scene_link(small_world(), [0, 0]), r"actions: expected 3 \(agents\), got 2"),
        (lambda: scene_link(small_world(), [0, 5, 0]), "actions: expected 0 to 4, got 5"),
        (lambda: scene_link(small_world(), [0, "chase", 0]), "actions: expected .*, got 'chase'"),
        (lambda: scene_link(small_world(), compare="X"), "variant: expected one of"),
        (lambda: scene_link("SB"), "world: expected"),
        (lambda: scene_link(mw.World("O", rows=65)), "world, rows: expected 1 to 64, got 65"),
        (
            lambda: scene_link(mw.World("O", n_evaders=101)),
            "world, n_evaders: expected 1 to 100, got 101",
        ),
        (lambda: scene_link(in_a_round()), "world: expected the end of a round, got turn 1"),
        (lambda: Playground(actions=[0]), "world: expected a world together with actions"),
    ],
)
def test_bad_arguments_are_refused(call: Callable[[], object], message: str) -> None:
    with pytest.raises((TypeError, ValueError), match=f"^{message}"):
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


def test_the_board_has_the_colours_of_the_package() -> None:
    sheet = (REPOSITORY / "web" / "src" / "board" / "board.css").read_text(encoding="utf-8")
    light = dict(re.findall(r"--([\w-]+): (#\w{6});", sheet.partition("}")[0]))
    expected = {
        "board-paper": colors.PAPER,
        "board-line": colors.GRID,
        "board-ink": colors.INK,
        "board-muted": colors.MUTED,
        "board-obstacle": colors.OBSTACLE,
        "pursuer": colors.PURSUER,
        "evader": colors.EVADER,
        "capture": colors.CAPTURE,
        "collision": colors.COLLISION,
    }
    assert {name: light[name].upper() for name in expected} == expected


def test_a_link_and_a_page_for_notebooks(tmp_path: Path) -> None:
    playground = Playground(small_world(), [2, 4, "fleer"])
    assert playground.url("docs/playground.html") == f"docs/playground.html#{playground.scene}"
    playground.save(tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert playground.scene.replace("&", "\\u0026") in page
    with pytest.raises(FileExistsError, match="force=True replaces it"):
        playground.save(tmp_path / "page.html")


def test_the_page_in_docs_is_the_present_one() -> None:
    kept = (REPOSITORY / "docs" / "playground.html").read_text(encoding="utf-8")
    assert kept == Playground().html(), "run python docs/make_pages.py"


def test_the_example_of_the_documentation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = (REPOSITORY / "docs" / "playground.md").read_text(encoding="utf-8")
    found = re.search(r"^```python\n(.*?)^```", text, re.M | re.S)
    monkeypatch.chdir(tmp_path)
    names: dict[str, Playground] = {}
    exec(found[1], names)
    assert names["playground"].scene.endswith("&next=24d")
    assert (tmp_path / "lesson.html").is_file()
    link = re.search(r"playground\.html#([^)]*)", text)
    assert link[1] == GALLERY[0].scene
