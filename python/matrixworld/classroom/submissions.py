"""What students hand in: programs and genomes in the directory of a class, and what is neither.

A submission is ``NAME.py``, ``NAME.npz``, or a file of these kinds in a directory ``NAME/``, as
learning platforms pack them. Files are read here and never run; links are not followed.
"""

from __future__ import annotations

import hashlib
import os
import sys
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Literal, NamedTuple, TypeAlias

import numpy as np

from matrixworld._util.checks import check_choice
from matrixworld._util.files import DamagedFileError, one_line, save_arrays
from matrixworld.classroom.untrusted import Form, kind_of_file, read_arrays, read_content
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
MOST_LAYERS = 16
"""The most hidden layers: a million layers of one unit would fit into a file, and take hours."""


class Submission(NamedTuple):
    """A file that was handed in; names are lines of printable characters."""

    name: str  # of the student
    file: str  # in the directory
    kind: FileKind
    path: Path
    content: bytes


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
        problem = _problem(path)
        if not problem:
            kind = FILE_KINDS[path.suffix.lower()]
            try:
                content = read_content(path, kind)
                submissions.append(Submission(shown, file, kind, path, content))
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
    if path.suffix.lower() not in FILE_KINDS:
        return f"expected a file that ends in {' or '.join(FILE_KINDS)}"
    return ""


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


# ---- A genome as a file --------------------------------------------------------------------------

GENOME_FORMS: dict[str, Form] = {
    "genome": ("f", 1),
    "hidden": ("iuf", 1),  # an empty list is an array of floats
    "activation": ("U", 0),
    "fov": ("iu", 0),
    "n_actions": ("iu", 0),
    "sampled": ("b", 0),
    "team": ("U", 0),
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
    network = policy.network
    save_arrays(
        Path(path),
        {
            "genome": policy.genome,
            "hidden": np.array(network.hidden, np.int64),
            "activation": network.activation,
            "fov": network.fov,
            "n_actions": network.n_actions,
            "sampled": network.sampled,
            "team": team,
        },
    )


def load_genome(path: str | os.PathLike[str]) -> tuple[Team, Population]:
    """Return the team of a genome's file, and the genome as a population of one.

    `save_genome` writes such files, and ``numpy.savez`` with the same keys. DamagedFileError if the
    file is damaged, too large, or not of this form; OSError if it cannot be read.
    """
    file = Path(path)
    return genome_of(file, read_content(file, "genome"))


def genome_of(path: Path, content: bytes) -> tuple[Team, Population]:
    """Return team and genome in the content of a file, as `load_genome`."""
    arrays = read_arrays(path, content, GENOME_FORMS)
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
