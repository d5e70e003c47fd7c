"""Runs that are killed or cannot write end, when resumed, as if nothing had happened."""

import errno
import signal
import sys
import time
from functools import cache
from itertools import count

import pytest

import killed
from killed import RUNS, SHORT_RUNS, Events, process, run_until_killed, start_or_resume, watched
from matrixworld import coevolution
from matrixworld.coevolution import LockedError, open_run
from slow import quickly
from tiny_race import directory_in_memory, results

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs signals and forks")

DEATHS = -signal.SIGKILL


@cache
def straight(kind):
    """Return the results of a run that is never disturbed."""
    with directory_in_memory() as directory:
        start_or_resume(kind, directory / "run")
        return results(directory / "run")


def check_readable(directory):
    """Readers accept every state that a killed process leaves."""
    if (directory / "config.json").exists():
        open_run(directory).log()


@pytest.mark.slow
@quickly("kind", SHORT_RUNS, lambda kind: kind == "short single")
def test_killed_at_every_write_and_every_match(kind, tmp_path):
    """Each event is tried, so that none depends on being hit at random."""
    for at in count():
        directory = tmp_path / str(at)
        child = process(run_until_killed, kind, directory, at)
        child.join()
        if child.exitcode == 0:
            break
        assert child.exitcode == DEATHS
        check_readable(directory)
        start_or_resume(kind, directory)
        assert results(directory) == straight(kind)
        assert not list(directory.glob(".*.tmp"))
    assert at > 25


@quickly("kind", RUNS, lambda kind: kind == "single")
def test_killed_again_and_again_at_the_next_write(kind, tmp_path):
    """Each process gets at most one event further than the one before: one run, killed often."""
    directory = tmp_path / "run"
    deaths = 0
    for at in range(200):  # more than there are events: it ends at the break
        child = process(run_until_killed, kind, directory, at)
        child.join()
        if child.exitcode == 0:
            break
        check_readable(directory)
        deaths += 1
    assert child.exitcode == 0
    assert deaths >= 15
    assert results(directory) == straight(kind)


def error_of(kind, directory, events):
    """Return the system error that stops a run; None if the run finishes."""
    try:
        with watched(events):
            start_or_resume(kind, directory)
    except OSError as error:
        return error
    return None


@pytest.mark.parametrize("kind", SHORT_RUNS)
def test_every_write_that_fails_names_its_file_and_loses_nothing(kind, tmp_path):
    def refuse():
        raise OSError(errno.ENOSPC, "No space left on device")

    for at in count():
        directory = tmp_path / str(at)
        raised = error_of(kind, directory, Events(at, refuse))
        if raised is None:
            break
        assert raised.errno == errno.ENOSPC
        assert str(directory) in str(raised)
        start_or_resume(kind, directory)
        assert results(directory) == straight(kind)
    assert at > 25


def test_killed_process_releases_the_lock(tmp_path):
    directory = tmp_path / "run"
    coevolution.start(RUNS["race"], directory)
    child = process(killed.hold, directory, tmp_path / "held")
    while not (tmp_path / "held").exists():
        time.sleep(0.01)
    with pytest.raises(LockedError, match="run: another process is running there"):
        coevolution.resume(directory)
    open_run(directory)  # reading needs no lock
    child.kill()
    child.join()
    assert coevolution.resume(directory).stage == 0
