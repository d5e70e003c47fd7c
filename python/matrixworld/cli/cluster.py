"""``--cluster``: work is done on a Dask cluster, one that exists or one of this machine's cores."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import click
import numpy as np

from matrixworld._util import checks, files
from matrixworld.coevolution.jobs import without_interrupts
from matrixworld.version import __version__, imported

AUTO = "auto"
"""Name of a cluster of this machine's cores."""
CONNECT_SECONDS = 30
"""How long an address is tried."""
FIRST_WORKER_SECONDS = 300
"""Workers of a batch system may start after the program that gives them work."""


@contextmanager
def on_cluster(where: str | None, threads: int | None = None) -> Iterator[Executor | None]:
    """Yield the executor that ``--cluster`` asks for, or None without it.

    `where` is ``auto``, the address of a scheduler such as ``tcp://host:8786``, or a scheduler
    file; `threads` is the option that has no meaning beside it.
    """
    if where is None:
        yield None
        return
    expected = "it without --cluster"
    checks.expect(threads is None, "--threads", expected, "both", click.UsageError)
    dask = imported("distributed", "cluster")
    with ExitStack() as stack:
        address: Any = where if "://" in where else None
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
                address = stack.enter_context(local)
        elif address is None:
            file = Path(where)
            address = files.read_json(file).get("address")
            if not isinstance(address, str):
                problem = "expected a scheduler file of Dask, got no address in it"
                raise files.DamagedFileError(file, problem)
        client = stack.enter_context(
            dask.Client(address, timeout=CONNECT_SECONDS, set_as_default=False)
        )
        client.wait_for_workers(1, timeout=FIRST_WORKER_SECONDS)
        for worker, found in client.run(versions, on_error="return").items():
            expected = f"workers with the versions {versions()} of matrixworld and NumPy"
            same, got = found == versions(), f"{found!r} of {worker}"  # for the same results
            checks.expect(same, "--cluster", expected, got, click.ClickException)
        yield stack.enter_context(client.get_executor(pure=False))


def versions() -> tuple[str, str]:
    """Return what results depend on, besides settings and seeds."""
    return __version__, np.__version__
