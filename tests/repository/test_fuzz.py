"""The public fuzzer finds planted bugs, by its seed alone."""

import time
from contextlib import contextmanager
from pathlib import Path
from unittest import mock

import pytest

import fuzz
import matrixworld as mw
from matrixworld._util import files
from matrixworld.cli import options
from matrixworld.coevolution.runs.writer import RunWriter


@contextmanager
def a_move_is_lost():
    """The last agent stays in its third step."""
    step = mw.World.step

    def planted(world, actions, **options):
        chosen = list(actions)
        if world.steps == 2:
            chosen[-1] = 0
        return step(world, chosen, **options)

    with mock.patch.object(mw.World, "step", planted):
        yield


@contextmanager
def an_unknown_directory_is_no_sentence():
    plain = options.find_runs

    def planted(path):
        return plain(path) or {}["run"]

    with mock.patch.object(options, "find_runs", planted):
        yield


@contextmanager
def damage_is_no_sentence():
    others = tuple(each for each in options.FAILURES if each is not files.DamagedFileError)
    with mock.patch.object(options, "FAILURES", others):
        yield


@contextmanager
def what_a_killed_writer_left_stays():
    with mock.patch.object(files, "remove_temporary_files"):
        yield


@contextmanager
def a_clock_decides():
    """Old checkpoints are removed if time has passed since the last one."""
    save, last = RunWriter.save, [-1e300]

    def planted(run, *args):
        last.append(time.time())
        keep = last[-1] < last[-2]
        with mock.patch.object(Path, "unlink") if keep else mock.MagicMock():
            save(run, *args)

    with mock.patch.object(RunWriter, "save", planted):
        yield


PLANTED = {
    "worlds": a_move_is_lost,
    "commands": an_unknown_directory_is_no_sentence,
    "files": damage_is_no_sentence,
    "kills": what_a_killed_writer_left_stays,
    "clocks": a_clock_decides,
}
SEEDS = {"worlds": 0, "commands": 31, "files": 0, "kills": 1, "clocks": 0}
"""Seeds with which few steps find each bug."""


@pytest.mark.slow
@pytest.mark.parametrize("kind", PLANTED)
def test_a_planted_bug_is_found(kind):
    seed = SEEDS[kind]
    assert not fuzz.fuzz(seed, steps=3, kinds=[kind])  # and nothing else
    with PLANTED[kind]():
        problem = fuzz.fuzz(seed, steps=3, kinds=[kind])
    assert problem.startswith(f"seed {seed}, step ")
    assert f"({kind})" in problem
