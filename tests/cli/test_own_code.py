"""A learner and samplers of the user's own on the command line."""

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner

from command_line import MAIN_JOB, RACE, evolved, matrixworld_command, words
from matrixworld.cli import main, report
from matrixworld.cli.setting_options import parsed, settings_of
from matrixworld.coevolution import open_run
from matrixworld.coevolution.runs import check_own_code
from tiny_race import results

RUN_OPTIONS = {**RACE, "schedule": "alternating", "opponents": 2}
PLACE = "alternating/seed-5"
SMALL = {"policy.hidden": []}
OWN = {
    "learner": "mine:Learner",
    "learner.settings.sigma": 0.2,
    "learner.settings.shrink": 0.5,
    "pursuers_meet": "mine:Sampler",
    "schedule.pursuers_meet.settings.forget": 0.25,
}
MINE = """
import os
import signal

from own_code import Hardest as Sampler
from own_code import HillClimber

told = 0


class Learner(HillClimber):
    def tell(self, fitness):
        global told
        told += 1
        if told == int(os.environ.get("KILLED_AT", 0)):
            os.kill(os.getpid(), signal.SIGKILL)
        super().tell(fitness)
"""
COMMAND = """
from matrixworld.cli import main, report

report.draw = lambda groups, root: None
main()
"""


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Run commands in a temporary directory, from which modules are imported."""
    sys.modules.pop("mine", None)
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(report, "draw", lambda groups, root: None)
    yield
    sys.modules.pop("mine", None)


@pytest.fixture
def mine() -> Path:
    """A module of the user."""
    path = Path("mine.py")
    path.write_text(MINE)
    return path


@pytest.fixture(scope="module")
def straight(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A finished race of the installed command, with a learner of the current folder."""
    folder = tmp_path_factory.mktemp("straight")
    (folder / "mine.py").write_text(MINE)
    assert evolve(folder, "--out", "run", *words({**RUN_OPTIONS, **OWN})) == 0
    return folder / "run" / PLACE


def evolve(folder: Path, *args: object, killed_at: int = 0) -> int:
    """Run ``matrixworld evolve`` in a process of its own; return its exit code."""
    paths = [str(Path(__file__).parents[1] / "support")]
    paths += filter(None, [os.environ.get("PYTHONPATH")])
    # As pip installs it: Python looks for modules where this file lies. -m would look in `folder`.
    command = folder / "bin" / "matrixworld"
    command.parent.mkdir(exist_ok=True)
    command.write_text(COMMAND)
    done = subprocess.run(
        [sys.executable, command, "evolve", *map(str, args), "--threads", "1"],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(paths), "KILLED_AT": str(killed_at)},
        capture_output=True,
        check=False,
    )
    return done.returncode


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
@pytest.mark.slow
def test_killed_in_the_middle_and_resumed(straight, mine, tmp_path):
    options = words({**RUN_OPTIONS, **OWN})
    assert evolve(tmp_path, "--out", "run", *options, killed_at=4) == -signal.SIGKILL
    assert evolve(tmp_path, "--resume", "run") == 0
    assert results(tmp_path / "run" / PLACE) == results(straight)


def test_finished_runs_are_read_and_not_continued_without_the_code(straight):
    shutil.copytree(straight, "RUN")
    settings = open_run("RUN").settings
    assert settings.learner.code == "mine:Learner"
    assert settings.learner.settings == {"sigma": 0.2, "shrink": 0.5}
    assert settings.schedule.pursuers_meet.settings == {"forget": 0.25}
    before = {path: path.read_bytes() for path in Path("RUN").iterdir()}
    for command in (["judge"], ["score", "--episodes", "2"]):
        matrixworld_command(*command, "RUN")
    assert "mine" not in sys.modules
    assert "learner: expected a module that" in evolved("--resume", "RUN", code=2).stderr
    assert {path: path.read_bytes() for path in Path("RUN").iterdir()} == before


def test_values_of_all_kinds(mine):
    mine.write_text(
        "import own_code\n"
        "def Learner(genome, samples, *, n, x, on, word) -> own_code.HillClimber:\n"
        "    assert (n, x, on, word) == (3, -0.5, True, 'fast'), (n, x, on, word)\n"
        "    assert [type(each) for each in (n, x, on, word)] == [int, float, bool, str]\n"
        "    return own_code.HillClimber(genome, samples)\n"
    )
    values = {"n": "3", "x": "-.5", "on": "true", "word": "fast"}
    sets = [(f"learner.settings.{name}", parsed(value)) for name, value in values.items()]
    [settings] = settings_of(
        {"learner": "mine:Learner", "schedule": MAIN_JOB[:1], "sets": [*sets, *SMALL.items()]}
    )
    check_own_code(settings)


def test_an_error_in_the_code_keeps_its_traceback_and_says_how_to_continue(mine):
    mine.write_text(f"{MINE}\nfrom own_code import Fails\n")
    options = words({**RACE, "schedule": MAIN_JOB[0], "learner": "mine:Fails"})
    done = CliRunner().invoke(main, ["evolve", "--out", "out", *options])
    assert isinstance(done.exception, ZeroDivisionError)
    assert "matrixworld evolve --resume out" in done.stderr
