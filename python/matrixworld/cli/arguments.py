"""Run directories as arguments of commands, and errors that a user's files can cause."""

from __future__ import annotations

import re
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor
from contextlib import contextmanager
from pathlib import Path, PurePath

import click

from matrixworld._util.checks import OutOfMemoryError
from matrixworld._util.files import DamagedFileError, LockedError
from matrixworld.cli.console import command
from matrixworld.coevolution.jobs import JOB, FailedRunsError
from matrixworld.coevolution.learners.learner import DivergedError
from matrixworld.coevolution.schedules import ALTERNATING, HALL_OF_FAME, PSRO, SCHEDULES
from matrixworld.coevolution.storage import OtherVersionError, run_directories
from matrixworld.version import MissingExtraError

# From the newest opponents only to those of all generations: the generalists are the last schedule.
ORDER = [*list(SCHEDULES)[:-1], HALL_OF_FAME, list(SCHEDULES)[-1], PSRO, ALTERNATING]
"""The order in which the runs of one job are played and shown."""
SEED = r"seed-(\d+)"
"""Names of the directories of a job's runs."""
MOST_NAMES = 5
"""Most runs that a message names."""


def find_runs(path: Path) -> list[Path]:
    """Return `path` if it is a run directory, else the run directories one or two levels below."""
    found = run_directories(path)
    return sorted(found, key=lambda run: place_in_job(run.relative_to(path)))


def place_in_job(name: PurePath | str) -> tuple[tuple[int, int, str], ...]:
    """Return a sort key for the runs of one job, by the names of their directories."""
    return tuple(map(_place, PurePath(name).parts))


def _place(name: str) -> tuple[int, int, str]:
    # seed-2 comes before seed-10.
    seed = re.fullmatch(SEED, name)
    schedule = ORDER.index(name) if name in ORDER else len(ORDER)
    return schedule, int(seed[1]) if seed else -1, name


def run_name(path: Path) -> str:
    """Return what a run is called: its directory, or in a job the folder of its seeds."""
    path = path.absolute()
    return path.parent.name if re.fullmatch(SEED, path.name) else path.name


def run_in(
    path: str,
    setting: str | None = None,
    expected: str = "a directory that holds a run",
    race: str | None = None,
) -> Path:
    """Return the run of a directory that is one or holds exactly one; else name the setting.

    Of several runs `race` chooses the one below the directory of this name.
    """
    runs = find_runs(Path(path))
    wanted = None if race is None else PurePath(race).parts
    chosen = [run for run in runs if wanted is None or _named(run.relative_to(path), wanted)]
    if len(chosen) == 1:
        return chosen[0]
    if runs == [Path(path)]:
        raise click.UsageError(f"--race: expected a directory of several races, got the run {path}")
    got = repr(path)
    if runs and setting is None:
        below = [run.relative_to(path) for run in runs]
        # The seed is left out where there is one only.
        short = list(dict.fromkeys(name.parts[0] for name in below))
        known = short if len(short) == len(below) else list(map(str, below))
        listed = ", ".join([*known[:MOST_NAMES], *["..."] * (len(known) > MOST_NAMES)])
        raise click.UsageError(
            f"{path}: expected one of its {len(runs)} races, got {race or 'none'}; --race NAME "
            f"with {listed}"
        )
    if runs:
        expected = "one run"
        names = ", ".join([*map(str, runs[:MOST_NAMES]), *["..."] * (len(runs) > MOST_NAMES)])
        got = f"a directory of several: {names}"
    raise click.BadParameter(f"expected {expected}, got {got}", param_hint=setting)


def run_of(ctx: click.Context, param: click.Parameter, value: str | None) -> Path | None:
    """Return the run of a directory, as a callback of an argument; --race chooses among several."""
    return None if value is None else run_in(value, race=ctx.meta.get(RACE))


def _named(name: PurePath, wanted: tuple[str, ...]) -> bool:
    return bool(wanted) and wanted in (name.parts[: len(wanted)], name.parts[-len(wanted) :])


def _keep_race(ctx: click.Context, param: click.Parameter, value: str | None) -> None:
    if value is not None:
        ctx.meta[RACE] = value


RACE = "matrixworld.race"
"""Key in the context of a command that takes one run, of the race that is chosen."""

# Eager: the argument is read after it.
race_option = click.option(
    "--race",
    metavar="NAME",
    is_eager=True,
    expose_value=False,
    callback=_keep_race,
    help="which race of RUN, if it holds several, such as hall-of-fame or hall-of-fame/seed-3",
)


def can_resume(path: Path) -> bool:
    """Return whether a directory holds a run, or runs that have been asked for."""
    return bool(find_runs(path)) or (path / JOB).exists()


def resume_command(root: Path) -> str:
    """Return the command that continues the runs in a directory."""
    return command("evolve --resume", root)


FAILURES = (
    BrokenExecutor,  # a lost cluster
    DamagedFileError,
    DivergedError,
    FailedRunsError,
    LockedError,
    MissingExtraError,
    OSError,
    OtherVersionError,
    OutOfMemoryError,
)
"""Errors whose message says all that a user can do; any other one is a mistake in the program."""


@contextmanager
def failures() -> Iterator[None]:
    """End any command with a message, not a traceback, on errors of files and memory."""
    try:
        yield
    # Any other error is a mistake in the program, and its traceback is wanted.
    except BrokenPipeError:  # the reader of the output has gone, which click handles
        raise
    except FAILURES as error:
        raise click.ClickException(str(error)) from error
    except (ImportError, MemoryError) as error:
        if isinstance(error, ImportError) and "map segment" not in str(error):
            raise
        # Estimates count what grows with the options, and other programs take memory meanwhile.
        raise click.ClickException("this machine has too little memory for these sizes") from error
