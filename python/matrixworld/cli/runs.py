"""Runs as arguments of commands: directories of jobs or runs, several of them or exactly one."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path, PurePath
from tempfile import TemporaryDirectory
from typing import Any
from zipfile import BadZipFile, ZipFile

import click

from matrixworld.cli.console import command, note, print_wrapped
from matrixworld.cli.options import check_exists
from matrixworld.coevolution import SavedRun
from matrixworld.coevolution.groups import RunGroup, grouped, job_directory, open_groups
from matrixworld.coevolution.storage import find_runs

MOST_NAMES = 5
"""Most runs that a message names."""


def runs_argument() -> Callable[[Any], Any]:
    """Return the argument of directories of jobs or runs."""

    def found(ctx: click.Context, param: click.Parameter, values: Sequence[str]) -> list[Path]:
        paths = [unpacked(Path(value)) for value in dict.fromkeys(values)]
        for path in paths:
            check_exists(path)
            if not find_runs(path):
                raise click.BadParameter(f"expected run directories, got {str(path)!r}")
        return paths

    return click.argument("runs", nargs=-1, required=True, metavar="RUN...", callback=found)


def unpacked(path: Path) -> Path:
    """Return the directory of an archive that the page evolve.html has saved, unpacked beside it.

    Any other path is returned as it is. A directory that holds something else is not changed.
    """
    if path.suffix.lower() != ".zip" or not path.is_file():
        return path
    directory = path.with_suffix("")
    try:
        with ZipFile(path) as archive:
            if not directory.exists():
                with TemporaryDirectory(prefix=".", dir=path.parent) as place:
                    archive.extractall(Path(place) / "run")
                    # In one moment: a command that is killed leaves no half of a run.
                    (Path(place) / "run").rename(directory)
            for name in archive.namelist():
                file = directory / name
                if not file.exists() or (
                    file.is_file() and file.read_bytes() != archive.read(name)
                ):
                    raise click.BadParameter(
                        f"{path}: expected its own run in {directory}, got another {name} there, "
                        f"or none"
                    )
    except BadZipFile as error:
        raise click.BadParameter(f"{path}: expected an archive of a race, got: {error}") from error
    return directory


def finished_groups(directories: Sequence[Path], *, unfinished: bool = False) -> list[RunGroup]:
    """Return the groups of finished runs in directories; say which have none.

    With `unfinished` a single run need not be finished.
    """
    groups = open_groups(*directories)
    runs = [run for directory in directories for run in find_runs(directory)]
    if unfinished and len(runs) == 1:
        return grouped({runs[0]: SavedRun(runs[0]).settings}, finished=runs)
    if not any(group.runs for group in groups):
        again = resume_command(directories[0])
        raise click.UsageError(f"{directories[0]}: expected a finished run; {again} continues it")
    for group in groups:
        if not group.runs:
            note(f"{group.name}: no seed is finished yet, and it is left out")
    return [group for group in groups if group.runs]


def common_directory(directories: Sequence[Path]) -> Path:
    """Return where files about runs go: the directory that holds all of them."""
    if len(directories) == 1:
        return directories[0]
    common = Path(os.path.commonpath([path.absolute() for path in directories]))
    return common if directories[0].is_absolute() else Path(os.path.relpath(common))


def run_in(
    path: str | Path,
    setting: str | None = None,
    expected: str = "a directory that holds a run",
    race: str | None = None,
) -> Path:
    """Return the run of a directory, which a setting names or else an argument.

    Of several runs `race` chooses those below the directory of this name. The first one of them is
    taken, and a note says so; a setting has to name exactly one.
    """
    runs = {run.relative_to(path): run for run in find_runs(Path(path))}
    wanted = PurePath(race or "").parts
    size = len(wanted)
    chosen = [
        run for name, run in runs.items() if wanted in (name.parts[:size], name.parts[-size:])
    ]
    if len(chosen) == 1:
        return chosen[0]
    if not runs:
        check_exists(path, f"; expected {expected}", setting)
        raise click.BadParameter(f"expected {expected}, got {str(path)!r}", param_hint=setting)
    listed = ", ".join([*map(str, runs)][:MOST_NAMES]) + ", ..." * (len(runs) > MOST_NAMES)
    if chosen and setting is None:
        note(f"{chosen[0]}: the first of {len(chosen)} races; --race chooses another: {listed}")
        return chosen[0]
    if setting is not None:
        got = f"a directory of several: {listed}"
        raise click.BadParameter(f"expected one run, got {got}", param_hint=setting)
    raise click.UsageError(
        f"{path}: expected --race with one of its races, {listed}, got {race or 'none'}"
    )


def dashed_name(run: Path) -> str:
    """Return a name of a run for files: that of its job, and its own in the job."""
    path, job = run.absolute(), job_directory(run).absolute()
    return "-".join([job.name, *path.relative_to(job).parts])


def resume_command(root: Path) -> str:
    """Return the command that continues the runs in a directory."""
    return command("evolve --resume", root)


def print_missing(group: RunGroup) -> None:
    """Name the seeds of a group that are not finished, if there are any."""
    if group.missing:
        print_wrapped(f"Not finished: seeds {', '.join(map(str, group.missing))}.")


def seeds_finished(group: RunGroup) -> str:
    """Return how many seeds of a group are finished, such as "9 of 10 seeds finished"."""
    return f"{len(group.runs)} of {len(group.runs) + len(group.missing)} seeds finished"
