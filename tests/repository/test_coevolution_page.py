"""The examples of the page on co-evolution run, one after the other, and its names exist."""

from __future__ import annotations

import re
import subprocess
import sys
from dataclasses import fields
from pathlib import Path

from matrixworld.coevolution import RaceSettings
from matrixworld.coevolution.opponents import SAMPLERS
from matrixworld.coevolution.settings import ALL_SCHEDULES

PAGE = (Path(__file__).parents[2] / "docs" / "coevolution.md").read_text(encoding="utf-8")


def test_the_examples_run(tmp_path: Path) -> None:
    code = "\n".join(re.findall(r"^```python\n(.*?)^```$", PAGE, re.M | re.S))
    command = [sys.executable, "-W", "error", "-c", code]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    specialists, generalists, budget, alone, seeds = done.stdout.splitlines()
    assert specialists.startswith("specialist-specialist 0.")
    assert generalists.startswith("generalist-generalist 0.")
    assert re.fullmatch(r"\{'hall': \d, 'archive': \d\}", budget)
    assert alone == "True"
    assert seeds == "[0, 1, 2]"


def test_the_table_names_every_selection_and_nothing_else() -> None:
    table = PAGE.split("| experiment | settings |")[1].split("\n\n")[0]
    values = set(re.findall(r'"([\w-]+)"', table))
    assert values == {*SAMPLERS, *ALL_SCHEDULES, "competitive"} - {"latest", "round-robin"}
    named = set(re.findall(r"`(\w+)=", table))
    assert named <= {item.name for item in fields(RaceSettings)}
    assert len(named) > 8
