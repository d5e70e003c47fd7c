"""The README's examples do what the README shows."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

from matrixworld import VARIANTS, Capture, Interaction, Outcome

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"^```python\n(.*?)^```\n(?:\n```text\n(.*?)^```$)?", README, re.M | re.S)


def test_examples_print_what_the_readme_shows(tmp_path: Path) -> None:
    assert len(EXAMPLES) == 4
    for code, shown in EXAMPLES:
        done = subprocess.run(
            [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True
        )
        assert done.stdout == shown
    assert [path.name for path in tmp_path.iterdir()] == ["chase.gif"]


def test_the_table_of_variants_is_the_one_of_the_package() -> None:
    moves = {
        Interaction.SIMULTANEOUS: "all at once",
        Interaction.SWARM_TURNS: "team by team",
        Interaction.AGENT_TURNS: "one at a time",
    }
    letters = {Outcome.DISAPPEAR: "D", Outcome.REACH: "R", Outcome.BOUNCE: "B"}
    captures = {Capture.OCCUPATION: "occupation", Capture.SURROUND: "surrounding"}
    for name, rules in VARIANTS.items():
        cells = [
            name,
            moves[rules.interaction],
            letters[rules.obstacle],
            letters[rules.teammate],
            f"{letters[rules.evader]}, {letters[rules.pursuer]}",
            captures[rules.capture],
            "disappear" if rules.removes_captured else "stay",
        ]
        row = f"| {' | '.join(cells)} |\n"
        assert row in README, f"README.md, The games: add the row {row}"


def test_every_file_that_the_readme_links_to_exists() -> None:
    links = re.findall(r"\]\(([^)#]+)\)", README)
    local = [link for link in links if not link.startswith("http")]
    assert len(local) >= 7
    assert [link for link in local if not (ROOT / link).exists()] == []
