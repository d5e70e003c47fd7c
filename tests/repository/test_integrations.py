"""The examples of the page on other libraries, each where its libraries are installed."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

PAGE = (Path(__file__).parents[2] / "docs" / "integrations.md").read_text(encoding="utf-8")
EXAMPLES = dict(re.findall(r"^## (\w+).*?^```python\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL))
NEEDS = {
    "PettingZoo": ["pettingzoo"],
    "SuperSuit": ["supersuit"],
    "Gymnasium": ["gymnasium"],
    "PyTorch": ["torch"],
}


def test_every_example_is_tested() -> None:
    assert list(EXAMPLES) == list(NEEDS)
    assert PAGE.count("```python") == len(NEEDS)


@pytest.mark.parametrize("library", NEEDS)
def test_example(library: str, tmp_path: Path) -> None:
    for module in NEEDS[library]:
        pytest.importorskip(module, exc_type=ImportError)
    command = [sys.executable, "-c", EXAMPLES[library]]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
