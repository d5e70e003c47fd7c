"""Sizes that cannot fit are refused before anything is allocated or written.

Estimates are sums of the largest arrays. What Python and the libraries need themselves, about
100 MB, is not counted.
"""

from __future__ import annotations

import os
from pathlib import Path

EPISODE_BYTES = 240
"""Statistics of an episode, as `rollout` holds them until it returns: twice."""

_SMALL = 2**26  # 64 MiB: to read what is available would take longer than such an allocation
_MEMINFO = Path("/proc/meminfo")
_GROUP = Path("/sys/fs/cgroup")


class OutOfMemoryError(ValueError):
    """Something needs more memory than this machine has available."""


def check_memory(what: str, **parts: int) -> None:
    """Raise OutOfMemoryError if `what` needs more bytes than are available, in all its parts."""
    needed = sum(parts.values())
    available = available_memory() if needed > _SMALL else None
    if available is not None and needed > available:
        largest = max(parts, key=parts.__getitem__)
        raise OutOfMemoryError(
            f"{what}: expected to need at most {available / 10**9:,.1f} GB of memory, which are "
            f"available, got an estimate of {needed / 10**9:,.1f} GB, of which {largest}: "
            f"{parts[largest] / 10**9:,.1f} GB"
        )


def available_memory() -> int | None:
    """Return the bytes that this process can still get without swapping; None where unknown."""
    limits = [
        limit for limit in (_system(), _control_group(), _address_space()) if limit is not None
    ]
    return max(0, min(limits)) if limits else None


def _system() -> int | None:
    if _MEMINFO.is_file():
        lines = (line.split() for line in _MEMINFO.read_text(encoding="ascii").splitlines())
        return next((1024 * int(line[1]) for line in lines if line[0] == "MemAvailable:"), None)
    try:  # elsewhere all memory is known at best
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, OSError, ValueError):  # Windows has none of these names
        return None


def _control_group() -> int | None:
    """Return what is left to a container."""
    try:
        limit = int((_GROUP / "memory.max").read_text(encoding="ascii"))
        held = dict(line.split() for line in (_GROUP / "memory.stat").read_text().splitlines())
        # Not memory.current, which counts files in the cache: the system drops them on demand.
        return limit - int(held["anon"])
    except (KeyError, OSError, ValueError):  # no group, another version, or the word "max"
        return None


def _address_space() -> int | None:
    """Return what ``ulimit -v`` leaves."""
    try:
        import resource

        limit, _ = resource.getrlimit(resource.RLIMIT_AS)
        if limit == resource.RLIM_INFINITY:
            return None
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
        return limit - pages * resource.getpagesize()
    except (ImportError, OSError, ValueError):
        return None
