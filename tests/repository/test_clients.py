"""The examples of the pages on learners run with few steps, where their libraries are installed."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
PAGES = sorted((DOCS / "clients").glob("*.md"))
EXAMPLES = {
    f"{page.stem}-{number}": example
    for page in PAGES
    for number, example in enumerate(
        re.findall(r"^```python\n(.*?)^```$", page.read_text(encoding="utf-8"), re.M | re.S), 1
    )
}
RATE = r"0\.\d+ \(0\.\d+ to 0\.\d+\)"


def imported(example: str) -> set[str]:
    """Return the modules that an example imports."""
    statements = list(ast.walk(ast.parse(example)))
    names = {a.name for s in statements if isinstance(s, ast.Import) for a in s.names}
    return names | {s.module or "" for s in statements if isinstance(s, ast.ImportFrom)}


def shortened(example: str) -> str:
    """Return the example with fewer steps: one or two updates of its learner."""
    short, count = re.subn(r"^STEPS = [\d_]+", "STEPS = 8_192", example, flags=re.M)
    assert count == 1
    return short


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_entry_names_every_page(page: Path) -> None:
    assert f"](clients/{page.name}" in (DOCS / "integrations.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", EXAMPLES)
def test_example(name: str, tmp_path: Path) -> None:
    for module in sorted(imported(EXAMPLES[name])):
        pytest.importorskip(module, exc_type=ImportError)
    command = [sys.executable, "-c", shortened(EXAMPLES[name])]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    for moment in ("before", "after"):
        assert re.search(rf"^{moment} {RATE}$", done.stdout, re.M), done.stdout
