"""The default executor: worker processes of this machine, of which each may die on its own."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import queue
import signal
import sys
import threading
import traceback
import warnings
from collections.abc import Callable
from concurrent.futures import Executor, Future
from dataclasses import dataclass
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess
from typing import Any, NamedTuple, TypeVar

from matrixworld._util.checks import check_integer, usable_cores
from matrixworld.coevolution.runs.alternating import DisengagementWarning

TRIES = 3
"""Workers that a task may lose before it fails."""

Result = TypeVar("Result")


class WorkerDiedError(RuntimeError):
    """A task has lost `TRIES` worker processes, for example for lack of memory."""


@dataclass
class _Task:
    future: Future[Any]
    call: Callable[..., Any]
    args: tuple[Any, ...]
    kwargs: dict[str, Any]


class LocalExecutor(Executor):
    """Worker processes, one task at a time in each.

    Parameters
    ----------
    workers : int, optional
        Number of processes. By default one per usable core.

    Notes
    -----
    `ProcessPoolExecutor` gives up all tasks when one worker dies. Here each worker stands alone,
    and the task of a dead one is done again: it must be able to continue what it has begun.
    Workers are started when there is work. They ignore Ctrl-C, and end with this process, even if
    it is killed.
    """

    def __init__(self, workers: int | None = None) -> None:
        count = usable_cores() if workers is None else check_integer("workers", workers, 1)
        self._tasks: queue.SimpleQueue[_Task | None] = queue.SimpleQueue()
        self._workers = [_Worker() for _ in range(count)]
        self._closed = False
        # Started by the first process, it would let Ctrl-C through to that (see `_serve`).
        if sys.platform != "win32":
            resource_tracker.ensure_running()
        self._threads = [
            threading.Thread(target=self._serve, args=(worker,), daemon=True)
            for worker in self._workers
        ]
        for thread in self._threads:
            thread.start()

    def submit(self, fn: Callable[..., Result], /, *args: Any, **kwargs: Any) -> Future[Result]:
        """Return the future of ``fn(*args, **kwargs)``; `fn` belongs to a module."""
        if self._closed:
            raise RuntimeError("submit: expected an executor that is not shut down")
        future: Future[Result] = Future()
        self._tasks.put(_Task(future, fn, args, kwargs))
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """End the workers when their tasks are done; see `concurrent.futures.Executor`."""
        self._closed = True
        if cancel_futures:
            self._cancel()
        for _ in self._threads:
            self._tasks.put(None)
        if wait:
            for thread in self._threads:
                thread.join()

    def kill(self) -> None:
        """End the workers at once; their tasks fail with `WorkerDiedError`."""
        self._closed = True
        self._cancel()
        for worker in self._workers:
            worker.kill()

    def _cancel(self) -> None:
        try:
            while True:
                task = self._tasks.get_nowait()
                if task is not None:
                    task.future.cancel()
        except queue.Empty:
            return

    def _serve(self, worker: _Worker) -> None:
        """Do tasks with one worker until there are no more; runs in a thread of its own."""
        # Worker processes inherit this: a Ctrl-C while they import must not print a traceback.
        if hasattr(signal, "pthread_sigmask"):
            signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
        while (task := self._tasks.get()) is not None:
            if task.future.set_running_or_notify_cancel():
                worker.do(task)
        worker.close()


class _Worker:
    """One worker process at a time."""

    def __init__(self) -> None:
        self._process: SpawnProcess | None = None
        self._pipe: Connection | None = None
        self._killed = False

    def do(self, task: _Task) -> None:
        """Do a task, if necessary with several processes, and set its future."""
        for _ in range(TRIES):
            if self._killed:
                break
            try:
                result, error = self._answer(task)
            except (EOFError, OSError):  # the process is dead
                self.close()
            except Exception as bad:  # noqa: BLE001, such as arguments that cannot be pickled
                task.future.set_exception(bad)
                return
            else:
                _settle(task.future, result, error)
                return
        problem = "killed" if self._killed else f"expected a worker that lives, lost {TRIES}"
        task.future.set_exception(WorkerDiedError(f"worker process: {problem}"))

    def close(self) -> None:
        """End the process, which does nothing now or is dead."""
        if self._pipe is not None:
            self._pipe.close()  # the process reads its end
        if self._process is not None:
            self._process.join()
        self._process = self._pipe = None

    def kill(self) -> None:
        """End the process at once, also while it starts."""
        self._killed = True
        process = self._process
        if process is not None:
            process.kill()

    def _answer(self, task: _Task) -> tuple[Any, _Failure | None]:
        if self._pipe is None:
            # spawn: a fork would copy locks that other threads of this process hold.
            context = multiprocessing.get_context("spawn")
            self._pipe, theirs = context.Pipe()
            self._process = context.Process(target=_work, args=(theirs,), daemon=True)
            self._process.start()
            theirs.close()  # else its end would not be seen when the process dies
            if self._killed:  # meanwhile
                self._process.kill()
        self._pipe.send((task.call, task.args, task.kwargs))
        answer: tuple[Any, _Failure | None] = self._pipe.recv()
        return answer


class _RemoteError(Exception):
    """The traceback of an error in a worker process, as text."""


class _Failure(NamedTuple):
    """An error in a worker process: pickled alone, it would lose its traceback."""

    error: BaseException
    traceback: str


def _settle(future: Future[Any], result: Any, failure: _Failure | None) -> None:
    if failure is None:
        future.set_result(result)
        return
    failure.error.__cause__ = _RemoteError(f"\n{failure.traceback}")
    future.set_exception(failure.error)


# In the worker process:


def _work(pipe: Connection) -> None:
    """Do what comes through a pipe until it is closed."""
    # Ctrl-C reaches all processes of a terminal; the main process tells the workers to stop.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # The main process warns when a run has ended, with its name.
    warnings.simplefilter("ignore", DisengagementWarning)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    while True:
        try:
            call, args, kwargs = pipe.recv()
        except EOFError:
            return
        pipe.send(_outcome(call, args, kwargs))


def _outcome(
    call: Callable[..., Any], args: tuple[Any, ...], kwargs: dict[str, Any]
) -> tuple[Any, _Failure | None]:
    try:
        result = call(*args, **kwargs)
        pickle.dumps(result)
    except BaseException as error:  # noqa: BLE001, it belongs to the future
        text = "".join(traceback.format_exception(error))
        try:
            # Some errors can be pickled, but not made again from what was pickled.
            pickle.loads(pickle.dumps(error))  # noqa: S301, of this process
        except Exception:  # noqa: BLE001, whatever its class does
            error = RuntimeError(f"{type(error).__name__}: {error}")
        return None, _Failure(error, text)
    return result, None


def _end_with_parent() -> None:
    """Wait for the death of the main process, and end this one at once."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        # Not sys.exit, which ends this thread only. Files are safe at any moment.
        os._exit(1)
