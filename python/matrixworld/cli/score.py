"""``matrixworld score``: a run's teams against opponents that no run has met."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import click

from matrixworld.cli.arguments import failures, run_of
from matrixworld.cli.clusters import cluster_option, on_cluster
from matrixworld.cli.console import print_wrapped, progress
from matrixworld.cli.options import (
    episodes_option,
    force_option,
    json_option,
    refuse_existing,
    seed_option,
    steps_option,
    threads_option,
    write_json,
)
from matrixworld.coevolution import HeldOutScores, SavedRun, Team, open_run, score

ALL = "all"
LAST = -1
SCORE = {"pursuer": "capture rate", "evader": "escape rate"}
LEGEND = (
    "In brackets: 95% interval over the episodes. Runs with other seeds may differ by more. In the "
    "mean every opponent has the same weight."
)


def _generation(ctx: click.Context, param: click.Parameter, value: str) -> int | None:
    """Return the number of a generation, or None for all."""
    if value == ALL:
        return None
    try:
        return int(value)
    except ValueError:
        raise click.BadParameter(f"expected a generation or {ALL}, got {value!r}") from None


@click.command("score")
@click.argument("run", callback=run_of)
@click.option(
    "--generation",
    default=str(LAST),
    callback=_generation,
    metavar="NUMBER|all",
    help="which one, negative numbers from the last; all: means of every one  [default: the last]",
)
@episodes_option
@steps_option
@seed_option
@json_option
@force_option
@threads_option
@cluster_option
def score_command(
    run: Path,
    generation: int | None,
    episodes: int,
    steps: int | None,
    seed: int,
    json_file: Path | None,
    force: bool,
    threads: int | None,
    where: str | None,
) -> None:
    """Score a run's teams against held-out opponents.

    The opponents are scripts of different skill and, in worlds with the default views and actions,
    small networks that come with the package. No run has learnt against them, and with one --seed
    all runs meet them in the same episodes: runs can be compared. RUN need not be finished.

    With --cluster the workers of a Dask cluster play blocks of the matches. It pays with
    --generation all and many episodes. The workers need not see RUN.
    """
    refuse_existing(json_file, force=force)
    with failures():
        scores = _play(open_run(run), generation, episodes, steps, seed, threads, where)
        _print(scores)
        teams = {f"{team}s": each.to_json() for team, each in scores.items()}
        write_json(json_file, {"run": str(run), "seed": seed, **teams})


def _play(
    saved: SavedRun,
    generation: int | None,
    episodes: int,
    steps: int | None,
    seed: int,
    threads: int | None,
    where: str | None,
) -> dict[Team, HeldOutScores]:
    with on_cluster(where, threads) as executor, progress() as report:
        try:
            return score(
                saved,
                generation=generation,
                episodes=episodes,
                steps=steps,
                seed=seed,
                threads=threads,
                report=report,
                executor=executor,
            )
        except IndexError as error:
            # The message begins with "generation", which is an option here.
            raise click.UsageError(f"--{error}") from error


def _print(scores: Mapping[Team, HeldOutScores]) -> None:
    for each in scores.values():
        (_print_team if len(each.generations) == 1 else _print_curve)(each)
        if each.left_out:
            print_wrapped(f"Left out: {each.left_out}.")
    click.echo()
    print_wrapped(LEGEND)
    matches = sum(each.matches for each in scores.values())
    click.echo(f"{matches:,} matches were played.")


def _print_team(scores: HeldOutScores) -> None:
    [generation] = scores.generations
    click.secho(f"\n{scores.team}s of generation {generation}: {SCORE[scores.team]}", bold=True)
    rows = {name: scores.against(name) for name in scores.opponents}
    # Its own interval: that of a mean is narrower than those of its parts.
    rows["mean"] = scores.mean()
    width = max(map(len, rows))
    for name, estimate in rows.items():
        click.echo(f"  {name:{width}}  {estimate}")


def _print_curve(scores: HeldOutScores) -> None:
    click.secho(f"\n{scores.team}s by generation: mean {SCORE[scores.team]}", bold=True)
    for row, generation in enumerate(scores.generations):
        click.echo(f"  {generation:10}  {scores.mean(row)}")
