"""``matrixworld replay``: watch an episode."""

from __future__ import annotations

from pathlib import Path

import click

from matrixworld import replay
from matrixworld.cli.arguments import failures, run_of
from matrixworld.coevolution import open_run
from matrixworld.config import WorldConfig
from matrixworld.episode import Episode
from matrixworld.policy import SCRIPTS, Team
from matrixworld.rollout import record
from matrixworld.rules import VARIANTS

LAST = -1
SLOWEST, FASTEST = 0.1, 50.0  # drawings a second that a GIF can show
SUFFIXES = (".gif", ".mp4", ".png", ".npz")
CHASER, FLEER = "chaser", "fleer"


def _out(ctx: click.Context, param: click.Parameter, value: tuple[Path, ...]) -> tuple[Path, ...]:
    for path in value:
        if path.suffix.lower() not in SUFFIXES:
            raise click.BadParameter(f"expected a name that ends in {', '.join(SUFFIXES)}: {path}")
    return value


@click.command("replay")
@click.argument("source", metavar="RUN|FILE|VARIANT")
@click.option("--pursuers", metavar="WHO", help="a generation of the run, or a script")
@click.option("--evaders", metavar="WHO", help="a generation of the run, or a script")
@click.option(
    "--episode",
    type=click.IntRange(min=0),
    metavar="NUMBER",
    help="which one of the match, or of the seed  [default: 0]",
)
@click.option("--seed", type=click.IntRange(min=0), metavar="INTEGER", help="of a variant's game")
@click.option("--rows", type=click.IntRange(min=1), metavar="INTEGER", help="of a variant's grid")
@click.option("--cols", type=click.IntRange(min=1), metavar="INTEGER", help="of a variant's grid")
@click.option(
    "--out",
    type=click.Path(path_type=Path, dir_okay=False),
    multiple=True,
    callback=_out,
    metavar="FILE",
    help="write it here instead of showing it: .gif, .mp4, .png (its last moment) or .npz (the "
    "episode itself); may be given several times",
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
    source: str,
    pursuers: str | None,
    evaders: str | None,
    episode: int | None,
    seed: int | None,
    rows: int | None,
    cols: int | None,
    out: tuple[Path, ...],
    fps: float,
    every: int,
) -> None:
    """Watch an episode in the terminal, or write it to files.

    Of a RUN it is the very episode that the payoff matrix counts: WHO is a generation, below 0
    from the last, by default the last. FILE is an episode that --out or Episode.save has written.
    VARIANT (O, SB, ...) is a new game between scripts: WHO is random, still, chaser or fleer, by
    default chaser against fleer.
    """
    world = {"seed": seed, "rows": rows, "cols": cols}
    with failures():
        if Path(source).is_file():
            _require_none(source, pursuers, evaders, episode, *world.values())
            played = _loaded(source)
        elif source.upper() in VARIANTS and not Path(source).exists():
            played = _scripted(source, pursuers, evaders, episode, **world)
        else:
            run = run_of(click.get_current_context(), replay_command.params[0], source)
            assert run is not None
            if any(value is not None for value in world.values()):
                raise click.UsageError("expected --seed, --rows and --cols with a variant only")
            played = _of_run(run, pursuers, evaders, episode)
        _show(played, out, fps=fps, every=every)
    caught, of = int(played.counted[-1].sum()), played.n_evaders
    written = ", ".join(map(str, out))
    click.echo(f"{caught} of {of} evaders captured, {played.length} steps  {written}".rstrip())


def _show(played: Episode, out: tuple[Path, ...], *, fps: float, every: int) -> None:
    if not out:
        replay.animate_terminal(played, fps=fps, every=every)
    for path in out:
        if path.suffix.lower() == ".npz":
            played.save(path)
            continue
        try:
            replay.save(played, path, fps=fps, every=every)
        except ImportError as error:
            raise click.ClickException(str(error)) from error


def _of_run(run: Path, pursuers: str | None, evaders: str | None, episode: int | None) -> Episode:
    try:
        return open_run(run).record(
            _generation("--pursuers", pursuers), _generation("--evaders", evaders), episode or 0
        )
    except IndexError as error:
        raise click.UsageError(str(error)) from error


def _generation(option: str, who: str | None) -> int:
    if who is None:
        return LAST
    try:
        return int(who)
    except ValueError:
        raise click.UsageError(f"{option}: expected a generation of the run, got {who!r}") from None


def _scripted(
    variant: str,
    pursuers: str | None,
    evaders: str | None,
    episode: int | None,
    *,
    seed: int | None,
    rows: int | None,
    cols: int | None,
) -> Episode:
    teams = _script("--pursuers", pursuers or CHASER), _script("--evaders", evaders or FLEER)
    try:
        config = WorldConfig(variant, rows=rows, cols=cols)
        return record(config, *teams, seed=seed or 0, episode=episode or 0)
    except ValueError as error:
        raise click.UsageError(str(error)) from error


def _script(option: str, who: str) -> Team:
    for script in SCRIPTS:
        if who == script:
            return script
    raise click.UsageError(f"{option}: expected {', '.join(SCRIPTS)}, got {who!r}")


def _require_none(file: str, *choice: object) -> None:
    if any(part is not None for part in choice):
        raise click.UsageError(
            f"{file} is a single episode: expected no --pursuers, --evaders, --episode, --seed, "
            "--rows or --cols with it"
        )


def _loaded(file: str) -> Episode:
    try:
        return Episode.load(file)
    except ValueError as error:
        raise click.ClickException(str(error)) from error
