"""Runs and jobs that are killed or cannot write end, when repeated, as if nothing had happened."""

import errno
import os
import signal
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from itertools import count

import pytest

import killed
import power_cut
from killed import JOB, RUNS, SETTINGS, SHORT_RUNS, Events, play_run, process, watched
from matrixworld.coevolution import LockedError, Run, create, evolve, open_run
from matrixworld.coevolution.jobs.job import found_job
from slow import quickly
from tiny_race import results, straight

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs signals and forks")

DEATH = -signal.SIGKILL


def deaths(target, *args):
    """Do `target` in a process that is killed at its first event, then at its second, and so on.

    Yields the number of each event, until one process comes to its end.
    """
    for at in count():
        child = process(target, *(arg(at) if callable(arg) else arg for arg in args), at)
        child.join()
        if child.exitcode == 0:
            return
        assert child.exitcode == DEATH
        yield at


def check_readable(directory):
    """Readers accept every state that a killed process leaves."""
    if (directory / "config.json").exists():
        open_run(directory).log()


@pytest.mark.nightly
@pytest.mark.parametrize("kind", SHORT_RUNS)
def test_killed_at_every_write_and_every_match(kind, tmp_path):
    for at in deaths(killed.run_until_killed, kind, lambda at: tmp_path / str(at)):
        directory = tmp_path / str(at)
        check_readable(directory)
        play_run(kind, directory)
        assert results(directory) == straight(SETTINGS[kind])
        assert not list(directory.glob(".*.tmp"))
    assert at > 25


@quickly("kind", RUNS, lambda kind: kind == "single")
def test_killed_again_and_again_at_the_next_write(kind, tmp_path):
    """Each process gets at most one event further than the one before: one run, killed often."""
    for at in deaths(killed.run_until_killed, kind, tmp_path / "run"):
        check_readable(tmp_path / "run")
        assert at < 200  # more than there are events
    assert at >= 15
    assert results(tmp_path / "run") == straight(SETTINGS[kind])
    assert not list((tmp_path / "run").glob(".*.tmp"))


def test_a_job_that_is_killed_while_it_is_made_is_none_or_whole(tmp_path):
    """The temporary folder of a dead process may stay; it stands in the way of nothing."""
    seen = set()
    for at in deaths(killed.create_until_killed, lambda at: tmp_path / str(at) / "job"):
        root = tmp_path / str(at) / "job"
        made = found_job(root)
        assert made in ({}, JOB)
        assert root.exists() == bool(made)
        seen.add(len(made))
        if at % 14 == 0 or made:
            runs = evolve([*JOB.values()], root, executor=ThreadPoolExecutor(1))
            assert results(runs[0].path) == straight(RUNS["single"])
            assert found_job(root) == JOB
    assert seen == {0, len(JOB)}
    assert at > 20


def error_of(kind, directory, events):
    try:
        with watched(events):
            play_run(kind, directory)
    except OSError as error:
        return error
    return None


@quickly("kind", SHORT_RUNS, lambda kind: kind == "short race")
def test_every_write_that_fails_names_its_file_and_loses_nothing(kind, tmp_path):
    def refuse():
        raise OSError(errno.ENOSPC, "No space left on device")

    for at in count():
        directory = tmp_path / str(at)
        raised = error_of(kind, directory, Events(at, refuse))
        if raised is None:
            break
        assert raised.errno == errno.ENOSPC
        assert str(tmp_path) in str(raised)  # that of a run is made beside it
        play_run(kind, directory)
        assert results(directory) == straight(SETTINGS[kind])
    assert at > 25


@pytest.mark.nightly
@pytest.mark.skipif(
    not os.access("/dev/loop-control", os.W_OK) or not os.access("/dev/fuse", os.W_OK),
    reason="needs root, loop devices and FUSE",
)
def test_a_run_goes_on_after_a_power_cut(tmp_path):
    """``tests/support/power_cut.py`` tries as many as one likes."""
    assert sum(power_cut.tries(0, 8, tmp_path).values()) == 8


def test_killed_process_releases_the_lock(tmp_path):
    directory = tmp_path / "run"
    create(RUNS["race"], directory)
    child = process(killed.hold, directory, tmp_path / "held")
    while not (tmp_path / "held").exists():
        time.sleep(0.01)
    with pytest.raises(LockedError, match="run: another process is running there"):
        Run(directory)
    open_run(directory)  # reading needs no lock
    child.kill()
    child.join()
    assert Run(directory).training.stage == 0
