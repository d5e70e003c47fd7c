"""docs/class.md: its examples work, and its numbers are those of the code."""

from __future__ import annotations

import contextlib
import io
import re
from pathlib import Path

import pytest

from class_submissions import ACTS, problem_here, write_programs
from matrixworld import WorldConfig
from matrixworld.classroom import play_class
from matrixworld.classroom.policy_server import MODULES
from matrixworld.classroom.sandbox import ALLOWED
from matrixworld.classroom.submissions import MOST_BYTES
from matrixworld.cli.classroom import play_command

PAGE = (Path(__file__).parents[2] / "docs" / "class.md").read_text(encoding="utf-8")
PROGRAM, TRIAL = re.findall(r"```python\n(.*?)```", PAGE, re.S)
LISTED = set(
    re.findall(r"`([\w.]+)`", PAGE.partition("A program can import")[2].partition("\n\n")[0])
)
"""The modules that a program can import."""
HEADERS = (
    Path("/usr/include/x86_64-linux-gnu/asm/unistd_64.h"),
    Path("/usr/include/asm-generic/unistd.h"),
)
"""Numbers of system calls, as Linux has them: of x86-64, and of aarch64."""


def test_the_program_of_the_page_plays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "anna.py").write_text(PROGRAM)
    monkeypatch.syspath_prepend(tmp_path)
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(TRIAL, {})
    assert 0.1 < float(printed.getvalue()) < 0.9


def test_programs_as_on_the_page_can_be_handed_in(tmp_path: Path) -> None:
    """The page's own, and one that imports all that the page lists."""
    if problem := problem_here():
        pytest.skip(problem)
    imports = "".join(f"import {name}\n" for name in sorted(LISTED))
    write_programs(tmp_path, {"anna": PROGRAM, "bo": imports + ACTS + "return 0"})
    config = WorldConfig("O", rows=8, cols=8, n_pursuers=2, n_evaders=2, max_steps=10)
    result = play_class(tmp_path, config, episodes=2)
    students = [entry.name for entry in result.entries["pursuer"] if entry.file]
    assert (students, result.refusals) == (["anna", "bo"], ())


def test_limits_and_options_are_those_of_the_command() -> None:
    rows = dict(re.findall(r"^\| `(--[\w-]+)` \| (\d+) \|", PAGE, re.M))
    options = {param.opts[0]: param.default for param in play_command.params}
    assert {name: float(value) for name, value in rows.items()} == {
        name: float(options[name]) for name in ("--seconds", "--wait", "--in-all", "--memory")
    }
    assert set(re.findall(r"`(--[\w-]+)", PAGE)) <= {*options, "--no-open"}
    assert f"allows {len(ALLOWED)} of them" in PAGE
    assert (MOST_BYTES["program"], MOST_BYTES["genome"]) == (256 << 10, 8 << 20)


def test_all_modules_that_programs_may_import_are_listed() -> None:
    hidden = {name for name in MODULES if name.startswith(("__", "numpy.", "encodings."))}
    assert {name.removesuffix(".abc") for name in set(MODULES) - hidden} | {"numpy"} == LISTED


@pytest.mark.parametrize("column", [0, 1])
def test_numbers_of_system_calls_are_those_of_linux(column: int) -> None:
    if not HEADERS[column].exists():
        pytest.skip("needs the headers of Linux")
    text = HEADERS[column].read_text(encoding="utf-8")
    numbers = dict(re.findall(r"#define __NR(?:3264)?_(\w+)\s+(\d+)", text))
    assert {name: int(numbers[name]) for name in ALLOWED} == {
        name: row[column] for name, row in ALLOWED.items()
    }
