"""The files of a run, to read, in a directory that can be copied and opened elsewhere.

====================  ==========================================================================
config.json           format, package version, kind of run, settings
archive.npz           genomes of all generations, ``pursuers`` and ``evaders`` (n, genes) float32,
                      and ``stage``, the number of finished stages
log.csv               one row per epoch (see `run_log.COLUMNS`)
payoff.npz            results of the archives against each other (see `Payoff`)
summary.json          the most important numbers of the run
checkpoint.npz        position in the run, and the state from which training continues
*.previous.npz        the archive and the checkpoint before the newest ones
====================  ==========================================================================

Several processes may read a directory; one writes to it, under its lock. The checksums of all files
but the log include that of config.json, so that a file of another run is refused; length and
checksum of the log are in the checkpoint. Files of different moments of the same run are refused
(see `consistency`). payoff.npz and summary.json follow from the other files:
if they are deleted, resuming the run makes them again.
"""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.coevolution.settings.training import settings_from_json
from matrixworld.coevolution.storage.consistency import (
    STAGES,
    Stated,
    check_form,
    check_log,
    check_pair,
    check_same,
    check_summary,
    counted,
    stated,
    steady,
)
from matrixworld.coevolution.storage.run_log import read_log
from matrixworld.coevolution.types import TEAMS, Genomes, Team
from matrixworld.files import json_digest, load_arrays, load_json
from matrixworld.reading import Arrays, DamagedFileError, one_line
from matrixworld.version import __version__

# Format 6 differs from 5 in the agent-steps that checkpoint and summary count.
FORMAT = 6
"""Version of the directory's layout; another one is refused."""

CONFIG, SUMMARY, LOG, LOCK = "config.json", "summary.json", "log.csv", ".lock"
ARCHIVE, CHECKPOINT, PAYOFF = "archive", "checkpoint", "payoff"

SETTINGS_OF_KIND: dict[str, type[RaceSettings] | type[SingleSettings]] = {
    "race": RaceSettings,
    "hall-of-fame": RaceSettings,
    "single": SingleSettings,
}
"""Class of the settings of each kind of run."""

Archive = dict[Team, Genomes]


class OtherVersionError(ValueError):
    """A file of a run is complete, but of another version of the package."""


class RunFiles:
    """The files of a run; nothing here writes.

    Parameters
    ----------
    path : Path
        The directory.
    """

    def __init__(self, path: Path) -> None:
        self.path = path

    @cached_property
    def _owner(self) -> str:
        """Owner of the files in their checksums: the checksum of config.json."""
        # Runs of other settings, or of another seed, have another one.
        return json_digest(self.config())

    # Configuration:

    def config(self) -> dict[str, Any]:
        """Return config.json; OtherVersionError if it has another format."""
        config = load_json(self.path / CONFIG)
        # Before any other entry is read: another format may not have it.
        if config.get("format") != FORMAT:
            raise OtherVersionError(
                f"{self.path / CONFIG}: expected format {FORMAT}, got "
                f"{one_line(config.get('format'))} (written by matrixworld {_version(config)})"
            )
        kind, known = config.get("kind"), list(SETTINGS_OF_KIND)
        if kind not in known:
            raise OtherVersionError(
                f"{self.path / CONFIG}: expected a run of kind {', '.join(known)}, got "
                f"{one_line(kind)}"
            )
        return config

    def settings(self) -> RaceSettings | SingleSettings:
        """Return the settings; OtherVersionError if this version cannot read them."""
        config = self.config()
        try:
            return settings_from_json(SETTINGS_OF_KIND[config["kind"]], config["settings"])
        except (AttributeError, KeyError, OverflowError, TypeError, ValueError) as error:
            # The checksum was correct, so that the file is not damaged.
            raise OtherVersionError(
                f"{self.path / CONFIG}: expected settings of matrixworld "
                f"{__version__}, got those of {_version(config)}: {one_line(error)}"
            ) from error

    # Reading:

    def archive(self) -> Archive:
        """Return the genomes (generations, genes) float32 of each team, up to the checkpoint.

        Raises
        ------
        DamagedFileError
            If a file is damaged, or older than another one.
        FileNotFoundError
            If there is no archive, or no checkpoint of an unfinished run.
        """
        return steady(self._read_archive, self._files())

    def _read_archive(self) -> Archive:
        if self.finished:
            archive = self._load_last(ARCHIVE)
            return {team: archive[f"{team}s"] for team in TEAMS}
        archive, state = self._load_pair()
        return archive_at(archive, state)

    def log(self) -> dict[str, NDArray[Any]]:
        """Return the columns of log.csv as arrays, up to the checkpoint; errors as `archive`."""
        return steady(self._read_log, self._files())

    def _read_log(self) -> dict[str, NDArray[Any]]:
        state = self._load_last(CHECKPOINT) if self.finished else self._load_pair()[1]
        return read_log(self.path / LOG, *log_position(state))

    def _load_last(self, name: str) -> Arrays:
        """Return a file of a finished run, which must be of its last stage."""
        path = self._file(name)
        arrays, last = self._load(path, name), Stated(self.path / SUMMARY, self.summary()[STAGES])
        check_same(stated(path, arrays), last)
        return arrays

    def _load_pair(self) -> tuple[Arrays, Arrays]:
        """Return archive and checkpoint of an unfinished run, which must fit."""
        # Not in the order in which they are written: the archive may be newer, but never older.
        saved = self._newest(CHECKPOINT)
        state = self._load(saved, CHECKPOINT)
        length = log_position(state)[0]
        genomes = self._newest(ARCHIVE)
        archive = self._load(genomes, ARCHIVE)
        check_pair(stated(genomes, archive), stated(saved, state))
        if not counted(archive, state):
            raise DamagedFileError(genomes, f"expected the genomes that {saved.name} counts")
        check_log(self.path / LOG, length, stated(genomes, archive), stated(saved, state))
        return archive, state

    def _newest(self, name: str) -> Path:
        # Between the two renames of a save there is only the previous file.
        newest, previous = self._both(name)
        return previous if previous.exists() and not newest.exists() else newest

    def _load(self, path: Path, name: str) -> Arrays:
        arrays = load_arrays(path, owner=self._owner_of(name))
        check_form(path, name, arrays)
        return arrays

    # Results:

    def payoff(self) -> Arrays:
        """Return the arrays of payoff.npz; FileNotFoundError while the run is not finished."""
        return self._load(self._file(PAYOFF), PAYOFF)

    def summary(self) -> dict[str, Any]:
        """Return summary.json; FileNotFoundError while the run is not finished."""
        path = self.path / SUMMARY
        values = load_json(path, owner=self._owner_of(SUMMARY))
        check_summary(path, self.config()["kind"], values)
        return values

    @property
    def finished(self) -> bool:
        """Whether the run has its results."""
        return (self.path / SUMMARY).exists() and self._file(PAYOFF).exists()

    # Names:

    def _owner_of(self, name: str) -> str:
        return f"{self._owner}/{name}"

    def _both(self, name: str) -> tuple[Path, Path]:
        """Return the newest file of a name and the one before it."""
        return self._file(name), self._previous(name)

    def _files(self) -> list[Path]:
        """Return all files that change while a run trains."""
        saved = [*self._both(ARCHIVE), *self._both(CHECKPOINT), self._file(PAYOFF)]
        return [*saved, self.path / LOG, self.path / SUMMARY]

    def _file(self, name: str) -> Path:
        return self.path / f"{name}.npz"

    def _previous(self, name: str) -> Path:
        return self.path / f"{name}.previous.npz"


def log_position(state: Arrays) -> tuple[int, str]:
    """Return length and checksum of the log at a checkpoint."""
    return int(state["log_length"]), str(state["log_checksum"])


def archive_at(archive: Arrays, state: Arrays) -> Archive:
    """Return the archive without genomes that were added after the checkpoint."""
    return {team: archive[f"{team}s"][: int(state[f"{team}s"])] for team in TEAMS}


def _version(config: dict[str, Any]) -> str:
    """Return the version of the package that wrote a config.json."""
    return one_line(config.get("matrixworld", "unknown"))
