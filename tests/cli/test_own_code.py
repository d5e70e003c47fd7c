"""A learner and samplers of the user's own on the command line."""

from pathlib import Path

from click.testing import CliRunner

from command_line import MAIN_JOB, RACE, evolved, words
from matrixworld.cli import main
from matrixworld.coevolution import open_run
from scripts import python

PLACE = "alternating/seed-5"
PLAIN = {name: value for name, value in RACE.items() if name != "population"}
OWN = {
    "learner": "mine:Learner",
    "learner.settings.sigma": 0.2,
    "pursuers_meet": "mine:Sampler",
    "schedule.pursuers_meet.settings.forget": 0.25,
}
MINE = """
from own_code import Hardest as Sampler
from own_code import HillClimber as Learner
"""
COMMAND = """
from matrixworld.cli import evolve, main

evolve.draw = lambda *args: None
main()
"""


def test_a_learner_of_the_current_folder():
    mine = Path("mine.py")
    mine.write_text(MINE)
    # As pip installs it: Python looks for modules where this file lies. -m would look here.
    command = Path("bin", "matrixworld")
    command.parent.mkdir()
    command.write_text(COMMAND)
    options = words({**PLAIN, "schedule": "alternating", "opponents": 2, **OWN})
    python(command, "evolve", "--out", "job", *options, "--threads", "1", check=True)
    settings = open_run(Path("job") / PLACE).settings
    assert (settings.learner.code, settings.learner.settings) == ("mine:Learner", {"sigma": 0.2})
    assert settings.schedule.pursuers_meet.settings == {"forget": 0.25}
    # It is not continued without the code.
    mine.unlink()
    (Path("job") / PLACE / "summary.json").unlink()
    assert "mine:Learner: expected a module that" in evolved("--resume", "job", code=2).stderr


def test_an_error_in_the_code_keeps_its_traceback_and_says_how_to_continue():
    options = words({**PLAIN, "schedule": MAIN_JOB[0], "learner": "own_code:Fails"})
    done = CliRunner().invoke(main, ["evolve", "--out", "out", *options])
    assert isinstance(done.exception, ZeroDivisionError)
    assert "matrixworld evolve --resume out" in done.stderr
