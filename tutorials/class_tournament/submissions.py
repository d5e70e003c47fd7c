"""What students hand in: programs, genomes and predictions in the directory of a class.

A submission is ``NAME.py``, ``NAME.npz``, ``NAME.jsonl``, or a file of these kinds in a directory
``NAME/``, as learning platforms pack them. A file from a stranger may be no regular file, of any
size, and hold anything: limits are checked before it is read or expanded. Nothing is run or
unpickled here, links are not followed, and nothing is allocated that a file merely claims to hold.
"""

from __future__ import annotations

import hashlib
import io
import math
import os
import re
import sys
import unicodedata
import zipfile
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from pathlib import Path
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np

from matrixworld._util.files import DamagedFileError, check_regular, one_line
from matrixworld.play import policies
from matrixworld.world.policy import Population, Team, TeamPolicy

FileKind: TypeAlias = Literal["program", "genome", "predictions"]
FILE_KINDS: dict[str, FileKind] = {".py": "program", ".npz": "genome", ".jsonl": "predictions"}
"""Kinds of submissions by the suffix of the file."""

IGNORED = ("__pycache__", "__MACOSX", "Thumbs.db", "desktop.ini")
"""Files that systems leave behind, beside those whose names begin with a dot."""
MOST_FILES = 1000
"""The most files of a class."""
MOST_OWN = 20
"""The most files in the directory of a student."""
LONGEST_NAME = 60
"""The most characters of a name on the page."""
PLATFORMS = (
    r"(?P<student>.+)_(?P<number>\d+)_assignsubmission_.+",  # Moodle
    r"(?P<student>[^_]+)_(?:LATE_)?(?P<number>\d{3,})_\d{3,}_.+",  # Canvas
    r"(?P<number>\d+)-\d+ - (?P<student>.+?) - .+",  # Brightspace
    r".+_(?P<student>(?P<number>[^_]+))_attempt_\d{4}(?:-\d\d){5}.*",  # Blackboard
)
"""Names that learning platforms give to files and directories: the student, and the number by which
the platform knows students (Blackboard: by their user names)."""
MOST_BYTES = {"genome": 8 * 2**20, "program": 2**18, "predictions": 2**16}
"""Most bytes of a file: a default genome has 48 kB, one with the published layers 1 MB, and the
predictions of the whole course 4 kB."""


class Submission(NamedTuple):
    """A file that was handed in; names are lines of printable characters."""

    name: str  # of the student
    file: str  # in the directory
    kind: FileKind
    content: bytes
    path: Path


@dataclass(frozen=True)
class Refusal:
    """A file that does not play."""

    name: str  # of the student
    file: str
    reason: str  # for the student who handed it in


@dataclass(frozen=True, eq=False)
class Entry:
    """What plays for one team; scripts are the package's own, for comparison."""

    name: str  # of the student, or of the script
    team: Team
    kind: Literal["program", "genome", "script"]
    file: str  # empty for a script
    policy: bytes | TeamPolicy  # the text of the program, the genome, or the name of the script

    @cached_property
    def key(self) -> str:
        """Depends on what plays and on its team, not on its name or place."""
        content = self.policy.encode() if isinstance(self.policy, str) else self.policy
        if isinstance(content, Population):
            content = content.genomes.tobytes()
        return hashlib.sha256(self.team.encode() + content).hexdigest()


# ---- The directory of a class --------------------------------------------------------------------


def read_submissions(directory: Path) -> tuple[list[Submission], list[Refusal]]:
    """Return what was handed in, and what cannot be read, in the order of the files' names.

    ValueError if there are more than `MOST_FILES`, or if Python imports modules from the directory:
    a submission of the name of a module would run here.
    """
    if any(Path(place).resolve() == directory.resolve() for place in sys.path):
        raise ValueError(
            f"{directory}: expected a directory from which Python imports nothing, got one of "
            f"sys.path; start Python elsewhere"
        )
    submissions: list[Submission] = []
    refusals: list[Refusal] = []
    listed = _listed(directory, MOST_FILES)
    names = students([_own_name(path) for path in listed])
    for path in listed:
        name = _shown_name(names[_own_name(path)])
        try:
            is_directory = not path.is_symlink() and path.is_dir()
            files = _listed(path, MOST_OWN) if is_directory else [path]
        except (DamagedFileError, OSError) as error:
            refusals.append(Refusal(name, one_line(path.name), reason_of(error)))
            continue
        for file in files:
            shown = one_line(file.relative_to(directory))
            try:
                submissions.append(Submission(name, shown, *read_file(file), file))
            except (DamagedFileError, OSError) as error:
                refusals.append(Refusal(name, shown, reason_of(error)))
        if len(submissions) + len(refusals) > MOST_FILES:
            raise ValueError(f"{directory}: expected at most {MOST_FILES} files, got more")
    return submissions, refusals


def _own_name(path: Path) -> str:
    """Return the name of a student's file or directory without the suffix of a submission."""
    return path.stem if path.suffix.lower() in FILE_KINDS else path.name


def students(names: Sequence[str]) -> dict[str, str]:
    """Return the name of the student by that of each file or directory.

    It is the part that a learning platform has put there, unless two students have the same.
    """
    short: dict[str, str] = {}
    numbers: defaultdict[str, set[str]] = defaultdict(set)
    for name in names:
        matches = (re.fullmatch(form, name, re.ASCII) for form in PLATFORMS)
        match = next(filter(None, matches), None)
        short[name] = match["student"].strip() if match else name
        numbers[folded(short[name])].add(match["number"] if match else "")
    return {
        name: student if len(numbers[folded(student)]) == 1 else name
        for name, student in short.items()
    }


def _listed(directory: Path, most: int) -> list[Path]:
    """Return what a directory holds, in order; DamagedFileError if that is more than `most`."""
    with os.scandir(directory) as entries:
        every = (entry.name for entry in entries)
        relevant = (name for name in every if not name.startswith(".") and name not in IGNORED)
        names = sorted(islice(relevant, most + 1))
    if len(names) > most:
        raise DamagedFileError(directory, f"expected at most {most} files, got more")
    return [directory / name for name in names]


def reason_of(error: Exception) -> str:
    """Return what is wrong with a file, without its path: students know their file's name."""
    if isinstance(error, OSError):
        return f"cannot be read: {error.strerror}"
    return one_line(error.args[1] if isinstance(error, DamagedFileError) else error)


def _shown_name(name: str) -> str:
    """Return a name as a line; with a checksum where it had to be changed, as others look alike."""
    line = one_line(name)
    if line == name and len(line) <= LONGEST_NAME:
        return line
    digest = hashlib.sha256(name.encode(errors="surrogateescape")).hexdigest()
    return f"{line[:LONGEST_NAME]} #{digest[:8]}"


def without_rivals(entries: Sequence[Entry]) -> tuple[list[Entry], list[Refusal]]:
    """Refuse all entries of a student who handed in several for one team."""
    groups: defaultdict[tuple[str, Team], list[Entry]] = defaultdict(list)
    for entry in entries:
        groups[folded(entry.name), entry.team].append(entry)
    kept: list[Entry] = []
    refusals: list[Refusal] = []
    for entry in entries:
        files = [rival.file for rival in groups[folded(entry.name), entry.team]]
        if len(files) == 1:
            kept.append(entry)
        else:
            expected = f"expected one policy for the {entry.team}s of {entry.name}"
            reason = f"{expected}, got {len(files)}: {', '.join(files)}"
            refusals.append(Refusal(entry.name, entry.file, reason))
    return kept, refusals


def folded(name: str) -> str:
    """Return a name whose case and form do not matter."""
    return unicodedata.normalize("NFKC", name).casefold().strip()


# ---- Reading a file ------------------------------------------------------------------------------


def read_file(path: Path) -> tuple[FileKind, bytes]:
    """Return kind and content of a submission.

    DamagedFileError if it is not regular, of another kind or too large, OSError if it cannot be
    opened.
    """
    # Before it is opened, too: a socket cannot be opened, and opening a device can have effects.
    check_regular(path, path.lstat().st_mode)
    if path.suffix.lower() not in FILE_KINDS:
        expected = f"expected a file that ends in {' or '.join(FILE_KINDS)}"
        raise DamagedFileError(path, expected)
    kind = FILE_KINDS[path.suffix.lower()]
    # Another file may take the name in between, and opening a FIFO must not wait for its writer.
    flags = ("O_NONBLOCK", "O_NOFOLLOW", "O_BINARY")
    handle = os.open(path, os.O_RDONLY | sum(getattr(os, flag, 0) for flag in flags))
    with open(handle, "rb") as file:
        status = os.fstat(handle)
        check_regular(path, status.st_mode)
        if status.st_size > MOST_BYTES[kind]:
            expected = f"expected at most {MOST_BYTES[kind]:,} bytes ({kind})"
            raise DamagedFileError(path, f"{expected}, got {status.st_size:,}")
        return kind, file.read(status.st_size)


# ---- A genome ------------------------------------------------------------------------------------

MOST_VALUES = 16
"""The most hidden layers, or inputs: a million layers would fit into a file, and take hours."""
MOST_UNPACKED = MOST_BYTES["genome"]
"""Most bytes of the arrays in a compressed file."""
MOST_MEMBERS = 100
"""Most arrays in a file; a genome's has nine at most."""

_COMPRESSIONS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)  # others may need any memory
_ENTRY = b"PK\x01\x02"  # begin of an entry in the directory of a zip archive
_HEADERS: dict[tuple[int, int], Any] = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}


def read_genome(path: Path, content: bytes) -> tuple[Team, Population]:
    """Return the team of a genome's file, and the genome as a population of one.

    DamagedFileError if the content is damaged, too large, or no genome.
    """
    try:
        _check_archive(content)
    except Exception as error:
        raise DamagedFileError(path, f"cut, altered or not an npz file ({error})") from error
    return policies.read_genome(path, content)


def _check_archive(content: bytes) -> None:
    """Raise ValueError for an archive that would expand to, or claims, more than a genome needs."""
    if content.count(_ENTRY) > MOST_MEMBERS:
        raise ValueError(f"expected at most {MOST_MEMBERS} arrays, got more")
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        members = archive.infolist()
        # The archive's directory tells the sizes, and zipfile expands no more than it tells.
        size = sum(member.file_size for member in members)
        if size > MOST_UNPACKED:
            raise ValueError(f"expected arrays of at most {MOST_UNPACKED:,} bytes, got {size:,}")
        for member in members:
            if member.compress_type not in _COMPRESSIONS:
                raise ValueError(f"{member.filename}: expected deflate or no compression")
            with archive.open(member) as file:
                shape, _, dtype = _HEADERS[np.lib.format.read_magic(file)](file)
                held = member.file_size - file.tell()
            # A header may claim any shape: NumPy would allocate it before it reads the numbers.
            claimed = math.prod(shape) * dtype.itemsize
            if dtype.hasobject or dtype.itemsize == 0 or claimed != held:
                expected = f"expected {held:,} bytes of numbers or text"
                got = f"dtype {dtype} and shape {shape}"
                raise ValueError(f"{member.filename}: {expected}, got {got}")
            name, count = member.filename.removesuffix(".npy"), math.prod(shape)
            if name != "genome" and count > MOST_VALUES:
                raise ValueError(f"{name}: expected at most {MOST_VALUES} values, got {count}")
