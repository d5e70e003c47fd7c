"""The task of a worker: one run from its start, or from its checkpoint, to its end."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from matrixworld.coevolution.many.job import settings_from_text
from matrixworld.coevolution.many.run_progress import RunProgress, clear_progress, write_progress
from matrixworld.coevolution.many.stop_mark import StopMark

from matrixworld._util.files import LockedError
from matrixworld.coevolution.runs.start import finish
from matrixworld.coevolution.storage.run_directory import CONFIG, COUNTS, RunDirectory

LOCK_WAIT = 120.0
"""Seconds for which a locked run directory is waited for. A worker that was declared lost may only
be frozen, and still holds the lock."""
LOOK = 0.5
"""Seconds between two looks at the stop mark."""

Result = TypeVar("Result")
Values = dict[str, str | int | float]


def run_task(
    settings: str,
    directory: str,
    name: str,
    token: str,
    threads: int = 1,
    lock_wait: float = LOCK_WAIT,
) -> Values:
    """Finish one run of a job, wherever this is called.

    Parameters
    ----------
    settings : str
        Settings of the run, from `settings_to_text`.
    directory, name : str
        Directory of the job, and name of the run in it.
    token : str
        Token of the start of the job (see `StopMark`).
    threads : int, optional
        Threads that play matches. Results do not depend on it.
    lock_wait : float, optional
        Seconds for which a locked run directory is waited for.

    Returns
    -------
    dict of str to str, int or float
        ``name``; ``seconds`` that the task took; of the run ``stages``, ``training_matches``,
        ``training_steps``, ``training_agent_steps``, ``evaluation_matches``, and its
        ``disengagement`` in words.

    Raises
    ------
    StoppedError
        If the job was stopped; the files hold the last checkpoint.
    LockedError
        If another process still holds the run directory after `lock_wait` seconds.

    Notes
    -----
    Other errors are those of `finish`. Only text and numbers go in and out, so that every executor
    can carry them.
    """
    began = time.monotonic()
    root = Path(directory)
    mark, path = StopMark(root, token), root / name
    mark.check()
    run = waiting(
        lambda: finish(
            settings_from_text(settings), path, threads=threads, report=_Look(root, name, mark)
        ),
        path, mark, lock_wait,
    )  # fmt: skip
    clear_progress(root, name)
    return {"name": name, "seconds": time.monotonic() - began, **counts_of(run.files)}


def counts_of(files: RunDirectory) -> Values:
    """Return what a finished run has played, and its disengagements in words."""
    numbers = files.summary()
    played = {key: numbers[key] for key in COUNTS}
    return {**played, "disengagement": "; ".join(numbers.get("disengagement", []))}


def waiting(
    play: Callable[[], Result], path: Path, mark: StopMark | None, seconds: float
) -> Result:
    """Return what `play` returns; repeat it while another process holds the run directory.

    Parameters
    ----------
    play : callable
        Plays the run.
    path : Path
        The run directory.
    mark : StopMark or None
        Ends the waiting, too.
    seconds : float
        Longest time to wait.
    """
    until = time.monotonic() + seconds
    while True:
        try:
            return play()
        except LockedError:
            if time.monotonic() > until:
                raise
        except FileExistsError:
            # The process that held the directory has made the run since: now it can be resumed.
            if not (path / CONFIG).exists():
                raise
        time.sleep(LOOK)
        if mark is not None:
            mark.check()


class _Look:
    """A report of a run that looks at the stop mark and writes the progress, twice a second."""

    def __init__(self, root: Path, name: str, mark: StopMark) -> None:
        self._root, self._name, self._mark = root, name, mark
        self._next = 0.0
        self._before: int | None = None

    def __call__(self, what: str, done: int, total: int) -> None:
        """Look, unless the last look is less than half a second ago."""
        self._before = done if self._before is None else self._before
        # Called after each epoch, which may take less than a millisecond.
        if time.monotonic() >= self._next:
            self._next = time.monotonic() + LOOK
            self._mark.check()
            write_progress(self._root, self._name, RunProgress(what, done, total, self._before))
