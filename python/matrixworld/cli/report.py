"""What ``matrixworld evolve`` draws, writes and prints when its runs are finished."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from matrixworld.analysis import Summary, describe
from matrixworld.cli.console import TERMS, command, print_table, print_wrapped
from matrixworld.cli.figures import draw_comparison, draw_run
from matrixworld.coevolution import SingleSettings
from matrixworld.coevolution.types import other
from matrixworld.files import save_json

if TYPE_CHECKING:
    from matrixworld.cli.jobs import Result


CLAIMS = {"specialist-specialist": "cycling", "generalist-generalist": "progress"}
"""What the paper reports of its schedules (Sun et al. 2023)."""
LOOKS = {
    "cycling": "looks like cycling",
    "progress": "looks like progress",
    "undecided": "is undecided",
}


def report(results: Sequence[Result], root: Path) -> None:
    """Draw the figures of finished runs, compare the races, and print the results in words.

    Parameters
    ----------
    results : sequence of Result
        The runs of one job.
    root : Path
        Directory of the job: of its single run, or the parent of several.
    """
    # Nothing is refused here: figures of an earlier report of the same runs are replaced.
    drawn = {each.path: draw_run(each) for each in results}
    races = {each.path.name: each for each in results if each.is_race}
    for each in results:
        if not each.is_race:
            _print_single(each)
    if len(races) > 1:
        draw_comparison(races, root / "comparison.png")
        numbers = {name: race.numbers for name, race in races.items()}
        save_json(root / "summary.json", {"runs": numbers})
    if races:
        _print_races(races)
    _print_files(drawn, root, compared=len(races) > 1)
    _print_next(results)


def _print_races(races: Mapping[str, Result]) -> None:
    for name, race in races.items():
        click.secho(f"\n{name}", bold=True)
        print_wrapped(describe(race.summary))
    if len(races) > 1:
        _print_comparison({name: race.summary for name, race in races.items()})
    click.echo()
    for name, race in races.items():
        _print_claim(name, race)
    click.echo(TERMS)


def _print_comparison(summaries: Mapping[str, Summary]) -> None:
    heads = ("race", "transitive share", "checkerboards", "swing", "lag rise", "")
    rows = [
        (
            name,
            _number(summary.last_half.transitive_share, ".2f"),
            _number(summary.last_half.checkerboard_share, ".1%"),
            f"{summary.swing:.2f}",
            f"{summary.lag_rise:+.2f}",
            LOOKS[summary.verdict],
        )
        for name, summary in summaries.items()
    ]
    click.echo()
    print_table([heads, *rows], "<>>>><")


def _number(value: float | None, form: str) -> str:
    return "-" if value is None else format(value, form)


def _print_claim(name: str, race: Result) -> None:
    settings, verdict = race.settings, race.summary.verdict
    claim = None if isinstance(settings, SingleSettings) else CLAIMS.get(settings.schedule)
    if claim is not None:
        here = "as here" if verdict == claim else f"this run {LOOKS[verdict]}"
        click.echo(f"{name}: the paper reports {claim} of this schedule, {here}.")


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


def _print_files(drawn: Mapping[Path, Sequence[Path]], root: Path, *, compared: bool) -> None:
    click.echo(f"\nAll files are in {root}:")
    if compared:
        click.echo("  comparison.png: the races side by side; summary.json: their numbers")
    for path, figures in drawn.items():
        place = "" if path == root else f"{path.name}/: "
        click.echo(f"  {place}{', '.join(figure.name for figure in figures)}")
    click.echo("  data of each run: payoff.npz, archive.npz, log.csv, summary.json")


def _print_next(results: Sequence[Result]) -> None:
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
    _print_commands(
        command("replay", path, match),
        command("replay", path, match, "--out match.gif"),
        command("diagnose", path),
        command("score", path),
        command("tournament", *paths[:2]),
        command("plot", *paths, "--force"),
    )


def _print_commands(*commands: str) -> None:
    for each in commands:
        click.echo(f"  {each}")
