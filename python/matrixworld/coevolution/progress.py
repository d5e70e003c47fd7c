"""Progress of a run or a job; nothing is shown unless a `ProgressBar` is passed as `report`."""

from __future__ import annotations

import shutil
import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, TextIO

from tqdm import tqdm

SECONDS = 0.5
"""Minimum time between two updates, in seconds."""
MOST_RUNS = 16
"""Most runs in work that are shown."""
TENTH = 0.1
"""Share of the work from one line to the next, if there is no terminal."""

# What matters most comes first: in a narrow terminal tqdm cuts the line at its right end.
LINE = "{percentage:3.0f}%  {remaining} left, {rate_fmt}, {n_fmt} of {total_fmt}, {desc}"
"""The parts of a line, as tqdm names them."""
BAR = LINE.replace("%  ", "%|{bar:16}| ")
"""The same with a bar; 60 columns show bar, time left and rate."""
STARTING = "{percentage:3.0f}%|{bar:16}| {n_fmt} of {total_fmt}, {desc}"
"""The line of a bar before anything has been played: there is no rate yet."""

JOB = ""
"""Name of the bar of the job, or of the only run."""


@dataclass(frozen=True)
class Progress:
    """Progress of a run, or of a job of several runs.

    Parameters
    ----------
    what : str
        What the run is doing; of a job, how many runs have ended.
    done, total : int
        Episodes played, and all of them. As long as runs of a job have not begun, its `total` is an
        estimate from the others.
    before : int, optional
        Episodes of `done` that were played before this start: they do not count for the rate.
    runs : mapping of str to Progress, optional
        The runs of a job that are in work, by name.
    """

    what: str
    done: int
    total: int
    before: int = 0
    runs: Mapping[str, Progress] = field(default_factory=dict)

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


class ProgressBar:
    """Rate and time left: bars in a terminal, one for each run in work; else plain lines.

    Parameters
    ----------
    unit : str, optional
        Name of the counted items.
    stream : TextIO, optional
        Where the progress is shown. The default is standard error.
    clock : callable, optional
        Returns the time in seconds.

    Examples
    --------
    ::

        with ProgressBar() as bar:
            race.run(bar)
        with ProgressBar() as bar:
            evolve(settings, "my-races", report=bar)
    """

    def __init__(
        self,
        unit: str = "matches",
        stream: TextIO | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._unit, self._stream, self._clock = unit, stream or sys.stderr, clock
        self._began: float | None = None
        self._next_time, self._next_share = 0.0, 0.0
        self._bars: dict[str, tqdm[None]] = {}

    def __call__(self, progress: Progress) -> None:
        """Show the progress of a run, or of a job with all its runs in work."""
        now = self._clock()
        if self._began is None:
            self._began, self._next_time, self._next_share = now, now, progress.share + TENTH
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
        # The lowest first: the line of the job stays.
        for bar in reversed(self._bars.values()):
            bar.close()

    def _draw(self, progress: Progress) -> None:
        # The last line stays free, else every update scrolls.
        most = max(1, min(MOST_RUNS, shutil.get_terminal_size().lines - 3))
        runs = dict(list(progress.runs.items())[:most])
        for name in self._bars.keys() - runs.keys() - {JOB}:
            self._bars.pop(name).close()
        self._draw_bar(JOB, progress.what, progress)
        for name, each in runs.items():
            self._draw_bar(name, f"{name}: {each.what}", each)

    def _draw_bar(self, name: str, what: str, progress: Progress) -> None:
        if name not in self._bars:
            self._bars[name] = tqdm(
                desc=what, total=progress.total, initial=progress.done, leave=name == JOB,
                unit=f" {self._unit}", unit_scale=True, dynamic_ncols=True, bar_format=STARTING,
                file=self._stream,
            )  # fmt: skip
        bar = self._bars[name]
        if name == JOB:
            bar.initial = progress.before  # more and more runs tell what was played before
        bar.total, bar.n = progress.total, min(progress.done, progress.total)
        bar.bar_format = BAR if bar.n > bar.initial else STARTING
        bar.set_description_str(what)

    def _write(self, progress: Progress, seconds: float) -> None:
        """Write a line if another tenth has been done since the last line."""
        # Shares such as 0.1 + 0.1 + 0.1 are inexact: the line at 30% must not wait for 30.01%.
        if progress.share < self._next_share - 1e-9:
            return
        self._next_share = progress.share + TENTH
        runs = [f"{name} {each.share:.0%}" for name, each in progress.runs.items()]
        shown = [*runs[:MOST_RUNS], *["..."] * (len(runs) > MOST_RUNS)]
        line = tqdm.format_meter(
            progress.done, progress.total, seconds, prefix=", ".join([progress.what, *shown]),
            unit=f" {self._unit}", unit_scale=True, bar_format=LINE, initial=progress.before,
        )  # fmt: skip
        self._stream.write(f"{line}\n")
        self._stream.flush()
