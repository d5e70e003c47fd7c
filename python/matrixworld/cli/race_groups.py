"""Races to judge, from run directories and payoff files: grouped by settings."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, cast

import click
import numpy as np

from matrixworld._util.files import DamagedFileError
from matrixworld.analysis import Judgement, Payoffs, judge, read_payoffs
from matrixworld.cli.arguments import all_of, find_runs
from matrixworld.cli.jobs import Result
from matrixworld.cli.run_groups import (
    Unfinished,
    by_settings,
    different,
    finished_runs,
    name_and_missing,
)
from matrixworld.coevolution.settings.race import RaceSettings

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
        return judge(self.payoffs)


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


def run_groups(
    runs: Sequence[Result], unfinished: Unfinished, episodes: int | None = None
) -> list[Group]:
    """Return finished races in groups that differ in their seed only."""
    return [_of_runs(group, unfinished, episodes) for group in by_settings(runs)]


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
    names = different([group.settings for group in groups if group.settings is not None])
    return "".join(f"\n  {_shown(group.settings, names)}: {group.name}" for group in groups)


def _shown(settings: RaceSettings | None, names: Sequence[str]) -> str:
    if settings is None:
        return "a file of unknown settings"
    return ", ".join(f"{name} {getattr(settings, name)}" for name in names) or "settings of a run"


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
