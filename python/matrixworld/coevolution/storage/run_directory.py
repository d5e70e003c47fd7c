"""The files of a run, in a directory that another person can open.

====================  ==========================================================================
config.json           format, package version, kind of run, settings
archive.npz           every generation's genomes, ``pursuers`` and ``evaders`` (n, genes) float32
log.csv               one row per epoch (see `run_log.COLUMNS`)
payoff.npz            what the archives score against each other (see `tournament.Payoff`)
summary.json          the run in a few numbers
checkpoint.npz        position and learners, from which the run goes on
*.previous.npz        the last archive and checkpoint but one
====================  ==========================================================================

Several processes may read a directory; one writes to it, under its lock. The checksums of all
files but the log, which the checkpoint knows, go with that of config.json: a file of another run is
refused. payoff.npz and summary.json follow from the others: deleted, they are made again on resume.
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

import matrixworld
from matrixworld.coevolution.settings import RaceSettings, SingleSettings
from matrixworld.coevolution.settings_json import settings_of
from matrixworld.coevolution.storage.files import (
    Arrays,
    DamagedFileError,
    OtherVersionError,
    is_temporary,
    json_digest,
    load_arrays,
    load_json,
    remove_temporary_files,
    save_arrays,
    save_json,
)
from matrixworld.coevolution.storage.lock import locked
from matrixworld.coevolution.storage.run_log import Row, RunLog, read_log
from matrixworld.coevolution.types import TEAMS, Genomes, Team

FORMAT = 3
"""Version of the directory's layout; another one is refused."""

CONFIG, SUMMARY, LOG, LOCK = "config.json", "summary.json", "log.csv", ".lock"
ARCHIVE, CHECKPOINT, PAYOFF = "archive", "checkpoint", "payoff"

REMAINS = {LOCK, "archive.npz", "checkpoint.npz"}
"""What a process that was killed while it made a run may have left, but for temporary files."""

Archive = dict[Team, Genomes]
Problems = list[FileNotFoundError | DamagedFileError]


@dataclass(frozen=True)
class Saved:
    """What a checkpoint holds: archives of both teams, and named arrays."""

    archive: Archive
    state: Arrays


class RunDirectory:
    """The files of one run. `create` makes a new one, `open` takes up an existing one."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._new_config: dict[str, Any] = {}
        self._log = RunLog(path / LOG)

    @classmethod
    def create(
        cls, path: str | Path, kind: str, settings: Mapping[str, Any], **more: Any
    ) -> RunDirectory:
        """Make an empty directory for a new run; FileExistsError if it holds anything.

        `kind`, `settings` and `more` are what `write_config` will write.
        """
        made = cls(Path(path))
        head = {"format": FORMAT, "matrixworld": matrixworld.__version__, "kind": kind}
        made._new_config = {**head, "settings": dict(settings), **more}
        made.path.mkdir(parents=True, exist_ok=True)
        made.check_empty()
        return made

    @classmethod
    def open(cls, path: str | Path) -> RunDirectory:
        """Return an existing run's directory; FileNotFoundError if it holds no run."""
        path = Path(path)
        if not (path / CONFIG).is_file():
            raise FileNotFoundError(f"{path}: holds no run, expected a file {CONFIG}")
        return cls(path)

    @cached_property
    def _owner(self) -> str:
        """Whose the files are: the checksum of config.json."""
        return json_digest(self._new_config or self.config())

    def check_empty(self) -> None:
        """FileExistsError if the directory holds anything.

        What a process left that was killed while it made a run does not count: it had learnt
        nothing, and its lock file says that all this is no one else's.
        """
        found = sorted(item.name for item in self.path.iterdir())
        if LOCK in found:
            found = [name for name in found if name not in REMAINS and not is_temporary(name)]
        if found:
            raise FileExistsError(
                f"{self.path}: expected a new or empty directory for a new run, found "
                f"{', '.join(found[:3])}{' ...' if len(found) > 3 else ''}"
            )

    def clear(self) -> None:
        """Remove what `check_empty` overlooks. To be called under the lock."""
        self.check_empty()
        remove_temporary_files(self.path)
        for name in REMAINS - {LOCK}:
            (self.path / name).unlink(missing_ok=True)

    def lock(self) -> AbstractContextManager[None]:
        """Hold the directory for writing; LockedError if another process does."""
        return locked(self.path / LOCK)

    def write_config(self) -> None:
        """Write config.json, which makes the directory a run: the last file of a new one."""
        save_json(self.path / CONFIG, self._new_config)

    def config(self) -> dict[str, Any]:
        """Return config.json; OtherVersionError if it is of another format."""
        config = load_json(self.path / CONFIG)
        if config.get("format") != FORMAT:
            raise OtherVersionError(
                f"{self.path / CONFIG}: expected format {FORMAT}, got {config.get('format')} "
                f"(written by matrixworld {config.get('matrixworld', 'unknown')})"
            )
        return config

    def settings(self) -> RaceSettings | SingleSettings:
        """Return the settings of the run; OtherVersionError if this version does not know them."""
        config = self.config()
        try:
            return settings_of(config)
        except (KeyError, TypeError, ValueError) as error:
            raise OtherVersionError(
                f"{self.path / CONFIG}: expected settings of matrixworld "
                f"{matrixworld.__version__}, got those of {config.get('matrixworld', 'unknown')}: "
                f"{error}"
            ) from error

    def save(self, archive: Archive, rows: Sequence[Row], state: Mapping[str, Any]) -> None:
        """Add the archive's and the log's news, then the checkpoint, which makes them count."""
        self._save(ARCHIVE, {f"{team}s": archive[team] for team in TEAMS})
        if rows:
            self._log.append(rows)
        counts = {f"{team}s": len(archive[team]) for team in TEAMS}
        mark = {"log_length": self._log.length, "log_checksum": self._log.checksum}
        self._save(CHECKPOINT, {**state, **counts, **mark})

    def restore(self) -> Saved:
        """Return the newest checkpoint that is whole, and cut the log back to it.

        A damaged file is warned of, set aside as ``*.damaged``, and the one before it is taken;
        DamagedFileError if none is whole. To be called under the lock.
        """
        remove_temporary_files(self.path)
        problems: Problems = []
        for state in self._whole(CHECKPOINT, problems):
            for archive in self._whole(ARCHIVE, problems):
                if self._fits(archive, state, problems):
                    self._set_aside(problems)
                    return Saved(_first(archive, state), state)
        reasons = "; ".join(dict.fromkeys(str(problem) for problem in problems))
        raise DamagedFileError(self.path, f"no whole checkpoint to go on from: {reasons}")

    def _whole(self, name: str, problems: Problems) -> Iterator[Arrays]:
        """Yield the newest file of a name and the one before it, leaving out damaged ones."""
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

    def _fits(
        self,
        archive: Arrays,
        state: Arrays,
        problems: Problems,
    ) -> bool:
        """Whether archive and log hold all that the checkpoint counts."""
        if any(len(archive[f"{team}s"]) < int(state[f"{team}s"]) for team in TEAMS):
            return False
        try:
            self._log.cut_back(*_log_mark(state))
        except DamagedFileError as error:
            problems.append(error)
            return False
        return True

    def _set_aside(self, problems: Problems) -> None:
        """Move damaged archives and checkpoints away, lest they take a good file's place."""
        for problem in {str(problem): problem for problem in problems}.values():
            if isinstance(problem, DamagedFileError):
                warnings.warn(f"{problem}; going on from the checkpoint before it", stacklevel=4)
                if problem.path.suffix == ".npz" and problem.path.exists():
                    os.replace(problem.path, f"{problem.path}.damaged")

    def archive(self) -> Archive:
        """Return the genomes (n, genes) of each team, by generation."""
        path = next((path for path in self._kept(ARCHIVE) if path.exists()), self._file(ARCHIVE))
        arrays = load_arrays(path, owner=self._owner_of(ARCHIVE))
        return {team: arrays[f"{team}s"] for team in TEAMS}

    def log(self) -> dict[str, NDArray[Any]]:
        """Return the columns of log.csv as arrays, up to the checkpoint."""
        problems: Problems = []
        for path in self._kept(CHECKPOINT):
            state = self._loaded(path, CHECKPOINT, problems)
            columns = None if state is None else self._logged(state, problems)
            if columns is not None:
                return columns
        raise problems[0]

    def _logged(self, state: Arrays, problems: Problems) -> dict[str, NDArray[Any]] | None:
        try:
            return read_log(self.path / LOG, *_log_mark(state))
        except DamagedFileError as error:
            problems.append(error)
            return None

    def _kept(self, name: str) -> list[Path]:
        """Return the files of a name that count: while a run goes on, one may be being replaced."""
        newest = [self._file(name)]
        return newest if self.finished else [*newest, self._previous(name)]

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
        """Whether the run has come to its end."""
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


def _log_mark(state: Arrays) -> tuple[int, str]:
    """Return length and checksum of the log that a checkpoint counts."""
    return int(state["log_length"]), str(state["log_checksum"])


def _first(archive: Arrays, state: Arrays) -> Archive:
    """Leave out genomes that were archived after the checkpoint."""
    return {team: archive[f"{team}s"][: int(state[f"{team}s"])] for team in TEAMS}
