"""Options that several commands share, each declared once; output files; failures."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Mapping
from concurrent.futures import BrokenExecutor
from pathlib import Path
from tempfile import TemporaryFile
from typing import Any

import click
from click.core import ParameterSource

from matrixworld._util.checks import INT_MAX, MOST_THREADS, OutOfMemoryError
from matrixworld._util.files import DamagedFileError, LockedError, check_replaceable, save_json
from matrixworld.cli.cluster import cluster_option
from matrixworld.cli.console import TO_STDOUT, say
from matrixworld.coevolution.jobs import FailedRunsError
from matrixworld.coevolution.learners.learner import DivergedError
from matrixworld.coevolution.sections import WORLD_HELP
from matrixworld.coevolution.settings import MOST_SEED
from matrixworld.coevolution.storage import OtherVersionError
from matrixworld.version import MissingExtraError
from matrixworld.world.rules import VARIANTS

Option = Callable[[Any], Any]
"""What adds an option to the function of a command."""

STDOUT = Path("-")
MOST_SEEDS = 100_000
"""Most seeds that a range names. Each is a directory."""


def option_name(field_name: str) -> str:
    """Return the option of a settings field."""
    return "--" + field_name.replace("_", "-")


class Existing(click.Path):
    """The path of something that exists."""

    def __init__(self, **attributes: Any) -> None:
        super().__init__(exists=True, path_type=Path, **attributes)

    def convert(self, value: Any, param: Any, ctx: Any) -> Any:
        """Return the path."""
        check_exists(value)
        return super().convert(value, param, ctx)


def check_exists(path: str | Path, expected: str = "", setting: str | None = None) -> None:
    """Refuse the path of nothing; `expected` says what its text could mean besides."""
    if not os.path.exists(path):
        told = f"{path}: no such file or directory{expected}"
        raise click.BadParameter(told, param_hint=setting)


# Values of options:


def checked_seed(ctx: click.Context, param: click.Parameter, value: int | None) -> int | None:
    """Return a seed, or None if none is given; a callback of an option."""
    # Not click.IntRange, which would print the 19 digits of the limit in every help page.
    if value is not None and not 0 <= value <= MOST_SEED:
        raise click.BadParameter(f"expected 0 to {MOST_SEED}, got {value}")
    return value


def seeds_of(
    ctx: click.Context, param: click.Parameter, value: str | None
) -> tuple[int, ...] | None:
    """Return the seeds that a text such as 0-9 or 0,3,5-7 names, in its order."""
    if value is None:
        return None
    if not re.fullmatch(r"\d{1,19}(-\d{1,19})?(,\d{1,19}(-\d{1,19})?)*", value):
        raise click.BadParameter(f"expected seeds such as 0-9 or 0,3,5-7, got {value!r}")
    seeds: list[int] = []
    for part in value.split(","):
        first, _, last = part.partition("-")
        found = range(int(first), int(last or first) + 1)
        # Before a list is made: 0-9999999999 would fill the memory.
        if not 0 < found.stop - found.start <= MOST_SEEDS:
            expected = f"1 to {MOST_SEEDS:,} seeds, the lower one first"
            raise click.BadParameter(f"expected {expected}, got {part}")
        seeds += found
    return tuple(dict.fromkeys(seeds))


def _json(ctx: click.Context, param: click.Parameter, value: Path | None) -> Path | None:
    if value == STDOUT:
        ctx.meta[TO_STDOUT] = True
    return value


def _obstacles(ctx: click.Context, param: click.Parameter, value: str | None) -> Any:
    if value is None:
        return None
    # A file that is named like a number can be given as ./0.1.
    try:
        return float(value)
    except ValueError:
        check_exists(value, "; expected a density in [0, 1) or a .map file")
        return value


# The options:


def integer(*names: str, least: int = 1, most: int = INT_MAX, default: int | None = None) -> Option:
    """Return an option of an integer: its names, and the help text as the last of them."""
    return click.option(
        *names[:-1],
        type=click.IntRange(least, most),
        default=default,
        show_default=default is not None,
        metavar="INTEGER",
        help=names[-1],
    )


SHARED: dict[str, Option] = {
    "seed": click.option(
        "--seed",
        type=int,
        callback=checked_seed,
        default=0,
        show_default=True,
        metavar="INTEGER",
        help="seed of all random numbers; equal seeds give equal results",
    ),
    "seeds": click.option(
        "--seeds",
        callback=seeds_of,
        metavar="SEEDS",
        help="a run of each seed, side by side: such as 0-9 or 0,3,5-7, in place of --seed",
    ),
    # At least 2: intervals over episodes do not exist for one. 100 episodes bring the interval of
    # a mean capture rate to about +-0.1 at worst.
    "episodes": integer(
        "--episodes", "fresh episodes of each pair of opponents", least=2, default=100
    ),
    "steps": integer(
        "--steps",
        "most steps of an episode  [default: as in the evaluation of RUN; without RUN 500, in "
        "solve 20]",
    ),
    "threads": integer(
        "--threads", "threads that play matches  [default: one per usable core]", most=MOST_THREADS
    ),
    "json": click.option(
        "--json",
        "json_file",
        type=click.Path(path_type=Path),
        metavar="FILE",
        callback=_json,
        help="write the numbers to this file, too; -: to standard output, and the text to the "
        "other",
    ),
    "force": click.option("--force", is_flag=True, help="replace files that exist"),
    "open": click.option(
        "--open/--no-open", "opens", default=True, help="open the page in a browser"
    ),
    "race": click.option(
        "--race",
        metavar="NAME",
        help="which race of RUN, if it holds several, such as hall-of-fame or hall-of-fame/seed-3  "
        "[default: the first]",
    ),
    "cluster": cluster_option,
    "variant": click.option(
        "--variant",
        type=click.types.FuncParamType(str.upper),
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
    **{
        name: click.option(option_name(name), type=int, metavar="INTEGER", help=WORLD_HELP[name])
        for name in ("rows", "cols", "n_pursuers", "n_evaders", "fov")
    },
}


def options(*names: str) -> Option:
    """Return what adds these options to a command, in this order."""

    def add(function: Any) -> Any:
        for name in reversed(names):
            function = SHARED[name](function)
        return function

    return add


def out_option(help: str, **attributes: Any) -> Option:
    """Return the option of the file or directory that a command writes."""
    return click.option(
        "--out", "-o", type=click.Path(path_type=Path), metavar="PATH", help=help, **attributes
    )


def given_options(options: Mapping[str, Any]) -> dict[str, Any]:
    """Return those options of the current command that the user has given."""
    # Not by comparing values with defaults: a default may be given, too, and settings such as
    # --seed must be refused beside --resume even then.
    source = click.get_current_context().get_parameter_source
    return {
        name: value for name, value in options.items() if source(name) != ParameterSource.DEFAULT
    }


# Output files:


def check_outputs(*files: Path | None, force: bool, redraws: bool = True) -> None:
    """Raise click.UsageError for the first output file that must not, or cannot, be written.

    To be called before anything is played or written. Pages and pictures that this package has
    drawn are drawn again without a question, if `redraws`.
    """
    for file in files:
        if file is None or file == STDOUT:
            continue
        try:
            check_replaceable(file)
            TemporaryFile(dir=file.parent).close()
        except FileExistsError as error:
            # Even with --force: a directory may hold a run, and a link may point to any file.
            raise click.UsageError(str(error)) from error
        except OSError as error:
            expected = f"a directory in which files can be made, got {str(file.parent)!r}"
            raise click.UsageError(f"{file}: expected {expected} ({error.strerror})") from error
        if file.exists() and not (force or (redraws and _is_drawn(file))):
            raise click.UsageError(f"{file}: exists; give --force to replace it")


DRAWN = (
    b'name="generator" content="matrixworld',
    b"Software\0matrixworld",
    b"/Creator (matrixworld",
    b"<dc:title>matrixworld<",
    b"!\xfe\x0bmatrixworld",  # comment of a GIF
    b"data\0\0\0\1\0\0\0\0matrixworld",  # comment of an MP4
)
"""What this package writes into pages and pictures."""


def _is_drawn(file: Path) -> bool:
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
        click.echo(json.dumps(values, indent=2, allow_nan=False))
    elif file is not None:
        save_json(file, values)
        say(f"\nWritten: {file}")


FAILURES = (
    BrokenExecutor,  # a lost cluster
    DamagedFileError,
    DivergedError,
    FailedRunsError,
    LockedError,
    MissingExtraError,
    OSError,
    OtherVersionError,
    OutOfMemoryError,
)
"""Errors whose message says all that a user can do; any other one is a mistake in the program."""
