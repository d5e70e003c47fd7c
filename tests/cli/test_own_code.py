"""A learner and samplers of the user's own on the command line."""

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner

from command_line import MAIN_JOB, RACE, evolved, matrixworld_command, words
from matrixworld.cli import evolve, main
from matrixworld.cli.setting_options import parsed, settings_of
from matrixworld.coevolution import open_run

PLACE = "alternating/seed-5"
PLAIN = {name: value for name, value in RACE.items() if name != "population"}
OWN = {
    "learner": "mine:Learner",
    "learner.settings.sigma": 0.2,
    "pursuers_meet": "mine:Sampler",
    "schedule.pursuers_meet.settings.forget": 0.25,
}
MINE = """
from own_code import Fails
from own_code import Hardest as Sampler
from own_code import HillClimber as Learner
"""
COMMAND = """
from matrixworld.cli import evolve, main

evolve.draw = lambda *args: None
main()
"""


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Run commands in a temporary directory, from which modules are imported."""
    sys.modules.pop("mine", None)
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(evolve, "draw", lambda *args: None)
    yield
    sys.modules.pop("mine", None)


@pytest.fixture
def mine() -> Path:
    """A module of the user."""
    path = Path("mine.py")
    path.write_text(MINE)
    return path


def test_a_learner_of_the_current_folder(mine: Path) -> None:
    # As pip installs it: Python looks for modules where this file lies. -m would look here.
    command = Path("bin", "matrixworld")
    command.parent.mkdir()
    command.write_text(COMMAND)
    options = words({**PLAIN, "schedule": "alternating", "opponents": 2, **OWN})
    paths = [str(Path(__file__).parents[1] / "support"), os.environ.get("PYTHONPATH", "")]
    subprocess.run(
        [sys.executable, command, "evolve", "--out", "job", *options, "--threads", "1"],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
        check=True,
    )
    # A finished run is read, but not continued, without the code.
    mine.unlink()
    run = Path(shutil.copytree(Path("job") / PLACE, "run"))
    settings = open_run(run).settings
    assert (settings.learner.code, settings.learner.settings) == ("mine:Learner", {"sigma": 0.2})
    assert settings.schedule.pursuers_meet.settings == {"forget": 0.25}
    for words_of in (["judge"], ["score", "--episodes", "2"]):
        matrixworld_command(*words_of, run)
    assert "mine" not in sys.modules
    (run / "summary.json").unlink()
    before = {path: path.read_bytes() for path in run.iterdir()}
    assert "mine:Learner: expected a module that" in evolved("--resume", run, code=2).stderr
    assert {path: path.read_bytes() for path in run.iterdir()} == before


def test_values_of_all_kinds(mine: Path) -> None:
    mine.write_text(
        "from dataclasses import dataclass\n"
        "from own_code import HillClimber\n"
        "@dataclass(frozen=True)\n"
        "class Learner(HillClimber):\n"
        "    n: int = 0\n    x: float = 0.0\n    on: bool = False\n    word: str = ''\n"
    )
    values = {"n": "3", "x": "-.5", "on": "true", "word": "fast"}
    sets = [(f"learner.settings.{name}", parsed(value)) for name, value in values.items()]
    options = {"learner": "mine:Learner", "schedule": MAIN_JOB[:1], "sets": sets}
    [settings] = settings_of(options)
    learner = settings.learner_of("pursuer")
    given = [getattr(learner, name) for name in values]
    assert given == [3, -0.5, True, "fast"]
    assert [type(each) for each in given] == [int, float, bool, str]


def test_an_error_in_the_code_keeps_its_traceback_and_says_how_to_continue(mine: Path) -> None:
    options = words({**PLAIN, "schedule": MAIN_JOB[0], "learner": "mine:Fails"})
    done = CliRunner().invoke(main, ["evolve", "--out", "out", *options])
    assert isinstance(done.exception, ZeroDivisionError)
    assert "matrixworld evolve --resume out" in done.stderr
