"""Programs in docs/clients, in which learners of other libraries learn, run with few steps."""

import ast
import re
from importlib.util import find_spec

import pytest

from pages import ROOT, read
from scripts import python

PROGRAMS = sorted((ROOT / "docs" / "clients").glob("learn_*.py"))
RATE = r"0\.\d+ \(0\.\d+ to 0\.\d+\)"


def missing_modules(code):
    statements = [*ast.walk(ast.parse(code))]
    names = [a.name for each in statements if isinstance(each, ast.Import) for a in each.names]
    names += [each.module or "" for each in statements if isinstance(each, ast.ImportFrom)]
    return [name for name in names if find_spec(name.partition(".")[0]) is None]


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.stem)
def test_learners_of_other_libraries_run_with_few_steps(program, tmp_path, monkeypatch):
    assert f"](clients/{program.name})" in read("docs/clients.md")
    code = program.read_text(encoding="utf-8")
    for module in missing_modules(code):
        pytest.importorskip(module, exc_type=ImportError)
    # One or two updates of the learner.
    short, count = re.subn(r"^STEPS = [\d_]+", "STEPS = 8_192", code, flags=re.M)
    assert count == 1  # else the program would take its full time
    monkeypatch.setenv("MINARI_DATASETS_PATH", str(tmp_path))
    done = python("-c", short, cwd=tmp_path)  # where it may write
    assert done.returncode == 0, done.stderr
    for moment in ("before", "after"):
        assert re.search(rf"^{moment} {RATE}$", done.stdout, re.M), done.stdout
