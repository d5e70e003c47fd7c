"""The files of a run, to write: new runs, checkpoints and the lock.

One process writes to a directory, under its lock. `run_files` lists the files and reads them.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from matrixworld.coevolution.storage.consistency import STAGE, counted
from matrixworld.coevolution.storage.run_files import (
    ARCHIVE,
    CHECKPOINT,
    CONFIG,
    FORMAT,
    LOCK,
    LOG,
    PAYOFF,
    SUMMARY,
    Archive,
    RunFiles,
    archive_at,
    log_position,
)
from matrixworld.coevolution.storage.run_log import Row, RunLog
from matrixworld.coevolution.types import TEAMS
from matrixworld.files import (
    is_temporary,
    json_digest,
    locked,
    remove_temporary_files,
    save_arrays,
    save_json,
)
from matrixworld.reading import Arrays, DamagedFileError
from matrixworld.version import __version__

INCOMPLETE = {LOCK, "archive.npz", "checkpoint.npz"}
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

    def save(self, archive: Archive, rows: Sequence[Row], state: Mapping[str, Any]) -> None:
        """Save the archive, new rows of the log, and a checkpoint.

        Parameters
        ----------
        archive : dict of str to ndarray of float32, shape (generations, genes)
            Genomes of each team.
        rows : sequence of dict
            Rows of the log since the last checkpoint.
        state : mapping of str to array_like
            What `restore` has to return; ``stage`` is the number of finished stages.
        """
        self._save_archive(archive, state)
        if rows:
            self._log.append(rows)
        # The checkpoint is written last: what archive and log hold beyond its counts is ignored.
        counts = {f"{team}s": len(archive[team]) for team in TEAMS}
        log = {"log_length": self._log.length, "log_checksum": self._log.checksum}
        self._save(CHECKPOINT, {**state, **counts, **log})

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
        # After a crash while saving, the newest archive may belong to no checkpoint, but it holds
        # the genomes of all checkpoints before it.
        for saved, state in self._intact(CHECKPOINT, problems):
            for genomes, archive in self._intact(ARCHIVE, problems):
                chosen = {CHECKPOINT: saved, ARCHIVE: genomes}
                if self._fits(chosen, archive, state, problems):
                    self._set_aside(problems)
                    self._settle(chosen, archive, state)
                    return Checkpoint(archive_at(archive, state), state)
        # Each problem once, although a file is tried with several others.
        reasons = "; ".join(dict.fromkeys(str(problem) for problem in problems))
        raise DamagedFileError(self.path, f"no intact checkpoint to continue from: {reasons}")

    def _intact(self, name: str, problems: Problems) -> Iterator[tuple[Path, Arrays]]:
        """Yield the newest file of a name and the one before it, without damaged ones."""
        for path in self._both(name):
            arrays = self._loaded(path, name, problems)
            if arrays is not None:
                yield path, arrays

    def _loaded(self, path: Path, name: str, problems: Problems) -> Arrays | None:
        try:
            return self._load(path, name)
        except (FileNotFoundError, DamagedFileError) as error:
            problems.append(error)
            return None

    def _fits(
        self, chosen: Mapping[str, Path], archive: Arrays, state: Arrays, problems: Problems
    ) -> bool:
        """Return whether archive and log hold everything that the checkpoint counts."""
        if not counted(archive, state):
            # An older archive that is tried in place of a damaged one is no problem of its own.
            if all(path == self._file(name) for name, path in chosen.items()):
                problem = "archive.npz is older than checkpoint.npz"
                problems.append(DamagedFileError(self.path, problem))
            return False
        try:
            self._log.truncate(*log_position(state))
        except DamagedFileError as error:
            problems.append(error)
            return False
        return True

    def _set_aside(self, problems: Problems) -> None:
        """Rename damaged archives and checkpoints, so that no save keeps one as the previous."""
        for problem in {str(problem): problem for problem in problems}.values():
            if isinstance(problem, DamagedFileError):
                warnings.warn(f"{problem}; continuing from the checkpoint before it", stacklevel=4)
                if problem.path.suffix == ".npz" and problem.path.exists():
                    os.replace(problem.path, f"{problem.path}.damaged")

    def _settle(self, chosen: Mapping[str, Path], archive: Arrays, state: Arrays) -> None:
        """Make the chosen checkpoint and archive the newest ones, so that readers see them, too."""
        for name, path in chosen.items():
            if path != self._file(name):
                os.replace(path, self._file(name))
        # After a second checkpoint is lost, the archive may be two stages ahead.
        if int(archive[STAGE]) > int(state[STAGE]) + 1:
            self._save_archive(archive_at(archive, state), state)

    def save_payoff(self, arrays: Mapping[str, NDArray[Any]]) -> None:
        """Write payoff.npz."""
        save_arrays(self._file(PAYOFF), arrays, owner=self._owner_of(PAYOFF))

    def save_summary(self, values: Mapping[str, Any]) -> None:
        """Write summary.json, the last file of a finished run."""
        save_json(self.path / SUMMARY, values, owner=self._owner_of(SUMMARY))

    def _save_archive(self, archive: Archive, state: Mapping[str, Any]) -> None:
        genomes = {f"{team}s": archive[team] for team in TEAMS}
        self._save(ARCHIVE, {**genomes, STAGE: state[STAGE]})

    def _save(self, name: str, arrays: Mapping[str, Any]) -> None:
        owner = self._owner_of(name)
        save_arrays(self._file(name), arrays, owner=owner, keep_as=self._previous(name))
