"""``matrixworld replay``: watch an episode."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from matrixworld import replay
from matrixworld.cli.arguments import failures, find_runs, run_of
from matrixworld.cli.options import obstacles_of
from matrixworld.coevolution import open_run
from matrixworld.config import WorldConfig
from matrixworld.episode import Episode
from matrixworld.policy import SCRIPTS, TeamPolicy
from matrixworld.rollout import record
from matrixworld.rules import VARIANTS, Rules, rules_of

LAST = -1
SLOWEST, FASTEST = 0.1, 50.0  # drawings a second that a GIF can show
SUFFIXES = (".gif", ".mp4", ".png", ".npz")
CHASER, FLEER = "chaser", "fleer"


def _out(ctx: click.Context, param: click.Parameter, value: tuple[Path, ...]) -> tuple[Path, ...]:
    for path in value:
        if path.suffix.lower() not in SUFFIXES:
            raise click.BadParameter(f"expected a name that ends in {', '.join(SUFFIXES)}: {path}")
    return value


def _source(ctx: click.Context, param: click.Parameter, value: str) -> Path | Rules:
    """A file, else a run, else the rules of a variant."""
    if Path(value).is_file():
        return Path(value)
    if find_runs(Path(value)):
        return run_of(ctx, param, value) or Path(value)
    try:
        return rules_of(value)
    except ValueError:
        raise click.BadParameter(
            f"expected the directory of a run, the file of an episode, or a variant "
            f"({', '.join(VARIANTS)}), got {value!r}"
        ) from None


@click.command("replay")
@click.argument("source", metavar="RUN|FILE|VARIANT", callback=_source)
@click.option("--pursuers", metavar="WHO", help="a generation of the run, or a script")
@click.option("--evaders", metavar="WHO", help="likewise")
@click.option(
    "--episode",
    type=click.IntRange(min=0),
    metavar="NUMBER",
    help="which one of the match, or of the seed  [default: 0]",
)
@click.option(
    "--seed",
    type=click.IntRange(min=0),
    metavar="INTEGER",
    help="of a variant's game  [default: 0]",
)
@click.option("--rows", type=click.IntRange(min=1), metavar="INTEGER", help="of a variant's grid")
@click.option("--cols", type=click.IntRange(min=1), metavar="INTEGER", help="of a variant's grid")
@click.option(
    "--obstacles",
    callback=obstacles_of,
    metavar="DENSITY|FILE",
    help="of a variant's grid: in [0, 1), or a MovingAI .map file",
)
@click.option(
    "--steps", type=click.IntRange(min=1), metavar="INTEGER", help="of a variant's game, at most"
)
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
@click.option(
    "--view",
    multiple=True,
    metavar="AGENT",
    help="outline in pictures what this agent sees: pursuer_0, ...; may be given several times",
)
def replay_command(
    source: Path | Rules,
    pursuers: str | None,
    evaders: str | None,
    episode: int | None,
    out: tuple[Path, ...],
    fps: float,
    every: int,
    view: tuple[str, ...],
    **world: Any,
) -> None:
    """Watch an episode in the terminal, or write it to files.

    Of a RUN it is the very episode that the payoff matrix counts: WHO is a generation, below 0
    from the last, by default the last. FILE is an episode that --out or Episode.save has written.
    VARIANT (O, SB, ...) is a new game between scripts: WHO is random, still, chaser, fleer,
    clumsy-chaser, hunter, surrounder, clumsy-fleer or dodger, by default chaser against fleer.
    """
    who: dict[str, Any] = {"pursuers": pursuers, "evaders": evaders, "episode": episode}
    if view and not out:
        raise click.UsageError("--view: expected a picture to --out together with it")
    with failures():
        if isinstance(source, Rules):
            played = _scripted(source, **who, **world)
        elif source.is_file():
            _refuse({**who, **world}, f"{source} is a single episode")
            played = _loaded(source)
        else:
            _refuse(world, f"{source} is a run")
            played = _of_run(source, **who)
        _show(played, out, fps=fps, every=every, viewers=view)
    caught, of = int(played.counted[-1].sum()), played.n_evaders
    written = ", ".join(map(str, out))
    click.echo(f"{caught} of {of} evaders captured, {played.length} steps  {written}".rstrip())


def _show(
    played: Episode, out: tuple[Path, ...], *, fps: float, every: int, viewers: tuple[str, ...]
) -> None:
    if not out:
        replay.animate_terminal(played, fps=fps, every=every)
    for path in out:
        if path.suffix.lower() == ".npz":
            played.save(path)
            continue
        try:
            replay.save(played, path, fps=fps, every=every, viewers=viewers)
        except (ImportError, ValueError) as error:
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
    rules: Rules,
    pursuers: str | None,
    evaders: str | None,
    episode: int | None,
    seed: int | None,
    steps: int | None,
    **world: Any,
) -> Episode:
    teams = _script("--pursuers", pursuers or CHASER), _script("--evaders", evaders or FLEER)
    limit: dict[str, Any] = {} if steps is None else {"max_steps": steps}
    try:
        config = WorldConfig(rules, **limit, **world)
        return record(config, *teams, seed=seed or 0, episode=episode or 0)
    except ValueError as error:
        raise click.UsageError(str(error)) from error


def _script(option: str, who: str) -> TeamPolicy:
    for script in SCRIPTS:
        if who == script:
            return script
    raise click.UsageError(f"{option}: expected {', '.join(SCRIPTS)}, got {who!r}")


def _refuse(options: Mapping[str, object], reason: str) -> None:
    given = [f"--{name}" for name, value in options.items() if value is not None]
    if given:
        raise click.UsageError(f"{reason}: expected no {', '.join(given)} with it")


def _loaded(file: Path) -> Episode:
    try:
        return Episode.load(file)
    except ValueError as error:
        raise click.ClickException(str(error)) from error
