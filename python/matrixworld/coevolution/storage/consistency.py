"""Which states of a run directory are legal: the files of a run are compared with each other.

A run saves its stage n, the number of finished stages, in this order:

1. log.csv, to which the rows of the stage are appended; each row states n;
2. pursuers.npy and evaders.npy, to which at most one genome each is appended;
3. checkpoint.npz, which states n, and how much of the other files belongs to it, with checksums.

A process may be killed at any moment. With checkpoint c there are two legal states: the other
files end where the checkpoint says; or the log goes on with rows of stage c + 1, not all of which
may be there, and each team may have one genome more, or a part of it. All others are mixtures of
several moments, such as a copy of a directory that lacks some files. summary.json, which is written
once at the end, states the last stage: behind it nothing follows.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from matrixworld._util.reading import Arrays, DamagedFileError, Form, check_arrays
from matrixworld.coevolution.storage.appended_file import Position, too_short
from matrixworld.coevolution.storage.genome_file import (
    GenomeFile,
    GenomePosition,
    file_size,
    head_of,
)
from matrixworld.coevolution.storage.run_log import rows_after
from matrixworld.coevolution.types import TEAMS

Result = TypeVar("Result")

STAGE = "stage"
"""Name of the number of finished stages, in the checkpoint and in the rows of the log."""
STAGES = "stages"
"""Name of the same number in the summary."""

COUNT: Form = ("iu", "")
SHAPE: Form = ("iu", "2")
TEXT: Form = ("U", "")
FORMS: dict[str, dict[str, Form]] = {
    "checkpoint": {
        STAGE: COUNT,
        "log_length": COUNT,
        "log_checksum": TEXT,
        **{f"{team}s": SHAPE for team in TEAMS},
        **{f"{team}s_checksum": TEXT for team in TEAMS},
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


def check_form(path: Path, name: str, arrays: Arrays) -> None:
    """Raise DamagedFileError unless a file `name` of a run holds what it must."""
    check_arrays(path, arrays, FORMS[name])
    for key, form in FORMS[name].items():
        if form in (COUNT, SHAPE) and arrays[key].min() < 0:
            raise DamagedFileError(path, f"{key}: expected at least 0, got {arrays[key]}")
        if form == SHAPE and arrays[key][0] and not arrays[key][1]:
            raise DamagedFileError(path, f"{key}: expected genomes with genes, got {arrays[key]}")
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


def check_last(path: Path, arrays: Arrays, summary: Path, stages: int) -> None:
    """Raise DamagedFileError unless the checkpoint of a finished run is of its last stage."""
    stage = int(arrays[STAGE])
    if stage != stages:
        older, newer = sorted([(stage, path), (stages, summary)])
        expected = f"expected stage {newer[0]}, got {older[0]}"
        raise DamagedFileError(older[1], f"older than {newer[1].name}, {expected}{SEVERAL}")


def check_log(log: Path, position: Position, checkpoint: Path, stage: int | None) -> bool:
    """Return whether the log goes on after a checkpoint, because a stage was being saved.

    Parameters
    ----------
    log : Path
        The log.
    position : Position
        Where it ends at the checkpoint. `read_log` raises an error for a shorter log.
    checkpoint : Path
        The checkpoint.
    stage : int, optional
        The stage that may follow; None if the run is finished.

    Raises
    ------
    DamagedFileError
        If the log goes on with something else than rows of this stage.
    """
    rows = rows_after(log, position)
    if rows and (stage is None or not _are_of(stage, rows)):
        allowed = "no more rows" if stage is None else f"no rows after stage {stage}"
        raise DamagedFileError(checkpoint, f"older than {log.name}, expected {allowed}{SEVERAL}")
    return bool(rows)


def _are_of(stage: int, rows: bytes) -> bool:
    """Return whether all rows, of which the last may be cut, begin with a stage."""
    mark = b"%d," % stage
    begin = rows.rfind(b"\n") + 1
    last = rows[begin : begin + len(mark)]
    found = rows.startswith(mark) + rows.count(b"\n" + mark)
    # Even the mark of the last row may be cut.
    return found == rows.count(b"\n") + (last == mark) and mark.startswith(last)


def check_genomes(path: Path, position: GenomePosition, checkpoint: Path, *, growing: bool) -> None:
    """Raise DamagedFileError unless a file of genomes ends where it may.

    Parameters
    ----------
    path : Path
        The file.
    position : GenomePosition
        Where it ends at the checkpoint.
    checkpoint : Path
        The checkpoint.
    growing : bool
        Whether a genome, or a part of it, may follow.
    """
    least = file_size(position)
    most = least + growing * position.genome_size
    found, head = 0, b""
    if path.exists():
        found, head = path.stat().st_size, GenomeFile(path).head()
    if found < least:
        raise too_short(path, least, found)
    if found > most:
        expected = f"expected a file of {most} bytes, got {found}"
        raise DamagedFileError(checkpoint, f"older than {path.name}, {expected}{SEVERAL}")
    shapes = [(position.genomes + more, position.genes) for more in range(growing + 1)]
    if least and head not in [head_of(*shape) for shape in shapes]:
        raise DamagedFileError(path, f"altered, expected a head with the shape {shapes[0]}")


def steady(read: Callable[[], Result], files: list[Path]) -> Result:
    """Return what `read` returns; repeat it when it fails while another process writes the files.

    Notes
    -----
    A run that is being saved lacks a file for a moment, and a reader may see the log of one save
    and the checkpoint of another. An error is therefore raised only if the files are the same
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
    return [version(path) for path in files]


def version(path: Path) -> tuple[int, int, int] | None:
    """Return what changes when a file is replaced or written to; None if there is none."""
    try:
        status = path.stat()
    except FileNotFoundError:
        return None
    return status.st_ino, status.st_size, status.st_mtime_ns
