"""What ``matrixworld evolve`` prints at the end of a job with several seeds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from matrixworld.coevolution.many.job import group_of

if TYPE_CHECKING:
    from matrixworld.cli.jobs import Result


def report_seeds(
    results: Sequence[Result],
    asked: Mapping[str, Sequence[int]],
    root: Path,
    failed: Mapping[Path, str] = {},
    threads: int | None = None,
) -> None:
    """Print which seeds are finished, what each has played, and which ones are missing.

    Parameters
    ----------
    results : sequence of Result
        The finished runs.
    asked : mapping of str to sequence of int
        Seeds that were asked for, by schedule or other name of a group of runs.
    root : Path
        Directory of the job.
    failed : mapping of Path to str, optional
        Why runs failed, by their directories.
    threads : int, optional
        Threads that play matches. By default all cores.
    """
    for group, seeds in asked.items():
        runs = {
            each.settings.seed: each
            for each in results
            if group_of(each.path.relative_to(root).as_posix(), each.settings) == group
        }
        click.secho(f"\n{group}: {len(runs)} of {len(seeds)} seeds finished", bold=True)
        for seed, run in runs.items():
            numbers = run.numbers
            click.echo(
                f"  seed {seed}: {numbers['training_matches']:,} training matches, "
                f"{numbers['training_agent_steps']:,} agent-steps"
            )
        missing = [str(seed) for seed in seeds if seed not in runs]
        if missing:
            click.echo(f"  missing: {', '.join(missing)}")
    for path, problem in failed.items():
        click.echo(f"{path}: {problem}")
