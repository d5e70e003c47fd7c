"""``matrixworld score``: a run's teams against opponents that no run has met."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from functools import partial
from pathlib import Path

import click

from matrixworld.cli.arguments import failures
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
from matrixworld.cli.run_groups import finished_runs, run_or_seeds
from matrixworld.cli.seed_scores import LEGEND as SEEDS_LEGEND
from matrixworld.cli.seed_scores import SCORE, plain_scored, print_scored, scored_groups
from matrixworld.coevolution import HeldOutScores, Report, SavedRun, Team, open_run, score

ALL = "all"
LAST = -1
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
@click.argument("runs", metavar="RUN", callback=run_or_seeds)
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
    runs: list[Path],
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
    all runs meet them in the same episodes: runs can be compared. RUN need not be finished. Of a
    job of several seeds (evolve --seeds) the finished ones are scored: mean and interval over the
    seeds of each group.

    With --cluster the workers of a Dask cluster play blocks of the matches. It pays with
    --generation all and many episodes. The workers need not see RUN.
    """
    refuse_existing(json_file, force=force)
    with failures(), on_cluster(where, threads) as executor:
        play = partial(_play, generation, episodes, steps, seed, threads, executor)
        if len(runs) == 1:
            [scores] = _play_all(runs, play).values()
            _print(scores)
            teams = {f"{team}s": each.to_json() for team, each in scores.items()}
            write_json(json_file, {"run": str(runs[0]), "seed": seed, **teams})
            return
        finished, unfinished = finished_runs(runs)
        played = _play_all([run.path for run in finished], play)
        groups = scored_groups(finished, unfinished, played)
        for group in groups:
            print_scored(group)
        click.echo()
        print_wrapped(SEEDS_LEGEND)
        plain = {group.name: plain_scored(group) for group in groups}
        write_json(json_file, {"seed": seed, "groups": plain})


Play = Callable[[SavedRun, Report], dict[Team, HeldOutScores]]


def _play_all(paths: Sequence[Path], play: Play) -> dict[Path, dict[Team, HeldOutScores]]:
    """Score runs one after the other, with one progress for all."""
    found = {}
    with progress() as report:
        for number, path in enumerate(paths):
            # Runs of a job play about equally many matches.
            def part(what: str, done: int, total: int, number: int = number) -> None:
                place = f"[{number + 1}/{len(paths)}] " if len(paths) > 1 else ""
                report(place + what, number * total + done, len(paths) * total)

            found[path] = play(open_run(path), part)
    return found


def _play(
    generation: int | None,
    episodes: int,
    steps: int | None,
    seed: int,
    threads: int | None,
    executor: Executor | None,
    saved: SavedRun,
    report: Report,
) -> dict[Team, HeldOutScores]:
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
