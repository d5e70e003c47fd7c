"""Which states of a run directory are legal: the files of a run are compared with each other.

A run saves its stage n, the number of finished stages, in this order:

1. archive.npz, which states n;
2. log.csv, to which the rows of the stage are appended;
3. checkpoint.npz, which states n, the number of genomes, and length and checksum of the log.

A process may be killed after any of them. With archive a and checkpoint c there are two legal
states: a = c, and the log ends where the checkpoint says; or a = c + 1, and the log is that long or
longer. All others are mixtures of several moments, such as a copy of a directory that lacks some
files. summary.json, which is written once at the end, states the last stage: a finished run has no
other.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import numpy as np

from matrixworld.coevolution.types import TEAMS
from matrixworld.reading import Arrays, DamagedFileError, Form, check_arrays

Result = TypeVar("Result")

STAGE = "stage"
"""Name of the number of finished stages, in the archive and in the checkpoint."""
STAGES = "stages"
"""Name of the same number in the summary."""

GENOMES: dict[str, Form] = {"pursuers": ("f", "P genes"), "evaders": ("f", "E more")}
COUNT: Form = ("iu", "")
FORMS: dict[str, dict[str, Form]] = {
    "archive": {STAGE: COUNT, **GENOMES},
    "checkpoint": {
        STAGE: COUNT,
        **dict.fromkeys(GENOMES, COUNT),
        "log_length": COUNT,
        "log_checksum": ("U", ""),
    },
    "payoff": {
        "capture_rates": ("f", "G H n"),
        "lengths": ("iu", "G H n"),
        "collisions": ("f", "G H 2 3"),
        "faults": ("f", "G H 2 3"),
        "agent_steps": ("f", "G H 2"),
        "pursuer_survivors": ("f", "G H"),
        "evader_survivors": ("f", "G H"),
    },
}
"""Arrays that each file of a run must hold; see `check_arrays`."""

MOST = np.finfo(np.float64).max
"""Largest number of a payoff: it is finite."""
SEVERAL = "; the files are from several moments of the run"
COUNTS = (
    STAGES, "training_matches", "training_steps", "training_agent_steps", "evaluation_matches",
)  # fmt: skip
"""Entries of the summary, integers, of every kind of run."""
MEANS = [f"{name}{end}" for name in ("capture_rate", "length") for end in ("", "_std")]
ENDS = [f"{name}{end}" for name in ("capture_rate", "length") for end in ("_low", "_high")]
"""Entries of the summary of one team: numbers, and ends of intervals, which may be None."""

TRIES = 100
"""Most times that a read is repeated while another process changes the files."""


class Stated(NamedTuple):
    """A file, and the stage that it states."""

    path: Path
    stage: int


def stated(path: Path, arrays: Arrays) -> Stated:
    """Return the stage that a file states."""
    return Stated(path, int(arrays[STAGE]))


def check_form(path: Path, name: str, arrays: Arrays) -> None:
    """Raise DamagedFileError unless a file `name` of a run holds what it must."""
    check_arrays(path, arrays, FORMS[name])
    for key, form in FORMS[name].items():
        if form == COUNT and arrays[key] < 0:
            raise DamagedFileError(path, f"{key}: expected at least 0, got {arrays[key]}")
    if name == "payoff":
        _check_payoff(path, arrays)


def _check_payoff(path: Path, arrays: Arrays) -> None:
    for name in FORMS["payoff"]:
        array = arrays[name]
        if not array.size:
            raise DamagedFileError(path, f"{name}: expected at least one number, got none")
        low, high, most = array.min(), array.max(), 1.0 if name == "capture_rates" else MOST
        if not 0 <= low <= high <= most:  # NaN is not, either
            expected = f"numbers from 0 to {most:g}"
            raise DamagedFileError(path, f"{name}: expected {expected}, got {low} to {high}")


def check_summary(path: Path, kind: str, values: Mapping[str, Any]) -> None:
    """Raise DamagedFileError unless a summary has the entries that the package reads."""
    expected: dict[str, tuple[type, ...]] = dict.fromkeys(COUNTS, (int,))
    if kind == "single":
        expected |= dict.fromkeys(MEANS, (int, float))
        expected |= dict.fromkeys(ENDS, (int, float, type(None)))
    for name, kinds in expected.items():
        # Not isinstance: True is an int.
        if name not in values or type(values[name]) not in kinds:
            got = repr(values[name]) if name in values else "none"
            raise DamagedFileError(path, f"expected a number {name!r}, got {got}")


def check_same(file: Stated, last: Stated) -> None:
    """Raise DamagedFileError unless a file of a finished run states its last stage."""
    if file.stage != last.stage:
        older, newer = sorted((file, last), key=lambda each: each.stage)
        raise _older(older, newer, str(newer.stage))


def check_pair(archive: Stated, checkpoint: Stated) -> None:
    """Raise DamagedFileError unless archive and checkpoint may be of the same moment."""
    if archive.stage < checkpoint.stage:
        expected = f"{checkpoint.stage} or {checkpoint.stage + 1}"
        raise _older(archive, checkpoint, expected)
    if archive.stage > checkpoint.stage + 1:
        raise _older(checkpoint, archive, f"{archive.stage - 1} or {archive.stage}")


def _older(older: Stated, newer: Stated, expected: str) -> DamagedFileError:
    return DamagedFileError(
        older.path,
        f"older than {newer.path.name}, expected stage {expected}, got {older.stage}{SEVERAL}",
    )


def check_log(log: Path, length: int, archive: Stated, checkpoint: Stated) -> None:
    """Raise DamagedFileError if the log goes on, although the next stage was not being saved.

    Parameters
    ----------
    log : Path
        The log.
    length : int
        Its length at the checkpoint, in bytes. `read_log` raises an error for a shorter log.
    archive, checkpoint : Stated
        Their stages.
    """
    found = log.stat().st_size if log.exists() else 0
    if archive.stage == checkpoint.stage and found > length:
        raise DamagedFileError(
            checkpoint.path,
            f"older than {log.name}, expected a log of {found} bytes, got {length}{SEVERAL}",
        )


def counted(archive: Arrays, checkpoint: Arrays) -> bool:
    """Return whether an archive holds all genomes that a checkpoint counts."""
    names = [f"{team}s" for team in TEAMS]
    return all(0 <= int(checkpoint[name]) <= len(archive[name]) for name in names)


def steady(read: Callable[[], Result], files: list[Path]) -> Result:
    """Return what `read` returns; repeat it when it fails while another process writes the files.

    Notes
    -----
    A run that is being saved lacks a file for a moment, and a reader may see the archive of one
    save and the checkpoint of another. An error is therefore raised only if the files are the same
    before and after.
    """
    for _ in range(TRIES):
        before = _versions(files)
        try:
            return read()
        except (FileNotFoundError, DamagedFileError):
            if _versions(files) == before:
                raise
    return read()


def _versions(files: list[Path]) -> list[Any]:
    """Return what changes when files are replaced, appended to, made or removed."""
    return [_version(path) for path in files]


def _version(path: Path) -> tuple[int, int, int] | None:
    try:
        status = path.stat()
    except FileNotFoundError:
        return None
    return status.st_ino, status.st_size, status.st_mtime_ns
