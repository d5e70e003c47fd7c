"""A lock file, so that two processes do not write to one run directory."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

if sys.platform == "win32":
    import msvcrt

    def _lock(handle: int) -> None:
        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
else:
    import fcntl

    def _lock(handle: int) -> None:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)


class LockedError(RuntimeError):
    """Another process is at work in the directory."""


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Hold the lock file `path` inside the with block; LockedError if another process does.

    The system lets go of the lock when its process ends, however it ends; the file stays.
    """
    handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
    try:
        try:
            _lock(handle)
        except (BlockingIOError, PermissionError) as error:
            raise LockedError(f"{path.parent}: another process is running there") from error
        except OSError as error:
            error.filename = str(path)  # a file system without locks does not say where
            raise
        yield
    finally:
        os.close(handle)
