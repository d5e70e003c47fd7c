"""A new variant needs a row of rules and a text; the rest of the package follows from them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import matrixworld
from matrixworld import _core

ROW = '        "X": Rules(Interaction.SWARM_TURNS, b, d, b, r, surround, True),\n'
TEXT = '        "X": VariantText(title="A trial", models="M.", choose="C.", observe="O."),\n'
CHECK = """
import sys
sys.meta_path[:] = [f for f in sys.meta_path if "ScikitBuild" not in type(f).__name__]
import pettingzoo
import matrixworld as mw
from matrixworld.coevolution import held_out
from matrixworld.envs import pursuit_evasion_x_v0

env = pettingzoo.make("parallel", "matrixworld/pursuit_evasion_x_v0")
assert env.config.rules == mw.VARIANTS["X"]
assert pursuit_evasion_x_v0.__doc__.startswith("# -X: A trial")
assert "| agents move | team by team |" in pursuit_evasion_x_v0.__doc__
assert set(held_out("evader", "X").values()) <= set(mw.SCRIPTS)
assert mw.record("X", "surrounder", "fleer", seed=0).length > 0
print("played")
"""


@pytest.fixture
def copied_package(tmp_path: Path) -> Path:
    """A copy of the package that tests may change."""
    copy = tmp_path / "matrixworld"
    shutil.copytree(Path(matrixworld.__file__).parent, copy)
    shutil.copy(_core.__file__, copy)  # in an editable installation it lies elsewhere
    return copy


def insert_before(file: Path, line: str, new: str) -> None:
    text = file.read_text(encoding="utf-8")
    assert text.count(line) == 1
    file.write_text(text.replace(line, new + line), encoding="utf-8")


def test_a_row_and_a_text_make_a_variant(copied_package: Path) -> None:
    insert_before(copied_package / "rules.py", '        "D": Rules(', ROW)
    insert_before(copied_package / "envs" / "variant_texts.py", '        "D": VariantText(', TEXT)
    done = subprocess.run(
        [sys.executable, "-c", CHECK],
        cwd=copied_package.parent,
        env={**os.environ, "PYTHONPATH": str(copied_package.parent)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stdout == "played\n", done.stderr
