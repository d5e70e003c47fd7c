"""Run the scripts of evolution/ from the command line, and read what they have published."""

import subprocess
import sys
from pathlib import Path

SCRIPTS = Path(__file__).parents[2] / "evolution"
RESULTS = SCRIPTS / "results"


def run_script(name, place, *options):
    """Run a script in a directory; warnings are errors."""
    command = [sys.executable, "-W", "error", SCRIPTS / f"{name}.py", *options]
    return subprocess.run(command, cwd=place, capture_output=True, text=True, timeout=300)


def run_quickly(name, place, *options):
    done = run_script(name, place, "--quick", *options)
    assert done.returncode == 0, done.stderr
    return done.stdout


def read(path):
    return path.read_text(encoding="utf-8")
