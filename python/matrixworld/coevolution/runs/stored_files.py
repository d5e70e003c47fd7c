"""The files of a run: what each stage adds, what training continues from, and the results.

====================  ==========================================================================
config.json           format, package version, facts of the game, settings
stage-0007.npz        what stage 7 has added: genomes, rows of the log, counters
checkpoint-0007.npz   state of learners and opponent samplers after stage 7, for the newest two
payoff.npz            results of the archives against each other (see `Payoff`)
summary.json          the most important numbers of the run
log.csv, *.npy        log and genomes of all stages, for other programs; of objects *.json
====================  ==========================================================================

Stage 0 is the run before training. A stage is saved in this order: its checkpoint, the stage
itself, and then the checkpoint two stages before is removed. The newest stage therefore has a
checkpoint, whenever the process is killed. Files are written under a temporary name, synced and
renamed: readers beside a writer see whole stages only, and need no lock. The results are written
when the training has ended; if payoff or summary are deleted, going on makes all again.

Payoff, log and genomes can be read of every format from `OLDEST` on, whatever its settings are
called: what they need is among the facts of the game (`runs.facts`). Only going on needs the newest
format.

`runs.stored` reads a run with its settings, `runs.writer` writes it.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld._util import files
from matrixworld._util.teams import PLURALS
from matrixworld.coevolution.runs.facts import TYPES, Facts
from matrixworld.coevolution.runs.places import CONFIG
from matrixworld.coevolution.types import TEAMS, Archive, Genomes, Payoff, Row

FORMAT = 12  # version of the directory's layout, which new runs have
OLDEST = 12  # the oldest one whose payoff, log and genomes can be read

LOCK = ".lock"
LOG = "log.csv"
PAYOFF = "payoff.npz"
SUMMARY = "summary.json"

OF_SCORES = ("scores", "mean", "std", "others", "teams")
"""Arrays of a payoff file that are no extras of a game."""


class OtherVersionError(ValueError):
    """A file of a run is complete, but of another version of the package."""


class StoredFiles:
    """The files of a run in a directory, its `path`, read without settings and game.

    Methods return what the files hold at that moment; `config` and `facts` stay as first read.
    """

    def __init__(self, path: str | Path) -> None:
        self.path: Path = Path(path)

    @property
    def exists(self) -> bool:
        """Whether the directory holds a run."""
        return (self.path / CONFIG).is_file()

    @cached_property
    def config(self) -> dict[str, Any]:
        """The content of config.json.

        FileNotFoundError without such a file, DamagedFileError if it was cut or altered,
        OtherVersionError if it has another format.
        """
        if not self.exists:
            raise FileNotFoundError(f"{self.path}: holds no run, expected a file {CONFIG}")
        values = files.read_json(self.path / CONFIG)
        # Before any other entry is read: another format may not have it.
        number = values.get("format")
        if not isinstance(number, int) or not OLDEST <= number <= FORMAT:
            version = values.get("matrixworld", "unknown")
            expected = f"format {FORMAT}" if OLDEST == FORMAT else f"format {OLDEST} to {FORMAT}"
            got = files.one_line(f"{number}, which matrixworld {version} has written and reads")
            raise OtherVersionError(f"{self.path / CONFIG}: expected {expected}, got {got}")
        return values

    @cached_property
    def facts(self) -> Facts:
        """What the files say of the game; DamagedFileError if that cannot be read."""
        try:
            return Facts.read(self.config["game"])
        except (KeyError, TypeError, ValueError) as error:
            problem = f"expected facts of the game, got {type(error).__name__}: {error}"
            raise files.DamagedFileError(self.path / CONFIG, files.one_line(problem)) from error

    def archive(self) -> Archive:
        """Return the genomes (generations, genes) of each team in all finished stages.

        They are float32; of a game whose genomes are objects they are text (generations, 1).

        Raises DamagedFileError if the file of a stage is damaged or missing.
        """
        archive = archive_of(self.stages(), one_population=self.facts.one_population)
        return dict(zip(self.facts.keys, archive.values(), strict=True))

    @property
    def columns(self) -> dict[str, type]:
        """Columns of the log, and their types."""
        return {name: TYPES[kind] for name, kind in self.facts.columns.items()}

    def log(self) -> dict[str, NDArray[Any]]:
        """Return the columns of the log (see `columns`) as arrays; errors as `archive`."""
        rows = self.rows(0)
        return {
            name: np.array([row[name] for row in rows], dtype=kind)
            for name, kind in self.columns.items()
        }

    def rows(self, after: int) -> list[Row]:
        """Return the rows of the log of all finished stages after one; errors as `archive`."""
        rows = csv.DictReader(io.StringIO(self.log_of(self.stages(after + 1)), newline=""))
        return [{name: kind(row[name]) for name, kind in self.columns.items()} for row in rows]

    def log_of(self, stages: Sequence[files.Arrays]) -> str:
        """Return the rows of the log that stages hold, as CSV with a head."""
        lines = "".join(stage["log"].item().decode() for stage in stages)
        return f"{','.join(self.columns)}\n{lines}"

    def payoff(self) -> Payoff:
        """Return the payoff; FileNotFoundError while the run is not finished."""
        arrays = self.load(PAYOFF)
        extras = {name: array for name, array in arrays.items() if name not in OF_SCORES}
        facts = self.facts
        others = arrays.get("others")
        return Payoff(arrays["scores"], extras, facts.teams, facts.exact, facts.score, others)

    def summary(self) -> dict[str, Any]:
        """Return summary.json; FileNotFoundError while the run is not finished."""
        values = files.read_json(self.path / SUMMARY)
        if not isinstance(values.get("stages"), int):
            raise files.DamagedFileError(self.path / SUMMARY, "expected the number of its stages")
        return values

    def check_results(self) -> None:
        """Raise DamagedFileError if a file of the results was cut or altered."""
        self.summary()
        self.payoff()

    def newest(self) -> int:
        """Return the number of the newest stage, 0 before the first."""
        return max(self.numbers("stage"), default=0)

    def numbers(self, kind: str) -> list[int]:
        """Return the stages of which there is a file of a kind, such as a checkpoint."""
        names = [path.stem.removeprefix(f"{kind}-") for path in self.path.glob(f"{kind}-*.npz")]
        return [int(name) for name in names if name.isdigit()]

    def load(self, name: str) -> files.Arrays:
        """Return the arrays of a file of the run."""
        return files.load_arrays(self.path / name)

    def stages(self, first: int = 0) -> list[files.Arrays]:
        """Return what finished stages have added; DamagedFileError if one is missing."""
        # The summary first: beside a writer, all stages that it counts are there afterwards.
        least = self.summary()["stages"] if (self.path / SUMMARY).exists() else 0
        return [self.stage(number) for number in range(first, max(least, self.newest()) + 1)]

    def stage(self, number: int) -> files.Arrays:
        """Return what a stage has added; DamagedFileError if its file is damaged or missing."""
        name = file_name("stage", number)
        try:
            return self.load(name)
        except FileNotFoundError as error:
            problem = "missing, expected the files of all stages"
            raise files.DamagedFileError(self.path / name, problem) from error


def file_name(kind: str, stage: int) -> str:
    """Return the name of the file of a stage."""
    return f"{kind}-{stage:04}.npz"


def archive_of(stages: Sequence[files.Arrays], *, one_population: bool = False) -> Archive:
    """Return the genomes that stages have added; (0, 0) for a team that a script plays.

    Those of one population are those of both teams.
    """

    def genomes(name: str) -> Genomes:
        added = [stage[name] for stage in stages if name in stage]
        return np.concatenate(added) if added else np.empty((0, 0), np.float32)

    if one_population:
        return dict.fromkeys(TEAMS, genomes(PLURALS[TEAMS[0]]))
    return {team: genomes(PLURALS[team]) for team in TEAMS}
