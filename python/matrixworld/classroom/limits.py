"""What a submitted program may use, and how a process is kept to it."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

from matrixworld._util.checks import check_integer, check_number

MOST_SECONDS = 3600


@dataclass(frozen=True)
class Limits:
    """Limits of a submitted program.

    Parameters
    ----------
    seconds : int, optional
        Processor time of one match, in seconds. The default is 10.
    wait : float, optional
        Time by the clock that one answer may take, in seconds. The default is 30.
    in_all : float, optional
        Processor time of all matches of one submission, in seconds. The default is 200.
    memory : int, optional
        Memory beyond that of Python and NumPy themselves, in MiB. The default is 512.

    Raises
    ------
    ValueError, TypeError
        If a limit is out of range.
    """

    seconds: int = 10
    wait: float = 30.0
    in_all: float = 200.0
    memory: int = 512

    def __post_init__(self) -> None:
        check_integer("seconds", self.seconds, 1, MOST_SECONDS)
        check_integer("memory", self.memory, 16, 1 << 20)
        for name in ("wait", "in_all"):
            check_number(name, getattr(self, name), least=0.0, positive=True)


def apply(limits: Limits, files: int | None) -> None:
    """Limit this process. Limits cannot be raised again.

    Parameters
    ----------
    limits : Limits
        Time and memory.
    files : int or None
        Files that are open already: the process can then open no other one, write to none, and
        start no process. None: only time and memory are limited.
    """
    import resource

    hard = {"RLIMIT_AS": _address_space() + limits.memory * 2**20, "RLIMIT_CORE": 0}
    if files is not None:
        hard |= {
            "RLIMIT_FSIZE": 0,  # of regular files; connections and /dev/null have no size
            "RLIMIT_MEMLOCK": 0,
            "RLIMIT_NOFILE": files,
            "RLIMIT_NPROC": 0,  # not for root, which the filter of system calls stops
        }
    for name, value in hard.items():
        # macOS lacks some of them, and refuses a limit of the address space.
        if hasattr(resource, name) and not (name == "RLIMIT_AS" and sys.platform == "darwin"):
            resource.setrlimit(getattr(resource, name), (value, value))
    # The first signal can be caught, the second one, a second later, cannot.
    resource.setrlimit(resource.RLIMIT_CPU, (limits.seconds, limits.seconds + 1))


def _address_space() -> int:
    """Return the bytes of address space that this process uses already."""
    import resource

    status = Path("/proc/self/statm")
    return int(status.read_text().split()[0]) * resource.getpagesize() if status.exists() else 0
