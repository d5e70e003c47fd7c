"""The page on figures names every figure and every function, and its commands exist."""

from __future__ import annotations

import re
from pathlib import Path

from matrixworld import plots
from matrixworld.cli.figures import OF_GAME, OF_RACE

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "figures.md").read_text(encoding="utf-8")


def test_the_table_names_the_figures() -> None:
    rows = re.findall(r"^\| [^|]+ \| `(matrixworld plot[^|]+)` \| (.+) \|$", PAGE, re.M)
    named = {re.search(r"--figure (\w+)", command)[1] for command, _ in rows}  # type: ignore[index]
    # The lag profile is not in the paper.
    assert named == {*OF_GAME, *OF_RACE} - {"lag_profile"}
    functions = [name for _, cell in rows for name in re.findall(r"`(\w+)`", cell)]
    assert set(functions) <= set(plots.__all__)


def test_the_pictures_exist() -> None:
    pictures = re.findall(r"!\[[^]]+\]\(([^)]+)\)", PAGE)
    assert {Path(each).stem for each in pictures} == set(OF_GAME)
    assert all((DOCS / each).read_bytes().startswith(b"\x89PNG") for each in pictures)
