"""Bars on a terminal: one of all runs of a job, and one of each run in work."""

from __future__ import annotations

import shutil
import sys
import time
from types import TracebackType
from typing import TextIO

from tqdm import tqdm

from matrixworld.coevolution.many.watch import JobProgress

MOST_BARS = 16
"""Most runs in work that have a bar of their own."""
LAYOUT = "{percentage:3.0f}%|{bar:16}| {desc}"
"""The parts of a line, as tqdm names them."""


class ProgressBars:
    """The progress of a job, as the `report` of `evolve_many`.

    Parameters
    ----------
    stream : TextIO, optional
        The terminal. The default is standard error.

    Examples
    --------
    ::

        with ProgressBars() as bars:
            evolve_many(settings, "my-races", report=bars)
    """

    def __init__(self, stream: TextIO | None = None) -> None:
        self._stream = sys.stderr if stream is None else stream
        # The last line stays free, else every update scrolls.
        self._most = max(1, min(MOST_BARS, shutil.get_terminal_size().lines - 3))
        self._began = time.monotonic()
        self._bars: list[tqdm[None]] = []

    def __call__(self, progress: JobProgress) -> None:
        """Draw all bars again."""
        self._show(0, f"{self._speed(progress)}, {progress.counts}", progress.done, progress.total)
        running = list(progress.running.items())[: self._most]
        for row, (name, each) in enumerate(running, start=1):
            self._show(row, f"{name}: {each.what}", each.done, each.total)
        for bar in self._bars[len(running) + 1 :]:
            bar.clear()

    def __enter__(self) -> ProgressBars:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        # The lowest first: the line of the job stays.
        for bar in reversed(self._bars):
            bar.close()

    def _speed(self, progress: JobProgress) -> str:
        """Return time left and rate. tqdm's own rate would count what was done before."""
        rate = (progress.done - progress.before) / max(time.monotonic() - self._began, 1e-9)
        left = tqdm.format_interval((progress.total - progress.done) / rate) if rate > 0 else "?"
        return f"{left} left, {tqdm.format_sizeof(rate)} matches/s"

    def _show(self, row: int, what: str, done: int, total: int) -> None:
        if row == len(self._bars):
            bar: tqdm[None] = tqdm(
                total=total, position=row, leave=row == 0, file=self._stream, bar_format=LAYOUT,
                dynamic_ncols=True,
            )  # fmt: skip
            self._bars.append(bar)
        bar = self._bars[row]
        bar.total, bar.n = total, min(done, total)
        bar.set_description_str(what, refresh=False)
        bar.refresh()
