"""Memory that worlds, matches and arrays need: estimated and refused before it is allocated.

An estimate is the largest number of bytes held at one time, of what grows with sizes that a caller
chooses. The constants are bytes that were measured on x86-64 with the engine as it is. What Python
and the libraries need themselves, about 100 MB, is not counted.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from matrixworld._util.checks import usable_cores

if TYPE_CHECKING:  # worlds and networks check their memory, so they import this module
    from matrixworld.world.config import WorldConfig
    from matrixworld.world.policy import Network

NUMBER = 4
"""Bytes of a float32: a gene, a weight, an activation."""
WORLD, WORLD_AGENT, WORLD_CELL = 800, 24, 3
"""Bytes of a world in a batch: of its own, per agent, and per cell where obstacles are drawn."""
THREAD_AGENT, THREAD_CELL = 150, 28
"""Bytes with which a thread plays any number of worlds of one configuration."""
MOST_OBSTACLE_SUMS = 2**24
"""Most bytes of sums over obstacles that a thread keeps of a network."""
EPISODE, KEPT_EPISODE = 232, 120
"""Bytes of the statistics of an episode: while `rollout` returns, and afterwards."""
EPISODES_PER_PIECE = 16
"""Episodes of a match that a thread takes at once."""

_SMALL = 2**26  # 64 MiB: to read what is available would take longer than such an allocation
_MEMINFO = Path("/proc/meminfo")
_GROUP = Path("/sys/fs/cgroup")


class OutOfMemoryError(ValueError):
    """Something needs more memory than this machine has available."""


def check_memory(what: str, needed: int | Mapping[str, int]) -> None:
    """Raise OutOfMemoryError if something needs more memory than is available.

    Parameters
    ----------
    what : str
        What needs it, for the message.
    needed : int or mapping of str to int
        The estimate in bytes: of the whole, or of its parts by name.

    Raises
    ------
    OutOfMemoryError
        If the estimate exceeds `available_memory`. Never where that is unknown.
    """
    parts = {"": needed} if isinstance(needed, int) else needed
    whole = sum(parts.values())
    available = available_memory() if whole > _SMALL else None
    if available is None or whole <= available:
        return
    largest = max(parts, key=parts.__getitem__)
    share = f", of which {largest}: {in_words(parts[largest])}" if largest else ""
    raise OutOfMemoryError(
        f"{what}: expected to need at most {in_words(available)} of memory, which are available, "
        f"got an estimate of {in_words(whole)}{share}"
    )


def in_words(size: int) -> str:
    """Return a number of bytes with a unit, such as "3.2 GB"."""
    for unit, step in (("EB", 10**18), ("PB", 10**15), ("TB", 10**12), ("GB", 10**9)):
        if size >= 1000 * step:
            return f"more than 1000 {unit}"
        if size >= step:
            return f"{size / step:.1f} {unit}"
    return f"{size / 10**6:.0f} MB"


def available_memory() -> int | None:
    """Return the bytes that this process can still get without swapping; None where unknown.

    Returns
    -------
    int or None
        The smallest of: what the system has available, what is left of the limit of the control
        group (containers), and what is left of the address space (``ulimit -v``). Where the system
        tells its memory only, all of it.
    """
    known = [
        limit for limit in (_system(), _control_group(), _address_space()) if limit is not None
    ]
    return max(0, min(known)) if known else None


def _system() -> int | None:
    if _MEMINFO.is_file():
        lines = (line.split() for line in _MEMINFO.read_text(encoding="ascii").splitlines())
        sizes = {name: 1024 * int(size) for name, size, *_ in lines}
        return sizes.get("MemAvailable:")
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, OSError, ValueError):  # Windows has none of these names
        return None


def _control_group() -> int | None:
    try:
        limit = int((_GROUP / "memory.max").read_text(encoding="ascii"))
        held = dict(line.split() for line in (_GROUP / "memory.stat").read_text().splitlines())
        # Not memory.current, which counts files in the cache: the system drops them on demand.
        return limit - int(held["anon"])
    except (KeyError, OSError, ValueError):  # no group, another version, or the word "max"
        return None


def _address_space() -> int | None:
    try:
        import resource

        limit, _ = resource.getrlimit(resource.RLIMIT_AS)
        if limit == resource.RLIM_INFINITY:
            return None
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
        return limit - pages * resource.getpagesize()
    except (ImportError, OSError, ValueError):
        return None


def thread_count(threads: int | None, pieces: int) -> int:
    """Return the number of threads that share pieces of work; None: one per usable core."""
    return min(threads or usable_cores(), pieces)


def batch_memory(config: WorldConfig, n_worlds: int, threads: int | None) -> int:
    """Return the estimate of a batch without the arrays that it writes into.

    Parameters
    ----------
    config : WorldConfig
        The configuration.
    n_worlds : int
        Worlds.
    threads : int or None
        Threads; None: one per usable core.
    """
    drawn = WORLD_CELL * config.rows * config.cols if config.density else 0
    world = WORLD + WORLD_AGENT * config.n_agents + drawn
    return n_worlds * world + thread_count(threads, n_worlds) * thread_memory(config)


def thread_memory(config: WorldConfig) -> int:
    """Return the estimate of what a thread needs besides the worlds; a `World` needs as much."""
    return THREAD_CELL * config.rows * config.cols + THREAD_AGENT * config.n_agents


def matches_memory(
    config: WorldConfig,
    networks: Iterable[Network],
    *,
    matches: int,
    worlds: int,
    threads: int | None,
) -> int:
    """Return the estimate of a rollout: statistics of the episodes, worlds and networks.

    Parameters
    ----------
    config : WorldConfig
        The configuration.
    networks : iterable of Network
        The networks of the teams that have one. Their genomes are not counted.
    matches, worlds : int
        Matches, and episodes of each.
    threads : int or None
        Threads; None: one per usable core.
    """
    # A thread copies the genome that it plays; tables of the first layer are as large as its
    # weights at most. The worlds of a piece are decided for together.
    together = min(worlds, EPISODES_PER_PIECE) * config.n_agents
    each = thread_memory(config) + sum(
        2 * NUMBER * network.genome_size
        + NUMBER * together * sum(network.hidden)
        + (MOST_OBSTACLE_SUMS if config.density or config.map is not None else 0)
        for network in networks
    )
    pieces = matches * -(-worlds // EPISODES_PER_PIECE)
    return matches * worlds * EPISODE + thread_count(threads, pieces) * each
