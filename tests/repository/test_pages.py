"""The pages of the variants: what their tables say is so, and those on disk are up to date."""

from __future__ import annotations

import importlib.util
import re
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import pettingzoo
import pytest
from PIL import Image

import matrixworld as mw
from matrixworld import envs
from matrixworld.envs import INFO_KEYS, OPTIONS, RENDER_MODES

DOCS = Path(__file__).parents[2] / "docs"
HAPPENS = {"DISAPPEAR": "disappears", "REACH": "goes on", "BOUNCE": "bounces back"}
MOVES = {"SIMULTANEOUS": "all at once", "AGENT_TURNS": "one after the other"}
CAPTURED = {
    "OCCUPATION": "a pursuer reaches it",
    "SURROUND": "pursuers, obstacles or the border are on its four sides",
}


def module_of(variant: str) -> Any:
    return import_module(f"matrixworld.envs.pursuit_evasion_{variant.lower()}_v0")


def table(text: str) -> dict[str, str]:
    """The rows of two cells."""
    rows = re.findall(r"^\| (.+?) \| (.+) \|$", text, re.MULTILINE)
    return {key: value.replace("`", "") for key, value in rows}


@pytest.mark.parametrize("variant", mw.VARIANTS)
def test_the_table_of_an_environment(variant: str) -> None:
    module = module_of(variant)
    env = module.parallel_env()
    env.reset(seed=0)
    name = env.metadata["name"]
    assert module.__name__ == f"matrixworld.envs.{name}"
    told = table(module.__doc__)
    pursuers, evaders = env.config.n_pursuers, env.config.n_evaders
    first = env.possible_agents[0]
    expected = {
        "Import": f"from matrixworld.envs import {name}",
        "Make": f'pettingzoo.make("parallel", "matrixworld/{name}")',
        "Actions": "Discrete",
        "Agents": f"pursuer_0 ... pursuer_{pursuers - 1}, evader_0 ... evader_{evaders - 1}",
        "Action Shape": str(env.action_space(first).shape),
        "Action Values": str(env.action_space(first)),
        "Observation Shape": str(env.observation_space(first).shape),
        "State Shape": str(env.state_space.shape),
    }
    assert expected.items() <= told.items()
    assert f"| Agents | `{len(env.possible_agents)}` |" in module.__doc__
    assert sorted(module.__all__) == ["env", "parallel_env", "raw_env"]


@pytest.mark.parametrize("variant", mw.VARIANTS)
def test_the_rules_of_an_environment(variant: str) -> None:
    rules, told = mw.VARIANTS[variant], table(module_of(variant).__doc__)
    assert module_of(variant).parallel_env().config.rules == rules
    assert told["agents move"] == MOVES[rules.interaction.name]
    assert told["who runs into an obstacle or the border"] == HAPPENS[rules.obstacle.name]
    assert told["an agent that collides with a teammate"] == HAPPENS[rules.teammate.name]
    assert told["an evader that collides with a pursuer"] == HAPPENS[rules.evader.name]
    assert told["a pursuer that collides with an evader"] == HAPPENS[rules.pursuer.name]
    assert told["an evader is captured when"] == CAPTURED[rules.capture.name]
    removed = rules.captured_disappear or rules.evader is mw.Outcome.DISAPPEAR
    assert (told["a captured evader"] == "disappears") == removed


@pytest.mark.parametrize("variant", mw.VARIANTS)
def test_pettingzoo_makes_it(variant: str) -> None:
    name = f"matrixworld/pursuit_evasion_{variant.lower()}_v0"
    parallel = pettingzoo.make("parallel", name, max_cycles=3, rows=20)
    assert (parallel.config.max_steps, parallel.config.rows) == (3, 20)
    assert parallel.config.rules == mw.VARIANTS[variant]
    assert pettingzoo.make("aec", name).unwrapped.config.rules == mw.VARIANTS[variant]


def test_what_is_common_to_all() -> None:
    text = envs.__doc__ or ""
    arrays = re.findall(r"^ *(\w+) +\(", mw.array_specs.__doc__ or "", re.MULTILINE)
    assert set(INFO_KEYS) <= {*re.findall(r"``(\w+)``", text), *arrays}
    assert all(option in text for option in OPTIONS)
    assert all(f'``"{mode}"``' in text for mode in RENDER_MODES)
    paid = mw.Rewards()
    for name in ("capture", "neighbor", "collide", "step"):
        pursuer, evader = (getattr(paid, f"{team}_{name}") for team in ("pursuer", "evader"))
        assert f"| {name} | {pursuer:+g} | {evader:+g} |" in text


def test_pages_are_those_of_the_docstrings() -> None:
    spec = importlib.util.spec_from_file_location("make_pages", DOCS / "make_pages.py")
    assert spec is not None
    assert spec.loader is not None
    make_pages = importlib.util.module_from_spec(spec)
    sys.modules["make_pages"] = make_pages  # dataclasses look their module up
    spec.loader.exec_module(make_pages)
    assert list(make_pages.MOMENTS) == list(mw.VARIANTS)
    for variant, moment in make_pages.MOMENTS.items():
        file = DOCS / "variants" / f"{variant.lower()}.md"
        assert file.read_text(encoding="utf-8") == make_pages.page(variant)
        with Image.open(file.with_suffix(".png")) as picture:
            assert picture.size == (504, 410)
        assert moment.step <= moment.episode(variant).length


def test_links_between_pages() -> None:
    for file in [DOCS / "README.md", *(DOCS / "variants").glob("*.md")]:
        for target in re.findall(r"\]\(([^)#]+)\)", file.read_text(encoding="utf-8")):
            assert (file.parent / target).exists(), f"{file.name}: {target}"
