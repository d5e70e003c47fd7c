"""What students hand in: programs and genomes in the directory of a class, and what is neither.

A submission is ``NAME.py``, ``NAME.npz``, or a file of these kinds in a directory ``NAME/``, as
learning platforms pack them. A file from a stranger may be no regular file, of any size, and hold
anything: limits are checked before it is read or expanded. Nothing is run or unpickled here, links
are not followed, and nothing is allocated that a file merely claims to hold.
"""

from __future__ import annotations

import hashlib
import io
import math
import os
import sys
import unicodedata
import zipfile
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import IO, Any, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_choice
from matrixworld._util.files import (
    UNREADABLE,
    DamagedFileError,
    check_regular,
    one_line,
    save_arrays,
)
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.play import NetworkPolicy
from matrixworld.world.policy import Network, Population, TeamPolicy

FileKind: TypeAlias = Literal["program", "genome"]
FILE_KINDS: dict[str, FileKind] = {".py": "program", ".npz": "genome"}
"""Kinds of submissions by the suffix of the file."""

IGNORED = ("__pycache__", "__MACOSX", "Thumbs.db", "desktop.ini")
"""Files that systems leave behind, beside those whose names begin with a dot."""
MOST_FILES = 1000
"""The most files of a class."""
LONGEST_NAME = 60
"""The most characters of a name on the page."""
MOST_BYTES = {"genome": 8 * 2**20, "program": 2**18}
"""Most bytes of a file: a default genome has 48 kB, one with the published layers 1 MB."""


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
    def key(self) -> tuple[int, ...]:
        """Numbers that depend on what plays and on its team, not on its name or place."""
        policy = self.policy
        if isinstance(policy, str):
            content = policy.encode()
        else:
            content = policy if isinstance(policy, bytes) else policy.genomes.tobytes()
        digest = hashlib.sha256(self.team.encode() + content).digest()
        return tuple(int.from_bytes(digest[at : at + 4], "little") for at in range(0, 16, 4))


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
    for number, (name, path) in enumerate(_files(directory)):
        if number == MOST_FILES:
            raise ValueError(f"{directory}: expected at most {MOST_FILES} files, got more")
        file, shown = one_line(path.relative_to(directory)), _display_name(name)
        try:
            submissions.append(Submission(shown, file, *read_file(path), path))
        except DamagedFileError as error:
            refusals.append(Refusal(shown, file, without_path(error)))
        except OSError as error:
            refusals.append(Refusal(shown, file, f"cannot be read: {error.strerror}"))
    return submissions, refusals


def _files(directory: Path) -> Iterator[tuple[str, Path]]:
    """Yield the name of the student and the path of every file that was handed in."""
    for path in _listed(directory):
        if not path.is_symlink() and path.is_dir():
            for inner in _listed(path):
                yield path.name, inner
        else:
            yield path.stem, path


def _listed(directory: Path) -> list[Path]:
    return sorted(
        path
        for path in directory.iterdir()
        if not path.name.startswith(".") and path.name not in IGNORED
    )


def without_path(error: DamagedFileError) -> str:
    """Return what is wrong with a file, without its path: students know their file's name."""
    return one_line(error.args[1])


def _display_name(name: str) -> str:
    line = one_line(name)
    return line if len(line) <= LONGEST_NAME else f"{line[:LONGEST_NAME]}..."


def without_rivals(entries: list[Entry]) -> tuple[list[Entry], list[Refusal]]:
    """Refuse all entries of a student who handed in several for one team."""
    groups: dict[tuple[str, Team], list[Entry]] = {}
    for entry in entries:
        groups.setdefault(_student_and_team(entry), []).append(entry)
    kept = [entry for entry in entries if len(groups[_student_and_team(entry)]) == 1]
    refusals = [
        Refusal(
            entry.name,
            entry.file,
            f"expected one policy for the {team}s of {entry.name}, got {len(group)}: "
            f"{', '.join(each.file for each in group)}",
        )
        for (_, team), group in groups.items()
        if len(group) > 1
        for entry in group
    ]
    return kept, refusals


def _student_and_team(entry: Entry) -> tuple[str, Team]:
    """Return student and team of an entry; the case and the form of a name do not matter."""
    return unicodedata.normalize("NFKC", entry.name).casefold().strip(), entry.team


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


# ---- A genome as a file --------------------------------------------------------------------------

GENOME_FORMS = {
    "genome": ("f", 1),
    "hidden": ("iuf", 1),  # an empty list is an array of floats
    "activation": ("U", 0),
    "fov": ("iu", 0),
    "n_actions": ("iu", 0),
    "sampled": ("b", 0),
    "team": ("U", 0),
}
"""Kinds of dtypes, as ``dtype.kind``, and number of dimensions of each array."""
MOST_LAYERS = 16
"""The most hidden layers: a million layers of one unit would fit into a file, and take hours."""
MOST_UNPACKED = 256 * 2**20
"""Most bytes of the arrays in a compressed file."""
MOST_MEMBERS = 100
"""Most arrays in a file; a genome's has seven."""

_COMPRESSIONS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)  # others may need any memory
_ENTRY = b"PK\x01\x02"  # begin of an entry in the directory of a zip archive
_HEADERS: dict[tuple[int, int], Any] = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}


def save_genome(path: str | os.PathLike[str], team: Team, policy: NetworkPolicy) -> None:
    """Write a policy as a file that `matrixworld class` plays.

    Parameters
    ----------
    path : str or path
        The file, which is replaced if it exists.
    team : {"pursuer", "evader"}
        The team for which it plays.
    policy : NetworkPolicy
        The policy, such as ``open_run(directory).policy("pursuer")``.

    Raises
    ------
    ValueError
        If there is no such team.
    """
    check_choice("team", team, TEAMS)
    save_arrays(
        Path(path),
        {
            **asdict(policy.network),
            "hidden": np.array(policy.network.hidden, np.int64),
            "genome": policy.genome,
            "team": team,
        },
    )


def read_genome(path: Path, content: bytes) -> tuple[Team, Population]:
    """Return the team of a genome's file, and the genome as a population of one.

    `save_genome` writes such files, and ``numpy.savez`` with the same keys. DamagedFileError if the
    content is damaged, too large, or not of this form.
    """
    try:
        arrays = _arrays(content)
    except UNREADABLE as error:
        raise DamagedFileError(path, f"cut, altered or not an npz file ({error})") from error
    team, layers = str(arrays["team"]), len(arrays["hidden"])
    if layers > MOST_LAYERS:
        raise DamagedFileError(path, f"hidden: expected at most {MOST_LAYERS} layers, got {layers}")
    try:
        check_choice("team", team, TEAMS)
        network = Network(
            tuple(int(size) for size in arrays["hidden"]),
            activation=str(arrays["activation"]),  # type: ignore[arg-type]
            fov=int(arrays["fov"]),
            n_actions=int(arrays["n_actions"]),
            sampled=bool(arrays["sampled"]),
        )
        return team, Population(arrays["genome"], network)  # type: ignore[return-value]
    except (OverflowError, TypeError, ValueError) as error:
        raise DamagedFileError(path, str(error)) from error


def _arrays(content: bytes) -> dict[str, NDArray[Any]]:
    """Return the arrays of a genome in the content of an npz file."""
    if content.count(_ENTRY) > MOST_MEMBERS:
        raise ValueError(f"expected at most {MOST_MEMBERS} arrays, got more")
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        # The archive's directory tells the sizes, and zipfile expands no more than it tells.
        size = sum(member.file_size for member in archive.infolist())
        if size > MOST_UNPACKED:
            raise ValueError(f"expected arrays of at most {MOST_UNPACKED:,} bytes, got {size:,}")
        return {name: _array(archive, name, *form) for name, form in GENOME_FORMS.items()}


def _array(archive: zipfile.ZipFile, name: str, kinds: str, ndim: int) -> NDArray[Any]:
    """Return an array, whose header is checked first."""
    if f"{name}.npy" not in archive.namelist():
        there = ", ".join(each.removesuffix(".npy") for each in archive.namelist())
        raise ValueError(f"expected an array {name!r}, got {there}")
    member = archive.getinfo(f"{name}.npy")
    if member.compress_type not in _COMPRESSIONS:
        raise ValueError(f"{name}: expected deflate or no compression")
    with archive.open(member) as file:
        shape, dtype = _header(file)
        if dtype.kind not in kinds or len(shape) != ndim:
            expected = f"expected dtype of kind {kinds} and {ndim} dimensions"
            raise ValueError(f"{name}: {expected}, got dtype {dtype} and shape {shape}")
        # A header may claim any shape: NumPy would allocate it before it reads the numbers.
        claimed, held = math.prod(shape) * dtype.itemsize, member.file_size - file.tell()
        if claimed != held:
            raise ValueError(f"{name}: expected {claimed:,} bytes, got {held:,}")
        file.seek(0)
        array: NDArray[Any] = np.lib.format.read_array(file, allow_pickle=False)
        return array


def _header(file: IO[bytes]) -> tuple[tuple[int, ...], np.dtype[Any]]:
    """Return shape and dtype of an array from its header."""
    version = np.lib.format.read_magic(file)
    if version not in _HEADERS:
        raise ValueError(f"expected an array of version 1.0 or 2.0, got {version}")
    try:
        shape, _, dtype = _HEADERS[version](file)
    except MemoryError:  # of Python's parser, in which the header is deeper than its stack
        raise ValueError("expected the header of an array, got deeper nested text") from None
    return shape, dtype
