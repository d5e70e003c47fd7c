"""Without PyTorch, what learns by it is refused before anything is written, and the rest works."""

import sys
from pathlib import Path

import pytest

from command_line import READING, WORLD, evolved, matrixworld_command, words
from matrixworld.coevolution import create, evolve
from tiny_race import tiny_race, tiny_single

HINT = "pip install 'matrixworld-pursuit[torch]'"


@pytest.fixture(autouse=True)
def runs(monkeypatch):
    """Leave a finished race and a run that has begun, both of actor-critic."""
    pytest.importorskip("torch")
    evolve(tiny_race(learner="actor-critic"), "RUN", threads=1)
    create(tiny_single(learner="actor-critic"), "begun")
    # As if it were not installed: `import torch` raises ModuleNotFoundError.
    monkeypatch.setitem(sys.modules, "torch", None)


def test_learning_is_refused_with_the_command_that_installs_it():
    before = sorted(Path().rglob("*"))
    critic = words({**WORLD, "learner": "actor-critic"})
    for arguments in (["--out", "new", *critic], ["--resume", "begun"]):
        told = evolved(*arguments, code=1).output
        assert told.strip() == f"Error: expected the module torch, which is not installed: {HINT}"
    assert sorted(Path().rglob("*")) == before


def test_what_was_learned_is_played_and_judged():
    for command in READING:
        assert matrixworld_command(*command).output
