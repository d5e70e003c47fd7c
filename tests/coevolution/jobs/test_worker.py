"""Worker processes: Ctrl-C, the end of the main process, and processes that cannot start."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from concurrent.futures import BrokenExecutor

import pytest

import dying
from matrixworld.coevolution.jobs.worker import WorkerProcesses
from scripts import wait_until

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
        worker = int(next((tmp_path / "workers").iterdir()).name)
        os.kill(worker, signal.SIGINT)  # as Ctrl-C, which reaches all processes: ignored
        time.sleep(0.2)
        assert alive(worker)
    finally:
        process.kill()
        process.wait()
    wait_until(lambda: not alive(worker), "end of the worker", 10.0)


LIMITED = """
import resource, sys
from matrixworld.coevolution import evolve
from tiny_race import tiny_race
if __name__ == "__main__":
    settings = [tiny_race(seed=seed) for seed in range(2)]
    resource.setrlimit(resource.RLIMIT_NOFILE, (int(sys.argv[1]),) * 2)
    try:
        evolve(settings, sys.argv[2], threads=2)
    except OSError as error:
        sys.exit(f"{error}")
"""


@pytest.mark.parametrize("files", [9, 12, 16])
def test_too_few_files_end_in_one_sentence(files, tmp_path):
    (tmp_path / "program.py").write_text(LIMITED)
    done = subprocess.run(
        [sys.executable, tmp_path / "program.py", str(files), tmp_path / "job"],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 1, done.stderr
    assert "Too many open files" in done.stderr.splitlines()[-1]
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "job" / ".start").exists()
