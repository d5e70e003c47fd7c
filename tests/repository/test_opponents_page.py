"""The examples of the page on opponents and champions run, one after the other."""

from __future__ import annotations

import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

PAGE = (Path(__file__).parents[2] / "docs" / "opponents.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"^```python\n(.*?)^```$", PAGE, re.M | re.S)
OPTIONAL = ("torch", "onnx")


def needs(example: str) -> list[str]:
    return [library for library in OPTIONAL if f"import {library}\n" in example]


def play(examples: list[str], directory: Path) -> list[str]:
    command = [sys.executable, "-W", "error", "-c", "\n".join(examples)]
    done = subprocess.run(command, cwd=directory, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_the_examples_run(tmp_path: Path) -> None:
    mean, against, *probabilities = play([e for e in EXAMPLES if not needs(e)], tmp_path)
    assert re.fullmatch(r"0\.\d+ \(0\.\d+ to 0\.\d+\)", mean)
    assert re.fullmatch(r"0\.\d+ \(0\.\d+ to 0\.\d+\)", against)
    assert "".join(probabilities).startswith("[")


@pytest.mark.parametrize("library", OPTIONAL)
def test_the_examples_with_another_library_run(library: str, tmp_path: Path) -> None:
    if find_spec(library) is None:
        pytest.skip(f"{library} is not installed")
    play([e for e in EXAMPLES if needs(e) in ([], [library])], tmp_path)
