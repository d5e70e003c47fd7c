"""What writes the files of a run, under its lock; any number of readers may read meanwhile."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld._util import files
from matrixworld._util.callers import warn_caller
from matrixworld._util.teams import PLURALS
from matrixworld.coevolution.runs.facts import Facts
from matrixworld.coevolution.runs.places import CONFIG
from matrixworld.coevolution.runs.stored import StoredRun
from matrixworld.coevolution.runs.stored_files import (
    FORMAT,
    LOCK,
    LOG,
    PAYOFF,
    SUMMARY,
    OtherVersionError,
    archive_of,
    file_name,
)
from matrixworld.coevolution.settings.race_settings import RaceSettings
from matrixworld.coevolution.states import State, flat
from matrixworld.coevolution.types import TEAMS, Archive, Genome, Genomes, Row, Team
from matrixworld.version import __version__


class RunWriter(StoredRun):
    """A run that one process writes, under its lock; any number may read it meanwhile."""

    def __init__(self, path: str | Path) -> None:
        super().__init__(path)
        self._saved: dict[Team, int] = dict.fromkeys(TEAMS, 0)  # genomes in the stages so far

    def lock(self) -> AbstractContextManager[None]:
        """Hold the directory for writing; LockedError if another process does."""
        return files.locked(self.path / LOCK)

    def begin(
        self,
        settings: RaceSettings,
        archive: Mapping[Team, Any],
        states: Mapping[str, State],
        **more: Any,
    ) -> None:
        """Write config.json, which holds the settings and `more`, and stage 0."""
        self.config = {
            "format": FORMAT,
            "matrixworld": __version__,
            "game": Facts.of(settings.game, settings.known)._asdict(),
            "settings": settings.to_json(),
            **more,
        }
        files.save_json(self.path / CONFIG, self.config)
        counters = ("matches", *settings.known.counters)
        self.save(0, archive, [], dict.fromkeys(counters, 0), states)

    def change(self, settings: RaceSettings) -> None:
        """Write config.json with other settings of the same run."""
        self.check_format()
        config = {**self.config, "settings": settings.to_json()}
        files.save_json(self.path / CONFIG, config)
        self.config = config
        self.settings = settings

    def check_format(self) -> None:
        """Raise OtherVersionError unless the run has the newest format, which going on needs."""
        number = self.config["format"]
        if number != FORMAT:
            raise OtherVersionError(
                f"{self.path / CONFIG}: expected format {FORMAT} to go on, got {number}, with "
                f"which matrixworld {self.config['matrixworld']} goes on"
            )

    def save(
        self,
        stage: int,
        archive: Mapping[Team, Genomes | Sequence[Genome]],
        rows: Sequence[Row],
        counters: Mapping[str, float],
        states: Mapping[str, State],
    ) -> None:
        """Save a stage and its checkpoint.

        `archive` holds all genomes of each team, `rows` the log of this stage alone; `states` are
        by the names of their parts of a checkpoint.
        """
        added: dict[str, Any] = {"log": self._as_csv(rows).encode(), **counters}
        for team in TEAMS[:1] if self.facts.one_population else TEAMS:
            new = archive[team][self._saved[team] :]
            if len(new):
                genomes = np.asarray(new)
                is_text = genomes.dtype.kind == "U"
                added[PLURALS[team]] = genomes if is_text else np.asarray(genomes, np.float32)
        checkpoint = {
            f"{part}.{path}": array
            for part, state in states.items()
            for path, array in flat(state).items()
        }
        files.save_arrays(self.path / file_name("checkpoint", stage), checkpoint)
        files.save_arrays(self.path / file_name("stage", stage), added)
        self._saved = {team: len(archive[team]) for team in TEAMS}
        (self.path / file_name("checkpoint", stage - 2)).unlink(missing_ok=True)

    def restore(self) -> tuple[list[files.Arrays], Archive, files.Arrays]:
        """Return all stages up to the newest intact one, their genomes, and its checkpoint.

        A damaged file is reported by a warning and renamed to ``*.damaged``.

        Raises
        ------
        DamagedFileError, OtherVersionError
            If no stage is intact and has a checkpoint, or the run has an older format.
        """
        self.check_format()
        files.remove_temporary_files(self.path)
        stages, checkpoint, problems = self._newest_intact()
        for problem in problems:
            warn_caller(f"{problem}; continuing from the stage before it")
            if problem.path.exists():
                os.replace(problem.path, f"{problem.path}.damaged")
        for number in self.numbers("checkpoint"):
            if number < len(stages) - 2:
                (self.path / file_name("checkpoint", number)).unlink()
        archive = archive_of(stages, one_population=self.facts.one_population)
        self._saved = {team: len(archive[team]) for team in TEAMS}
        return stages, archive, checkpoint

    def _newest_intact(
        self,
    ) -> tuple[list[files.Arrays], files.Arrays, list[files.DamagedFileError]]:
        """Return the stages up to the newest one that can go on, its checkpoint, and the damage.

        It can go on if its checkpoint and all stages up to it are intact.
        """
        # Several checkpoints may fail by the same stage.
        problems: dict[Path, files.DamagedFileError] = {}
        # A run that was killed may have a checkpoint of a stage that it has not saved.
        numbers = [number for number in self.numbers("checkpoint") if number <= self.newest()]
        for number in sorted(numbers, reverse=True):
            try:
                stages = [self.stage(earlier) for earlier in range(number + 1)]
                checkpoint = self.load(file_name("checkpoint", number))
                return stages, checkpoint, [*problems.values()]
            except files.DamagedFileError as error:  # noqa: PERF203, tried once or twice
                problems[error.path] = error
        reasons = "; ".join(map(str, problems.values())) or "got no file checkpoint-*.npz"
        raise files.DamagedFileError(self.path, f"no intact stage to continue from: {reasons}")

    def save_results(self, payoff: Mapping[str, NDArray[Any]], summary: Mapping[str, Any]) -> None:
        """Write log and genomes for other programs, payoff.npz, and summary.json as the last."""
        stages = self.stages()
        with files.replacing(self.path / LOG) as file:
            file.write(self.log_of(stages).encode())
        archive = archive_of(stages, one_population=self.facts.one_population)
        for name, genomes in dict(zip(self.facts.teams, archive.values(), strict=True)).items():
            if genomes.dtype.kind == "U":
                files.save_json(self.path / f"{name}.json", {"genomes": genomes[:, 0].tolist()})
            elif len(genomes):  # those of a team that a script plays are none
                with files.replacing(self.path / f"{name}.npy") as file:
                    np.save(file, genomes)
        files.save_arrays(self.path / PAYOFF, payoff)
        files.save_json(self.path / SUMMARY, summary)

    def _as_csv(self, rows: Sequence[Row]) -> str:
        text = io.StringIO()
        # The same line ends on all systems, so that files are the same, too.
        writer = csv.DictWriter(text, self.columns, lineterminator="\n")
        for row in rows:
            # Nine digits identify every float32.
            writer.writerow({k: f"{v:.9g}" if isinstance(v, float) else v for k, v in row.items()})
        return text.getvalue()
