"""Finished runs in groups that differ in their seed only, and the seeds that are missing."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import fields
from pathlib import Path, PurePath
from typing import Any

import click

from matrixworld.cli.arguments import SEED, find_runs, run_of
from matrixworld.cli.console import note
from matrixworld.cli.jobs import Result, open_result
from matrixworld.coevolution.jobs.job import open_job
from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.coevolution.storage.run_directory import RunDirectory

Unfinished = Mapping[Path, RaceSettings | SingleSettings]
"""Settings of runs that are not finished, by their directories."""


def of_seeds(paths: Collection[Path]) -> bool:
    """Return whether all paths are runs of jobs, ``seed-<n>``."""
    return all(re.fullmatch(SEED, path.name) for path in paths)


def of_several_seeds(paths: Collection[Path]) -> bool:
    """Return whether all paths are runs of jobs, and some differ in their seed only."""
    return of_seeds(paths) and len({path.parent for path in paths}) < len(paths)


def run_or_seeds(ctx: click.Context, param: click.Parameter, value: str) -> list[Path]:
    """Return the run of a directory, or all runs of a job of several seeds."""
    runs = find_runs(Path(value))
    if of_several_seeds(runs):
        return runs
    run = run_of(ctx, param, value)
    return [] if run is None else [run]


def finished_runs(paths: Sequence[Path]) -> tuple[list[Result], Unfinished]:
    """Open finished runs; those of a job of several seeds need not be finished.

    Directories of seeds of which none is finished are named.

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
    _note_groups_without_runs(runs, unfinished)
    return runs, unfinished


def _note_groups_without_runs(runs: Sequence[Result], unfinished: Unfinished) -> None:
    """Name the directories of seeds of which none is finished."""
    finished, all_runs = {run.path.parent for run in runs}, {*unfinished, *(r.path for r in runs)}
    groups = {path.parent for path in all_runs} | _groups_not_begun(all_runs)
    for folder in sorted(groups - finished):
        note(f"{folder}: no seed is finished yet, and it is left out")


def _groups_not_begun(paths: Collection[Path]) -> set[Path]:
    """Return the directories that jobs will have, if all runs of a job that exist are given."""
    found = set()
    for root in {path.parent.parent for path in paths if of_seeds([path])}:
        job = open_job(root)
        if job is not None and set(find_runs(root)) <= set(paths):
            found |= {(root / name).parent for name in job.runs}
    return found


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


def root_of(runs: Sequence[Result]) -> Path:
    """Return the directory of a job, if all of its runs are there, else what the runs share."""
    common = Path(os.path.commonpath([run.path.absolute().parent for run in runs]))
    job = open_job(common.parent)
    # A job of one schedule, all of whose runs lie in one directory below that of the job.
    if job is not None and all(PurePath(name).parts[0] == common.name for name in job.runs):
        return common.parent
    return common


def _asked(folder: Path, settings: Any) -> set[int]:
    """Return the seeds that the job of a directory was asked for, of these settings."""
    job = open_job(folder.parent)
    return {each.seed for each in job.runs.values() if _same(each, settings)} if job else set()


def _same(one: Any, other: Any) -> bool:
    return type(one) is type(other) and not different([one, other])


def different(settings: Sequence[Any]) -> list[str]:
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
