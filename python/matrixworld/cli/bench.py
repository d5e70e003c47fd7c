"""``matrixworld bench``: how fast worlds and matches are played on this machine."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from matrixworld.bench import (
    Machine,
    Measurement,
    WrongAnswerError,
    check_matches,
    check_worlds,
    measurements,
    usable_cores,
)
from matrixworld.cli.arguments import failures
from matrixworld.cli.bench_report import figures_of, print_figures, print_machine
from matrixworld.cli.evolve import INTERRUPTED
from matrixworld.cli.options import (
    SectionedCommand,
    given_settings,
    settings_from,
    sizes_of,
    world_options,
)
from matrixworld.cli.progress import note, progress
from matrixworld.coevolution import RaceSettings
from matrixworld.config import WorldConfig
from matrixworld.files import save_json
from matrixworld.rules import VARIANTS, rules_of

HIDDEN = ((32,), (64, 64), (400, 300))
REPEATS = 5
SECONDS = 4.0
LONGEST = 3600.0
MOST_THREADS = 1024


def _variant(ctx: click.Context, param: click.Parameter, value: str) -> str:
    """The name of a variant, which may be written as `rules_of` takes it."""
    try:
        rules = rules_of(value)
    except ValueError as error:
        raise click.BadParameter(str(error).removeprefix("variant: ")) from None
    return next(name for name, row in VARIANTS.items() if row == rules)


def _hidden(
    ctx: click.Context, param: click.Parameter, values: tuple[str, ...]
) -> list[tuple[int, ...]]:
    given = [sizes_of(ctx, param, value) or () for value in values]
    return list(dict.fromkeys(given or HIDDEN))


def _seconds(ctx: click.Context, param: click.Parameter, value: float) -> float:
    if not 0 < value <= LONGEST:
        raise click.BadParameter(f"expected a number above 0, at most {LONGEST:g}, got {value:g}")
    return value


def _new_file(ctx: click.Context, param: click.Parameter, value: Path | None) -> Path | None:
    """A file to be made, refused before a minute is spent on what goes into it."""
    if value is not None and value.exists():
        raise click.BadParameter(f"expected a new file, and {str(value)!r} exists")
    if value is not None and not value.parent.is_dir():
        raise click.BadParameter(f"expected a directory that exists, got {str(value.parent)!r}")
    return value


@click.command("bench", cls=SectionedCommand)
@click.argument("variant", default="O", callback=_variant)
@click.option(
    "--hidden",
    multiple=True,
    callback=_hidden,
    metavar="SIZES",
    help="hidden layers of the networks in matches, such as 32 or 64,64; none: no hidden layer; "
    "may be given several times  [default: 32 and 64,64 and 400,300]",
)
@click.option(
    "--seconds",
    type=float,
    default=SECONDS,
    show_default=True,
    callback=_seconds,
    metavar="NUMBER",
    help=f"time of each measurement, in {REPEATS} repeats; there are about 14",
)
@click.option(
    "--threads",
    type=click.IntRange(1, MOST_THREADS),
    metavar="INTEGER",
    help="threads to measure beside one  [default: one a core]",
)
@click.option(
    "--json",
    "target",
    type=click.Path(path_type=Path),
    callback=_new_file,
    metavar="FILE",
    help="write the figures to this new file, too",
)
@world_options
def bench_command(
    variant: str,
    hidden: list[tuple[int, ...]],
    seconds: float,
    threads: int | None,
    target: Path | None,
    **options: Any,
) -> None:
    """Measure how fast worlds and matches are played on this machine.

    Takes about a minute, and wants the machine for itself. VARIANT is a game (O, SB, ...), by
    default O. First the answers are checked: that many worlds at once play as single ones do, and
    several threads as one does.

    Ctrl-C stops, and prints what has been measured so far.
    """
    given = given_settings(options)
    races = [_races({**given, "variant": variant, "hidden": sizes}) for sizes in hidden]
    settings = [race for race, *_ in races]
    threads = threads or usable_cores()
    machine, world = _machine(), settings[0].world(settings[0].eval_steps)
    print_machine(machine, variant, world)
    measured, stopped = _measure(settings, world, threads, seconds)
    if measured:
        figures = figures_of(measured, machine, world, races[0])
        print_figures(figures, default=variant == "O" and not given)
        _save(target, figures)
    if stopped:
        until = ". The figures are those until then" if measured else " before there were figures"
        note(f"\nStopped{until}.")
        raise click.exceptions.Exit(INTERRUPTED)


def _races(given: dict[str, Any]) -> list[RaceSettings]:
    return [race for race in settings_from(given) if isinstance(race, RaceSettings)]


def _machine() -> Machine:
    try:
        return Machine.this()
    except ValueError as error:
        raise click.ClickException(str(error)) from error


def _measure(
    settings: Sequence[RaceSettings], world: WorldConfig, threads: int, seconds: float
) -> tuple[list[Measurement], bool]:
    """What could be measured, and whether Ctrl-C ended it."""
    planned: list[Measurement] = []
    stopped = False
    try:
        _check(settings, world, threads)
        planned += measurements(
            world,
            settings[0].world(settings[0].train_steps),
            [each.network for each in settings],
            population=settings[0].population,
            threads=threads,
        )
        _repeat(planned, seconds / REPEATS)
    except KeyboardInterrupt:
        stopped = True
    return [each for each in planned if each.rates], stopped


def _check(settings: Sequence[RaceSettings], world: WorldConfig, threads: int) -> None:
    try:
        check_worlds(world, threads)
        for each in settings:
            check_matches(each.world(each.train_steps), each.network, threads)
    except WrongAnswerError as error:
        raise click.ClickException(
            f"{error}. Nothing was measured: a wrong answer is worth nothing, however fast."
        ) from error


def _repeat(planned: Sequence[Measurement], seconds: float) -> None:
    """Measure everything once, and again: what disturbs for a while disturbs all alike."""
    total = REPEATS * len(planned)
    with progress(unit="timings") as report:
        for number in range(total):
            each = planned[number % len(planned)]
            report(each.what, number, total)
            each.repeat(seconds)
        report("done", total, total)


def _save(target: Path | None, figures: dict[str, Any]) -> None:
    if target is None:
        return
    with failures():
        if target.exists():
            raise click.ClickException(f"{target} has come to exist meanwhile and is left alone")
        save_json(target, figures)
    click.echo(f"\nWritten: {target}")
