"""Worker processes: Ctrl-C, the end of the main process, and processes that cannot start."""

import multiprocessing.queues
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import BrokenExecutor

import pytest

import dying
from matrixworld.coevolution import evolve
from matrixworld.coevolution.jobs import worker
from matrixworld.coevolution.jobs.worker import WorkerProcesses
from scripts import wait_until
from tiny_race import tiny_race

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs signals")


def alive(pid):
    """Return whether a process runs."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    # A process that has ended waits for its parent to ask.
    with open(f"/proc/{pid}/stat") as file:
        return file.read().rpartition(")")[2].split()[0] != "Z"


def test_a_worker_in_work_ends_at_once_with_the_executor(tmp_path):
    with WorkerProcesses(1) as processes:
        running = processes.submit(dying.slow, 60.0, str(tmp_path))
        waiting = [processes.submit(pow, 2, 3) for _ in range(5)]
        wait_until(lambda: list(tmp_path.iterdir()), "begin of the work")
        began = time.monotonic()
    assert time.monotonic() - began < 5.0
    assert waiting[-1].cancelled()
    with pytest.raises(BrokenExecutor):
        running.result()
    assert not alive(int(next(tmp_path.iterdir()).name))


PROGRAM = """
from matrixworld.coevolution.jobs.worker import WorkerProcesses
import dying, sys
if __name__ == "__main__":
    with WorkerProcesses(1) as processes:
        processes.submit(dying.slow, 600.0, sys.argv[1]).result()
"""


def test_workers_end_with_the_main_process_even_if_it_is_killed(tmp_path):
    (tmp_path / "program.py").write_text(PROGRAM)
    (tmp_path / "workers").mkdir()
    process = subprocess.Popen(
        [sys.executable, tmp_path / "program.py", tmp_path / "workers"],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    try:
        wait_until(lambda: list((tmp_path / "workers").iterdir()), "begin of the work")
        number = int(next((tmp_path / "workers").iterdir()).name)
        os.kill(number, signal.SIGINT)  # as Ctrl-C, which reaches all processes: ignored
        time.sleep(0.2)
        assert alive(number)
    finally:
        process.kill()
        process.wait()
    wait_until(lambda: not alive(number), "end of the worker", 10.0)


LIMITED = """
import resource, sys
from matrixworld.coevolution import evolve
from tiny_race import tiny_race
if __name__ == "__main__":
    settings = [tiny_race(seed=seed) for seed in range(2)]
    resource.setrlimit(getattr(resource, f"RLIMIT_{sys.argv[1]}"), (int(sys.argv[2]),) * 2)
    try:
        evolve(settings, sys.argv[3], threads=2)
    except OSError as error:
        sys.exit(f"{error}")
"""


NOT_FOR_ROOT = pytest.mark.skipif(os.geteuid() == 0, reason="root has no limit of processes")


@pytest.mark.parametrize(
    ("what", "limit", "reason"),
    [
        *[("NOFILE", files, "[Errno 24] Too many open files") for files in (9, 12, 16)],
        pytest.param("NPROC", 1, "[Errno 11]", marks=NOT_FOR_ROOT),
    ],
)
def test_a_limit_of_the_system_ends_in_one_sentence(what, limit, reason, tmp_path):
    (tmp_path / "program.py").write_text(LIMITED)
    done = subprocess.run(
        [sys.executable, tmp_path / "program.py", what, str(limit), tmp_path / "job"],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 1, done.stderr
    assert done.stderr.startswith(f"worker processes: expected to start one, got: {reason}")
    assert len(done.stderr.splitlines()) == 1
    assert {path.name for path in (tmp_path / "job").iterdir()} <= {".lock", "job.json"}


def no_thread(*args):
    raise RuntimeError("can't start new thread")


def test_a_pool_without_its_thread_ends_its_workers(monkeypatch, capfd):
    monkeypatch.setattr(threading.Thread, "start", no_thread)
    with WorkerProcesses(2) as processes, pytest.raises(OSError, match="can't start new thread"):
        processes.submit(pow, 2, 3)
    assert not multiprocessing.active_children()
    assert not capfd.readouterr().err


def test_calls_fail_if_the_thread_that_hands_them_out_dies(monkeypatch, capfd):
    monkeypatch.setattr(multiprocessing.queues.Queue, "_start_thread", no_thread)
    hook = threading.excepthook
    with WorkerProcesses(1) as processes:
        # The thread dies during the first call or after it.
        for _ in range(2):
            with pytest.raises(BrokenExecutor, match="can't start new thread"):
                processes.submit(pow, 2, 3).result(timeout=60)
    assert threading.excepthook is hook
    assert not capfd.readouterr().err


def test_workers_that_cannot_start_are_tried_some_times(monkeypatch, tmp_path, capfd):
    monkeypatch.setattr(worker, "_begin", dying.begin_without_threads)
    with pytest.raises(BrokenExecutor, match="expected some that start, lost 4; memory or the num"):
        evolve([tiny_race(seed=seed) for seed in range(2)], tmp_path / "job", threads=2)
    assert {path.name for path in (tmp_path / "job").iterdir()} == {".lock", "job.json"}
    assert not capfd.readouterr().err
