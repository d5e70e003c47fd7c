"""What a job has come to: figures, summary, and what is printed."""

from __future__ import annotations

import shlex
import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path

import click

from matrixworld.analysis import Summary, describe, summarize
from matrixworld.cli.figures import draw_comparison, draw_run
from matrixworld.coevolution import SavedRun, SingleSettings, open_run
from matrixworld.coevolution.types import other
from matrixworld.files import save_json

CLAIMS = {"specialist-specialist": "cycling", "generalist-generalist": "progress"}
"""What the paper reports of its schedules (Sun et al. 2023)."""
LOOKS = {
    "cycling": "looks like cycling",
    "progress": "looks like progress",
    "undecided": "is undecided",
}
WIDEST = 100  # columns of printed text


def report(paths: Sequence[Path], root: Path) -> None:
    """Draw the figures of finished runs, write what compares them, and print all in words."""
    runs = {path: open_run(path) for path in paths}
    drawn = {path: draw_run(path) for path in paths}
    races = {path.name: run for path, run in runs.items() if is_race(run)}
    for path, run in runs.items():
        if not is_race(run):
            _print_single(path, run)
    if races:
        _report_races(races, root if len(races) > 1 else None)
    _print_files(drawn, root)
    _print_next(runs)


def is_race(run: SavedRun) -> bool:
    """Whether both teams evolved."""
    return not isinstance(run.settings, SingleSettings)


def _report_races(races: Mapping[str, SavedRun], compared_in: Path | None) -> None:
    payoffs = {name: run.payoff().capture_rate for name, run in races.items()}
    summaries = {name: summarize(payoff) for name, payoff in payoffs.items()}
    if compared_in is not None:
        draw_comparison(payoffs, compared_in / "comparison.png")
        numbers = {name: run.files.summary() for name, run in races.items()}
        save_json(compared_in / "summary.json", {"runs": numbers})
    for name, summary in summaries.items():
        click.secho(f"\n{name}", bold=True)
        print_wrapped(describe(summary))
    if len(races) > 1:
        print_table(summaries)
    click.echo()
    for name, run in races.items():
        _print_claim(name, run, summaries[name])


def print_wrapped(text: str) -> None:
    """Print each line of a text as an indented paragraph as wide as the terminal."""
    width = min(WIDEST, shutil.get_terminal_size().columns)
    for line in text.splitlines():
        click.echo(click.wrap_text(line, width, initial_indent="  ", subsequent_indent="    "))


def print_table(summaries: Mapping[str, Summary]) -> None:
    """Print the headline numbers of races, one a line."""
    width = max(len("race"), *map(len, summaries))
    heads = ("transitive share", "checkerboards", "swing", "lag rise")
    click.echo(f"\n{'race':{width}}  {'  '.join(heads)}")
    for name, summary in summaries.items():
        late = summary.last_half
        cells = (
            _number(late.transitive_share, ".2f"),
            _number(late.checkerboard_share, ".1%"),
            f"{summary.swing:.2f}",
            f"{summary.lag_rise:+.2f}",
        )
        aligned = (f"{cell:>{len(head)}}" for cell, head in zip(cells, heads, strict=True))
        click.echo(f"{name:{width}}  {'  '.join(aligned)}  {LOOKS[summary.verdict]}")


def _number(value: float | None, form: str) -> str:
    return "-" if value is None else format(value, form)


def _print_claim(name: str, run: SavedRun, summary: Summary) -> None:
    claim = None if isinstance(run.settings, SingleSettings) else CLAIMS.get(run.settings.schedule)
    if claim is not None:
        here = "as here" if summary.verdict == claim else f"this run {LOOKS[summary.verdict]}"
        click.echo(f"{name}: the paper reports {claim} of this schedule, {here}.")


def _print_single(path: Path, run: SavedRun) -> None:
    settings, numbers = run.settings, run.files.summary()
    if isinstance(settings, SingleSettings):
        click.secho(f"\n{path}", bold=True)
        click.echo(
            f"  {settings.team}s after {settings.epochs} epochs against {settings.against}, in "
            f"{numbers['evaluation_matches']} fresh episodes of at most {settings.eval_steps} "
            f"steps:\n"
            f"  capture rate {numbers['capture_rate']:.4f} +- {numbers['capture_rate_std']:.4f}, "
            f"length {numbers['length']:.1f} +- {numbers['length_std']:.1f} steps"
        )


def _print_files(drawn: Mapping[Path, Sequence[Path]], root: Path) -> None:
    click.echo(f"\nEverything is in {root}:")
    if len(drawn) > 1:
        click.echo("  comparison.png: the races side by side; summary.json: their numbers")
    for path, figures in drawn.items():
        place = "" if path == root else f"{path.name}/: "
        click.echo(f"  {place}{', '.join(figure.name for figure in figures)}")
    click.echo("  and for further work payoff.npz, archive.npz, log.csv, summary.json")


def _print_next(runs: Mapping[Path, SavedRun]) -> None:
    *_, (path, run) = runs.items()
    click.echo("\nWhat to try next:")
    if isinstance(run.settings, SingleSettings):
        _print_command("replay", path, "--out match.gif")
        _print_command("evolve --against", path, f"--team {other(run.settings.team)}")
        return
    last = run.settings.generations
    match = f"--pursuers {last} --evaders {last // 2}"
    _print_command("replay", path, match)
    _print_command("replay", path, match, "--out match.gif")
    _print_command("diagnose", path)
    _print_command("score", path)
    _print_command("tournament", *runs, *(["--episodes 50"] if len(runs) == 1 else []))
    _print_command("plot", *runs)


def _print_command(name: str, *words: Path | str) -> None:
    quoted = [shlex.quote(str(word)) if isinstance(word, Path) else word for word in words]
    click.echo(f"  matrixworld {name} {' '.join(quoted)}")
