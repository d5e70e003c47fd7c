"""The command line, called in the tests' process, with the options of tiny runs."""

import re

from click.testing import CliRunner

from matrixworld.analysis import CONDITIONS
from matrixworld.cli import main
from matrixworld.cli.options import option_name
from matrixworld.coevolution.settings.race_settings import paths_of
from tiny_race import TINY

WORLD = {**TINY, "hidden": "4"}
RACE = {**WORLD, "generations": 2, "pursuer_epochs": 2, "evader_epochs": 3}
JOB = {**RACE, "joint_epochs": 2}
"""Options of the main job, whose races have several schedules."""
MAIN_JOB = ("specialist-specialist", "hall-of-fame", "generalist-generalist")
PLACES = [f"{schedule}/seed-{TINY['seed']}" for schedule in MAIN_JOB]
"""Where the runs of the main job are."""
FIGURES = {f"{name}.png" for name in ("payoff", "training", "collisions")}
READING = [
    ["judge", "RUN"],
    ["replay", "RUN", "--out", "match.npz"],
    ["explore", "RUN", "--figures", "--force"],
    ["explore", "RUN", "--out", "page.html", "--no-open"],
    ["score", "RUN", "--episodes", "2"],
    ["tournament", "RUN", "--episodes", "2"],
]
"""Commands that read a finished race, RUN."""
PNG, GIF = b"\x89PNG", b"GIF89a"


def words(options):
    """Settings by the names of their fields, as options of ``evolve``: changes of the paper's."""
    known = {option.name for option in main.commands["evolve"].params}
    typed = [] if "game" in options else ["--paper"]
    for name, value in options.items():
        own = [option_name(name), str(value)]
        typed += own if name in known else ["--set", f"{paths_of(name)[0]}={value}"]
    return typed


def matrixworld_command(*args, code=0):
    return run_command(main, *args, code=code)


def run_command(command, *args, code=0):
    result = CliRunner().invoke(command, [str(arg) for arg in args])
    # What click does with an error that it knows.
    unexpected = None if isinstance(result.exception, SystemExit) else result.exception
    assert unexpected is None, result.output
    assert result.exit_code == code, result.output
    return result


def evolved(*args, code=0):
    return matrixworld_command("evolve", *args, code=code)


def run_together(output):
    return " ".join(output.split())


def judged_in(output):
    """Return the verdicts in the table of a judgement: those of the first window."""
    row = re.compile(rf"({'|'.join(CONDITIONS)}) +(present|absent|cannot tell)")
    verdicts = {}
    for match in filter(None, map(row.match, output.splitlines())):
        verdicts.setdefault(*match.groups())  # later tables are of other windows
    return verdicts
