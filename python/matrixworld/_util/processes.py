"""Processes of this machine that work for this one, and end with it."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import warnings
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import connection, resource_tracker
from multiprocessing.connection import Connection


@contextmanager
def processes(count: int, *, ignore: type[Warning] | None = None) -> Iterator[Executor]:
    """Yield an executor with processes, which end with the block, or if this process is killed.

    They do not tell warnings of the category `ignore`.
    """
    # spawn: a fork would copy locks that other threads of this process hold.
    context = multiprocessing.get_context("spawn")
    # A pipe that nothing is sent through: its end shows, also when either process is killed. An
    # Event would wait for ever for a process that died while it waited for the Event.
    reader, writer = context.Pipe(duplex=False)
    with reader, writer, ProcessPoolExecutor(count, context, _begin, (reader, ignore)) as pool:
        try:
            yield pool
        except BaseException:
            writer.close()
            # Until they have ended, they hold the locks of their runs.
            pool.shutdown(cancel_futures=True)
            raise


@contextmanager
def without_interrupts() -> Iterator[None]:
    """Keep Ctrl-C, which a terminal sends to all, from processes that are started here."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    # Started later, it would unblock Ctrl-C in the thread that starts it.
    resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _begin(parent: Connection, ignore: type[Warning] | None) -> None:
    """Begin a process that ends when it is stopped, or with the process that has started it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if ignore is not None:
        warnings.simplefilter("ignore", ignore)
    threading.Thread(target=_end_with, args=(parent,), daemon=True).start()


def _end_with(parent: Connection) -> None:
    connection.wait([parent])
    os._exit(1)  # not sys.exit, which ends this thread only; files are safe at any moment
