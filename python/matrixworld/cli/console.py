"""What commands print: progress of a job, notes and warnings, wrapped text, tables."""

from __future__ import annotations

import shlex
import shutil
import sys
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from itertools import zip_longest
from pathlib import Path
from typing import TextIO

import click
from tqdm import tqdm

from matrixworld.coevolution.progress import ProgressBar, Report

INTERRUPTED = 130
"""Exit code of a program that Ctrl-C has ended: 128 + SIGINT, as shells report it."""

TERMS = "Terms are explained in docs/glossary.md."
WIDEST = 100
"""Columns of printed text, also in a wider terminal."""

SHARE = 0.1
"""Share of a job from one progress line to the next."""
SLOW = 10.0
"""Rates below it, in units a second, are shown with a decimal."""


class ProgressLines:
    """Progress as plain lines with rate and time left, for output that is not a terminal.

    Parameters
    ----------
    stream : TextIO
        Where the lines go.
    clock : callable, optional
        Returns the time in seconds.
    unit : str, optional
        What is counted.
    """

    def __init__(
        self,
        stream: TextIO,
        clock: Callable[[], float] = time.monotonic,
        unit: str = "matches",
    ) -> None:
        self._stream, self._clock, self._unit = stream, clock, unit
        self._began: tuple[float, int] | None = None
        self._next = 0.0

    def __call__(self, what: str, done: int, total: int, before: int | None = None) -> None:
        """Write a line if another tenth of the job has been done since the last line.

        Parameters
        ----------
        what : str
            What is being done.
        done, total : int
            What has been done, and all of it.
        before : int, optional
            What had been done before the job was resumed. By default as of the first call.
        """
        if self._began is None:
            # A resumed job begins with matches done already: they do not count for the rate.
            self._began = self._clock(), done
            self._next = done / total + SHARE
        # Shares such as 0.1 + 0.1 + 0.1 are inexact: the line at 30% must not wait for 30.01%.
        if done / total >= self._next - 1e-9:
            self._next = done / total + SHARE
            earlier = self._began[1] if before is None else before
            seconds, since = self._clock() - self._began[0], done - earlier
            rate = since / seconds if seconds else 0.0
            left = tqdm.format_interval((total - done) / rate) if rate else "?"
            shown = f"{rate:,.0f}" if rate >= SLOW else f"{rate:.1f}"
            self._stream.write(
                f"{done / total:4.0%}  {done:,} of {total:,} {self._unit}, {shown} a second, "
                f"{left} left ({what})\n"
            )
            self._stream.flush()


@contextmanager
def progress(stream: TextIO | None = None, unit: str = "matches") -> Iterator[Report]:
    """Show the progress of a job: a bar in a terminal, else lines.

    Parameters
    ----------
    stream : TextIO, optional
        Where it goes. The default is standard error.
    unit : str, optional
        What is counted.

    Yields
    ------
    callable
        To be called as ``report(what, done, total)``.
    """
    out = sys.stderr if stream is None else stream
    # A bar redraws its line, which makes a log file unreadable.
    if out.isatty():
        with ProgressBar(unit) as bar:
            yield bar
    else:
        yield ProgressLines(out, unit=unit)


def part_of_job(report: Report, place: str, others: int, whole: int) -> Report:
    """Return a report of one part of a job, of which other parts have done `others` of `whole`."""
    return lambda what, done, total: report(place + what, others + done, whole)


def note(text: str) -> None:
    """Write a line to standard error, above a progress bar if there is one."""
    # A plain print would break the bar's line in two.
    tqdm.write(text, file=sys.stderr)


@contextmanager
def warnings_as_notes() -> Iterator[None]:
    """Print each warning that is meant for users as a line, when it is raised."""
    with warnings.catch_warnings():
        # "always": the second run of a job may raise the same warning from the same line.
        warnings.simplefilter("always", UserWarning)
        plain = warnings.showwarning

        def show(
            message: Warning | str,
            category: type[Warning],
            filename: str,
            lineno: int,
            file: TextIO | None = None,
            line: str | None = None,
        ) -> None:
            # Other warnings, such as those of libraries, are for developers: they keep their form.
            if issubclass(category, UserWarning):
                note(f"Warning: {message}")
            else:
                plain(message, category, filename, lineno, file, line)

        warnings.showwarning = show
        yield


def print_wrapped(text: str) -> None:
    """Print each line of a text as an indented paragraph as wide as the terminal."""
    width = min(WIDEST, shutil.get_terminal_size().columns)
    for line in text.splitlines():
        click.echo(click.wrap_text(line, width, initial_indent="  ", subsequent_indent="    "))


def print_table(rows: Sequence[Sequence[str]], align: str) -> None:
    """Print rows of cells in columns, the first row in bold.

    Parameters
    ----------
    rows : sequence of sequences of str
        The cells, of all rows equally many. A cell may have several lines.
    align : str
        A format character for each column: ``"<"`` left, ``">"`` right.
    """
    columns = zip(*rows, strict=True)
    widths = [max(len(line) for cell in c for line in cell.split("\n")) for c in columns]
    for number, row in enumerate(rows):
        for line in zip_longest(*(cell.split("\n") for cell in row), fillvalue=""):
            cells = (f"{c:{a}{w}}" for c, a, w in zip(line, align, widths, strict=True))
            click.secho("  ".join(cells).rstrip(), bold=number == 0)


def command(name: str, *words: Path | str) -> str:
    """Return a command as a user can type it: paths are quoted, other words stay as they are."""
    quoted = [shlex.quote(str(word)) if isinstance(word, Path) else word for word in words]
    return " ".join(["matrixworld", name, *quoted])
