"""Alarms: an end for code of the user that hangs."""

from __future__ import annotations

import signal
import threading
import time
from types import FrameType
from typing import Any

_AGAIN = 0.5
"""Seconds after which an alarm that was caught is raised again."""


_began: float | None = None


def busy_for() -> float:
    """Return for how many seconds the code inside an alarm has run; 0 outside of one.

    That code can switch the alarm off or catch what it raises. Another thread can look here.
    """
    began = _began
    return 0.0 if began is None else time.monotonic() - began


class TooSlowError(BaseException):
    """Code of the user takes longer than it may. No Exception, which that code might catch."""


class alarm:  # noqa: N801, a context manager that is used as a function
    """Raises TooSlowError where the code inside is after so many seconds; never for None.

    It needs the main thread of a system with alarm signals, of which nobody else makes use;
    otherwise nothing is raised.
    """

    def __init__(self, seconds: float | None) -> None:
        self._seconds = seconds
        self._before: Any = None

    def __enter__(self) -> None:
        global _began
        in_main = threading.current_thread() is threading.main_thread()
        if self._seconds is None or not in_main or not hasattr(signal, "setitimer"):
            return
        before = signal.getsignal(signal.SIGALRM)
        if before not in (signal.SIG_DFL, signal.SIG_IGN):
            return
        self._before = before
        signal.signal(signal.SIGALRM, _ring)
        _began = time.monotonic()
        signal.setitimer(signal.ITIMER_REAL, self._seconds, _AGAIN)

    def __exit__(self, *error: object) -> None:
        global _began
        if self._before is not None:
            _began = None  # from now on it does not ring
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, self._before)


def _ring(number: int, frame: FrameType | None) -> None:
    if _began is not None:
        raise TooSlowError
