"""The suite as a file: it is what is computed, and its page's check runs as it stands."""

import re
import runpy
from pathlib import Path

import pytest

import suite
from matrixworld.solver.suite import FILE

ROOT = Path(__file__).parents[2]


def test_the_file_is_what_is_computed(monkeypatch, capsys):
    assert suite.FILE.read_bytes() == FILE.read_bytes()
    monkeypatch.setattr("sys.argv", ["suite.py", "--check"])
    with pytest.raises(SystemExit) as ended:
        suite.main()
    assert not ended.value.code
    assert capsys.readouterr().out == "25 worlds of mw25.json are as computed\n"


def test_the_check_on_the_page_runs_as_it_stands(monkeypatch, tmp_path):
    page = (ROOT / "docs" / "suite.md").read_text(encoding="utf-8")
    [text] = re.findall(r"```python no-run\n(.*?)```", page, re.S)
    script = tmp_path / "check.py"
    monkeypatch.chdir(ROOT)
    script.write_text(text)
    runpy.run_path(str(script))
    script.write_text(text.replace('game["steps"]', 'game["steps"] - 1'))
    with pytest.raises(AssertionError):
        runpy.run_path(str(script))
