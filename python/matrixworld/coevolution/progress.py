"""Progress of a run; nothing is shown unless a `ProgressBar` is passed as `report`."""

from __future__ import annotations

from collections.abc import Callable
from types import TracebackType

from tqdm import tqdm

SECONDS = 0.5
"""Minimum time between two updates of the bar, in seconds."""

# What matters most comes first: in a narrow terminal tqdm cuts the line at its right end.
LAYOUT = "{percentage:3.0f}%|{bar:16}| {remaining} left, {rate_fmt}, {n_fmt} of {total_fmt}, {desc}"
"""The parts of the bar's line, as tqdm names them; 60 columns show bar, time left and rate."""

Report = Callable[[str, int, int], None]
"""Called often, as ``report(activity, episodes played, total episodes)``."""


def silent(activity: str, done: int, total: int) -> None:
    """Report nothing."""


class ProgressBar:
    """A tqdm bar on the terminal, with rate and remaining time.

    Parameters
    ----------
    unit : str, optional
        Name of the counted items.

    Examples
    --------
    ::

        with ProgressBar() as bar:
            race.run(bar)
    """

    def __init__(self, unit: str = "matches") -> None:
        self._unit = unit
        self._bar: tqdm[None] | None = None

    def __call__(self, activity: str, done: int, total: int) -> None:
        """Show the activity, and that `done` of `total` episodes have been played."""
        if self._bar is None:
            self._bar = tqdm(
                total=total,
                initial=done,
                unit=f" {self._unit}",
                unit_scale=True,
                mininterval=SECONDS,
                bar_format=LAYOUT,
                dynamic_ncols=True,
            )
        self._bar.set_description_str(activity, refresh=False)
        self._bar.update(done - self._bar.n)

    def __enter__(self) -> ProgressBar:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._bar is not None:
            self._bar.close()
