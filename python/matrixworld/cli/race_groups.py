"""Races to judge, from run directories and payoff files: grouped by settings."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from pathlib import Path
from typing import Any, cast

import click
import numpy as np

from matrixworld.analysis import Judgement, Payoffs, read_payoffs
from matrixworld.analysis.judgement import judge_payoffs
from matrixworld.cli.arguments import all_of, find_runs
from matrixworld.cli.console import note
from matrixworld.cli.jobs import Result, open_result
from matrixworld.coevolution.many.job import open_job
from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.coevolution.storage.run_directory import RunDirectory
from matrixworld.reading import DamagedFileError

FILES = (".csv", ".npz")


@dataclass(frozen=True)
class Group:
    """Races that are judged together.

    Parameters
    ----------
    paths : tuple of Path
        Run directories, or payoff files.
    payoffs : Payoffs
        Payoffs of all of them.
    settings : RaceSettings or None
        Settings of the runs, with the seed of the first; None for files.
    name : str
        What the group is called: the directory of its seeds, or the paths.
    runs : tuple of Result, optional
        The runs; none for files.
    missing : tuple of int, optional
        Seeds of the same job that are not finished.
    """

    paths: tuple[Path, ...]
    payoffs: Payoffs
    settings: RaceSettings | None
    name: str
    runs: tuple[Result, ...] = ()
    missing: tuple[int, ...] = ()

    @property
    def seeds(self) -> tuple[int, ...]:
        """Seeds of the runs, in their order."""
        return tuple(run.settings.seed for run in self.runs)

    @cached_property
    def judgement(self) -> Judgement:
        """The judgement of all of them together."""
        return judge_payoffs(self.payoffs)


Unfinished = Mapping[Path, RaceSettings | SingleSettings]
"""Settings of runs that are not finished, by their directories."""


def of_seeds(paths: Collection[Path]) -> bool:
    """Return whether all paths are runs of a job of several seeds, ``seed-<n>``."""
    return all(re.fullmatch(r"seed-\d+", path.name) for path in paths)


def _is_payoff_file(path: Path) -> bool:
    return path.suffix.lower() in FILES and path.is_file()


def _sources(path: Path) -> list[Path]:
    """Return a payoff file as it is, else the runs that a directory is or holds."""
    return [path] if _is_payoff_file(path) else find_runs(path)


races_argument: Callable[[Any], Any] = click.argument(
    "races",
    nargs=-1,
    required=True,
    metavar="RUN|FILE...",
    callback=all_of(_sources, f"run directories, or {' or '.join(FILES)} files"),
)
"""Argument of commands that judge races: run directories or payoff files."""


def groups_of(paths: Sequence[Path], episodes: int | None) -> list[Group]:
    """Return the groups of races: runs by their settings, each payoff file on its own.

    Parameters
    ----------
    paths : sequence of Path
        Run directories and payoff files.
    episodes : int or None
        Episodes behind each cell of files that do not hold them.

    Raises
    ------
    click.UsageError
        If a run is not a finished race, two runs have the same seed, a file is not one of payoffs,
        or `episodes` differs from what a run or file holds.
    """
    files = [path for path in paths if _is_payoff_file(path)]
    runs, unfinished = finished_runs([path for path in paths if path not in files])
    for run in runs:
        # The payoff of one team alone is a single cell.
        if not run.is_race:
            raise click.UsageError(
                f"{run.path}: expected a race, got a run in which one team evolved"
            )
    groups = run_groups(runs, unfinished, episodes)
    return [*groups, *(_of_files([path], episodes) for path in files)]


def finished_runs(paths: Sequence[Path]) -> tuple[list[Result], Unfinished]:
    """Open finished runs; those of a job of several seeds need not be finished.

    Returns
    -------
    list of Result
        The finished runs.
    mapping of Path to settings
        Settings of the other ones.

    Raises
    ------
    click.UsageError
        If another run is not finished, or none is.
    """
    unfinished = {}
    for path in filter(lambda path: of_seeds([path]), paths):
        files = RunDirectory.open(path)
        if not files.finished:
            unfinished[path] = files.settings()
    runs = [open_result(path) for path in paths if path not in unfinished]
    if unfinished and not runs:
        raise click.UsageError(f"{paths[0].parent}: expected a finished run, got none")
    return runs, unfinished


def run_groups(
    runs: Sequence[Result], unfinished: Unfinished, episodes: int | None = None
) -> list[Group]:
    """Return finished races in groups that differ in their seed only."""
    _note_groups_without_runs(unfinished, runs)
    return [_of_runs(group, unfinished, episodes) for group in by_settings(runs)]


def _note_groups_without_runs(unfinished: Unfinished, runs: Sequence[Result]) -> None:
    """Name the directories of seeds of which none is finished."""
    begun = {path.parent for path in unfinished}
    for folder in sorted(begun - {run.path.parent for run in runs}):
        note(f"{folder}: no seed is finished yet, and it is left out")


def by_settings(runs: Sequence[Result]) -> list[list[Result]]:
    """Return the runs in groups that differ in their seed only, each seed once.

    Raises
    ------
    click.UsageError
        If two runs are the same.
    """
    groups: list[list[Result]] = []
    for run in runs:
        same = [group for group in groups if _same(group[0].settings, run.settings)]
        if same:
            same[0].append(run)
        else:
            groups.append([run])
    for group in groups:
        _check_seeds(group)
    return groups


def one_group(paths: Sequence[Path], episodes: int | None, hint: str = "") -> Group:
    """Return the only group of races; click.UsageError, with `hint`, for several.

    Several files are one group: that they are from races of the same settings cannot be checked.
    """
    if len(paths) > 1 and all(map(_is_payoff_file, paths)):
        return _of_files(paths, episodes)
    groups = groups_of(paths, episodes)
    if len(groups) > 1:
        raise click.UsageError(
            f"expected runs that differ in their seed only, got {len(groups)} groups{hint}:"
            f"{_described(groups)}"
        )
    return groups[0]


def _described(groups: Sequence[Group]) -> str:
    """Return a line for each group: the settings in which it differs, and its paths."""
    names = _different([group.settings for group in groups if group.settings is not None])
    return "".join(f"\n  {_shown(group.settings, names)}: {group.name}" for group in groups)


def _shown(settings: RaceSettings | None, names: Sequence[str]) -> str:
    if settings is None:
        return "a file of unknown settings"
    return ", ".join(f"{name} {getattr(settings, name)}" for name in names) or "settings of a run"


def _same(one: Any, other: Any) -> bool:
    return type(one) is type(other) and not _different([one, other])


def _different(settings: Sequence[Any]) -> list[str]:
    """Return the names of the fields, but the seed, in which settings differ."""
    values = [_resolved(each) for each in settings]
    return [name for name in values[0] if any(v[name] != values[0][name] for v in values)]


def _resolved(settings: Any) -> dict[str, Any]:
    """Return the fields, but the seed, with the values that a default stands for."""
    world = settings.world(settings.train_steps)
    given = {item.name: getattr(settings, item.name) for item in fields(settings)}
    del given["seed"]
    return {
        **given,
        "variant": settings.rules,
        "rows": world.rows,
        "cols": world.cols,
        "pursuers": world.n_pursuers,
        "evaders": world.n_evaders,
        "learner": settings.learner_name,
        "overlap_penalty": settings.resolved_overlap_penalty,
    }


def _check_seeds(runs: Sequence[Result]) -> None:
    seeds: dict[int, Path] = {}
    for run in runs:
        # Equal settings and seeds give equal runs, which are no independent observations.
        if run.settings.seed in seeds:
            raise click.UsageError(
                f"expected runs with different seeds, got the same run twice: "
                f"{seeds[run.settings.seed]}, {run.path}"
            )
        seeds[run.settings.seed] = run.path


def _of_runs(runs: Sequence[Result], unfinished: Unfinished, episodes: int | None) -> Group:
    name, missing = name_and_missing(runs, unfinished)
    return group_of_runs(name, runs, missing, episodes)


def group_of_runs(
    name: str, runs: Sequence[Result], missing: Sequence[int], episodes: int | None = None
) -> Group:
    """Return finished races of the same settings as a group."""
    scores = np.stack([run.payoff.capture_rates for run in runs])
    payoffs = _read(scores, episodes, per_episode=True)
    settings = cast(RaceSettings, runs[0].settings)  # `groups_of` refuses others
    paths = tuple(run.path for run in runs)
    return Group(paths, payoffs, settings, name, tuple(runs), tuple(missing))


def name_and_missing(runs: Sequence[Result], unfinished: Unfinished) -> tuple[str, list[int]]:
    """Return what a group of runs is called, and the seeds of its job that are not finished."""
    settings, folder = runs[0].settings, runs[0].path.parent
    waiting = {p: each.seed for p, each in unfinished.items() if _same(each, settings)}
    members = {*(run.path for run in runs), *waiting}
    # Only whole directories have seeds that are missing: of others the user left some out.
    whole = of_seeds(members) and members == set(find_runs(folder))
    asked = _asked(folder, settings) if whole else set()
    missing = sorted({*asked, *waiting.values()} - {run.settings.seed for run in runs})
    if whole and len(runs) + len(missing) > 1:
        return str(folder), missing
    return ", ".join(str(run.path) for run in runs), missing


def _asked(folder: Path, settings: Any) -> set[int]:
    """Return the seeds that the job of a directory was asked for, of these settings."""
    # Races lie in a directory of their schedule, runs of one team in that of the job.
    for root in (folder.parent, folder):
        job = open_job(root)
        if job is not None:
            return {each.seed for each in job.runs.values() if _same(each, settings)}
    return set()


def _of_files(files: Sequence[Path], episodes: int | None) -> Group:
    # One file may hold several runs, which a list of files may not.
    payoffs = _read(files[0] if len(files) == 1 else list(files), episodes)
    return Group(tuple(files), payoffs, None, ", ".join(map(str, files)))


def _read(source: Any, episodes: int | None, *, per_episode: bool = False) -> Payoffs:
    try:
        payoffs = read_payoffs(source, per_episode=per_episode)
    except DamagedFileError:
        # A ValueError, too, but the fault of a file and not of an argument.
        raise
    except (TypeError, ValueError) as error:
        raise click.UsageError(str(error)) from error
    if episodes is not None and payoffs.episodes not in (None, episodes):
        raise click.UsageError(
            f"--episodes: expected {payoffs.episodes}, which the payoffs hold, or no number, got "
            f"{episodes}"
        )
    return replace(payoffs, episodes=episodes or payoffs.episodes)
