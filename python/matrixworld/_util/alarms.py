"""Alarms: an end for code of the user that hangs."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

_AGAIN = 0.5
"""Seconds after which an alarm that was caught is raised again."""


_began: float | None = None


def busy_for() -> float:
    """Return for how many seconds the code inside an alarm has run; 0 outside of one.

    That code can switch the alarm off or catch what it raises. Another thread can look here.
    """
    return 0.0 if _began is None else time.monotonic() - _began


class TooSlowError(BaseException):
    """Code of the user takes longer than it may. No Exception, which that code might catch."""


@contextmanager
def alarm(seconds: float | None) -> Iterator[None]:
    """Raise TooSlowError where the code inside is after so many seconds; never for None.

    It needs the main thread of a system with alarm signals, of which nobody else makes use;
    otherwise nothing is raised.
    """
    in_main = threading.current_thread() is threading.main_thread()
    if seconds is None or not in_main or not hasattr(signal, "setitimer"):
        yield
        return
    before = signal.getsignal(signal.SIGALRM)
    if before not in (signal.SIG_DFL, signal.SIG_IGN, _ring):
        yield
        return
    global _began
    _began = time.monotonic()
    signal.signal(signal.SIGALRM, _ring)
    signal.setitimer(signal.ITIMER_REAL, seconds, _AGAIN)
    try:
        yield
    finally:
        _began = None
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def _ring(number: int, frame: FrameType | None) -> None:
    raise TooSlowError
