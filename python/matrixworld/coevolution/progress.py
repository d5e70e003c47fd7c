"""Progress of a run or a job; nothing is shown unless a `ProgressBar` is passed as `report`."""

from __future__ import annotations

import logging
import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TextIO

from tqdm import tqdm

LOG = logging.getLogger("matrixworld")
"""Told when a run begins or goes on, has saved a stage, and ends; shows nothing by itself."""
SECONDS = 0.5  # minimum time between two updates, in seconds
TENTH = 0.1  # share of the work from one line to the next, if there is no terminal

SHARES = 1000  # parts into which a share is divided

LINE = "{desc}: {percentage:3.0f}%  {remaining} left"  # the parts of a line, as tqdm names them
BAR = LINE.replace("%  ", "%|{bar:16}| ")  # the same with a bar
STARTING = "{desc}: {percentage:3.0f}%|{bar:16}|"
"""The line of a bar before anything has been played: the time that is left is not known yet."""


@dataclass(frozen=True)
class Progress:
    """What a run or a job is doing: `what`, and `done` of `total` epochs.

    The evaluation counts as the epochs that take as long. Those played `before` this start do not
    count for the rate.
    """

    what: str
    done: int
    total: int
    before: int = 0

    @property
    def share(self) -> float:
        """The part that is done, from 0 to 1."""
        return self.done / max(self.total, 1)


Report = Callable[[Progress], None]
"""Called often while something is played: by many runs twice a second, by one after each epoch."""
OnEpoch = Callable[[Mapping[str, Any]], None]
"""Called with a row for each epoch that a run plays: the columns of log.csv, with ``run`` (the name
of the run's directory, or its name in a job) and ``seed``."""


class StopRun(Exception):  # noqa: N818, it is no error of the run
    """Raised by the caller's `on_epoch` to stop a run, which the same call continues later."""


def silent(progress: Progress) -> None:
    """Report nothing."""


def part_of(report: Report, number: int, count: int, place: str = "") -> Report:
    """Return what reports part `number` of `count` about equally long ones, as one of the whole."""

    def report_part(part: Progress) -> None:
        done = number * part.total + part.done
        report(Progress(f"{place}{part.what}", done, count * part.total, part.before))

    return report_part


class ProgressBar:
    """What is being done, and the time left: a bar in a terminal, else plain lines.

    It is shown on a `stream`, by default standard error, by a `clock` that returns seconds. In the
    first seconds, until `after`, nothing is shown: what takes no longer needs no bar.
    """

    def __init__(
        self,
        stream: TextIO | None = None,
        clock: Callable[[], float] = time.monotonic,
        after: float = 0.0,
    ) -> None:
        self._stream = stream or sys.stderr
        self._clock = clock
        self._show_from = clock() + after
        self._began: float | None = None
        self._next_time = 0.0
        self._next_share = 0.0
        self._bar: tqdm[None] | None = None
        self._what: str | None = None  # the part of `share`, and what was done of it before
        self._before = 0

    def share(self, what: str, share: float) -> None:
        """Show the share of a part of some work; the time left is that of the part."""
        done = round(SHARES * share)
        if what != self._what or self._began is None:  # it begins with this share
            self._close()
            self._what = what
            self._before = done
            self._began = None
        self(Progress(what, done, SHARES, self._before))

    def __call__(self, progress: Progress) -> None:
        """Show the progress of a run, or of a job."""
        now = self._clock()
        if now < self._show_from:
            return
        if self._began is None:
            self._began = now
            self._next_time = now
            self._next_share = progress.share + TENTH
        # Bars redraw their lines, which makes a log file unreadable.
        if not self._stream.isatty():
            self._write(progress, now - self._began)
        # Epochs may take less than a millisecond.
        elif now >= self._next_time or progress.share >= 1.0:
            self._next_time = now + SECONDS
            self._draw(progress)

    def __enter__(self) -> ProgressBar:
        return self

    def __exit__(self, *error: object) -> None:
        self._close()

    def _close(self) -> None:
        if self._bar is not None:
            self._bar.close()
            self._bar = None

    def _draw(self, progress: Progress) -> None:
        if self._bar is None:
            self._bar = tqdm(
                desc=progress.what, initial=progress.done, dynamic_ncols=True,
                bar_format=STARTING, file=self._stream,
            )  # fmt: skip
        bar = self._bar
        bar.initial = progress.before  # more and more runs tell what was played before
        bar.total = progress.total
        bar.n = min(progress.done, progress.total)
        bar.bar_format = BAR if bar.n > bar.initial else STARTING
        bar.set_description_str(progress.what)

    def _write(self, progress: Progress, seconds: float) -> None:
        """Write a line if another tenth has been done since the last line."""
        # Shares such as 0.1 + 0.1 + 0.1 are inexact: the line at 30% must not wait for 30.01%.
        if progress.share < self._next_share - 1e-9:
            return
        self._next_share = progress.share + TENTH
        line = tqdm.format_meter(
            progress.done, progress.total, seconds, prefix=progress.what, bar_format=LINE,
            initial=progress.before,
        )  # fmt: skip
        self._stream.write(f"{line}\n")
        self._stream.flush()
