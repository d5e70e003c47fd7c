"""The examples of docs/analysis.md print what the page shows, and its names exist."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from matrixworld import analysis

PAGE = (Path(__file__).parents[2] / "docs" / "analysis.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"^```python\n(.*?)^```\n\n```text\n(.*?)^```$", PAGE, re.M | re.S)

NUMBER = r"-?\d+\.?\d*"


def test_every_example_is_tested() -> None:
    assert len(EXAMPLES) == PAGE.count("```python") == 4


@pytest.mark.parametrize("number", range(4))
def test_example(number: int, tmp_path: Path) -> None:
    code, shown = EXAMPLES[number]
    command = [sys.executable, "-W", "error", "-c", code]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    # Another SciPy may resample differently: text stays, numbers change a little.
    assert re.sub(NUMBER, "#", done.stdout) == re.sub(NUMBER, "#", shown)
    printed, expected = ([*map(float, re.findall(NUMBER, t))] for t in (done.stdout, shown))
    assert printed == pytest.approx(expected, abs=0.01)


def test_names() -> None:
    table = PAGE.split("| question |")[1].split("\n\n")[0]
    named = re.findall(r"`(\w+)`", table)
    assert len(named) > 15
    assert set(named) <= set(analysis.__all__)
