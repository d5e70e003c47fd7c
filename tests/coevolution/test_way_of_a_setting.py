"""How far a setting travels: from an option of ``evolve`` to config.json."""

import json
import sys
from dataclasses import is_dataclass
from pathlib import Path

import pytest
from click.testing import CliRunner

import matrixworld
from matrixworld.cli import evolve
from matrixworld.coevolution.jobs import job as jobs

ROOT = str(Path(matrixworld.__file__).parent)
MOST_FUNCTIONS, MOST_FILES = 22, 10


class Enough(Exception):  # noqa: N818, it is no error
    """The runs have been made."""


def values_in(given):
    yield given
    if is_dataclass(given) and not isinstance(given, type):
        given = vars(given)
    if isinstance(given, dict | list | tuple):
        for part in given.values() if isinstance(given, dict) else given:
            yield from values_in(part)


def passed(code, arguments, value):
    """Return whether a function receives a value; a section does not receive what it holds."""
    count = code.co_argcount + code.co_kwonlyargcount
    count += bool(code.co_flags & 4) + bool(code.co_flags & 8)  # *args, **kwargs
    names = [name for name in code.co_varnames[:count] if name != "self"]
    return any(
        type(each) in (type(value), str) and each in (value, str(value))
        for name in names
        for each in values_in(arguments.get(name))
    )


@pytest.mark.parametrize(
    ("options", "path", "value"),
    [
        (["--set", "learner.sigma=0.123"], ("learner", "sigma"), 0.123),
        (["--generations", "173"], ("schedule", "generations"), 173),
    ],
)
def test_a_value_passes_few_functions(options, path, value, tmp_path, monkeypatch):
    create_job = jobs.create_job

    def only_create(*args):
        create_job(*args)
        raise Enough

    monkeypatch.setattr(jobs, "create_job", only_create)
    seen = set()

    def follow(frame, event, argument):
        code = frame.f_code
        own = event == "call" and code.co_filename.startswith(ROOT)
        if own and passed(code, frame.f_locals, value):
            seen.add((code.co_filename.removeprefix(ROOT), code.co_name, code.co_firstlineno))

    words = ["--out", str(tmp_path / "job"), "--schedule", "specialist-specialist"]
    before = sys.getprofile()
    sys.setprofile(follow)
    try:
        result = CliRunner().invoke(evolve.evolve_command, [*words, *options])
    finally:
        sys.setprofile(before)
    assert isinstance(result.exception, Enough), result.output
    [config] = (tmp_path / "job").glob("*/*/config.json")
    assert json.loads(config.read_text())["settings"][path[0]][path[1]] == value
    files = {file for file, *_ in seen}
    assert len(seen) <= MOST_FUNCTIONS, sorted(seen)
    assert len(files) <= MOST_FILES, sorted(files)
