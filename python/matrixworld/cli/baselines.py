"""Baselines of figures: teams that were trained in another way, against the races' opponents."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import click

from matrixworld.cli.jobs import Result
from matrixworld.coevolution.evaluation.baselines import scores_in_race, trained_team
from matrixworld.coevolution.storage.saved_run import (
    SavedRun,
    open_run,
    open_runs,
    run_directories,
)
from matrixworld.coevolution.types import TEAMS, Team

Scores = dict[Team, dict[str, float]]
"""Mean scores by team and by the name of the baseline."""


def _parsed(ctx: click.Context, param: click.Parameter, values: Sequence[str]) -> dict[str, Path]:
    named: dict[str, Path] = {}
    for value in values:
        name, separator, path = value.partition("=")
        if not (name and separator and path):
            raise click.BadParameter(f"expected NAME=RUN, got {value!r}")
        if name in named:
            raise click.BadParameter(f"expected each name once, got {name!r} twice")
        named[name] = Path(path)
    return named


baseline_option = click.option(
    "--baseline",
    "baselines",
    multiple=True,
    callback=_parsed,
    metavar="NAME=RUN",
    help="a team that was trained in another way (evolve --against): its last generation plays "
    "against the race's opponents, and is a level line in the figure of generalisation. RUN may "
    "hold a run for each seed of the races. May be repeated",
)


def open_baselines(baselines: Mapping[str, Path]) -> dict[str, list[SavedRun]]:
    """Return the runs of each baseline; click.UsageError if one is no run of one team."""
    for name, path in baselines.items():
        if not run_directories(path):
            raise click.UsageError(
                f"--baseline {name}: expected a directory that holds runs: {path}"
            )
    opened = {name: open_runs(path) for name, path in baselines.items()}
    for name, runs in opened.items():
        if not runs:
            raise click.UsageError(f"--baseline: expected a finished run, got {baselines[name]}")
        try:
            teams = {trained_team(run)[0] for run in runs}
        except ValueError as error:
            raise click.UsageError(f"--baseline: {error}") from error
        if len(teams) > 1:
            raise click.UsageError(
                f"--baseline: expected runs of one team, got both teams in {baselines[name]}"
            )
    return opened


def baseline_scores(race: Result, baselines: Mapping[str, Sequence[SavedRun]]) -> Scores:
    """Return the mean score of each baseline against all opponents of a race."""
    scores: Scores = {team: {} for team in TEAMS}
    if not baselines:
        return scores
    opponents = open_run(race.path)
    for name, runs in baselines.items():
        team, champion = trained_team(_of_seed(name, runs, race.settings.seed))
        scores[team][name] = float(scores_in_race(opponents, team, champion).mean())
    return scores


def _of_seed(name: str, runs: Sequence[SavedRun], seed: int) -> SavedRun:
    """Return the run with the seed of the race; the only one, if there is only one."""
    if len(runs) == 1:
        return runs[0]
    found = [run for run in runs if run.settings.seed == seed]
    if len(found) != 1:
        raise click.UsageError(
            f"--baseline {name}: expected one run of seed {seed}, or one in all, got {len(found)}"
        )
    return found[0]
