"""What several commands share: options, each declared once; runs as arguments; output files."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import BrokenExecutor
from pathlib import Path, PurePath
from tempfile import TemporaryFile
from typing import Any

import click
from click.core import ParameterSource

from matrixworld._util import checks, files
from matrixworld._util.constraints import Whole
from matrixworld.cli import cluster, console
from matrixworld.coevolution import groups
from matrixworld.coevolution.games.pursuit import WORLD_HELP
from matrixworld.coevolution.learners.learner import DivergedError
from matrixworld.coevolution.runs.places import CONFIG, abbreviated, find_runs, new_directory
from matrixworld.coevolution.runs.stored_files import OtherVersionError
from matrixworld.coevolution.saved_run import SavedRun
from matrixworld.coevolution.settings.race_settings import MOST_SEED
from matrixworld.play.functions import PlayerError
from matrixworld.version import MissingExtraError
from matrixworld.world.rules import VARIANTS

Option = Callable[[Any], Any]
"""What adds an option to the function of a command."""

MOST_SEEDS = 100_000
"""Most seeds that a range names. Each is a directory."""
FAILURES = (
    BrokenExecutor,  # a lost cluster
    DivergedError,
    MissingExtraError,
    OSError,
    checks.OutOfMemoryError,
    cluster.OtherWorkerError,
    files.DamagedFileError,
    files.LockedError,
    OtherVersionError,
    PlayerError,
)
"""Errors whose message says all that a user can do; any other one is a mistake in the program."""


def option_name(field_name: str) -> str:
    """Return the option of a settings field, as the current command writes it."""
    context = click.get_current_context(silent=True)
    params = context.command.params if context else ()
    written = {str(param.name): param.opts[0] for param in params}
    return written.get(field_name, "--" + field_name.replace("_", "-"))


def refuse_beside(subject: str, names: Iterable[str], why: str = "", *, fact: str = "") -> None:
    """Raise click.UsageError if options of these names are given beside an option or argument.

    The message begins with this `subject`, perhaps with a `fact` about it: "my-race is a run".
    """
    if refused := ", ".join(map(option_name, sorted(names))):
        begin = f"{subject} {fact}" if fact else subject
        raise click.UsageError(f"{begin}: expected no {refused} beside it{why}")


def refusal(path: str | Path, expected: str) -> str:
    """Return the sentence about a path that is none of what is expected."""
    if os.path.exists(path):
        return f"expected {expected}, got {str(path)!r}"
    return f"{path}: no such file or directory; expected {expected}"


# Values of options:


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
        count = int(last or first) - int(first) + 1
        # Before a list is made: 0-9999999999 would fill the memory.
        if not 0 < count <= MOST_SEEDS:
            expected = f"1 to {MOST_SEEDS:,} seeds, the lower one first"
            raise click.BadParameter(f"expected {expected}, got {part}")
        seeds += range(int(first), int(first) + count)
    return tuple(dict.fromkeys(seeds))


def _obstacles(ctx: click.Context, param: click.Parameter, value: str | None) -> float | str | None:
    """Return a density or the path of a file."""
    # A file that is named like a number can be given as ./0.1.
    if value is None:
        return None
    try:
        return float(value)
    except ValueError:
        if os.path.exists(value):
            return value
        expected = "a density in [0, 1) or a .map file"
        raise click.BadParameter(refusal(value, expected)) from None


def _cluster(ctx: click.Context, param: click.Parameter, value: str | None) -> str | None:
    """Return the name, address or file of a cluster."""
    if value is None or value == cluster.AUTO or "://" in value or Path(value).is_file():
        return value
    expected = f"{cluster.AUTO}, an address such as tcp://HOST:8786 or a scheduler file"
    raise click.BadParameter(refusal(value, expected))


# The options:


class Integers(click.IntRange):
    """Integers in a range; others are refused in the words of the settings."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the integer; click.BadParameter for any other value."""
        number = click.INT.convert(value, param, ctx)
        if expected := Whole(int(self.min or 0), int(self.max or 0)).expected(number):
            self.fail(f"expected {expected}, got {value}", param, ctx)
        return number


def integer(
    *names: str, least: int = 1, most: int = checks.INT_MAX, default: int | None = None
) -> Option:
    """Return an option of an integer: its names, and the help text as the last of them."""
    return click.option(
        *names[:-1],
        type=Integers(least, most),
        default=default,
        show_default=default is not None,
        metavar="INTEGER",
        help=names[-1],
    )


SHARED: dict[str, Option] = {
    "seed": integer(
        "--seed",
        "seed of all random numbers; equal seeds give equal results",
        least=0,
        most=MOST_SEED,
        default=0,
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
    "steps": integer("--steps", "most steps of an episode  [default: 500, in solve 20]"),
    "threads": integer(
        "--threads",
        "threads that play matches  [default: one per usable core]",
        most=checks.MOST_THREADS,
    ),
    "json": click.option(
        "--json",
        "json_file",
        type=click.Path(path_type=Path),
        metavar="FILE",
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
    "cluster": click.option(
        "--cluster",
        "where",
        metavar="auto|ADDRESS|FILE",
        callback=_cluster,
        help="play on a Dask cluster: auto (this machine), tcp://HOST:8786, or a scheduler file",
    ),
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


def shared(*names: str) -> Option:
    """Return what adds these options to a command, in this order."""

    def add(function: Any) -> Any:
        for name in reversed(names):
            function = SHARED[name](function)
        return function

    return add


def out(text: str, **attributes: Any) -> Option:
    """Return the option of the file that a command writes."""
    return click.option(
        "--out", "-o", type=click.Path(path_type=Path), metavar="PATH", help=text, **attributes
    )


def names_given() -> set[str]:
    """Return the names of the options of the current command that the user has given."""
    # Not by comparing values with defaults: a default may be given, too, and settings such as
    # --seed must be refused beside --resume even then.
    context = click.get_current_context()
    default = ParameterSource.DEFAULT
    return {name for name in context.params if context.get_parameter_source(name) != default}


def given(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return those options of the current command that the user has given."""
    names = names_given()
    return {name: value for name, value in values.items() if name in names}


# Runs as arguments:


def runs(*suffixes: str) -> Option:
    """Return the argument of directories of jobs or runs, and of files with these suffixes."""
    expected = "run directories"
    if suffixes:
        expected += f", or {' or '.join(suffixes)} files"

    def checked(ctx: click.Context, param: click.Parameter, values: Sequence[Path]) -> list[Path]:
        paths = [unpacked(path) for path in dict.fromkeys(values)]
        for path in paths:
            is_file = path.is_file() and path.suffix.lower() in suffixes
            if not is_file and not find_runs(path):
                raise click.BadParameter(refusal(path, expected))
        return paths

    return click.argument(
        "sources" if suffixes else "runs",
        nargs=-1,
        required=True,
        type=click.Path(path_type=Path),
        metavar="RUN|FILE..." if suffixes else "RUN...",
        callback=checked,
    )


def unpacked(path: Path) -> Path:
    """Return the directory of an archive that the page evolve.html has saved, unpacked beside it.

    Any other path is returned as it is. A directory that holds something else is not changed.
    """
    if path.suffix.lower() != ".zip" or not path.is_file():
        return path
    directory = path.with_suffix("")
    parts = files.read_archive(path, "archive of a race", lambda part: part.read())
    if CONFIG not in parts or not all(re.fullmatch(r"\.?\w[\w.-]*", name) for name in parts):
        raise click.BadParameter(f"{path}: expected an archive of a race, got none of its files")
    if not directory.exists():
        with new_directory(directory) as place:
            for name, content in parts.items():
                (place / name).write_bytes(content)
    for name, content in parts.items():
        file = directory / name
        if not file.is_file() or file.read_bytes() != content:
            expected = f"its own run in {directory}"
            raise click.BadParameter(f"{path}: expected {expected}, got other files")
    return directory


def finished_groups(
    directories: Sequence[Path], *, unfinished: bool = False
) -> list[groups.RunGroup]:
    """Return the groups of finished runs in directories; say which have none.

    With `unfinished` a single run need not be finished.
    """
    paths = [path for directory in directories for path in find_runs(directory)]
    if unfinished and len(paths) == 1:
        return groups.grouped(map(SavedRun, paths), finished=paths)
    with console.warnings_as_notes():  # of runs of other versions
        opened = groups.open_groups(*directories)
    if not any(group.runs for group in opened):
        again = resume_command(directories[0])
        raise click.UsageError(f"{directories[0]}: expected a finished run; {again} continues it")
    for group in opened:
        if not group.runs:
            console.note(f"{group.name}: no seed is finished yet, and it is left out")
    return [group for group in opened if group.runs]


def run_in(path: str | Path, race: str | None = None) -> Path:
    """Return the run of a directory.

    Of several runs `race` chooses those below the directory of this name. The first one of them is
    taken, and a note says so.
    """
    runs = find_runs(Path(path))
    if not runs:
        raise click.UsageError(refusal(path, "a directory that holds a run"))
    listed = abbreviated([str(run.relative_to(path)) for run in runs])
    chosen = [run for run in runs if _is_in_race(run.relative_to(path), race or "")]
    if not chosen:
        races = f"--race with one of its races, {listed}"
        raise click.UsageError(f"{path}: expected {races}, got {race}")
    if len(chosen) > 1:
        others = f"the first of {len(chosen)} races; --race chooses another: {listed}"
        console.note(f"{chosen[0]}: {others}")
    return chosen[0]


def _is_in_race(name: Path, race: str) -> bool:
    """Return whether the name of a run in its job begins, or ends, with that of a race."""
    wanted = PurePath(race).parts
    size = len(wanted)
    return wanted in (name.parts[:size], name.parts[-size:])


def resume_command(root: Path) -> str:
    """Return the command that continues the runs in a directory."""
    return console.command("evolve --resume", root)


# Output files:

DRAWN = (
    b'name="generator" content="matrixworld',
    b"Software\0matrixworld",
    b"/Creator (matrixworld",
    b"<dc:title>matrixworld<",
    b"!\xfe\x0bmatrixworld",  # comment of a GIF
    b"data\0\0\0\1\0\0\0\0matrixworld",  # comment of an MP4
)
"""What this package writes into pages and pictures."""


def check_outputs(*outputs: Path | None, force: bool, redraws: bool = True) -> None:
    """Raise click.UsageError for the first output file that must not, or cannot, be written.

    To be called before anything is played or written. Pages and pictures that this package has
    drawn are drawn again without a question, if `redraws`.
    """
    for file in outputs:
        if file is None or file == console.STDOUT:
            continue
        try:
            files.check_replaceable(file)
            TemporaryFile(dir=file.parent).close()
        except FileExistsError as error:
            # Even with --force: a directory may hold a run, and a link may point to any file.
            raise click.UsageError(str(error)) from error
        except OSError as error:
            expected = f"a directory in which files can be made, got {str(file.parent)!r}"
            raise click.UsageError(f"{file}: expected {expected} ({error.strerror})") from error
        if file.exists() and not force:
            content = file.read_bytes() if redraws else b""
            if not any(mark in content for mark in DRAWN):
                raise click.UsageError(f"{file}: exists; give --force to replace it")


def write_json(file: Path | None, values: Mapping[str, Any]) -> None:
    """Write values to what --json names, if it is given, and print the name of a file."""
    if file == console.STDOUT:
        click.echo(json.dumps(values, indent=2, allow_nan=False))
    elif file is not None:
        files.save_json(file, values)
        console.say(f"\nWritten: {file}")
