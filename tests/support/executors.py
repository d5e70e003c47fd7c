"""Executors that do their work in an order of their own, and threads in place of processes."""

import threading
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from contextlib import contextmanager
from functools import partial

import pytest


@contextmanager
def jobs_in_threads():
    """Play jobs in threads: a process takes a second to start, and has tests of its own."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            "matrixworld.coevolution.jobs.play.processes",
            lambda count, **options: ThreadPoolExecutor(count),
        )
        yield


class Reversed(Executor):
    """Does its tasks in a thread when all are there, the last one first."""

    def __init__(self, count):
        self.tasks = []
        self.left = count

    def submit(self, fn, /, *args, **kwargs):
        future = Future()
        self.tasks.append((future, partial(fn, *args, **kwargs)))
        self.left -= 1
        if not self.left:
            # The caller waits for results in its own thread.
            threading.Thread(target=self.work).start()
        return future

    def work(self):
        for future, task in reversed(self.tasks):
            future.set_result(task())
