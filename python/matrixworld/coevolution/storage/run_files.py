"""The files of a run, to read, in a directory that can be copied and opened elsewhere.

====================  ==========================================================================
config.json           format, package version, kind of run, settings
log.csv               one row per epoch (see `run_log.COLUMNS`)
pursuers.npy          genomes of all generations of the pursuers, (n, genes) float32
evaders.npy           the same of the evaders; a team that a script plays has no file
payoff.npz            results of the archives against each other (see `Payoff`)
summary.json          the most important numbers of the run
checkpoint.npz        position in the run, and the state from which training continues
*.previous.npz        the checkpoint before the newest one
====================  ==========================================================================

Several processes may read a directory; one writes to it, under its lock. The log and the genomes
grow; their lengths and checksums are in the checkpoint. The checksums of all other files include
that of config.json, so that a file of another run is refused. Files of different moments of the
same run are refused, too (see `consistency`). payoff.npz and summary.json follow from the other
files: if they are deleted, resuming the run makes them again.
"""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from matrixworld._util.files import json_digest, load_arrays, load_json
from matrixworld._util.reading import Arrays, DamagedFileError, one_line
from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.coevolution.settings.training import settings_from_json
from matrixworld.coevolution.storage.appended_file import Position
from matrixworld.coevolution.storage.consistency import (
    STAGE,
    STAGES,
    check_form,
    check_genomes,
    check_last,
    check_log,
    check_summary,
    steady,
    version,
)
from matrixworld.coevolution.storage.genome_file import GenomeFile, GenomePosition
from matrixworld.coevolution.storage.run_log import read_log
from matrixworld.coevolution.types import TEAMS, Genomes, Team
from matrixworld.version import __version__

# Format 7 differs from 6 in the genomes, which are appended to one file per team, and no longer
# written as a whole to archive.npz after each stage; and in the column `stage` of the log.
FORMAT = 8
"""Version of the directory's layout; another one is refused."""

CONFIG, SUMMARY, LOG, LOCK = "config.json", "summary.json", "log.csv", ".lock"
CHECKPOINT, PAYOFF = "checkpoint", "payoff"

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
        state = self._moment()
        return {team: self._genomes(team).read(genome_position(state, team)) for team in TEAMS}

    def log(self) -> dict[str, NDArray[Any]]:
        """Return the columns of log.csv as arrays, up to the checkpoint; errors as `archive`."""
        return steady(self._read_log, self._files())

    def _read_log(self) -> dict[str, NDArray[Any]]:
        return read_log(self.path / LOG, log_position(self._moment()))

    def _moment(self) -> Arrays:
        """Return the checkpoint; DamagedFileError unless the other files are of its moment."""
        # Before the files that it counts: they may be newer, but never older.
        path = self._newest(CHECKPOINT)
        before = version(path)
        state = self._load(path, CHECKPOINT)
        try:
            self._check_ends(path, state)
        except DamagedFileError:
            # After another checkpoint the files may hold any number of further stages. What this
            # one has counted stays.
            if version(path) == before:
                raise
        return state

    def _check_ends(self, checkpoint: Path, state: Arrays) -> None:
        following: int | None = int(state[STAGE]) + 1
        if self.finished:
            check_last(checkpoint, state, self.path / SUMMARY, self.summary()[STAGES])
            following = None
        growing = check_log(self.path / LOG, log_position(state), checkpoint, following)
        for team in TEAMS:
            path, position = self._genomes(team).path, genome_position(state, team)
            check_genomes(path, position, checkpoint, growing=growing)

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
        saved = [*self._both(CHECKPOINT), self._file(PAYOFF)]
        grown = [self.path / LOG, *(self._genomes(team).path for team in TEAMS)]
        return [*saved, *grown, self.path / SUMMARY]

    def _genomes(self, team: Team) -> GenomeFile:
        return GenomeFile(self.path / genomes_name(team))

    def _file(self, name: str) -> Path:
        return self.path / f"{name}.npz"

    def _previous(self, name: str) -> Path:
        return self.path / f"{name}.previous.npz"


def genomes_name(team: Team) -> str:
    """Return the name of the file with a team's genomes."""
    return f"{team}s.npy"


def log_position(state: Arrays) -> Position:
    """Return where the log ends at a checkpoint."""
    return Position(int(state["log_length"]), str(state["log_checksum"]))


def genome_position(state: Arrays, team: Team) -> GenomePosition:
    """Return where the genomes of a team end at a checkpoint."""
    genomes, genes = state[f"{team}s"].tolist()
    return GenomePosition(genomes, genes, str(state[f"{team}s_checksum"]))


def _version(config: dict[str, Any]) -> str:
    """Return the version of the package that wrote a config.json."""
    return one_line(config.get("matrixworld", "unknown"))
