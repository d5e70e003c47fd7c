"""What ``matrixworld evolve`` draws, writes and prints when its runs are finished."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from matrixworld._util.files import save_json
from matrixworld.cli.arguments import run_name
from matrixworld.cli.console import TERMS, command
from matrixworld.cli.explore import write_explorer
from matrixworld.cli.figures import draw_comparison, draw_run
from matrixworld.cli.held_out import held_out_scores
from matrixworld.cli.judgements import counts, print_head, print_judgement
from matrixworld.cli.race_tables import print_claims, print_comparison
from matrixworld.coevolution import SingleSettings
from matrixworld.coevolution.types import other
from matrixworld.explorer.runs_page import PAGE

if TYPE_CHECKING:
    from matrixworld.cli.held_out import Scores
    from matrixworld.cli.jobs import Result


def report(results: Sequence[Result], root: Path, threads: int | None = None) -> None:
    """Score and judge the races among finished runs, draw figures, and print the results.

    Parameters
    ----------
    results : sequence of Result
        The runs of one job.
    root : Path
        Directory of the job: of its single run, or the parent of several.
    threads : int, optional
        Threads that play matches against held-out opponents. By default all cores.
    """
    races = {run_name(each.path): each for each in results if each.is_race}
    scores = held_out_scores(list(races.values()), threads)
    # Nothing is refused here: figures of an earlier report of the same runs are replaced.
    drawn = {each.path: draw_run(each) for each in results}
    for each in results:
        if not each.is_race:
            _print_single(each)
    if len(races) > 1:
        draw_comparison(races, root / "comparison.png")
        numbers = {n: {**race.numbers, "held_out": scores[race.path]} for n, race in races.items()}
        save_json(root / "summary.json", {"runs": numbers})
    write_explorer(results, root / PAGE)
    if races:
        _print_races(races, scores)
    _print_files(drawn, root, races=len(races))
    _print_next(results, root)


def _print_races(races: Mapping[str, Result], scores: Mapping[Path, Scores]) -> None:
    print_comparison(races, scores)
    for name, race in races.items():
        print_head(f"{name}: {counts(race.judgement)}")
        print_judgement(race.judgement)
    print_claims(races)
    click.echo(f"\n{TERMS}")


def _print_single(run: Result) -> None:
    settings, numbers = run.settings, run.numbers
    if isinstance(settings, SingleSettings):
        click.secho(f"\n{run.path}", bold=True)
        click.echo(
            f"  {settings.team}s after {settings.epochs} epochs against {settings.against}, in "
            f"{numbers['evaluation_matches']} fresh episodes of at most {settings.eval_steps} "
            f"steps:\n"
            f"  capture rate {_with_interval(numbers, 'capture_rate', '.4f')}\n"
            f"  length in steps {_with_interval(numbers, 'length', '.1f')}"
        )


def _with_interval(numbers: Mapping[str, Any], name: str, form: str) -> str:
    """Return a mean over episodes, its interval and the standard deviation, in words."""
    mean, low, high, std = (numbers[name + end] for end in ("", "_low", "_high", "_std"))
    if low is None:
        return f"{mean:{form}} (in every episode)"
    return (
        f"{mean:{form}} (95% interval of the mean {low:{form}} to {high:{form}}; standard "
        f"deviation of an episode {std:{form}})"
    )


def _print_files(drawn: Mapping[Path, Sequence[Path]], root: Path, *, races: int) -> None:
    click.echo(f"\nAll files are in {root}:")
    click.echo(f"  {PAGE}: open it in a browser; it plays every match of the payoff matrices")
    if races > 1:
        click.echo("  comparison.png: the races side by side; summary.json: their numbers")
    for path, figures in drawn.items():
        place = "" if path == root else f"{path.relative_to(root)}/: "
        click.echo(f"  {place}{', '.join(figure.name for figure in figures)}")
    scores = ", scores.json" if races else ""
    click.echo(f"  data of each run: payoff.npz, *.npy (genomes), log.csv, summary.json{scores}")


def _print_next(results: Sequence[Result], root: Path) -> None:
    # The last run: of the default job the generalists, whose late pursuers are worth watching.
    path, settings = results[-1].path, results[-1].settings
    click.echo("\nWhat to try next:")
    if isinstance(settings, SingleSettings):
        _print_commands(
            command("replay", path, "--out match.gif"),
            command("evolve --against", path, f"--team {other(settings.team)}"),
        )
        return
    last = settings.generations
    match = f"--pursuer {last} --evader {last // 2}"
    paths = [each.path for each in results]
    each_run = ["--each"] if len(paths) > 1 else []
    _print_commands(
        command("replay", path, match),
        command("replay", path, match, "--out match.gif"),
        command("diagnose", root, *each_run, "--explain"),
        command("analyze", path),
        command("score", path),
        command("tournament", *paths[:2]),
        command("plot", *paths, "--force"),
    )


def _print_commands(*commands: str) -> None:
    for each in commands:
        click.echo(f"  {each}")
