"""The files of a run, in a directory that can be copied and opened elsewhere.

====================  ==========================================================================
config.json           format, package version, kind of run, settings
archive.npz           genomes of all generations, ``pursuers`` and ``evaders`` (n, genes) float32
log.csv               one row per epoch (see `run_log.COLUMNS`)
payoff.npz            results of the archives against each other (see `Payoff`)
summary.json          the most important numbers of the run
checkpoint.npz        position in the run, and the state from which training continues
*.previous.npz        the archive and the checkpoint before the newest ones
====================  ==========================================================================

Several processes may read a directory; one writes to it, under its lock. The checksums of all files
but the log include that of config.json, so that a file of another run is refused; length and
checksum of the log are in the checkpoint. payoff.npz and summary.json follow from the other files:
if they are deleted, resuming the run makes them again.
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

from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.coevolution.settings.training import settings_from_json
from matrixworld.coevolution.storage.run_log import Row, RunLog, read_log
from matrixworld.coevolution.types import TEAMS, Genomes, Team
from matrixworld.files import (
    Arrays,
    DamagedFileError,
    is_temporary,
    json_digest,
    load_arrays,
    load_json,
    locked,
    remove_temporary_files,
    save_arrays,
    save_json,
)
from matrixworld.version import __version__

# Format 4 differs from 3 in the fields `elite_episodes` and `retention_episodes` of the settings,
# and in the state of the genetic algorithm in the checkpoint.
FORMAT = 4
"""Version of the directory's layout; another one is refused."""

CONFIG, SUMMARY, LOG, LOCK = "config.json", "summary.json", "log.csv", ".lock"
ARCHIVE, CHECKPOINT, PAYOFF = "archive", "checkpoint", "payoff"

INCOMPLETE = {LOCK, "archive.npz", "checkpoint.npz"}
"""Files that a process may leave, besides temporary ones, if it is killed while it makes a run."""

SETTINGS_OF_KIND: dict[str, type[RaceSettings] | type[SingleSettings]] = {
    "race": RaceSettings,
    "hall-of-fame": RaceSettings,
    "single": SingleSettings,
}
"""Class of the settings of each kind of run."""

Archive = dict[Team, Genomes]
Problems = list[FileNotFoundError | DamagedFileError]


class OtherVersionError(ValueError):
    """A file of a run is complete, but of another version of the package."""


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


class RunDirectory:
    """The files of one run; made by `create` for a new run and by `open` for an existing one.

    Parameters
    ----------
    path : Path
        The directory.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
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
        """Owner of the files in their checksums: the checksum of config.json."""
        # Runs of other settings, or of another seed, have another one.
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

    # Configuration:

    def config(self) -> dict[str, Any]:
        """Return config.json; OtherVersionError if it has another format."""
        config = load_json(self.path / CONFIG)
        # Before any other entry is read: another format may not have it.
        if config.get("format") != FORMAT:
            raise OtherVersionError(
                f"{self.path / CONFIG}: expected format {FORMAT}, got {config.get('format')} "
                f"(written by matrixworld {config.get('matrixworld', 'unknown')})"
            )
        return config

    def settings(self) -> RaceSettings | SingleSettings:
        """Return the settings; OtherVersionError if this version cannot read them."""
        config = self.config()
        try:
            return _settings_of(config)
        except (KeyError, TypeError, ValueError) as error:
            # The checksum was correct, so that the file is not damaged.
            raise OtherVersionError(
                f"{self.path / CONFIG}: expected settings of matrixworld "
                f"{__version__}, got those of {config.get('matrixworld', 'unknown')}: "
                f"{error}"
            ) from error

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
            What `restore` has to return.
        """
        self._save(ARCHIVE, {f"{team}s": archive[team] for team in TEAMS})
        if rows:
            self._log.append(rows)
        # The checkpoint is written last: what archive and log hold beyond its counts is ignored.
        counts = {f"{team}s": len(archive[team]) for team in TEAMS}
        log = {"log_length": self._log.length, "log_checksum": self._log.checksum}
        self._save(CHECKPOINT, {**state, **counts, **log})

    def restore(self) -> Checkpoint:
        """Return the newest intact checkpoint, and truncate the log to it.

        To be called under the lock. A damaged file is reported by a warning and renamed to
        ``*.damaged``; the file before it is used instead.

        Raises
        ------
        DamagedFileError
            If no checkpoint is intact.
        """
        remove_temporary_files(self.path)
        problems: Problems = []
        # After a crash while saving, the newest archive may belong to no checkpoint, but it holds
        # the genomes of all checkpoints before it.
        for state in self._intact(CHECKPOINT, problems):
            for archive in self._intact(ARCHIVE, problems):
                if self._fits(archive, state, problems):
                    self._set_aside(problems)
                    return Checkpoint(_archive_at(archive, state), state)
        # Each problem once, although a file is tried with several others.
        reasons = "; ".join(dict.fromkeys(str(problem) for problem in problems))
        raise DamagedFileError(self.path, f"no intact checkpoint to continue from: {reasons}")

    def _intact(self, name: str, problems: Problems) -> Iterator[Arrays]:
        """Yield the newest file of a name and the one before it, without damaged ones."""
        for path in (self._file(name), self._previous(name)):
            arrays = self._loaded(path, name, problems)
            if arrays is not None:
                yield arrays

    def _loaded(self, path: Path, name: str, problems: Problems) -> Arrays | None:
        try:
            return load_arrays(path, owner=self._owner_of(name))
        except (FileNotFoundError, DamagedFileError) as error:
            problems.append(error)
            return None

    def _fits(self, archive: Arrays, state: Arrays, problems: Problems) -> bool:
        """Return whether archive and log hold everything that the checkpoint counts."""
        if any(len(archive[f"{team}s"]) < int(state[f"{team}s"]) for team in TEAMS):
            return False
        try:
            self._log.truncate(*_log_position(state))
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

    # Reading:

    def archive(self) -> Archive:
        """Return the genomes (generations, genes) float32 of each team."""
        paths = self._readable(ARCHIVE)
        path = next((path for path in paths if path.exists()), paths[0])
        arrays = load_arrays(path, owner=self._owner_of(ARCHIVE))
        return {team: arrays[f"{team}s"] for team in TEAMS}

    def log(self) -> dict[str, NDArray[Any]]:
        """Return the columns of log.csv as arrays, up to the checkpoint."""
        problems: Problems = []
        for path in self._readable(CHECKPOINT):
            state = self._loaded(path, CHECKPOINT, problems)
            columns = None if state is None else self._logged(state, problems)
            if columns is not None:
                return columns
        raise problems[0]

    def _logged(self, state: Arrays, problems: Problems) -> dict[str, NDArray[Any]] | None:
        try:
            return read_log(self.path / LOG, *_log_position(state))
        except DamagedFileError as error:
            problems.append(error)
            return None

    def _readable(self, name: str) -> list[Path]:
        """Return the files of a name that may be read, the newest first."""
        newest = [self._file(name)]
        # Between the two renames of a save, a run that trains has only the previous file.
        return newest if self.finished else [*newest, self._previous(name)]

    # Results:

    def save_payoff(self, arrays: Mapping[str, NDArray[Any]]) -> None:
        """Write payoff.npz."""
        save_arrays(self._file(PAYOFF), arrays, owner=self._owner_of(PAYOFF))

    def payoff(self) -> Arrays:
        """Return the arrays of payoff.npz; FileNotFoundError while the run is not finished."""
        return load_arrays(self._file(PAYOFF), owner=self._owner_of(PAYOFF))

    def save_summary(self, values: Mapping[str, Any]) -> None:
        """Write summary.json, the last file of a finished run."""
        save_json(self.path / SUMMARY, values, owner=self._owner_of(SUMMARY))

    def summary(self) -> dict[str, Any]:
        """Return summary.json; FileNotFoundError while the run is not finished."""
        return load_json(self.path / SUMMARY, owner=self._owner_of(SUMMARY))

    @property
    def finished(self) -> bool:
        """Whether the run has its results."""
        return (self.path / SUMMARY).exists() and self._file(PAYOFF).exists()

    def _save(self, name: str, arrays: Mapping[str, Any]) -> None:
        owner = self._owner_of(name)
        save_arrays(self._file(name), arrays, owner=owner, keep_as=self._previous(name))

    def _owner_of(self, name: str) -> str:
        return f"{self._owner}/{name}"

    def _file(self, name: str) -> Path:
        return self.path / f"{name}.npz"

    def _previous(self, name: str) -> Path:
        return self.path / f"{name}.previous.npz"


def _log_position(state: Arrays) -> tuple[int, str]:
    """Return length and checksum of the log at a checkpoint."""
    return int(state["log_length"]), str(state["log_checksum"])


def _archive_at(archive: Arrays, state: Arrays) -> Archive:
    """Return the archive without genomes that were added after the checkpoint."""
    return {team: archive[f"{team}s"][: int(state[f"{team}s"])] for team in TEAMS}


def _settings_of(config: dict[str, Any]) -> RaceSettings | SingleSettings:
    """Return the settings in the config.json of a run; ValueError on an unknown kind of run."""
    kind = config["kind"]
    if kind not in SETTINGS_OF_KIND:
        known = ", ".join(SETTINGS_OF_KIND)
        raise ValueError(f"kind of run: expected one of {known}, got {kind!r}")
    return settings_from_json(SETTINGS_OF_KIND[kind], config["settings"])
