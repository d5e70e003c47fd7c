"""Run directories as arguments and options of commands (callbacks of Click)."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from matrixworld.coevolution import (
    ALTERNATING,
    HALL_OF_FAME,
    SCHEDULES,
    DamagedFileError,
    LockedError,
    OtherVersionError,
)
from matrixworld.coevolution.storage.run_directory import CONFIG
from matrixworld.policy import SCRIPTS

UNMADE = ".unmade"
"""A file in a directory of several runs until the last of them has been made."""

ORDER = [*SCHEDULES, ALTERNATING, HALL_OF_FAME]
"""The order in which the runs of one job are played and shown."""

threads_option = click.option(
    "--threads",
    type=click.IntRange(min=1),
    metavar="INTEGER",
    help="threads; no result depends on them  [default: one a core]",
)


def find_runs(path: Path) -> list[Path]:
    """The run that a directory is, or the runs directly in it; empty if there are none."""
    if (path / CONFIG).is_file():
        return [path]
    return sorted((file.parent for file in path.glob(f"*/{CONFIG}")), key=_place)


def _place(run: Path) -> tuple[int, str]:
    return ORDER.index(run.name) if run.name in ORDER else len(ORDER), run.name


def check_made(path: Path) -> None:
    """Raise click.UsageError if only some of the runs in a directory have been made."""
    if (path / UNMADE).exists():
        raise click.UsageError(
            f"{path}: was stopped while its runs were being made, before any of them had begun; "
            f"delete it and start again"
        )


def runs_of(ctx: click.Context, param: click.Parameter, value: str | None) -> list[Path]:
    """The runs of a directory that is a run or holds some."""
    if value is None:
        return []
    runs = find_runs(Path(value))
    check_made(Path(value))
    if not runs:
        raise click.BadParameter(f"expected a directory that holds a run, got {value!r}")
    return runs


def run_of(ctx: click.Context, param: click.Parameter, value: str | None) -> Path | None:
    """The run of a directory that is a run or holds exactly one."""
    runs = runs_of(ctx, param, value)
    if len(runs) > 1:
        names = ", ".join(str(run) for run in runs)
        raise click.BadParameter(f"expected one run, got a directory of several: {names}")
    return runs[0] if runs else None


def opponent_of(ctx: click.Context, param: click.Parameter, value: str | None) -> str | None:
    """The name of a script, or the path of a run."""
    if value is None or value in SCRIPTS:
        return value
    if not find_runs(Path(value)):
        scripts = ", ".join(SCRIPTS)
        raise click.BadParameter(f"expected {scripts} or a run directory, got {value!r}")
    return str(run_of(ctx, param, value))


@contextmanager
def failures() -> Iterator[None]:
    """End the command with a message, not a traceback, on what a user's files can cause."""
    try:
        yield
    except (DamagedFileError, OtherVersionError, LockedError, OSError) as error:
        raise click.ClickException(str(error)) from error
