"""Progress of runs in work: a tiny file for each, which any process may read.

The files are in ``.progress`` in the directory of a job. They are not needed to go on: they may be
missing or old.
"""

from __future__ import annotations

import json
import os
from dataclasses import asdict, dataclass
from pathlib import Path

PROGRESS = ".progress"
"""Name of the directory."""
SEPARATOR = "@"
"""Stands for the slash of a run's name, which cannot contain it."""
NEW = ".new"
"""Suffix of a file that is being written."""


@dataclass(frozen=True)
class RunProgress:
    """Progress of a run in work.

    Parameters
    ----------
    what : str
        What the run is doing.
    done, total : int
        Episodes that it has played, and all of them.
    before : int
        Episodes that it had played when its task began: those of an earlier start.
    """

    what: str
    done: int
    total: int
    before: int

    @property
    def share(self) -> float:
        """The part of the run that is done, from 0 to 1."""
        return self.done / max(self.total, 1)


def write_progress(directory: Path, name: str, progress: RunProgress) -> None:
    """Write the progress of a run, in one step."""
    file = _file(directory, name)
    temporary = file.with_name(file.name + NEW)
    # Not by `files.replacing`: it syncs, and this file may be lost.
    try:
        file.parent.mkdir(exist_ok=True)
        temporary.write_text(json.dumps(asdict(progress)), encoding="utf-8")
        os.replace(temporary, file)
    except OSError:
        return  # a full disk is reported by the run itself, which writes files that matter


def clear_progress(directory: Path, name: str) -> None:
    """Remove the file of a run that is no longer in work."""
    _file(directory, name).unlink(missing_ok=True)


def read_progress(directory: Path) -> dict[str, RunProgress]:
    """Return the progress of all runs in work, by name, in the order of the names."""
    try:
        # One listing, although there may be a thousand runs that have not begun.
        files = sorted((directory / PROGRESS).iterdir())
    except FileNotFoundError:
        return {}
    found = {file.name.replace(SEPARATOR, "/"): _read(file) for file in files}
    return {name: each for name, each in found.items() if each is not None}


def _read(file: Path) -> RunProgress | None:
    try:
        return RunProgress(**json.loads(file.read_text(encoding="utf-8")))
    except (OSError, TypeError, ValueError):
        return None  # being written or removed, or left by a killed process


def remove_progress(directory: Path) -> None:
    """Remove the files of all runs, and their directory."""
    folder = directory / PROGRESS
    if folder.is_dir():
        for file in folder.iterdir():
            file.unlink(missing_ok=True)
        folder.rmdir()


def _file(directory: Path, name: str) -> Path:
    return directory / PROGRESS / name.replace("/", SEPARATOR)
