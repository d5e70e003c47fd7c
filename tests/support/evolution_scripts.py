"""Run the scripts of evolution/ from the command line, and read what they have published."""

import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).parents[2] / "evolution"
RESULTS = SCRIPTS / "results"


def run_script(name, place, *options):
    """Run a script in a directory; warnings are errors, but for those that quick races deserve."""
    one_wins = "ignore:generations"  # ... 4 to 6: the evaders win nearly all matches
    command = [sys.executable, "-W", "error", "-W", one_wins, SCRIPTS / f"{name}.py", *options]
    return subprocess.run(command, cwd=place, capture_output=True, text=True, timeout=300)


def run_quickly(name, place, *options):
    """Return what a quick run tells; skip the test of a script that needs a missing module."""
    done = run_script(name, place, "--quick", *options)
    missing = re.search(r"expected the module (\w+), which is not installed", done.stderr)
    if missing and find_spec(missing[1]) is None:
        pytest.skip(f"needs {missing[1]}")
    assert done.returncode == 0, done.stderr
    return done.stdout


def read(path):
    return path.read_text(encoding="utf-8")
