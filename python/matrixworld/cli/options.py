"""Options that several commands share, each declared once, and the group of all commands."""

from __future__ import annotations

import importlib
import json
import math
import os
import re
import shlex
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from itertools import chain
from pathlib import Path
from tempfile import TemporaryFile
from typing import Any, TypeVar

import click
from click.core import ParameterSource

from matrixworld import _core
from matrixworld._util.checks import INT_MAX, MOST_THREADS
from matrixworld._util.files import check_replaceable, printable, save_json
from matrixworld.cli.arguments import failures
from matrixworld.cli.console import INTERRUPTED, TO_STDOUT, note, say, say_to_stdout
from matrixworld.coevolution.sections import WORLD_HELP
from matrixworld.coevolution.settings import MOST_SEED
from matrixworld.world.rules import VARIANTS

AnyFunction = TypeVar("AnyFunction", bound=Callable[..., Any])

TYPED = "matrixworld.typed"
"""Key of the words after ``matrixworld`` in the group's context."""


def option_name(field_name: str) -> str:
    """Return the option of a settings field."""
    return "--" + field_name.replace("_", "-")


def one_of(names: Iterable[str]) -> Callable[[Any, Any, str], list[str]]:
    """Return what completes these names in a shell, for options that take other words, too."""
    return lambda ctx, param, typed: [n for n in names if n.lower().startswith(typed.lower())]


VARIANT: Mapping[str, Any] = {
    "type": click.types.FuncParamType(str.upper), "shell_complete": one_of(VARIANTS)
}  # fmt: skip


class FiniteRange(click.FloatRange):
    """A range of numbers that does not let nan pass."""

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """Return the number."""
        number = float(super().convert(value, param, ctx))
        if math.isnan(number):
            self.fail(f"{value!r} is not a number", param, ctx)
        return number


def checked_seed(ctx: click.Context, param: click.Parameter, value: int | None) -> int | None:
    """Return a seed, or None if none is given; a callback of an option."""
    # Not click.IntRange, which would print the 19 digits of the limit in every help page.
    if value is not None and not 0 <= value <= MOST_SEED:
        raise click.BadParameter(f"expected 0 to {MOST_SEED}, got {value}")
    return value


seed_option = click.option(
    "--seed",
    type=int,
    callback=checked_seed,
    default=0,
    show_default=True,
    metavar="INTEGER",
    help="seed of all random numbers; equal seeds give equal results",
)

# At least 2: intervals over episodes do not exist for one. 100 episodes bring the interval of a
# mean capture rate to about +-0.1 at worst, and are what `coevolution.score` plays by default.
episodes_option = click.option(
    "--episodes",
    type=click.IntRange(2, INT_MAX),
    default=100,
    show_default=True,
    metavar="INTEGER",
    help="fresh episodes of each pair of opponents",
)
steps_option = click.option(
    "--steps",
    type=click.IntRange(1, INT_MAX),
    metavar="INTEGER",
    help="most steps of an episode  [default: as in the evaluation of RUN; without RUN 500, in a "
    "class 100, in solve 20]",
)
threads_option = click.option(
    "--threads",
    type=click.IntRange(1, MOST_THREADS),
    metavar="INTEGER",
    help="threads that play matches  [default: one per usable core]",
)
STDOUT = Path("-")


def _json(ctx: click.Context, param: click.Parameter, value: Path | None) -> Path | None:
    if value == STDOUT:
        ctx.meta[TO_STDOUT] = True
    return value


json_option = click.option(
    "--json",
    "json_file",
    type=click.Path(path_type=Path),
    metavar="FILE",
    callback=_json,
    help="write the numbers to this file, too; -: to standard output, and the text to the other",
)
force_option = click.option("--force", is_flag=True, help="replace files that exist")


def out_option(help: str, **attributes: Any) -> Callable[[Any], Any]:
    """Return the option of the file or directory that a command writes."""
    return click.option(
        "--out", "-o", type=click.Path(path_type=Path), metavar="PATH", help=help, **attributes
    )


# Several seeds:

MOST_SEEDS = 100_000
"""Most seeds of a job. Each is a directory."""
RANGE = r"\d{1,19}(-\d{1,19})?"


def seeds_of(
    ctx: click.Context, param: click.Parameter, value: str | None
) -> tuple[int, ...] | None:
    """Return the seeds that a text such as 0-9 or 0,3,5-7 names, in its order."""
    if value is None:
        return None
    if not re.fullmatch(f"{RANGE}(,{RANGE})*", value):
        raise click.BadParameter(f"expected seeds such as 0-9 or 0,3,5-7, got {value!r}")
    ends = [[int(end) for end in part.split("-")] for part in value.split(",")]
    ranges = [range(part[0], part[-1] + 1) for part in ends]
    for each in ranges:
        if not each:
            last = each.stop - 1
            raise click.BadParameter(f"expected the lower seed first, got {each.start}-{last}")
        if each[-1] > MOST_SEED:
            raise click.BadParameter(f"expected seeds from 0 to {MOST_SEED}, got {each[-1]}")
    # Before any list is made: 0-9999999999 would fill the memory.
    count = sum(each.stop - each.start for each in ranges)
    if count > MOST_SEEDS:
        raise click.BadParameter(f"expected at most {MOST_SEEDS:,} seeds, got {count:,}")
    seeds = Counter(chain.from_iterable(ranges))
    [(seed, times)] = seeds.most_common(1)
    if times > 1:
        raise click.BadParameter(f"expected each seed once, got {seed} several times")
    return tuple(seeds)


seeds_option = click.option(
    "--seeds",
    callback=seeds_of,
    metavar="SEEDS",
    help="a run of each seed, side by side: such as 0-9 or 0,3,5-7, in place of --seed",
)


# Worlds:


def _obstacles(ctx: click.Context, param: click.Parameter, value: str | None) -> Any:
    if value is None:
        return None
    # A file that is named like a number can be given as ./0.1.
    try:
        return float(value)
    except ValueError:
        if Path(value).is_file():
            return value
    raise click.BadParameter(f"expected a density in [0, 1) or a .map file, got {value!r}")


SPECIAL: dict[str, Callable[[Any], Any]] = {
    "variant": click.option(
        "--variant",
        **VARIANT,
        metavar="NAME",
        help=f"game variant: {', '.join(VARIANTS)}; --variants of evolve explains them",
    ),
    "obstacles": click.option(
        "--obstacles",
        callback=_obstacles,
        metavar="DENSITY|FILE",
        help="density of obstacles in [0, 1), or a MovingAI .map file",
    ),
    "diagonal": click.option("--diagonal/--no-diagonal", default=None, help=WORLD_HELP["diagonal"]),
}
"""Options of a world that are no integers."""


def world_options(*names: str) -> Callable[[AnyFunction], AnyFunction]:
    """Return what adds the options of these fields of a world to a command, in this order."""

    def add(function: AnyFunction) -> AnyFunction:
        for name in reversed(names):
            option = SPECIAL.get(name) or click.option(
                option_name(name), type=int, metavar="INTEGER", help=WORLD_HELP[name]
            )
            function = option(function)
        return function

    return add


# Values:


def given_options(options: Mapping[str, Any]) -> dict[str, Any]:
    """Return those options of the current command that the user has given."""
    # Not by comparing values with defaults: a default may be given, too, and settings such as
    # --seed must be refused beside --resume even then.
    source = click.get_current_context().get_parameter_source
    return {
        name: value for name, value in options.items() if source(name) != ParameterSource.DEFAULT
    }


def refuse_existing(*files: Path | None, force: bool, redraws: bool = True) -> None:
    """Raise click.UsageError for the first output file that must not, or cannot, be written.

    To be called before anything is played or written, so that a refusal costs no time and leaves
    no part of the output behind.
    """
    for file in files:
        if file is None or file == STDOUT:
            continue
        if not file.parent.is_dir():
            raise click.UsageError(
                f"{file}: expected a directory that exists, got {str(file.parent)!r}"
            )
        try:
            TemporaryFile(dir=file.parent).close()
        except OSError as error:
            expected = f"a directory in which files can be made, got {str(file.parent)!r}"
            raise click.UsageError(f"{file}: expected {expected} ({error.strerror})") from error
        try:
            check_replaceable(file)
        except FileExistsError as error:
            # Even with --force: a directory may hold a run, and a link may point to any file.
            raise click.UsageError(str(error)) from error
        if file.exists() and not (force or (redraws and is_drawn(file))):
            raise click.UsageError(f"{file}: exists; give --force to replace it")


DRAWN = (
    b'name="generator" content="matrixworld',
    b"Software\0matrixworld",
    b"/Creator (matrixworld",
    b"<dc:title>matrixworld<",
    b"!\xfe\x0bmatrixworld",  # comment of a GIF
    b"data\0\0\0\1\0\0\0\0matrixworld",  # comment of an MP4
)
"""What this package writes into pages and pictures; they are drawn again without a question."""


def is_drawn(file: Path) -> bool:
    """Return whether a file is a page or a picture that this package has written."""
    # A film has its comment behind a table of its frames.
    size, part = file.stat().st_size, 1 << 16
    with file.open("rb") as stream:
        ends = stream.read(part)
        stream.seek(max(0, size - part))
        ends += stream.read()
    return any(mark in ends for mark in DRAWN)


def write_json(file: Path | None, values: Mapping[str, Any]) -> None:
    """Write values to what --json names, if it is given, and print the name of a file."""
    if file == STDOUT:
        say_to_stdout(json.dumps(values, indent=2, allow_nan=False))
    elif file is not None:
        save_json(file, values)
        say(f"\nWritten: {file}")


def check_environment() -> None:
    """Raise click.ClickException for a value that the engine or Matplotlib would refuse later."""
    try:
        _core.kernel_level()  # reads MATRIXWORLD_KERNELS
        if "MPLBACKEND" in os.environ:  # only then: the import takes a third of a second
            importlib.import_module("matplotlib")
    except ValueError as error:
        message = str(error).replace("Key backend", "MPLBACKEND")
        raise click.ClickException(message) from error


class Commands(click.Group):
    """A group of commands; Ctrl-C says how to go on."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the command's name, the command, and its arguments, which are kept."""
        ctx.meta[TYPED] = list(args)
        return super().resolve_command(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command; after Ctrl-C, print the command that starts it again."""
        try:
            with failures():  # of all commands, and of options, which name files, too
                check_environment()
                return super().invoke(ctx)
        except click.ClickException as error:
            # It may quote a name or a file; the attribute is final for others.
            vars(error)["message"] = printable(error.message)
            raise
        except KeyboardInterrupt:
            again = shlex.join(["matrixworld", *ctx.meta.get(TYPED, [])])
            note(f"\nStopped. No file is half written. To start again:\n  {again}")
            raise click.exceptions.Exit(INTERRUPTED) from None
