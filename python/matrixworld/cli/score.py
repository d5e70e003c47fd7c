"""``matrixworld score``: a run's teams against opponents that it has not met."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import click

from matrixworld.cli.arguments import failures, run_of, threads_option
from matrixworld.cli.progress import progress
from matrixworld.cli.report import print_wrapped
from matrixworld.coevolution import HeldOutScores, SavedRun, Team, open_run, score
from matrixworld.files import save_json

ALL = "all"
LAST = -1
SCORE = {"pursuer": "capture rate", "evader": "escape rate"}
LEGEND = (
    "In brackets: what the luck of these episodes leaves open (95%). Other seeds of the run may "
    "differ by more. The mean counts every opponent the same."
)


def _generation(ctx: click.Context, param: click.Parameter, value: str) -> int | None:
    if value == ALL:
        return None
    try:
        return int(value)
    except ValueError:
        raise click.BadParameter(f"expected a generation or {ALL}, got {value!r}") from None


@click.command("score")
@click.argument("run", callback=run_of)
@click.option(
    "--generation", default=str(LAST), callback=_generation, metavar="NUMBER|all",
    help="which one, below 0 from the last; all: means of every one  [default: the last]",
)  # fmt: skip
@click.option(
    "--episodes", type=click.IntRange(min=2), default=100, show_default=True, metavar="INTEGER",
    help="episodes against each opponent",
)  # fmt: skip
@click.option(
    "--steps", type=click.IntRange(min=1), metavar="INTEGER",
    help="most steps of an episode  [default: as in the evaluation of RUN]",
)  # fmt: skip
@click.option(
    "--seed", type=click.IntRange(0, 2**63 - 1), default=0, show_default=True, metavar="INTEGER",
    help="seed of the episodes, the same for every run",
)  # fmt: skip
@click.option(
    "--json", "json_file", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
    help="write the numbers to a file, too",
)  # fmt: skip
@threads_option
def score_command(
    run: Path,
    generation: int | None,
    episodes: int,
    steps: int | None,
    seed: int,
    json_file: Path | None,
    threads: int | None,
) -> None:
    """Score a run's teams against held-out opponents.

    They are scripts of different skill and, in worlds seen and walked as by default, small networks
    that come with the package. No run has learnt against them, so that runs can be compared. RUN
    need not be finished.
    """
    with failures():
        saved = open_run(run)
        scores = _play(saved, generation, episodes, steps, seed, threads)
        if json_file is not None:
            teams = {f"{team}s": each.to_json() for team, each in scores.items()}
            save_json(json_file, {"run": str(run), "seed": seed, **teams})
    _print(scores)
    if json_file is not None:
        click.echo(f"\nWritten: {json_file}")


def _play(
    saved: SavedRun,
    generation: int | None,
    episodes: int,
    steps: int | None,
    seed: int,
    threads: int | None,
) -> dict[Team, HeldOutScores]:
    with progress() as report:
        try:
            return score(
                saved,
                generation=generation,
                episodes=episodes,
                steps=steps,
                seed=seed,
                threads=threads,
                report=report,
            )
        except IndexError as error:
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
    rows["mean"] = scores.mean()
    width = max(map(len, rows))
    for name, estimate in rows.items():
        click.echo(f"  {name:{width}}  {estimate}")


def _print_curve(scores: HeldOutScores) -> None:
    click.secho(f"\n{scores.team}s by generation: mean {SCORE[scores.team]}", bold=True)
    for row, generation in enumerate(scores.generations):
        click.echo(f"  {generation:10}  {scores.mean(row)}")
