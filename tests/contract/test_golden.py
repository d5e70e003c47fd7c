"""Readable playthroughs of the variants, compared with the files in ``golden/``.

After a change of the rules, or for a new variant, run
``PYTHONPATH=tests/support python tests/contract/test_golden.py`` to write the files anew;
their difference shows what the change did.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path
from string import ascii_lowercase, ascii_uppercase

import numpy as np
import pytest

import matrixworld as mw
from rows import config_of, random_actions

FOLDER = Path(__file__).parent / "golden"
STEPS = 12
# Episodes in which much happens. A variant that is not named here plays seed 0.
SEEDS = {"D": 3, "R": 264, "B": 14, "O": 26, "S": 5, "SB": 280, "SD": 5, "SDB": 2, "TO": 1}


def letters_of(config: mw.WorldConfig) -> str:
    """A, B, ... for pursuers and a, b, ... for evaders."""
    return ascii_uppercase[: config.n_pursuers] + ascii_lowercase[: config.n_evaders]


def drawing(world: mw.World) -> Iterator[str]:
    cells = [["#" if wall else "" for wall in row] for row in world.map]
    letters = letters_of(world.config)
    for agent in np.flatnonzero(world.alive):
        row, col = world.positions[agent]
        cells[row][col] += letters[agent]
    width = max(len(cell) for row in cells for cell in row)
    for row in cells:
        yield "    " + " ".join((cell or ".").ljust(width) for cell in row).rstrip()


def played(world: mw.World, actions: np.ndarray) -> Iterator[str]:
    """One step in words."""
    letters = letters_of(world.config)
    before = world.alive
    rewards = world.step(actions, explain=True)
    acting = np.flatnonzero(before)
    moves = [f"{letters[a]} {mw.Action(actions[a]).name.lower()}" for a in acting]
    yield f"step {world.steps}: {', '.join(moves)}"
    yield from (f"  {conflict}" for conflict in world.conflicts)
    paid = [f"{letters[a]} {rewards[a]:+.2f}" for a in acting]
    yield f"  rewards: {', '.join(paid)}"
    n_pursuers = world.config.n_pursuers
    for evader in np.flatnonzero(world.captured):
        letter, captors = letters[n_pursuers + evader], world.captors[evader]
        yield f"  {letter} is captured" + (f", captors: {captors}" if captors else "")
    gone = [letters[a] for a in np.flatnonzero(before & ~world.alive)]
    if gone:
        yield f"  gone: {', '.join(gone)}"
    yield from drawing(world)


def heading(name: str, config: mw.WorldConfig) -> Iterator[str]:
    yield f"Pursuit-Evasion-{name}, {config.rows} x {config.cols}, seed {SEEDS.get(name, 0)}"
    for item in fields(config.rules):
        value = getattr(config.rules, item.name)
        yield f"  {item.name}: {getattr(value, 'name', value)}"
    letters = letters_of(config)
    names = [f"{letter} {config.agent_name(a)}" for a, letter in enumerate(letters)]
    yield f"  {', '.join(names)}"
    yield ""


def playthrough(name: str) -> str:
    """An episode of random actions, at most `STEPS` long."""
    surround = mw.VARIANTS[name].capture is mw.Capture.SURROUND
    teams = {"n_pursuers": 9, "n_evaders": 2} if surround else {"n_pursuers": 3, "n_evaders": 4}
    config = config_of(name, rows=5, cols=6, obstacles=0.1, **teams)
    world, seed = mw.World(config), SEEDS.get(name, 0)
    world.reset(seed)
    lines = [*heading(name, config), "start", *drawing(world)]
    for actions in random_actions(seed, config.n_actions, STEPS, config.n_agents):
        lines += ["", *played(world, actions)]
        if world.terminated:
            lines += ["", "terminated"]
            break
    return "\n".join(lines) + "\n"


def path_of(name: str) -> Path:
    return FOLDER / f"{name}.txt"


@pytest.mark.parametrize("name", list(mw.VARIANTS))
def test_playthrough(name: str) -> None:
    file = path_of(name)
    command = "PYTHONPATH=tests/support python tests/contract/test_golden.py"
    assert file.exists(), f"golden/{file.name} is missing: run {command}"
    assert playthrough(name) == file.read_text(encoding="utf-8")


def test_each_file_belongs_to_a_variant() -> None:
    assert {path.name for path in FOLDER.iterdir()} <= {path_of(name).name for name in mw.VARIANTS}


def test_the_files_show_what_can_happen() -> None:
    texts = {path.stem: path.read_text(encoding="utf-8") for path in FOLDER.iterdir()}
    for word in ("is captured", "gone:", "bounces", "both bounce", "ran into", "had to stay"):
        assert any(word in text for text in texts.values()), word
    for name, text in texts.items():
        assert "is captured" in text, f"{name} shows no capture: choose another seed in SEEDS"


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for variant in mw.VARIANTS:
        path_of(variant).write_text(playthrough(variant), encoding="utf-8")
