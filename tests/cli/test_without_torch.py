"""Without PyTorch, what learns by it is refused before anything is written, and the rest works."""

import sys
from pathlib import Path

import pytest

from command_line import READING, evolved, matrixworld_command, words
from matrixworld.coevolution import finish, start
from tiny_race import tiny_race, tiny_single

HINT = "pip install 'matrixworld-pursuit[torch]'"

AGAINST_A_RACE = {"schedule": "against", "opponent": "race", "start": "race"}


def files(root: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in root.rglob("*") if path.is_file()}


@pytest.fixture
def runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the directory of a finished race and a run that has begun, both of actor-critic."""
    pytest.importorskip("torch")
    root = tmp_path / "runs"
    finish(tiny_race(learner="actor-critic"), root / "race", threads=1)
    start(tiny_single(learner="actor-critic"), root / "begun", threads=1)
    # As if it were not installed: `import torch` raises ModuleNotFoundError.
    monkeypatch.setitem(sys.modules, "torch", None)
    return root


TINY = {"rows": 6, "cols": 6, "fov": 3, "n_pursuers": 2, "n_evaders": 3, "hidden": "4"}
CRITIC = words({"learner": "actor-critic", **TINY})


@pytest.mark.parametrize(
    "arguments",
    [
        ["--out", "new", *CRITIC],
        ["--out", "new", "--schedule", "against", *CRITIC],
        ["--out", "new", "--seeds", "0-1", *CRITIC],
        ["--out", "new", *words(AGAINST_A_RACE), *CRITIC],
        ["--resume", "begun"],
    ],
    ids=["races", "alone", "seeds", "start", "resume"],
)
def test_learning_is_refused_with_the_command_that_installs_it(
    runs: Path, arguments: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(runs)
    before = files(runs)
    told = evolved(*arguments, code=1).output
    assert told.strip() == f"Error: expected the module torch, which is not installed: {HINT}"
    assert files(runs) == before
    assert not (runs / "new").exists()


@pytest.mark.parametrize("command", READING, ids=" ".join)
def test_what_was_learned_is_played_and_judged(
    runs: Path, command: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(runs)
    (runs / "race").rename("RUN")
    assert matrixworld_command(*command).output
