"""What commands print: progress of a job, notes and warnings, wrapped text, tables."""

from __future__ import annotations

import shlex
import shutil
import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click
from tqdm import tqdm

from matrixworld._util.files import printable
from matrixworld._util.readable import table_lines
from matrixworld.coevolution.progress import ProgressBar

INTERRUPTED = 130
"""Exit code of a program that Ctrl-C has ended: 128 + SIGINT, as shells report it."""

TERMS = "Terms are explained in docs/glossary.md."
WIDEST = 80
"""Columns of printed text, also in a wider terminal."""


def progress(unit: str = "matches") -> ProgressBar:
    """Return what shows progress on standard error: bars in a terminal, else lines."""
    return ProgressBar(unit, sys.stderr)


TO_STDOUT = "matrixworld.json"
"""Key in the context of a command whose numbers take standard output, and its text the other."""


def say(text: object = "", *, bold: bool = False) -> None:
    """Print text, whatever names and files have brought into it; all commands print so."""
    context = click.get_current_context(silent=True)
    click.secho(printable(text), bold=bold, err=context is not None and TO_STDOUT in context.meta)


def say_to_stdout(values: str) -> None:
    """Print JSON, whose escapes need no cleaning, where --json asks for standard output."""
    click.echo(values)


def note(text: str) -> None:
    """Write a line to standard error, above a progress bar if there is one."""
    # A plain print would break the bar's line in two.
    tqdm.write(printable(text), file=sys.stderr)


@contextmanager
def warnings_as_notes() -> Iterator[None]:
    """Print each warning that is meant for users as a line, when it is raised."""
    with warnings.catch_warnings():
        # "always": the second run of a job may raise the same warning from the same line.
        warnings.simplefilter("always", UserWarning)
        plain = warnings.showwarning

        def show(message: Warning | str, category: type[Warning], *place: Any, **more: Any) -> None:
            # Other warnings, such as those of libraries, are for developers: they keep their form.
            if issubclass(category, UserWarning):
                note(f"Warning: {message}")
            else:
                plain(message, category, *place, **more)

        warnings.showwarning = show
        yield


def print_wrapped(text: str) -> None:
    """Print each line of a text as an indented paragraph as wide as the terminal."""
    width = min(WIDEST, shutil.get_terminal_size().columns)
    for line in text.splitlines():
        say(click.wrap_text(line, width, initial_indent="  ", subsequent_indent="    "))


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


def in_words(seconds: float) -> str:
    """Return a duration, such as "2.5 minutes"."""
    # From one and a half units on: "80 seconds" reads better than "1.3 minutes".
    for unit, length in (("hours", 3600.0), ("minutes", 60.0)):
        if seconds >= 1.5 * length:
            return f"{seconds / length:.{0 if seconds >= 10 * length else 1}f} {unit}"
    return f"{seconds:.{0 if seconds >= 10 else 1}f} seconds"
