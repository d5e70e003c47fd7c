"""Worker processes: results, deaths, errors, shutdown, and the end of the main process."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time

import pytest

import dying
from matrixworld.coevolution import LocalExecutor, WorkerDiedError

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs signals")


@pytest.fixture(scope="module")
def executor():
    """Two workers, which start when they are needed."""
    with LocalExecutor(2) as executor:
        yield executor


def test_results_and_errors_belong_to_their_futures(executor):
    futures = [executor.submit(pow, 2, n) for n in range(20)]
    failed = executor.submit(dying.fail)
    keywords = executor.submit(sorted, [1, 3, 2], reverse=True)
    assert [future.result() for future in futures] == [2**n for n in range(20)]
    assert keywords.result() == [3, 2, 1]
    with pytest.raises(KeyError, match="no luck"):
        failed.result()
    assert "in fail" in str(failed.exception().__cause__)


def test_a_task_whose_worker_dies_is_done_again_and_no_other_one_suffers(executor, tmp_path):
    future = executor.submit(dying.die_until, str(tmp_path), 2)
    others = [executor.submit(pow, 2, n) for n in range(50)]
    assert [other.result() for other in others] == [2**n for n in range(50)]
    assert future.result() == 3


def test_a_task_that_kills_three_workers_fails_and_the_next_one_is_done(executor, tmp_path):
    future = executor.submit(dying.die_until, str(tmp_path), 9)
    with pytest.raises(WorkerDiedError, match="lost 3"):
        future.result()
    assert len(list(tmp_path.iterdir())) == 3
    assert executor.submit(pow, 2, 3).result() == 8


def alive(pid):
    """Return whether a process runs."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    # A process that has ended waits for its parent to ask.
    with open(f"/proc/{pid}/stat") as file:
        return file.read().rpartition(")")[2].split()[0] != "Z"


def wait_until(condition, seconds=60.0):
    """Wait until a condition holds."""
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.02)


def test_kill_ends_workers_at_once_and_cancels_what_has_not_begun(tmp_path):
    executor = LocalExecutor(1)
    running = executor.submit(dying.slow, 60.0, str(tmp_path))
    waiting = executor.submit(pow, 2, 3)
    wait_until(lambda: list(tmp_path.iterdir()))
    began = time.monotonic()
    executor.kill()
    executor.shutdown()
    assert time.monotonic() - began < 5.0
    assert waiting.cancelled()
    with pytest.raises(WorkerDiedError, match="killed"):
        running.result()
    assert not alive(int(next(tmp_path.iterdir()).name))
    with pytest.raises(RuntimeError, match="shut down"):
        executor.submit(pow, 2, 3)


PROGRAM = """
from matrixworld.coevolution import LocalExecutor
import dying, sys
if __name__ == "__main__":
    LocalExecutor(1).submit(dying.slow, 600.0, sys.argv[1]).result()
"""


def test_workers_end_with_the_main_process_even_if_it_is_killed(tmp_path):
    (tmp_path / "program.py").write_text(PROGRAM)
    (tmp_path / "workers").mkdir()
    process = subprocess.Popen(
        [sys.executable, tmp_path / "program.py", tmp_path / "workers"],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    try:
        wait_until(lambda: list((tmp_path / "workers").iterdir()))
        worker = int(next((tmp_path / "workers").iterdir()).name)
        os.kill(worker, signal.SIGINT)  # as Ctrl-C, which reaches all processes: ignored
        time.sleep(0.2)
        assert alive(worker)
    finally:
        process.kill()
        process.wait()
    wait_until(lambda: not alive(worker), seconds=10.0)
