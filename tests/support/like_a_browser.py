"""Makes this process like a page with Pyodide: one thread, no other process, fewer modules.

Import it before anything else, in a process of its own.
"""

import _thread
import os
import sys
import threading
from typing import Any, NoReturn

MISSING = {
    *("_multiprocessing", "_posixshmem", "curses", "fcntl", "pwd", "readline", "resource"),
    *("termios", "moocore"),  # DEAP's own dependency has no wheel for browsers
}


class Without:
    """A finder of modules that does not find those that a browser lacks."""

    def __init__(self, finder: Any) -> None:
        self.finder = finder

    def __getattr__(self, name: str) -> Any:
        return getattr(self.finder, name)

    def find_spec(self, name: str, *more: Any) -> Any:
        return None if name in MISSING else self.finder.find_spec(name, *more)


def refuse(*given: Any, **options: Any) -> NoReturn:
    raise RuntimeError("can't start new thread")


sys.meta_path[:] = map(Without, sys.meta_path)
for missing in MISSING:
    sys.modules.pop(missing, None)
_thread.start_new_thread = threading._start_new_thread = refuse  # type: ignore[attr-defined]
os.fork = refuse
os.cpu_count = lambda: 1
vars(os).pop("sched_getaffinity", None)
