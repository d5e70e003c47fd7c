"""The option ``--cluster``: an executor for commands that can share their work."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from pathlib import Path

import click

from matrixworld.cli.console import note
from matrixworld.cluster import UnfitWorkerError, check_where, cluster
from matrixworld.coevolution import RaceSettings


def _where(ctx: click.Context, param: click.Parameter, value: str | None) -> str | None:
    if value is not None:
        try:
            check_where(value)
        except ValueError as error:
            raise click.BadParameter(str(error).removeprefix("cluster: ")) from error
    return value


cluster_option = click.option(
    "--cluster",
    "where",
    metavar="auto|ADDRESS|FILE",
    callback=_where,
    help="play on a Dask cluster: auto (this machine), tcp://HOST:8786, or a scheduler file",
)


def refuse_threads(where: str | None, threads: int | None) -> None:
    """Raise click.UsageError if ``--threads`` is given beside ``--cluster``."""
    if where is not None and threads is not None:
        raise click.UsageError("--threads: expected it without --cluster, got both")


@contextmanager
def on_cluster(
    where: str | None,
    threads: int | None,
    directory: Path | None = None,
    settings: Iterable[RaceSettings] = (),
) -> Iterator[Executor | None]:
    """Yield the executor that ``--cluster`` asks for, or None without it.

    `directory` is what the work reads and writes, `settings` are those of the runs to play.
    """
    if where is None:
        yield None
        return
    refuse_threads(where, threads)
    alike = any(each.learner.rounds_by_processor for each in settings)
    try:
        with cluster(where, directory=directory, like_processors=alike, tell=note) as executor:
            yield executor
    except (ImportError, UnfitWorkerError) as error:
        raise click.ClickException(str(error)) from error
