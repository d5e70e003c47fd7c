"""Races to judge, from run directories and payoff files: grouped by settings."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any, cast

import click
import numpy as np

from matrixworld.analysis import Payoffs, read_payoffs
from matrixworld.cli.arguments import all_of, find_runs
from matrixworld.cli.jobs import Result, open_result
from matrixworld.coevolution.settings.race import RaceSettings
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
    """

    paths: tuple[Path, ...]
    payoffs: Payoffs
    settings: RaceSettings | None

    @property
    def name(self) -> str:
        """The paths."""
        return ", ".join(map(str, self.paths))


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
    runs = [_race(path) for path in paths if path not in files]
    by_settings: list[list[Result]] = []
    for run in runs:
        same = [g for g in by_settings if not _different([g[0].settings, run.settings])]
        if same:
            same[0].append(run)
        else:
            by_settings.append([run])
    groups = [_of_runs(group, episodes) for group in by_settings]
    return [*groups, *(_of_files([path], episodes) for path in files)]


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


def _different(settings: Sequence[Any]) -> list[str]:
    """Return the names of the fields, but the seed, in which settings differ."""
    values = [_resolved(each) for each in settings]
    return [name for name in values[0] if any(v[name] != values[0][name] for v in values)]


def _resolved(settings: RaceSettings) -> dict[str, Any]:
    """Return the fields, but the seed, with the values that a default stands for."""
    world = settings.world(settings.train_steps)
    given = {item.name: getattr(settings, item.name) for item in fields(RaceSettings)}
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


def _race(path: Path) -> Result:
    run = open_result(path)
    # The payoff of one team alone is a single cell.
    if not run.is_race:
        raise click.UsageError(f"{path}: expected a race, got a run in which one team evolved")
    return run


def _of_runs(runs: Sequence[Result], episodes: int | None) -> Group:
    seeds: dict[int, Path] = {}
    for run in runs:
        # Equal settings and seeds give equal runs, which are no independent observations.
        if run.settings.seed in seeds:
            raise click.UsageError(
                f"expected runs with different seeds, got the same run twice: "
                f"{seeds[run.settings.seed]}, {run.path}"
            )
        seeds[run.settings.seed] = run.path
    scores = np.stack([run.payoff.capture_rates for run in runs])
    paths = tuple(run.path for run in runs)
    settings = cast(RaceSettings, runs[0].settings)  # `_race` refuses others
    return Group(paths, _read(scores, episodes, per_episode=True), settings)


def _of_files(files: Sequence[Path], episodes: int | None) -> Group:
    # One file may hold several runs, which a list of files may not.
    return Group(tuple(files), _read(files[0] if len(files) == 1 else list(files), episodes), None)


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
