"""Connections to a Dask cluster: one that exists, or one of this machine's cores."""

from __future__ import annotations

import asyncio
import logging
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

from matrixworld._util.checks import usable_cores
from matrixworld._util.files import DamagedFileError, read_json
from matrixworld.cluster.executor import ClusterExecutor
from matrixworld.cluster.probe import posted
from matrixworld.coevolution.jobs.worker import without_interrupts
from matrixworld.version import install_hint

AUTO = "auto"
"""Name of a cluster of this machine's cores."""
CONNECT_SECONDS = 30
"""How long an address is tried."""


@contextmanager
def cluster(
    where: str,
    *,
    directory: Path | None = None,
    same_processors: bool = False,
    tell: Callable[[str], None] = warnings.warn,
) -> Iterator[Executor]:
    """Yield an executor whose work is done on a Dask cluster.

    Parameters
    ----------
    where : str
        ``"auto"`` for a cluster of one process for each core of this machine; the address of a
        scheduler, such as ``"tcp://host:8786"``; or the path of a scheduler file.
    directory : Path, optional
        Directory that the work reads and writes: all workers must see it, and its locks.
    same_processors : bool, optional
        Whether the workers' linear algebra must be the same as here: CMA-ES needs it.
    tell : callable, optional
        Called with each sentence for the user, about workers that join or are missing.

    Yields
    ------
    Executor
        Its functions must be importable by the workers, and its values be small. After an error in
        the block, work that has not begun is dropped, and work that has begun is waited for
        `STOP_SECONDS`: Dask cannot stop it.

    Raises
    ------
    ImportError
        If Dask is not installed.
    ValueError
        If `where` is none of the three.
    UnfitWorkerError
        If a worker cannot share the work.
    OSError
        If there is no scheduler, or no worker joins within `FIRST_WORKER_SECONDS`.
    """
    with ExitStack() as stack:
        client = stack.enter_context(_connected(where))
        probe = stack.enter_context(posted(directory, same_processors=same_processors))
        executor = ClusterExecutor(client, probe, tell=tell)
        stack.callback(executor.close)
        executor.start()
        yield executor


def check_where(where: str) -> None:
    """Raise ValueError unless `where` can name a cluster."""
    if where != AUTO and "://" not in where and not Path(where).is_file():
        raise ValueError(
            f"cluster: expected {AUTO}, an address such as tcp://HOST:8786 or a scheduler file, "
            f"got {where!r}"
        )


@contextmanager
def _connected(where: str) -> Iterator[Any]:
    """Yield a client of a cluster; see `cluster`."""
    check_where(where)
    try:
        from distributed import Client, LocalCluster
    except ImportError as error:
        hint = install_hint("cluster")
        raise ImportError(f"A cluster needs the extra 'cluster': {hint}") from error
    # Dask has no types.
    connect: Any = Client
    local: Any = LocalCluster
    with ExitStack() as stack:
        if where == AUTO:
            with without_interrupts():
                address: Any = stack.enter_context(local(**_local()))
        else:
            address = where if "://" in where else _address_in(Path(where))
        stack.enter_context(_quiet())
        if where != AUTO:
            _check_answer(address)
        with connect(address, timeout=CONNECT_SECONDS, set_as_default=False) as client:
            yield client


def _address_in(file: Path) -> str:
    """Return the address in a scheduler file."""
    address = read_json(file).get("address")
    if not isinstance(address, str):
        raise DamagedFileError(file, "expected a scheduler file of Dask, got no address in it")
    return address


def _check_answer(address: str) -> None:
    """Raise OSError if no scheduler answers: a client would wait for the answer without a limit."""
    from distributed import Security
    from distributed.comm import connect  # type: ignore[attr-defined]

    # Dask has no types.
    security: Any = Security
    say_hello: Any = connect

    async def greet() -> None:
        certificates = security().get_connection_args("client")
        comm = await say_hello(address, timeout=CONNECT_SECONDS, **certificates)
        await comm.close()

    # In a thread: notebooks have an event loop of their own in this one.
    with ThreadPoolExecutor(1) as thread:
        waited = thread.submit(asyncio.run, asyncio.wait_for(greet(), CONNECT_SECONDS))
        try:
            waited.result()
        except asyncio.TimeoutError:
            raise OSError(
                f"{address}: expected a Dask scheduler, got no answer within {CONNECT_SECONDS} s"
            ) from None


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep tracebacks of a lost connection off the terminal: the executor says it in a sentence."""
    loggers = [logging.getLogger(f"distributed.{name}") for name in ("client", "core", "comm")]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    yield
    for logger, level in zip(loggers, levels, strict=True):
        logger.setLevel(level)


def _local() -> dict[str, Any]:
    """Return the options of a cluster on this machine."""
    return {
        "n_workers": usable_cores(),
        "threads_per_worker": 1,
        "host": "127.0.0.1",
        "dashboard_address": "127.0.0.1:0",
        "worker_dashboard_address": "127.0.0.1:0",
        # Dask would end workers at its own limit. The package estimates memory before a run.
        "memory_limit": 0,
        "silence_logs": "CRITICAL",
    }
