"""Commands on races of a game of your own, races that go on, and policies that one can read."""

import importlib
import re
import sys
from collections import Counter
from pathlib import Path

import pytest

import matrixworld as mw
from command_line import RACE, evolved, matrixworld_command, run_together, words
from matrixworld._util.files import read_json
from matrixworld.coevolution import open_run

pytestmark = pytest.mark.usefixtures("undrawn")

GAME = """
import numpy as np
from matrixworld.coevolution import Game

SCALE = 1.0

def beats(a, b, rng):
    return 0.5 + np.tanh(SCALE * (a - b).mean(1)) / 2

def show(a, b):
    return f"{a.mean():.3f} meets {b.mean():.3f}"

numbers = Game(beats, 3, ("hosts", "parasites"), deterministic=True, show=show)
"""
SHORT = {"generations": 7, "joint_epochs": 2, "population": 6}
TYPED = words({"game": "numbers_game:numbers", "schedule": "hall-of-fame", **SHORT})


@pytest.fixture
def game(tmp_path, monkeypatch):
    """Write the game of a module into the current directory."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(str(tmp_path))
    sys.modules.pop("numbers_game", None)
    Path("numbers_game.py").write_text(GAME)
    return Path("numbers_game.py")


def changed(game, old, new):
    game.write_text(game.read_text().replace(old, new))
    importlib.invalidate_caches()
    sys.modules.pop("numbers_game", None)


def test_a_game_of_your_own_is_raced_judged_and_shown(game):
    told = evolved("--out", "out", *TYPED).stdout
    assert "improved" in told
    assert "pursuer" not in told + matrixworld_command("judge", "--explain", "out").stdout
    archive = open_run("out/hall-of-fame/seed-0").archive()
    first, last = (archive[team] for team in ("hosts", "parasites"))
    shown = matrixworld_command("replay", "out", "--pursuer", "3", "--evader", "-1").stdout
    assert shown == f"{first[3].mean():.3f} meets {last[-1].mean():.3f}\n"
    refused = matrixworld_command("score", "out", code=2).stderr
    assert "expected a run of pursuers and evaders, got one of the game numbers_game" in refused


NEEDING_THE_GAME = ["tournament out", "evolve --resume out", "explore out", "replay out"]


def test_without_the_game_a_sentence_says_what_to_install(game):
    evolved("--out", "out", *TYPED)
    refused = matrixworld_command("playground", "out", code=2).stderr
    assert "expected a run of pursuers and evaders, got one of the game numbers_game" in refused
    changed(game, GAME, "")
    game.unlink()
    for typed in NEEDING_THE_GAME:
        refused = matrixworld_command(*typed.split(), code=2).stderr
        assert "numbers_game:numbers: expected a module that can be imported" in refused, typed
    assert matrixworld_command("judge", "out").stdout


def test_a_changed_game_goes_on_by_force_only(game):
    evolved("--out", "out", *TYPED)
    changed(game, "SCALE = 1.0", "SCALE = 2.0")
    config = Path("out/hall-of-fame/seed-0/config.json")
    before = config.read_bytes()
    longer = ("--resume", "out", "--generations", 8)
    assert "expected the source of the game as it was" in evolved(*longer, code=2).stderr
    assert config.read_bytes() == before
    # Others tell it.
    assert "source of the game as it was" in matrixworld_command("replay", "out").stderr
    evolved(*longer, "--force")
    assert open_run(config.parent).payoff().matrix.shape == (9, 9)


def test_what_rates_moves_ends_in_words(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    others = ("hidden", "pursuer_epochs", "evader_epochs")
    race = {name: value for name, value in RACE.items() if name not in others}
    one = ("--schedule", "hall-of-fame", "--set", "schedule.joint_epochs=2")
    told = evolved("--out", "out", *words(race), *one, "--set", "policy=rating").stdout
    assert "What evolved: hall-of-fame, seed 5" in told
    for team in ("pursuers", "evaders"):
        kept = read_json(next(Path("out").rglob("scores.json")))[team]["evolved"]
        assert f"Generation {kept['generation']}: {kept['sentence']}" in run_together(told)
        losses = {term["input"]: term["lost"] for term in kept["terms"]}
        assert {*losses} == {*mw.Rating.inputs}
        # An input is named with its loss if the interval lies on one side of 0.
        named = [each for each in losses.values() if not each["low"] <= 0 <= each["high"]]
        sizes = [float(size) for size in re.findall(r"\((?:worth )?(0\.\d+)", kept["sentence"])]
        assert sorted(sizes) == sorted(round(abs(each["value"]), 3) for each in named)
    known = "Known beyond the view: pursuers: right of way, a direction for 12 steps; "
    assert known in run_together(told)
    several = {name: value for name, value in race.items() if name != "seed"}
    rating = (*words(several), *one, "--set", "policy=rating")
    told = run_together(evolved("--out", "seeds", "--seeds", "1-3", *rating).stdout)
    every = [read_json(path)["pursuers"]["evolved"] for path in Path("seeds").rglob("scores.json")]
    named = Counter(
        term["input"] for each in every for term in each["terms"] if term["lost"]["low"] > 0
    )
    assert len(every) == 3
    assert named
    [listed] = re.findall(
        "Seeds, of 3, in which an input of pursuers is worth something: ([^.]*)", told
    )
    assert dict(re.findall(r"(\w+) (\d)", listed)) == {k: str(v) for k, v in named.items()}
    program = ("--set", "policy=program", "--learner", "gp")
    assert "rating = " in evolved("--out", "programs", *words(race), *one, *program).stdout
