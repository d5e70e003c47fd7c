"""``matrixworld bench``: how fast this machine plays; `matrixworld.bench` measures it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from matrixworld._util.checks import check_threads
from matrixworld.bench import (
    Machine,
    Measurement,
    WrongAnswerError,
    check_matches,
    check_worlds,
    measurements,
)
from matrixworld.cli.arguments import failures
from matrixworld.cli.bench_report import figures_of, print_figures, print_machine
from matrixworld.cli.console import INTERRUPTED, note, progress
from matrixworld.cli.options import (
    SectionedCommand,
    force_option,
    given_options,
    json_option,
    refuse_existing,
    threads_option,
    write_json,
)
from matrixworld.cli.setting_options import settings_from, sizes_of, world_options
from matrixworld.coevolution import RaceSettings
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import VARIANTS, rules_of

# The default of `evolve`, a common size, and the network of the published runs.
HIDDEN = ((32,), (64, 64), (400, 300))
REPEATS = 5
SECONDS = 4.0
LONGEST = 3600.0


def _variant(ctx: click.Context, param: click.Parameter, value: str) -> str:
    """Return the name of a variant, given in any form that `rules_of` accepts."""
    try:
        rules = rules_of(value)
    except ValueError as error:
        raise click.BadParameter(str(error).removeprefix("variant: ")) from None
    return next(name for name, row in VARIANTS.items() if row == rules)


def _hidden(
    ctx: click.Context, param: click.Parameter, values: tuple[str, ...]
) -> list[tuple[int, ...]]:
    # sizes_of returns None for no value only, and here every value is a string.
    given = [sizes_of(ctx, param, value) or () for value in values]
    return list(dict.fromkeys(given or HIDDEN))


def _seconds(ctx: click.Context, param: click.Parameter, value: float) -> float:
    # Not click.FloatRange, which lets nan pass.
    if not 0 < value <= LONGEST:
        raise click.BadParameter(f"expected a number above 0, at most {LONGEST:g}, got {value:g}")
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
@threads_option
@json_option
@force_option
@world_options()
def bench_command(
    variant: str,
    hidden: list[tuple[int, ...]],
    seconds: float,
    threads: int | None,
    json_file: Path | None,
    force: bool,
    **options: Any,
) -> None:
    """Measure how fast worlds and matches are played on this machine.

    Takes about a minute; other programs should not be busy meanwhile. VARIANT is a game (O, SB,
    ...), by default O. Everything is measured with one thread and with --threads. First the
    results are checked: those of many worlds against single worlds, and those of several threads
    against one.

    Ctrl-C stops, and prints what has been measured so far.
    """
    refuse_existing(json_file, force=force)
    given = given_options(options)
    # One row of races for each network; the first network is that of the world's own lines.
    races = [_races({**given, "variant": variant, "hidden": sizes}) for sizes in hidden]
    settings = [race for race, *_ in races]
    threads = check_threads(threads)
    machine, world = _machine(), settings[0].world(settings[0].eval_steps)
    print_machine(machine, variant, world)
    with failures():
        measured, stopped = _measure(settings, world, threads, seconds)
    if measured:
        figures = figures_of(measured, machine, world, races[0])
        print_figures(figures, default=variant == "O" and not given)
        with failures():
            write_json(json_file, figures)
    if stopped:
        what = "The figures are from the time before" if measured else "Nothing was measured yet"
        note(f"\nStopped. {what}.")
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
    """Return what was measured, and whether Ctrl-C stopped it."""
    planned: list[Measurement] = []
    stopped = False
    # Ctrl-C may come in the checks, too: then nothing is planned yet.
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
    # After Ctrl-C some have not been measured at all.
    return [each for each in planned if each.rates], stopped


def _check(settings: Sequence[RaceSettings], world: WorldConfig, threads: int) -> None:
    try:
        check_worlds(world, threads)
        for each in settings:
            check_matches(each.world(each.train_steps), each.network, threads)
    except WrongAnswerError as error:
        raise click.ClickException(
            f"{error}. Nothing was measured, because the results are wrong."
        ) from error


def _repeat(planned: Sequence[Measurement], seconds: float) -> None:
    """Measure everything once, then everything again, and so on."""
    # In turns, so that a disturbance of some seconds does not spoil all repeats of one line.
    total = REPEATS * len(planned)
    with progress(unit="timings") as report:
        for number in range(total):
            each = planned[number % len(planned)]
            report(each.what, number, total)
            each.repeat(seconds)
        report("done", total, total)
