"""The scripts in evolution/ run."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

SCRIPTS = Path(__file__).parents[1] / "evolution"


def test_arms_race_runs_and_draws(tmp_path: Path) -> None:
    command = [sys.executable, "-W", "error", SCRIPTS / "arms_race.py", "--quick"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    for schedule in ("specialist-specialist", "generalist-generalist"):
        assert f"\n{schedule}\nThis run " in done.stdout
    assert "at generation 12" in done.stdout
    assert [path.name for path in tmp_path.iterdir()] == ["arms_race.png"]
    assert (tmp_path / "arms_race.png").read_bytes().startswith(b"\x89PNG")


def test_an_unknown_schedule_is_refused(tmp_path: Path) -> None:
    command = [sys.executable, SCRIPTS / "arms_race.py", "--schedules", "tit-for-tat"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert done.returncode == 2
    assert "invalid choice: 'tit-for-tat'" in done.stderr
    assert list(tmp_path.iterdir()) == []
