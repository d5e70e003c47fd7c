"""Held-out scores of a job of several seeds: means and intervals over the seeds of each group."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import Estimate, fewest_runs, interquartile_mean, interval_over_runs
from matrixworld.analysis.plain_values import plain_values
from matrixworld.cli.console import print_wrapped
from matrixworld.cli.jobs import Result
from matrixworld.cli.run_groups import Unfinished, by_settings, name_and_missing
from matrixworld.cli.seed_tables import shown
from matrixworld.coevolution import HeldOutScores, Team

SCORE = {"pursuer": "capture rate", "evader": "escape rate"}
LEGEND = (
    "In brackets: 95% interval of the mean over seeds; one seed has none. In the mean every "
    f"opponent has the same weight. The interval of an interquartile mean takes {fewest_runs()} "
    "seeds."
)
FORM = ".3f"

OfTeams = Mapping[Team, HeldOutScores]


@dataclass(frozen=True)
class ScoredGroup:
    """Scores of the runs of a group that differ in their seed only.

    Parameters
    ----------
    name : str
        The directory of the seeds, or the paths.
    seeds, missing : tuple of int
        Seeds that are scored, and those of the job that are not finished.
    scores : tuple of mapping of str to HeldOutScores
        Scores of each run by team.
    """

    name: str
    seeds: tuple[int, ...]
    missing: tuple[int, ...]
    scores: tuple[OfTeams, ...]

    def rates(self, team: Team) -> NDArray[np.float64]:
        """Return mean scores (generations, seeds, opponents) of a team."""
        return np.stack([each[team].rates.mean(axis=2) for each in self.scores], axis=1)


def scored_groups(
    runs: Sequence[Result], unfinished: Unfinished, played: Mapping[Path, OfTeams]
) -> list[ScoredGroup]:
    """Return the groups of finished runs with their scores.

    Parameters
    ----------
    runs : sequence of Result
        The finished runs.
    unfinished : mapping of Path to settings
        Settings of the other runs of the job.
    played : mapping of Path to mapping of str to HeldOutScores
        Scores of the finished runs.
    """
    groups = []
    for group in by_settings(runs):
        name, missing = name_and_missing(group, unfinished)
        seeds = tuple(run.settings.seed for run in group)
        scores = tuple(played[run.path] for run in group)
        groups.append(ScoredGroup(name, seeds, tuple(missing), scores))
    return groups


def print_scored(group: ScoredGroup) -> None:
    """Print the scores of both teams over the seeds of a group."""
    of_asked = f"{len(group.seeds)} of {len(group.seeds) + len(group.missing)} seeds finished"
    click.secho(f"\n{group.name}: {of_asked}", bold=True)
    for team, scores in group.scores[0].items():
        rates = group.rates(team)
        if len(scores.generations) == 1:
            _print_last(scores, rates[0])
        else:
            _print_generations(scores, rates)
        if scores.left_out:
            print_wrapped(f"Left out: {scores.left_out}.")
    if group.missing:
        print_wrapped(f"Not finished: seeds {', '.join(map(str, group.missing))}.")


def _print_last(scores: HeldOutScores, rates: NDArray[np.float64]) -> None:
    click.echo(f"{scores.team}s of generation {scores.generations[0]}: {SCORE[scores.team]}")
    rows = _estimates(scores, rates)
    width = max(map(len, rows))
    for name, estimate in rows.items():
        click.echo(f"  {name:{width}}  {shown(estimate, FORM)}")


def _print_generations(scores: HeldOutScores, rates: NDArray[np.float64]) -> None:
    click.echo(f"{scores.team}s by generation: mean {SCORE[scores.team]}")
    for generation, of_seeds in zip(scores.generations, rates, strict=True):
        click.echo(f"  {generation:10}  {shown(_mean(of_seeds.mean(axis=1)), FORM)}")


def _estimates(scores: HeldOutScores, rates: NDArray[np.float64]) -> dict[str, Estimate]:
    """Return the estimates over seeds against each opponent, and over all of them."""
    against = {name: _mean(rates[:, k]) for k, name in enumerate(scores.opponents)}
    middle = interquartile_mean(rates)
    return {**against, "mean": _mean(rates.mean(axis=1)), "interquartile mean": middle}


def _mean(values: NDArray[np.float64]) -> Estimate:
    return interval_over_runs(values, bounds=(0.0, 1.0))


def plain_scored(group: ScoredGroup) -> dict[str, Any]:
    """Return the scores of a group as plain values: over seeds, and of each seed."""
    return {
        "seeds": list(group.seeds),
        "missing": list(group.missing),
        **{
            f"{team}s": {
                "generations": list(scores.generations),
                "over_seeds": [
                    plain_values(_estimates(scores, rates)) for rates in group.rates(team)
                ],
                "by_seed": {
                    str(seed): each[team].to_json()
                    for seed, each in zip(group.seeds, group.scores, strict=True)
                },
            }
            for team, scores in group.scores[0].items()
        },
    }
