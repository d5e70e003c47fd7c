"""Progress of a job of several runs: a bar for each run in work and one in all, or plain lines."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TextIO

from tqdm import tqdm

from matrixworld.cli.console import ProgressLines
from matrixworld.coevolution import JobProgress, RunProgress
from matrixworld.coevolution.many.watch import JobReport

MOST_BARS = 16
"""Most runs that have a bar of their own."""
ALL = "{percentage:3.0f}%|{bar:16}| {desc}"
"""The parts of the line of all runs, as tqdm names them."""
ONE = "{percentage:3.0f}%|{bar:16}| {desc}"
"""The same of one run."""


@contextmanager
def job_progress(stream: TextIO | None = None) -> Iterator[JobReport]:
    """Show the progress of a job on a stream, by default standard error."""
    out = sys.stderr if stream is None else stream
    if not out.isatty():
        yield JobLines(out)
        return
    bars = JobBars(out)
    try:
        yield bars
    finally:
        bars.close()


def counts(progress: JobProgress) -> str:
    """Return how many runs have ended."""
    failed = f", {progress.failed} failed" if progress.failed else ""
    return f"{progress.finished} of {progress.asked} runs{failed}"


class JobLines:
    """Plain lines: one at each tenth of the job, and one when a run has failed.

    Parameters
    ----------
    stream : TextIO
        Where the lines go.
    """

    def __init__(self, stream: TextIO) -> None:
        self._lines = ProgressLines(stream)

    def __call__(self, progress: JobProgress) -> None:
        """Write a line if it is time for one."""
        shown = [f"{name} {_share(each):.0%}" for name, each in progress.running.items()]
        what = ", ".join([counts(progress), *shown[:MOST_BARS]])
        self._lines(what, progress.done, progress.total)


class JobBars:
    """Bars on a terminal: the job in the first line, runs in work in the next ones.

    Parameters
    ----------
    stream : TextIO
        The terminal.
    """

    def __init__(self, stream: TextIO) -> None:
        rows = shutil.get_terminal_size().lines
        # The last line stays free, else every update scrolls.
        self._most = max(1, min(MOST_BARS, rows - 3))
        self._stream = stream
        self._bars: list[tqdm[None]] = []

    def __call__(self, progress: JobProgress) -> None:
        """Draw all bars again."""
        self._show(0, counts(progress), progress.done, progress.total)
        running = list(progress.running.items())[: self._most]
        for row, (name, each) in enumerate(running, start=1):
            self._show(row, f"{name}: {each.what}", each.done, each.total)
        for bar in self._bars[len(running) + 1 :]:
            bar.clear()

    def close(self) -> None:
        """Leave the line of the job on the terminal, and clear the others."""
        for bar in self._bars:
            bar.close()

    def _show(self, row: int, what: str, done: int, total: int) -> None:
        if row == len(self._bars):
            bar = tqdm(
                total=total, position=row, leave=row == 0, file=self._stream, bar_format=ONE,
                dynamic_ncols=True,
            )  # fmt: skip
            self._bars.append(bar)
        bar = self._bars[row]
        bar.total, bar.n = total, done
        bar.set_description_str(what, refresh=False)
        bar.refresh()


def _share(run: RunProgress) -> float:
    return run.done / max(run.total, 1)
