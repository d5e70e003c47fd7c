"""Runs and payoff files in groups: what differs in its seed only is judged and shown together.

A single run is a group of one. A group is judged once; tables, figures and pages read that.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import click
import numpy as np

from matrixworld._util.files import DamagedFileError, json_digest, load_json
from matrixworld.analysis import Judgement, judge, read_payoffs
from matrixworld.analysis.payoffs import Payoffs
from matrixworld.cli.arguments import SEED, find_runs, resume_command
from matrixworld.cli.console import note
from matrixworld.coevolution import Payoff, RaceSettings, RunDirectory
from matrixworld.coevolution.evaluation.scores import HELD_OUT_VERSION
from matrixworld.coevolution.jobs import JOB, open_job
from matrixworld.version import __version__

FILES = (".csv", ".npz")
SCORES = "scores.json"
"""File in the run directory: scores against held-out opponents, played once and kept."""
SCORED_EPISODES = 100
"""Episodes of each pair. They and the seed are the defaults of ``matrixworld score``."""
SCORED_SEED = 0

Scores = dict[str, Any]
"""``HeldOutScores.to_json()`` of the last ``"pursuers"`` and of the last ``"evaders"``."""


@dataclass(frozen=True)
class Result:
    """A run of a job, which may not even have begun. What its files hold is read once."""

    files: RunDirectory
    settings: RaceSettings
    finished: bool = True

    @property
    def path(self) -> Path:
        """The run's directory."""
        return self.files.path

    @cached_property
    def payoff(self) -> Payoff:
        """The content of payoff.npz."""
        return self.files.payoff()

    @cached_property
    def numbers(self) -> dict[str, Any]:
        """The content of summary.json."""
        return self.files.summary()

    @cached_property
    def held_out(self) -> Scores:
        """Scores of the last generations against held-out opponents; `play_held_out` plays them."""
        return kept_scores(self.files) or {}


SCORED_BY = {
    "matrixworld": __version__,
    "held_out": HELD_OUT_VERSION,
    "episodes": SCORED_EPISODES,
    "seed": SCORED_SEED,
}
"""What kept scores were played by. Scores by anything else are played anew."""


def kept_scores(files: RunDirectory) -> Scores | None:
    """Return the scores in the run directory; None if none are kept there, or other ones."""
    try:
        kept = load_json(files.path / SCORES, owner=owner_of_scores(files))
    except (FileNotFoundError, DamagedFileError):
        return None
    return kept if all(kept.get(key) == value for key, value in SCORED_BY.items()) else None


def owner_of_scores(files: RunDirectory) -> str:
    """Return what seals the file: scores of another run are not taken for those of this one."""
    return f"{json_digest(files.config)}/{SCORES}"


def open_result(path: Path) -> Result:
    """Return the run of a directory, finished or not."""
    files = RunDirectory.open(path)
    return Result(files, files.settings, files.finished)


@dataclass(frozen=True)
class Group:
    """Finished runs that differ in their seed only, one or many; or payoff files, without runs.

    `paths` name it: the directory of all seeds, or those of the runs, or the files. `missing` are
    seeds of the same job that are not finished. `episodes` are those behind each cell of payoffs
    that do not hold them.
    """

    paths: tuple[Path, ...]
    runs: tuple[Result, ...] = ()
    missing: tuple[int, ...] = ()
    episodes: int | None = None

    @property
    def name(self) -> str:
        """What the group is called: its paths."""
        return ", ".join(map(str, self.paths))

    def inside(self, root: Path) -> Group:
        """Return the same group with its paths inside the directory of its job."""
        return replace(self, paths=tuple(_inside(path, root) for path in self.paths))

    @property
    def seeds(self) -> tuple[int, ...]:
        """Seeds of the runs, in their order."""
        return tuple(run.settings.seed for run in self.runs)

    @property
    def several(self) -> bool:
        """Whether several seeds were asked for."""
        return len(self.runs) + len(self.missing) > 1

    @property
    def is_race(self) -> bool:
        """Whether both teams evolved."""
        return all(run.settings.is_race for run in self.runs)

    @property
    def settings(self) -> RaceSettings | None:
        """Settings of the runs, with the seed of the first; None for files."""
        return self.runs[0].settings if self.runs else None

    @cached_property
    def payoffs(self) -> Payoffs:
        """Payoffs of all runs, or of the files."""
        if not self.runs:
            # One file may hold several runs, which a list of files may not.
            source = self.paths[0] if len(self.paths) == 1 else list(self.paths)
            return read_payoffs(source, episodes=self.episodes)
        rates = np.stack([run.payoff.capture_rates for run in self.runs])
        return read_payoffs(rates, per_episode=True, episodes=self.episodes)

    @cached_property
    def judgement(self) -> Judgement:
        """The judgement of all of them together."""
        return judge(self.payoffs)

    @cached_property
    def singles(self) -> tuple[Group, ...]:
        """Each run, or each file, as a group of its own."""
        if self.runs:
            alone = [Group((run.path,), (run,), episodes=self.episodes) for run in self.runs]
            return tuple(alone) if self.several else (self,)
        return tuple(Group((file,), episodes=self.episodes) for file in self.paths)

    def finished_of_asked(self) -> str:
        """Return how many seeds are finished, such as ``"9 of 10"``."""
        return f"{len(self.runs)} of {len(self.runs) + len(self.missing)}"


# Arguments of commands:


def _is_payoff_file(path: Path) -> bool:
    return path.suffix.lower() in FILES and path.is_file()


def runs_argument(*, files: bool = False, required: bool = True) -> Callable[[Any], Any]:
    """Return the argument of directories of jobs or runs, perhaps of payoff files, too."""
    metavar = "RUN|FILE..." if files else "RUN..."
    expected = f"run directories, or {' or '.join(FILES)} files" if files else "run directories"

    def found(ctx: click.Context, param: click.Parameter, values: Sequence[str]) -> list[Path]:
        paths: list[Path] = []
        for value in values:
            is_file = files and _is_payoff_file(Path(value))
            here = [Path(value)] if is_file else find_runs(Path(value))
            if not here:
                raise click.BadParameter(f"expected {expected}, got {value!r}")
            paths += here
        # A run may be named twice: by itself, and by the directory that holds it.
        return list(dict.fromkeys(paths))

    return click.argument(
        "runs",
        nargs=-1,
        required=required,
        metavar=metavar if required else f"[{metavar}]",
        callback=found,
    )


# Groups:


def groups_of(
    paths: Sequence[Path], *, episodes: int | None = None, unfinished: bool = False
) -> list[Group]:
    """Return the groups of run directories, and one of all payoff files.

    Of several runs those that are not finished are left out, and named. With `unfinished` a single
    one need not be finished.
    """
    files = tuple(path for path in paths if _is_payoff_file(path))
    runs = [open_result(path) for path in paths if path not in files]
    if unfinished and len(runs) == 1:
        runs = [Result(runs[0].files, runs[0].settings)]
    if runs and not any(run.finished for run in runs):
        first = runs[0].path
        again = resume_command(job_above(first) or first)
        raise click.UsageError(f"{first}: expected a finished run; {again} continues it")
    groups = grouped([*runs, *_not_begun([run.path for run in runs])], episodes)
    for group in groups:
        if not group.runs:
            note(f"{group.name}: no seed is finished yet, and it is left out")
    of_files = [Group(files, episodes=episodes)] if files else []
    return [*(group for group in groups if group.runs), *of_files]


def grouped(runs: Iterable[Result], episodes: int | None = None) -> list[Group]:
    """Return runs, finished or not, in groups that differ in their seed only."""
    found: dict[tuple[RaceSettings, float], list[Result]] = {}
    for run in runs:
        # A penalty that is given by its default value makes no difference.
        settings, usual = run.settings, replace(run.settings.fitness, overlap_penalty=None)
        key = replace(settings.method, fitness=usual), settings.overlap_penalty
        found.setdefault(key, []).append(run)
    return [_group(members, episodes) for members in found.values()]


def _group(members: Sequence[Result], episodes: int | None) -> Group:
    finished = tuple(run for run in members if run.finished)
    seeds: dict[int, Path] = {}
    for run in finished:
        # Equal settings and seeds give equal runs, which are no independent observations.
        first = seeds.setdefault(run.settings.seed, run.path)
        if first != run.path:
            raise click.UsageError(
                f"expected runs with different seeds, got the same run twice: {first}, {run.path}"
            )
    missing = {run.settings.seed for run in members} - seeds.keys()
    return Group(_paths(members), finished, tuple(sorted(missing)), episodes)


def _paths(members: Sequence[Result]) -> tuple[Path, ...]:
    """Return the directory of seeds if all of them are there, else the paths."""
    folder, paths = members[0].path.parent, {run.path.absolute() for run in members}
    of_seeds = all(re.fullmatch(SEED, path.name) for path in paths)
    if of_seeds and {*find_runs(folder.absolute())} <= paths:
        return (folder,)
    return tuple(run.path for run in members)


# Directories of jobs:


def _inside(path: Path, root: Path) -> Path:
    path, folder = path.absolute(), root.absolute()
    if path == folder:
        return Path(path.name)
    return path.relative_to(folder) if path.is_relative_to(folder) else path


def job_above(path: Path) -> Path | None:
    """Return the directory of the job that a run or its group belongs to; None without a job."""
    for folder in (path.absolute(), *path.absolute().parents[:2]):
        if (folder / JOB).exists():
            return folder if path.is_absolute() else Path(os.path.relpath(folder))
    return None


def _not_begun(paths: Collection[Path]) -> list[Result]:
    """Return the runs that have not begun, of jobs and groups all of whose runs are given.

    Of others the user has left some out.
    """
    given = {path.absolute() for path in paths}
    whole = cache(lambda folder: _all_in(folder, given))
    found: dict[Path, Result] = {}
    for root in {root for path in paths if (root := job_above(path)) is not None}:
        job = open_job(root)
        for name, settings in {} if job is None else job.items():
            path = root / name
            folders = (path.parent.absolute(), root.absolute())
            if path.absolute() not in given and any(map(whole, folders)):
                found[path] = Result(RunDirectory(path), settings, finished=False)
    return list(found.values())


def _all_in(folder: Path, given: Collection[Path]) -> bool:
    runs = find_runs(folder)
    return bool(runs) and {*runs} <= {*given}


def place_of(paths: Sequence[Path]) -> Path:
    """Return where files about runs go: the directory of their job, if all of it is given.

    Else it is the directory that holds all of them, or the single run.
    """
    root = job_above(paths[0])
    if root is not None and _all_in(root.absolute(), {path.absolute() for path in paths}):
        return root
    if len(paths) == 1:
        return paths[0]
    return Path(os.path.commonpath([path.absolute() for path in paths]))
