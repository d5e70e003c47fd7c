"""Makes this process like a page with Pyodide: one thread, no other process, fewer modules.

Import it before anything else, in a process of its own.
"""

import _thread
import os
import sys
import threading

MISSING = {
    *("_multiprocessing", "_posixshmem", "curses", "fcntl", "pwd", "readline", "resource"),
    *("termios", "moocore"),  # DEAP's own dependency has no wheel for browsers
}


class Without:
    """A finder of modules that does not find those that a browser lacks."""

    def __init__(self, finder):
        self.finder = finder

    def __getattr__(self, name):
        return getattr(self.finder, name)

    def find_spec(self, name, *more):
        return None if name in MISSING else self.finder.find_spec(name, *more)


def refuse(*given, **options):
    raise RuntimeError("can't start new thread")


sys.meta_path[:] = map(Without, sys.meta_path)
for missing in MISSING:
    sys.modules.pop(missing, None)
_thread.start_new_thread = threading._start_new_thread = refuse
os.fork = refuse
os.cpu_count = lambda: 1
vars(os).pop("sched_getaffinity", None)
