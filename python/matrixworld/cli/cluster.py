"""``--cluster``: work is done on a Dask cluster, one that exists or one of this machine's cores."""

from __future__ import annotations

import platform
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click
import numpy as np

from matrixworld._util import checks, files
from matrixworld._util.processes import without_interrupts
from matrixworld.version import __version__, imported

AUTO = "auto"
"""Name of a cluster of this machine's cores."""
CONNECT_SECONDS = 30
"""How long an address is tried."""
FIRST_WORKER_SECONDS = 300
"""Workers of a batch system may start after the program that gives them work."""


class OtherWorkerError(RuntimeError):
    """A worker has other versions of matrixworld or NumPy, and could have other results."""


@contextmanager
def on_cluster(where: str | None, threads: int | None = None) -> Iterator[Executor | None]:
    """Yield the executor that ``--cluster`` asks for, or None without it.

    `where` is ``auto``, the address of a scheduler such as ``tcp://host:8786``, or a scheduler
    file; `threads` is the option that has no meaning beside it. BrokenExecutor if the cluster is
    lost in the block.
    """
    if where is None:
        yield None
        return
    if threads is not None:
        raise click.UsageError("--threads: expected it without --cluster, got both")
    dask = imported("distributed", "cluster")
    with (
        _scheduler(where, dask) as scheduler,
        dask.Client(scheduler, timeout=CONNECT_SECONDS, set_as_default=False) as client,
    ):
        client.wait_for_workers(1, timeout=FIRST_WORKER_SECONDS)
        for worker, got in client.run(versions, on_error="return").items():
            if got != versions():
                raise _other_worker(versions(), got, worker)
        with client.get_executor(pure=False) as executor:
            try:
                yield SameVersions(executor)
            except CancelledError as error:  # all that Dask says
                lost = "--cluster: the scheduler was lost, or the work was cancelled there"
                raise BrokenExecutor(lost) from error


@contextmanager
def _scheduler(where: str, dask: Any) -> Iterator[Any]:
    """Yield what a client connects to: a cluster that ends with the block, or an address."""
    if where == AUTO:
        with without_interrupts():
            local = dask.LocalCluster(
                n_workers=checks.usable_cores(),
                threads_per_worker=1,
                host="127.0.0.1",
                dashboard_address="127.0.0.1:0",
                worker_dashboard_address="127.0.0.1:0",
                # Dask would end workers at its own limit. Memory is estimated before a run.
                memory_limit=0,
                silence_logs="CRITICAL",
            )
        with local:
            yield local
    elif "://" in where:
        yield where
    else:
        yield _address_in(Path(where))


def _address_in(file: Path) -> str:
    """Return the address in a scheduler file; DamagedFileError if it has none."""
    address = files.read_json(file).get("address")
    if not isinstance(address, str):
        problem = "expected a scheduler file of Dask, got no address in it"
        raise files.DamagedFileError(file, problem)
    return address


# Versions:


def versions() -> tuple[str, str]:
    """Return what results depend on, besides settings and seeds."""
    return __version__, np.__version__


class SameVersions(Executor):
    """Gives work to another executor, for workers of the same versions; others may come later."""

    def __init__(self, executor: Executor) -> None:
        self._executor = executor

    def submit(self, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Submit a call, whose error is OtherWorkerError at a worker of other versions."""
        return self._executor.submit(call_in, versions(), function, *args, **kwargs)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """End the other executor."""
        self._executor.shutdown(wait)


def call_in(
    expected: tuple[str, str], function: Callable[..., Any], /, *args: Any, **kwargs: Any
) -> Any:
    """Call a function where the versions are the expected ones; OtherWorkerError elsewhere."""
    if versions() != expected:
        raise _other_worker(expected, versions(), platform.node())
    return function(*args, **kwargs)


def _other_worker(expected: tuple[str, str], got: object, worker: str) -> OtherWorkerError:
    return OtherWorkerError(
        f"--cluster: expected workers with the versions {expected} of matrixworld and NumPy, got "
        f"{got!r} of {worker}"
    )
