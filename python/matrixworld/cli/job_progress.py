"""Progress of a job of several runs: bars in a terminal, else plain lines."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TextIO

from matrixworld.cli.console import ProgressLines
from matrixworld.coevolution import JobProgress, ProgressBars
from matrixworld.coevolution.many.watch import JobReport

MOST_NAMES = 16
"""Most runs that a line names."""


@contextmanager
def job_progress(stream: TextIO | None = None) -> Iterator[JobReport]:
    """Show the progress of a job on a stream, by default standard error."""
    out = sys.stderr if stream is None else stream
    # Bars redraw their lines, which makes a log file unreadable.
    if out.isatty():
        with ProgressBars(out) as bars:
            yield bars
    else:
        yield JobLines(out)


class JobLines:
    """A plain line at each tenth of a job, with its rate, the time left, and the runs in work.

    Parameters
    ----------
    stream : TextIO
        Where the lines go.
    """

    def __init__(self, stream: TextIO) -> None:
        self._lines = ProgressLines(stream)

    def __call__(self, progress: JobProgress) -> None:
        """Write a line if it is time for one."""
        running = [f"{name} {each.share:.0%}" for name, each in progress.running.items()]
        more = ["..."] if len(running) > MOST_NAMES else []
        what = ", ".join([progress.counts, *running[:MOST_NAMES], *more])
        self._lines(what, progress.done, progress.total, progress.before)
