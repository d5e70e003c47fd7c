"""Progress of a job of several runs: one bar, or lines now and then."""

from __future__ import annotations

import sys
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TextIO

from tqdm import tqdm

from matrixworld.coevolution import ProgressBar, Report

SHARE = 0.1
"""Share of a job from one line to the next where there is no terminal."""
SLOW = 10.0


class ProgressLines:
    """Plain lines with rate and time left, for output that is no terminal."""

    def __init__(
        self,
        stream: TextIO,
        clock: Callable[[], float] = time.monotonic,
        unit: str = "matches",
    ) -> None:
        self._stream, self._clock, self._unit = stream, clock, unit
        self._began: tuple[float, int] | None = None
        self._next = 0.0

    def __call__(self, what: str, done: int, total: int) -> None:
        """Write a line if enough has been done since the last."""
        if self._began is None:
            self._began = self._clock(), done
            self._next = done / total + SHARE
        if done / total >= self._next - 1e-9:
            self._next = done / total + SHARE
            seconds, since = self._clock() - self._began[0], done - self._began[1]
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
    """What is called as report(what is going on, matches done, matches in all).

    stream: None for standard error
    unit: what is counted, if not matches
    """
    out = sys.stderr if stream is None else stream
    if out.isatty():
        with ProgressBar(unit) as bar:
            yield bar
    else:
        yield ProgressLines(out, unit=unit)


def note(text: str) -> None:
    """Write a line to standard error, above a bar if there is one."""
    tqdm.write(text, file=sys.stderr)


@contextmanager
def warnings_as_notes() -> Iterator[None]:
    """Tell warnings meant for users in a line each, as they come."""
    with warnings.catch_warnings():
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
            if issubclass(category, UserWarning):
                note(f"Warning: {message}")
            else:
                plain(message, category, filename, lineno, file, line)

        warnings.showwarning = show
        yield
