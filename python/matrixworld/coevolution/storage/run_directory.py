"""The files of a run, to write: new runs, checkpoints and the lock.

One process writes to a directory, under its lock. `run_files` lists the files and reads them.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from matrixworld._util.files import (
    is_temporary,
    json_digest,
    locked,
    remove_temporary_files,
    save_arrays,
    save_json,
)
from matrixworld._util.reading import Arrays, DamagedFileError
from matrixworld.coevolution.storage.appended_file import Position
from matrixworld.coevolution.storage.consistency import STAGE
from matrixworld.coevolution.storage.genome_file import GenomeFile
from matrixworld.coevolution.storage.run_files import (
    CHECKPOINT,
    CONFIG,
    FORMAT,
    LOCK,
    LOG,
    PAYOFF,
    SUMMARY,
    Archive,
    RunFiles,
    genome_position,
    genomes_name,
    log_position,
)
from matrixworld.coevolution.storage.run_log import Row, RunLog
from matrixworld.coevolution.types import TEAMS, Genome, Genomes, Team
from matrixworld.version import __version__

INCOMPLETE = {LOCK, *map(genomes_name, TEAMS), "checkpoint.npz"}
"""Files that a process may leave, besides temporary ones, if it is killed while it makes a run."""

Problems = list[FileNotFoundError | DamagedFileError]


@dataclass(frozen=True)
class Checkpoint:
    """A restored checkpoint.

    Parameters
    ----------
    archive : dict of str to ndarray of float32, shape (generations, genes)
        Genomes of each team.
    state : dict of str to ndarray
        Arrays that were saved with it.
    """

    archive: Archive
    state: Arrays


class RunDirectory(RunFiles):
    """The files of one run; made by `create` for a new run and by `open` for an existing one.

    Parameters
    ----------
    path : Path
        The directory.
    """

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self._new_config: dict[str, Any] = {}
        self._log = RunLog(path / LOG)
        self._grown: dict[Team, GenomeFile] = {team: self._genomes(team) for team in TEAMS}

    @classmethod
    def create(
        cls, path: str | Path, kind: str, settings: Mapping[str, Any], **more: Any
    ) -> RunDirectory:
        """Return the directory of a new run, and make it if it does not exist.

        Parameters
        ----------
        path : str or Path
            The directory.
        kind, settings, **more
            Kind of run, settings and other entries of config.json, which `write_config` writes.

        Raises
        ------
        FileExistsError
            If the directory is not empty.
        """
        files = cls(Path(path))
        head = {"format": FORMAT, "matrixworld": __version__, "kind": kind}
        files._new_config = {**head, "settings": dict(settings), **more}
        files.path.mkdir(parents=True, exist_ok=True)
        files.check_empty()
        return files

    @classmethod
    def open(cls, path: str | Path) -> RunDirectory:
        """Return the directory of an existing run; FileNotFoundError if it holds no run."""
        path = Path(path)
        if not (path / CONFIG).is_file():
            raise FileNotFoundError(f"{path}: holds no run, expected a file {CONFIG}")
        return cls(path)

    @cached_property
    def _owner(self) -> str:
        """As in `RunFiles`, also before config.json is written."""
        return json_digest(self._new_config or self.config())

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the path alone: a copy reads from the directory what it needs."""
        return type(self), (self.path,)

    # Making a new run:

    def check_empty(self) -> None:
        """Raise FileExistsError if the directory is not empty.

        Notes
        -----
        Files of a run that was never completely made do not count. Its lock file shows that they
        are from such a run, and they hold no training yet.
        """
        found = sorted(item.name for item in self.path.iterdir())
        if LOCK in found:
            found = [name for name in found if name not in INCOMPLETE and not is_temporary(name)]
        if found:
            raise FileExistsError(
                f"{self.path}: expected a new or empty directory for a new run, found "
                f"{', '.join(found[:3])}{' ...' if len(found) > 3 else ''}"
            )

    def clear(self) -> None:
        """Remove the files that `check_empty` ignores. To be called under the lock."""
        # Again, because another process may have made a run before this one got the lock.
        self.check_empty()
        remove_temporary_files(self.path)
        for name in INCOMPLETE - {LOCK}:
            (self.path / name).unlink(missing_ok=True)

    def lock(self) -> AbstractContextManager[None]:
        """Hold the directory for writing; LockedError if another process does."""
        return locked(self.path / LOCK)

    def write_config(self) -> None:
        """Write config.json: the last file of a new run, with which the directory holds a run."""
        save_json(self.path / CONFIG, self._new_config)

    # Checkpoints:

    def save(
        self,
        archive: Mapping[Team, Genomes | Sequence[Genome]],
        rows: Sequence[Row],
        state: Mapping[str, Any],
    ) -> None:
        """Save new genomes, new rows of the log, and a checkpoint.

        Parameters
        ----------
        archive : mapping of str to array_like of float32, shape (generations, genes)
            All genomes of each team. Those that were saved before are not read again.
        rows : sequence of dict
            Rows of the log since the last checkpoint.
        state : mapping of str to array_like
            What `restore` has to return; ``stage`` is the number of finished stages.
        """
        # In the order that `consistency` explains. The checkpoint is written last: what the other
        # files hold beyond it is ignored.
        if rows:
            self._log.append([{**row, STAGE: state[STAGE]} for row in rows])
        for team, file in self._grown.items():
            file.append(archive[team][file.position.genomes :])
        counted = _counted(self._log.position, self._grown)
        path, owner = self._file(CHECKPOINT), self._owner_of(CHECKPOINT)
        save_arrays(path, {**state, **counted}, owner=owner, keep_as=self._previous(CHECKPOINT))

    def restore(self) -> Checkpoint:
        """Return the newest intact checkpoint, and truncate the log to it.

        To be called under the lock. A damaged file is reported by a warning and renamed to
        ``*.damaged``; the file before it is used instead, and becomes the newest.

        Raises
        ------
        DamagedFileError
            If no checkpoint is intact.
        """
        remove_temporary_files(self.path)
        problems: Problems = []
        for path in self._both(CHECKPOINT):
            found = self._fitting(path, problems)
            if found is not None:
                self._set_aside(problems)
                self._settle(path, found.state)
                return found
        # Each problem once, although a file is tried with both checkpoints.
        reasons = "; ".join(dict.fromkeys(str(problem) for problem in problems))
        raise DamagedFileError(self.path, f"no intact checkpoint to continue from: {reasons}")

    def _fitting(self, path: Path, problems: Problems) -> Checkpoint | None:
        """Return a checkpoint if everything that it counts is there."""
        try:
            state = self._load(path, CHECKPOINT)
            self._log.check(log_position(state))
            archive = {t: file.read(genome_position(state, t)) for t, file in self._grown.items()}
        except (FileNotFoundError, DamagedFileError) as error:
            problems.append(error)
            return None
        return Checkpoint(archive, state)

    def _set_aside(self, problems: Problems) -> None:
        """Rename a damaged checkpoint, so that no save keeps it as the previous one."""
        for problem in problems:
            if isinstance(problem, DamagedFileError):
                warnings.warn(f"{problem}; continuing from the checkpoint before it", stacklevel=4)
                if problem.path == self._file(CHECKPOINT) and problem.path.exists():
                    os.replace(problem.path, f"{problem.path}.damaged")

    def _settle(self, chosen: Path, state: Arrays) -> None:
        """Make a checkpoint the newest one, and remove what other files hold beyond it."""
        if chosen != self._file(CHECKPOINT):
            os.replace(chosen, self._file(CHECKPOINT))
        # The log last: genomes may be more than the checkpoint counts only if the log is longer.
        for team, file in self._grown.items():
            file.truncate(genome_position(state, team))
        self._log.truncate(log_position(state))

    def save_payoff(self, arrays: Mapping[str, NDArray[Any]]) -> None:
        """Write payoff.npz."""
        save_arrays(self._file(PAYOFF), arrays, owner=self._owner_of(PAYOFF))

    def save_summary(self, values: Mapping[str, Any]) -> None:
        """Write summary.json, the last file of a finished run."""
        save_json(self.path / SUMMARY, values, owner=self._owner_of(SUMMARY))


def _counted(log: Position, grown: Mapping[Team, GenomeFile]) -> dict[str, Any]:
    """Return what a checkpoint states about the files that grow."""
    counted: dict[str, Any] = {"log_length": log.length, "log_checksum": log.checksum}
    for team, file in grown.items():
        genomes, genes, checksum = file.position
        counted |= {f"{team}s": [genomes, genes], f"{team}s_checksum": checksum}
    return counted
