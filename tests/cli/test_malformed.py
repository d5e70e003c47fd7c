"""Malformed values of every option: a message, no traceback, and nothing written."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner

from command_line import words
from matrixworld.cli import main

LONG = "1" + "0" * 5000
MALFORMED = ("", "nan", "-inf", "1e400", "-1", "2.5e-3x", "1" + "0" * 400, LONG)
"""Values of an option; none is a size, or a name of something that exists."""

ARGUMENTS = {
    "evolve": ["--out", "new", *words({"generations": 1, "pursuer_epochs": 1, "evader_epochs": 1})],
    "tournament": ["run", "--episodes", "2"],
    "score": ["run", "--episodes", "2"],
    "exploit": ["run", "--champion", "pursuer", "--matches", "50", "--episodes", "2"],
    "replay": ["run", "--out", "new.png"],
    "explore": ["run", "--figures"],
    "bench": ["--set", "world.rows=6", "--set", "world.cols=6", "--seconds", "0.01"],
}
"""Arguments that make a command valid."""
LEGAL = {(name, "-1") for name in ("--pursuer", "--evader", "--generation", "--step")}
"""The last generation or step."""
FILES = {"--json", "--out"}
"""Options that take any name of a file that can exist."""


def options() -> Iterator[pytest.ParameterSet]:
    """Yield every option that takes a value, of every command above."""
    for name in ARGUMENTS:
        for param in main.commands[name].params:
            if not getattr(param, "is_flag", True):
                yield pytest.param(name, param.opts[0], id=f"{name}{param.opts[0]}")


def contents() -> dict[Path, tuple[int, bytes]]:
    """Return all files below the working directory, with times and contents."""
    files = [path for path in Path().rglob("*") if path.is_file()]
    return {path: (path.stat().st_mtime_ns, path.read_bytes()) for path in files}


@pytest.mark.usefixtures("run")
@pytest.mark.parametrize(("command", "option"), list(options()))
def test_a_malformed_value_is_refused_and_nothing_is_written(command: str, option: str) -> None:
    before = contents()
    for value in (LONG,) if option in FILES else MALFORMED:
        if (option, value) in LEGAL:
            continue
        result = CliRunner().invoke(main, [command, *ARGUMENTS[command], option, value])
        assert isinstance(result.exception, SystemExit), (value[:20], result.exception)
        assert result.exit_code in (1, 2)
        assert "Error: " in result.stderr
        assert contents() == before, value[:20]
        assert {path.name for path in Path().iterdir()} == {"run"}


def test_the_arguments_are_valid_without_a_malformed_value(run: Path) -> None:
    for command, arguments in ARGUMENTS.items():
        if command in ("tournament", "score", "replay"):
            assert CliRunner().invoke(main, [command, *arguments]).exit_code == 0, command
