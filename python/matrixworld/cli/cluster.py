"""``--cluster``: work is done on a Dask cluster, one that exists or one of this machine's cores."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import click
import numpy as np

from matrixworld._util.checks import usable_cores
from matrixworld._util.files import DamagedFileError, read_json
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
    if threads is not None:
        raise click.UsageError("--threads: expected it without --cluster, got both")
    dask = imported("distributed", "cluster")
    with ExitStack() as stack:
        if where == AUTO:
            with without_interrupts():
                address: Any = stack.enter_context(dask.LocalCluster(**_local()))
        else:
            address = where if "://" in where else _address_in(Path(where))
        client = stack.enter_context(
            dask.Client(address, timeout=CONNECT_SECONDS, set_as_default=False)
        )
        client.wait_for_workers(1, timeout=FIRST_WORKER_SECONDS)
        _check_versions(client)
        yield stack.enter_context(client.get_executor(pure=False))


def versions() -> tuple[str, str]:
    """Return what results depend on, besides settings and seeds."""
    return __version__, np.__version__


def _check_versions(client: Any) -> None:
    """Refuse workers with other versions, which would give other results."""
    for address, found in client.run(versions, on_error="return").items():
        if found != versions():
            raise click.ClickException(
                f"--cluster: expected workers with the versions {versions()} of matrixworld and "
                f"NumPy, got {found!r} of {address}"
            )


def _local() -> dict[str, Any]:
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


def _address_in(file: Path) -> str:
    address = read_json(file).get("address")
    if not isinstance(address, str):
        raise DamagedFileError(file, "expected a scheduler file of Dask, got no address in it")
    return address


def _where(ctx: click.Context, param: click.Parameter, value: str | None) -> str | None:
    if value not in (None, AUTO) and "://" not in value and not Path(value).is_file():
        expected = f"{AUTO}, an address such as tcp://HOST:8786 or a scheduler file"
        got = repr(value) if Path(value).exists() else f"{value}: no such file or directory"
        raise click.BadParameter(f"expected {expected}, got {got}")
    return value


cluster_option = click.option(
    "--cluster",
    "where",
    metavar="auto|ADDRESS|FILE",
    callback=_where,
    help="play on a Dask cluster: auto (this machine), tcp://HOST:8786, or a scheduler file",
)
