"""What lies in the directory of a class: programs and genomes, and what is neither.

A submission is ``NAME.py``, ``NAME.npz``, or a file of these kinds in a directory ``NAME/``, as
learning platforms pack them. Files are read here and never run; links are not followed.
"""

from __future__ import annotations

import hashlib
import sys
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Literal, TypeAlias

from matrixworld._util.reading import DamagedFileError, one_line
from matrixworld.classroom.untrusted import kind_of_file, read_content
from matrixworld.coevolution.types import Team
from matrixworld.world.policy import TeamPolicy

Kind: TypeAlias = Literal["program", "genome", "script"]
KINDS: dict[str, Literal["program", "genome"]] = {".py": "program", ".npz": "genome"}
"""Kinds of submissions by the suffix of the file."""

IGNORED = ("__pycache__", "__MACOSX", "Thumbs.db", "desktop.ini")
"""Files that systems leave behind, beside those whose names begin with a dot."""
MOST_FILES = 1000
"""The most files of a class."""
LONGEST_NAME = 60
"""The most characters of a name on the page."""


@dataclass(frozen=True)
class Submission:
    """A file that was handed in.

    Parameters
    ----------
    name : str
        Name of the student, as one line of printable characters.
    file : str
        Name of the file in the directory, as one line of printable characters.
    kind : {"program", "genome"}
        What it is.
    path : Path
        Where it is.
    content : bytes
        What it holds.
    """

    name: str
    file: str
    kind: Literal["program", "genome"]
    path: Path
    content: bytes


@dataclass(frozen=True)
class Refusal:
    """A file that does not play.

    Parameters
    ----------
    name : str
        Name of the student.
    file : str
        Name of the file.
    reason : str
        Why, for the student who handed it in.
    """

    name: str
    file: str
    reason: str


@dataclass(frozen=True, eq=False)
class Entry:
    """What plays for one team in the tournament.

    Parameters
    ----------
    name : str
        Name of the student, or of the script.
    team : {"pursuer", "evader"}
        The team.
    kind : {"program", "genome", "script"}
        What it is; scripts are the package's own, for comparison.
    file : str
        Name of the file; empty for a script.
    policy : bytes, Population or str
        The text of the program, the genome, or the name of the script.
    """

    name: str
    team: Team
    kind: Kind
    file: str
    policy: bytes | TeamPolicy

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


def read_submissions(directory: Path) -> tuple[list[Submission], list[Refusal]]:
    """Return what was handed in, and what cannot be read.

    Parameters
    ----------
    directory : Path
        The directory of the class.

    Returns
    -------
    submissions : list of Submission
        In the order of their files' names.
    refusals : list of Refusal
        In the same order.

    Raises
    ------
    OSError
        If the directory cannot be read.
    ValueError
        If it holds more than `MOST_FILES` files, or if Python imports modules from it: a submission
        of the name of a module would run here.
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
        file, shown = one_line(path.relative_to(directory)), display_name(name)
        problem = _problem(path)
        if not problem:
            try:
                content = read_content(path, KINDS[path.suffix.lower()])
                submissions.append(
                    Submission(shown, file, KINDS[path.suffix.lower()], path, content)
                )
                continue
            except DamagedFileError as error:
                problem = without_path(error)
            except OSError as error:
                problem = f"cannot be read: {error.strerror}"
        refusals.append(Refusal(shown, file, problem))
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


def _problem(path: Path) -> str:
    """Return why a path is no submission; empty if it may be one."""
    found = kind_of_file(path.lstat().st_mode)
    if found:
        return f"expected a file, got {found}"
    if path.suffix.lower() not in KINDS:
        return f"expected a file that ends in {' or '.join(KINDS)}"
    return ""


def without_path(error: DamagedFileError) -> str:
    """Return what is wrong with a file, without its path: students know their file's name."""
    return one_line(error.args[1])


def display_name(name: str) -> str:
    """Return a name as one short line of printable characters."""
    line = one_line(name)
    return line if len(line) <= LONGEST_NAME else f"{line[:LONGEST_NAME]}..."


def same_student(name: str) -> str:
    """Return what names of the same student have in common: case and form do not matter."""
    return unicodedata.normalize("NFKC", name).casefold().strip()


def without_rivals(entries: list[Entry]) -> tuple[list[Entry], list[Refusal]]:
    """Refuse all entries of a student who handed in several for one team.

    Parameters
    ----------
    entries : list of Entry
        Entries of students.

    Returns
    -------
    entries : list of Entry
        Those that are the only one of their student and team.
    refusals : list of Refusal
        One for each of the others.
    """
    groups: dict[tuple[str, Team], list[Entry]] = {}
    for entry in entries:
        groups.setdefault((same_student(entry.name), entry.team), []).append(entry)
    kept = [entry for entry in entries if len(groups[same_student(entry.name), entry.team]) == 1]
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
