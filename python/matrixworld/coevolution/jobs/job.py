"""A job: the runs that were asked for, by the names of their directories, and its file.

The file is written before any run begins. A job that is stopped, even at once, therefore knows the
runs that have not begun.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from matrixworld._util.checks import shown
from matrixworld._util.files import load_json, one_line, save_json
from matrixworld.coevolution.schedules import Against
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import OtherVersionError
from matrixworld.version import __version__
from matrixworld.world.policy import SCRIPTS

JOB = "job.json"
FORMAT = 1
"""Version of the file's layout; another one is refused."""
NAME = re.compile(r"\w[\w.=+-]*(/\w[\w.=+-]*)?")
"""Names of runs: relative paths of one or two parts that every system accepts."""

ITSELF = "."
"""Name of the only run of a job whose directory is that of the run, as `finish` makes it."""


@dataclass(frozen=True)
class Job:
    """Runs that were asked for together: settings by the path of a run's directory in the job's."""

    runs: Mapping[str, RaceSettings]


def job_of(settings: RaceSettings | Sequence[RaceSettings] | Mapping[str, RaceSettings]) -> Job:
    """Return the job of these settings, perhaps by name; without names each run gets one.

    Raises TypeError or ValueError if there are no settings, two runs have the same name or the same
    settings, or a name is not the path of a directory.
    """
    if isinstance(settings, RaceSettings):
        settings = [settings]
    given: Iterable[tuple[str, Any]] = (
        settings.items() if isinstance(settings, Mapping) else map(_named, settings)
    )
    runs: dict[str, RaceSettings] = {}
    for name, each in given:
        if not isinstance(each, RaceSettings):
            raise TypeError(f"settings: expected RaceSettings, got {shown(each)}")
        if name in runs:
            raise ValueError(
                f"settings: expected runs of different schedules or seeds, or a name for each, "
                f"got two of {name}"
            )
        runs[name] = _from_anywhere(each)
    _check_names(runs)
    # Equal runs are no independent observations.
    names: dict[RaceSettings, str] = {}
    for name, each in runs.items():
        other = names.setdefault(each, name)
        if other != name:
            raise ValueError(f"settings: expected different runs, got {other} and {name}, equal")
    return Job(runs)


def _named(settings: Any) -> tuple[str, Any]:
    # What is no settings is refused by `job_of`.
    folder = settings.schedule.name if isinstance(settings, RaceSettings) else ""
    return f"{folder}/seed-{getattr(settings, 'seed', None)}", settings


def _check_names(runs: Mapping[str, RaceSettings]) -> None:
    if not runs:
        raise ValueError("settings: expected at least one run, got none")
    for name in runs:
        if not isinstance(name, str) or not NAME.fullmatch(name) or name == JOB:
            expected = "names such as sigma-0.1 or sigma-0.1/seed-3"
            raise ValueError(f"settings: expected {expected}, got {shown(name)}")
        # A run inside the directory of another one would be one of its files.
        if "/" in name and name.partition("/")[0] in runs:
            raise ValueError(f"settings: expected runs beside each other, got {name} in a run")


def _from_anywhere(settings: RaceSettings) -> RaceSettings:
    """Return settings whose paths mean the same in another current directory, as workers have."""
    schedule = settings.schedule
    if not isinstance(schedule, Against):
        return settings
    paths = {"opponent": schedule.opponent, "start": schedule.start}
    absolute: dict[str, Any] = {
        name: str(Path(path).absolute())
        for name, path in paths.items()
        if path is not None and path not in SCRIPTS
    }
    return replace(settings, schedule=replace(schedule, **absolute))


def group_of(name: str) -> str:
    """Return the name of the runs that differ from a run in their seed only, such as a schedule."""
    return name.rpartition("/")[0] or name


# The file:


def save_job(directory: Path, job: Job) -> None:
    """Write the file of a job into its directory."""
    # Settings that differ in the seed only are written once: 1,000 seeds take 40 kB, not 3 MB.
    groups: dict[str, dict[str, Any]] = {}
    for name, settings in job.runs.items():
        values = settings.to_json()
        seed = values.pop("seed")
        key = json.dumps(values, sort_keys=True)
        groups.setdefault(key, {"settings": values, "seeds": {}})["seeds"][name] = seed
    head = {"format": FORMAT, "matrixworld": __version__}
    save_json(directory / JOB, {**head, "groups": list(groups.values())})


def open_job(directory: str | Path) -> Job | None:
    """Return the job of a directory, None if it holds no file of a job.

    Raises DamagedFileError or OtherVersionError if the file cannot be read.
    """
    path = Path(directory) / JOB
    if not path.exists():
        return None
    values = load_json(path)
    if values.get("format") != FORMAT:
        got = one_line(values.get("format"))
        raise OtherVersionError(f"{path}: expected format {FORMAT}, got {got}")
    try:
        job = Job({name: each for group in values["groups"] for name, each in _runs_in(group)})
        _check_names(job.runs)
    except (AttributeError, KeyError, OverflowError, TypeError, ValueError) as error:
        # The checksum was correct, so that the file is not damaged.
        raise OtherVersionError(
            f"{path}: expected settings of matrixworld {__version__}, got those of "
            f"{one_line(values.get('matrixworld', 'unknown'))}: {one_line(error)}"
        ) from error
    return job


def _runs_in(group: Mapping[str, Any]) -> list[tuple[str, RaceSettings]]:
    return [
        (name, RaceSettings.from_json({**group["settings"], "seed": seed}))
        for name, seed in group["seeds"].items()
    ]
