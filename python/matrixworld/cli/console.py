"""What commands print: text, tables, notes and warnings; and the command to type next."""

from __future__ import annotations

import shlex
import shutil
import sys
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

import click
from tqdm import tqdm

from matrixworld._util.files import printable
from matrixworld._util.readable import table_lines
from matrixworld._util.teams import PLURALS
from matrixworld.coevolution.evaluation.scores import BestScript, knows
from matrixworld.coevolution.games.pursuit import PursuitSettings
from matrixworld.coevolution.groups import RunGroup
from matrixworld.coevolution.settings.race_settings import RaceSettings
from matrixworld.coevolution.types import Team
from matrixworld.world.config import world_name

TERMS = "What to do next: docs/my_result.md. Terms: docs/glossary.md."
STDOUT = Path("-")
"""The file of a command whose numbers take standard output, and its text the other."""


def say(text: object = "", *, bold: bool = False) -> None:
    """Print text, whatever names and files have brought into it; all commands print so."""
    context = click.get_current_context(silent=True)
    err = context is not None and context.params.get("json_file") == STDOUT
    click.secho(printable(text), bold=bold, err=err)


def note(text: str) -> None:
    """Write a line to standard error, above a progress bar if there is one."""
    # A plain print would break the bar's line in two.
    tqdm.write(printable(text), file=sys.stderr)


@contextmanager
def warnings_as_notes() -> Iterator[None]:
    """Print each warning as a line, when it is raised."""
    with warnings.catch_warnings():
        # "always": the second run of a job may raise the same warning from the same line.
        warnings.simplefilter("always", UserWarning)
        warnings.showwarning = lambda message, *place: note(f"Warning: {message}")
        yield


def print_head(text: str) -> None:
    """Print what a table is about, in bold, below an empty line."""
    say(f"\n{text}", bold=True)


def width() -> int:
    """Return the columns of the terminal."""
    return shutil.get_terminal_size().columns


def print_wrapped(text: str) -> None:
    """Print each line of a text as an indented paragraph as wide as the terminal."""
    for line in text.splitlines():
        say(click.wrap_text(line, width(), initial_indent="  ", subsequent_indent="    "))


def print_table(rows: Sequence[Sequence[str]], align: str) -> None:
    """Print rows of cells in columns, as `table_lines` does, the first row in bold."""
    rows = [[printable(cell) for cell in row] for row in rows]  # as wide as they are printed
    for number, lines in enumerate(table_lines(rows, align)):
        for line in lines:
            say(line, bold=number == 0)


def command(name: str, *words: Path | str) -> str:
    """Return a command as a user can type it: paths are quoted, other words stay as they are."""
    quoted = [shlex.quote(str(word)) if isinstance(word, Path) else word for word in words]
    return " ".join(["matrixworld", name, *quoted])


def counted(number: int, noun: str) -> str:
    """Return a number with its noun, such as "1 race" or "2,000 races"."""
    return f"{number:,} {noun if number == 1 else f'{noun}s'}"


def print_missing(group: RunGroup) -> None:
    """Name the seeds of a group that are not finished, if there are any."""
    if group.missing:
        what = "seed" if len(group.missing) == 1 else "seeds"
        print_wrapped(f"Not finished: {what} {', '.join(map(str, group.missing))}.")


def seeds_finished(group: RunGroup) -> str:
    """Return how many seeds of a group are finished, such as "9 of 10 seeds finished"."""
    return f"{len(group.runs)} of {len(group.runs) + len(group.missing)} seeds finished"


def place_of(settings: RaceSettings) -> str:
    """Return the game and its teams in words, such as "courtyard (O), 4 pursuers and 4 evaders"."""
    name = settings.game.variant
    if not isinstance(settings.game, PursuitSettings):
        return f"{name}, {' and '.join(dict.fromkeys(settings.teams))}"
    world = settings.game.world
    if world_name(world):
        name = f"{world_name(world)} ({name})"
    pursuers = counted(world.n_pursuers, "pursuer")
    return f"{name}, {pursuers} and {counted(world.n_evaders, 'evader')}"


def beyond_views(group: RunGroup, scripts: Mapping[Team, BestScript]) -> str:
    """Return what teams and the best scripts know beyond their views; empty if it is nothing."""
    known = {}
    for team, script in scripts.items():
        known[PLURALS[team]] = knows(group.runs[0].teams[team].policy)
        known[script.name] = knows(script.name)
    beyond = "; ".join(f"{name}: {', '.join(each)}" for name, each in known.items() if each)
    return f"Known beyond the view: {beyond}." if beyond else ""
