"""``matrixworld grade``: programs that work, that fail in every way, and what is printed."""

import json

import pytest

import matrixworld as mw
from matrixworld.cli import main

GOOD = """
import numpy as np

def evade(view, rng):
    pursuers = np.argwhere(view[1]) - view.shape[1] // 2
    if not len(pursuers):
        return rng.integers(5)
    down, right = pursuers[0]
    return (3 if down < 0 else 1) if abs(down) > abs(right) else (2 if right < 0 else 4)
"""
HOSTILE = {
    "hangs": (
        "def pursue(view):\n    while True: pass",
        "hangs.py, line 2: expected an answer within 1 s",
    ),
    "ignores": (
        "import signal\ndef pursue(view):\n    signal.signal(signal.SIGALRM, signal.SIG_IGN)\n"
        "    while True: pass",
        "ignores.py, line 4: expected an answer within 1 s, got none, and it goes on",
    ),
    "ends": (
        "import os\ndef pursue(view):\n    os._exit(3)",
        "ends.py: it has ended Python, with exit code 3",
    ),
    "nine": ("def pursue(view):\n    return 9", "got 9, for the view"),
    "odds": (
        "def pursue(view, rng):\n    return [0.5, 0.48, 0, 0, 0.0]",
        "sum to 1, got 0.5, 0.48, 0, 0, 0, sum 0.98, for the view",
    ),
    "begins": ("while True: pass", "begins.py, line 1: expected it to run within 1 s"),
    "divides": ("def pursue(view):\n    return 1 // 0", "divides.py, line 2: ZeroDivisionError"),
    "syntax": ("def pursue(view:\n    return 0", "syntax.py, line 1: SyntaxError"),
    "nobody": ("x = 1", "nobody.py: expected a function pursue or choose for pursuers, got none"),
    "exits": ("raise SystemExit", "exits.py, line 1: SystemExit"),
}
ONE = ("--world", "4")


def run(runner, *arguments):
    return runner.invoke(main, ["grade", *map(str, arguments)])


@pytest.fixture
def runner():
    from click.testing import CliRunner

    return CliRunner()


@pytest.fixture
def files(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "anna.py").write_text(GOOD)
    for name, (text, _) in HOSTILE.items():
        (tmp_path / f"{name}.py").write_text(text)
    return tmp_path


def test_programs_that_fail_are_named_and_stop_nothing_else(runner, files):
    hostile = [f"{name}.py" for name in HOSTILE]
    result = run(runner, *hostile, "anna.py", *ONE, "--seconds", 1, "--json", "found.json")
    assert result.exit_code == 1
    told = " ".join(result.stderr.split())
    for _, expected in HOSTILE.values():
        assert expected in told
    assert "run on this machine, with your rights" in told
    [found] = json.loads((files / "found.json").read_text())["grades"]
    expected = mw.grade("anna.py", worlds=mw.SUITE.worlds[3].config)
    assert found["player"] == "anna.py"
    assert found["teams"].keys() == {"evader"}
    share = expected.teams["evader"].share
    assert found["teams"]["evader"]["share"] == pytest.approx(share, abs=1e-12)


def test_one_player_is_told_from_its_worst_position_on(runner, files):
    result = run(runner, "-adversary", "--team", "pursuer", *ONE)
    assert result.exit_code == 0, result.stderr
    lines = result.output.split("\n")
    first = next(n for n, line in enumerate(lines) if line.startswith("1. "))
    assert "loses nothing: " in "".join(lines[first : first + 5])
    assert "mean of 1 world, exactly: in turns 0.609" in result.output
    assert "docs/suite.md" in result.output


def test_several_players_are_told_in_the_order_of_their_grades(runner, files):
    result = run(runner, "random", "chaser", "-adversary", *ONE, "--team", "pursuer")
    assert result.exit_code == 0
    names = [line.split()[0] for line in result.output.split("\n")[3:6]]
    assert names[-1] == "random"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["."], "expected a file, a line of text or a run directory, got a directory without"),
        (["chaser", "--world", "26"], "--world: expected a number from 1 to 25, got 26"),
        ([], "Missing argument"),
    ],
)
def test_what_is_refused(runner, files, arguments, said):
    result = run(runner, *arguments)
    assert result.exit_code == 2
    assert said in " ".join(result.stderr.split())


def test_numbers_can_go_to_standard_output(runner, files):
    result = run(runner, "chaser", *ONE, "--json", "-")
    assert {each["player"] for each in json.loads(result.stdout)["grades"]} == {"chaser"}
