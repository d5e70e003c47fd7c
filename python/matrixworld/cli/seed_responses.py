"""Best responses to the champions of a job of several seeds: gains, and their mean over seeds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import click

from matrixworld.analysis import Estimate, interval_over_runs
from matrixworld.cli.console import print_table, print_wrapped
from matrixworld.cli.jobs import Result
from matrixworld.cli.run_groups import Unfinished, by_settings, name_and_missing
from matrixworld.cli.seed_tables import shown
from matrixworld.coevolution import BestResponse

LEGEND = (
    "Gain: score of the response minus that of the champion's last opponent in its own run. In "
    "brackets: 95% interval over the episodes; of the mean, over the seeds. Each champion is "
    "exploitable by at least its gain; a larger budget may find more."
)
GAINS = (-1.0, 1.0)


@dataclass(frozen=True)
class RespondedGroup:
    """Responses to the champions of runs that differ in their seed only.

    Parameters
    ----------
    name : str
        The directory of the seeds, or the paths.
    responses : dict of int to BestResponse
        Responses by the seed of the champion's run.
    missing : tuple of int
        Seeds of the job that are not finished.
    """

    name: str
    responses: dict[int, BestResponse]
    missing: tuple[int, ...]

    def mean_gain(self) -> Estimate:
        """Return the mean gain, with an interval over the seeds."""
        gains = [each.gain.gain.value for each in self.responses.values()]
        return interval_over_runs(gains, bounds=GAINS)


def responded_groups(
    runs: Sequence[Result], unfinished: Unfinished, played: Mapping[Path, BestResponse]
) -> list[RespondedGroup]:
    """Return the groups of finished runs with the responses to their champions.

    Parameters
    ----------
    runs : sequence of Result
        The finished runs.
    unfinished : mapping of Path to settings
        Settings of the other runs of the job.
    played : mapping of Path to BestResponse
        Responses by the directory of the champion's run.
    """
    groups = []
    for group in by_settings(runs):
        name, missing = name_and_missing(group, unfinished)
        responses = {run.settings.seed: played[run.path] for run in group}
        groups.append(RespondedGroup(name, responses, tuple(missing)))
    return groups


def print_responded(group: RespondedGroup, score: str) -> None:
    """Print a line for each seed of a group, and the mean gain.

    Parameters
    ----------
    group : RespondedGroup
        The group.
    score : str
        What the scores are.
    """
    of_asked = f"{len(group.responses)} of {len(group.responses) + len(group.missing)} seeds"
    click.secho(f"\n{group.name}: {score}, {of_asked}", bold=True)
    rows = [["seed", "before", "response", "gain"]]
    rows += [
        [str(seed), f"{each.before.mean():.3f}", f"{each.after.mean():.3f}", f"{each.gain.gain}"]
        for seed, each in group.responses.items()
    ]
    rows.append(["mean", "", "", shown(group.mean_gain(), ".3f")])
    print_table(rows, ">>><")
    if group.missing:
        print_wrapped(f"Not finished: seeds {', '.join(map(str, group.missing))}.")
