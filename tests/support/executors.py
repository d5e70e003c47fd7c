"""Executors that do their work in an order of their own."""

import threading
from collections.abc import Callable
from concurrent.futures import Executor, Future
from typing import Any


class Reversed(Executor):
    """Does its tasks in a thread when all are there, the last one first."""

    def __init__(self, count: int) -> None:
        self.tasks: list[tuple[Future[Any], Callable[..., Any], Any]] = []
        self.left = count

    def submit(self, fn, /, *args, **kwargs):
        future: Future[Any] = Future()
        self.tasks.append((future, fn, args))
        self.left -= 1
        if not self.left:
            # The caller waits for results in its own thread.
            threading.Thread(target=self.work).start()
        return future

    def work(self) -> None:
        for future, fn, args in reversed(self.tasks):
            future.set_result(fn(*args))
