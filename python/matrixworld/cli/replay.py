"""``matrixworld replay``: watch a match."""

from __future__ import annotations

from pathlib import Path

import click

from matrixworld import replay
from matrixworld.cli.arguments import failures, run_of
from matrixworld.coevolution import open_run
from matrixworld.episode import Episode

LAST = -1
SLOWEST, FASTEST = 0.1, 50.0  # drawings a second that a GIF can show


def _run_or_file(ctx: click.Context, param: click.Parameter, value: str) -> tuple[str, Path | None]:
    """What was given, and the run that it names if it is no file."""
    return value, None if Path(value).is_file() else run_of(ctx, param, value)


@click.command("replay")
@click.argument("source", metavar="RUN|FILE", callback=_run_or_file)
@click.option("--pursuers", type=int, metavar="GENERATION", help="[default: the last]")
@click.option("--evaders", type=int, metavar="GENERATION", help="[default: the last]")
@click.option("--episode", type=click.IntRange(min=0), metavar="NUMBER", help="[default: 0]")
@click.option(
    "--gif",
    type=click.Path(path_type=Path, dir_okay=False),
    help="write an animation here instead of showing the match",
)
@click.option(
    "--save",
    type=click.Path(path_type=Path, dir_okay=False),
    help="write the episode here (.npz) instead of showing the match",
)
@click.option(
    "--fps",
    type=click.FloatRange(SLOWEST, FASTEST),
    default=10.0,
    show_default=True,
    metavar="NUMBER",
    help="drawings a second",
)
@click.option(
    "--every",
    type=click.IntRange(min=1),
    default=1,
    show_default=True,
    metavar="STEPS",
    help="steps from one drawing to the next",
)
def replay_command(
    source: tuple[str, Path | None],
    pursuers: int | None,
    evaders: int | None,
    episode: int | None,
    gif: Path | None,
    save: Path | None,
    fps: float,
    every: int,
) -> None:
    """Watch a match of a run.

    It is shown in the terminal, or written as a GIF. What is played is the very episode that the
    run's payoff matrix counts. Generations below 0 count from the last. FILE is an episode that
    --save or Episode.save has written.
    """
    name, run = source
    with failures():
        played = (
            _loaded(name, pursuers, evaders, episode)
            if run is None
            else _played(run, pursuers, evaders, episode)
        )
        if gif is not None:
            replay.save_gif(played, gif, fps=fps, every=every)
        if save is not None:
            played.save(save)
        if gif is None and save is None:
            replay.animate_terminal(played, fps=fps, every=every)
    caught, of = int(played.counted[-1].sum()), played.n_evaders
    written = ", ".join(str(path) for path in (gif, save) if path is not None)
    click.echo(f"{caught} of {of} evaders captured, {played.length} steps  {written}".rstrip())


def _played(run: Path, pursuers: int | None, evaders: int | None, episode: int | None) -> Episode:
    try:
        return open_run(run).record(
            LAST if pursuers is None else pursuers,
            LAST if evaders is None else evaders,
            episode or 0,
        )
    except IndexError as error:
        raise click.UsageError(str(error)) from error


def _loaded(file: str, *choice: int | None) -> Episode:
    if any(part is not None for part in choice):
        raise click.UsageError(
            f"{file} is a single episode: expected no --pursuers, --evaders or --episode with it"
        )
    try:
        return Episode.load(file)
    except ValueError as error:
        raise click.ClickException(str(error)) from error
