"""How far a setting travels: from an option of ``evolve`` to config.json."""

import json
import sys
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

import matrixworld
from matrixworld.cli import evolve
from matrixworld.coevolution import jobs

ROOT = str(Path(matrixworld.__file__).parent)
MOST_FUNCTIONS, MOST_FILES = 30, 10


def values_in(given: Any) -> Iterator[Any]:
    yield given
    parts: Any = ()
    if isinstance(given, dict):
        parts = given.values()
    elif isinstance(given, list | tuple):
        parts = given
    elif is_dataclass(given) and not isinstance(given, type):
        parts = [getattr(given, item.name, None) for item in fields(given)]
    for part in parts:
        yield from values_in(part)


def passed(frame: Any, value: float) -> bool:
    """Return whether a function that is called receives a value, itself or in an argument."""
    code = frame.f_code
    count = code.co_argcount + code.co_kwonlyargcount
    count += bool(code.co_flags & 4) + bool(code.co_flags & 8)  # *args, **kwargs
    names = [name for name in code.co_varnames[:count] if name != "self"]
    each = [part for name in names for part in values_in(frame.f_locals.get(name))]
    return any(type(one) in (type(value), str) and one in (value, str(value)) for one in each)


@pytest.mark.parametrize(
    ("options", "section", "name", "value"),
    [
        (["--set", "learner.sigma=0.123"], "learner", "sigma", 0.123),
        (["--generations", "173"], "schedule", "generations", 173),
    ],
)
def test_a_value_passes_few_functions(
    options: list[str],
    section: str,
    name: str,
    value: float,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    create_job, seen = jobs.create_job, set()

    def make_and_end(*given: Any) -> None:
        create_job(*given)
        raise KeyboardInterrupt

    def follow(frame: Any, event: str, argument: Any) -> None:
        code = frame.f_code
        if event == "call" and code.co_filename.startswith(ROOT) and passed(frame, value):
            seen.add((code.co_filename, code.co_name, code.co_firstlineno))

    monkeypatch.setattr(jobs, "create_job", make_and_end)
    words = ["--out", str(tmp_path / "job"), "--schedule", "specialist-specialist", *options]
    before = sys.getprofile()
    sys.setprofile(follow)
    try:
        CliRunner().invoke(evolve.evolve_command, words)
    finally:
        sys.setprofile(before)
    [config] = (tmp_path / "job").glob("*/*/config.json")
    assert json.loads(config.read_text())["settings"][section][name] == value
    assert len(seen) <= MOST_FUNCTIONS, sorted(seen)
    assert len({file for file, *_ in seen}) <= MOST_FILES, sorted(seen)
