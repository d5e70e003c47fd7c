"""Runs that a command plays: a single one, or several as one job."""

from __future__ import annotations

import traceback
from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import replace
from pathlib import Path

import click

from matrixworld.cli.arguments import find_runs, place_in_job, resume_command
from matrixworld.cli.console import note, progress
from matrixworld.cli.groups import Result, open_result
from matrixworld.coevolution import (
    PluginError,
    RaceSettings,
    RunDirectory,
)
from matrixworld.coevolution.jobs.evolve import BAD_FILES, described, play_job
from matrixworld.coevolution.jobs.job import Job, job_of, open_job

RUNS = Path("runs")
"""Parent directory of runs for which no directory is given."""


def default_directory(job: Job) -> Path:
    """Return the directory named after a job's variant and seeds, such as ``runs/O-seed0``."""
    settings = next(iter(job.runs.values()))
    seeds = [each.seed for each in job.runs.values()]
    named = f"seeds{seeds[0]}-{seeds[-1]}" if len({*seeds}) > 1 else f"seed{seeds[0]}"
    what = "" if settings.is_race else f"-{settings.schedule.name}"
    return RUNS / f"{settings.variant}{what}-{named}"


def new_job(settings: Sequence[RaceSettings], seeds: Sequence[int] | None) -> Job:
    """Return the job of runs that options ask for: settings of different schedules, and seeds."""
    # The order in which find_runs finds them, so that --resume prints and draws the same.
    ordered = sorted(settings, key=lambda each: place_in_job(each.schedule.name))
    if seeds is None:
        return job_of(ordered)
    return job_of([replace(each, seed=seed) for each in ordered for seed in seeds])


def found_job(root: Path) -> Job:
    """Return the job in a directory; a run's directory is a job of one."""
    job = open_job(root)
    if job is not None:
        return job
    runs = find_runs(root)
    if runs != [root] and open_job(root.parent) is not None:
        hint = resume_command(root.parent)
        raise click.UsageError(f"--resume: expected a whole job, got a part of it; {hint}")
    # Runs that were put together by hand.
    return Job({run.relative_to(root).as_posix(): RunDirectory(run).settings() for run in runs})


def play_runs(
    job: Job, root: Path, threads: int | None, executor: Executor | None = None, *, new: bool
) -> tuple[list[Result], dict[Path, str]]:
    """Play the runs of a job; return the finished ones, and why the others failed.

    The error of a single run is raised.
    """
    with progress() as bar:
        names, errors = play_job(
            job, root, keep=new, executor=executor, threads=threads, report=bar.show
        )
    for error in errors.values():
        if len(job.runs) == 1:
            raise error  # as it is: one sentence, or the traceback of the user's own code
        if isinstance(error, PluginError):  # the user's own code: the traceback is wanted
            note("".join(traceback.format_exception(error)))
    failed = {root / name: described(root / name, error) for name, error in errors.items()}
    results = []
    for path in (root / name for name in names):
        try:
            result = open_result(path)
            _ = result.payoff, result.numbers  # read now: damaged ones are named below
            results.append(result)
        except BAD_FILES as error:  # noqa: PERF203, of one run: the others are shown
            failed[path] = described(path, error)
    return results, failed
