"""Tournaments: the payoff matrix of two archives, each genome against each."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor, as_completed
from dataclasses import dataclass, replace
from itertools import product
from math import isqrt
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_instance, check_integer, check_number, check_threads
from matrixworld._util.memory import EPISODE_BYTES, check_memory
from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.types import Seeds
from matrixworld.play.rollout import EpisodeStatistics, Matches, Rollout, rollout
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Population, TeamPolicy, check_team

BLOCK_SECONDS = 20.0
"""Seconds of work in a block that an executor plays: many times what it takes to hand it out, and
short enough to keep all workers busy to the end."""
MEASURED_SECONDS, MEASURED_PAIRS = 0.3, 20
"""Most seconds and pairs by which the work of a pair is measured."""

MEANS = ("collisions", "faults", "agent_steps", "pursuer_survivors", "evader_survivors")
"""Statistics of which a payoff holds the mean over the episodes."""
STATISTICS = ("capture_rate", "length", *MEANS)
"""All statistics that a payoff needs."""

Key = TypeVar("Key")


def tournament(
    config: WorldConfig,
    pursuers: TeamPolicy,
    evaders: TeamPolicy,
    *,
    seed: int,
    episodes: int,
    threads: int | None = None,
    play: Rollout = rollout,
    first: tuple[int, int] = (0, 0),
    on_row: Callable[[int], None] = lambda played: None,
    executor: Executor | None = None,
    block_seconds: float = BLOCK_SECONDS,
) -> Payoff:
    """Play every pursuer against every evader.

    Parameters
    ----------
    config : WorldConfig
        The world.
    pursuers, evaders : Population or str
        Populations of G and H genomes, or names of scripts (then G or H is 1).
    seed : int
        Seed of the run.
    episodes : int
        Episodes of each pair.
    threads : int, optional
        Threads that `play` may use. By default all cores. Results do not depend on it.
    play : callable, optional
        Plays matches: a pure function with the arguments of `matrixworld.rollout`.
    first : tuple of int, optional
        Generations of the first pursuer and of the first evader, which the seeds depend on.
    on_row : callable, optional
        Called after each row of the matrix, or each block, with the number of episodes played so
        far.
    executor : concurrent.futures.Executor, optional
        Plays blocks of the matrix, each with `threads` threads, by default one. Without an executor
        the rows are played here, one after the other. The result is the same.
    block_seconds : float, optional
        About the work of a block, measured with some pairs on this machine.

    Returns
    -------
    Payoff
        Results of G x H pairs.

    Notes
    -----
    The seed of a pair is ``evaluation_seed(seed, pursuer generation, evader generation)``. It does
    not depend on the other pairs, so that each can be replayed alone.

    References
    ----------
    Floreano, D. and Nolfi, S. (1997). God save the red queen! Competition in co-evolutionary
    robotics. Genetic Programming 1997. (The "master tournament".)
    """
    for name, team in (("pursuers", pursuers), ("evaders", evaders)):
        check_team(name, team)
    check_integer("episodes", episodes, 1)
    check_threads(threads)
    check_number("block_seconds", block_seconds, least=0.0, positive=True)
    size = _count(pursuers), _count(evaders)
    # The statistics of all episodes are kept until the end.
    check_memory("tournament", episodes=EPISODE_BYTES * size[0] * size[1] * episodes)
    generations = (range(start, start + n) for start, n in zip(first, size, strict=True))
    seeds = [evaluation_seed(seed, g, h) for g, h in product(*generations)]
    table = np.array(seeds, dtype=np.uint64).reshape(size)
    pairs, cells = Pairs(config, pursuers, evaders, table, episodes, play), _Cells(size, episodes)
    if executor is None:
        # One row at a time, so that the progress can be reported.
        for block in _blocks(size, (1, size[1])):
            on_row(cells.fill(block, play_pairs(pairs.part(block), threads)))
    else:
        check_instance("executor", executor, Executor)
        blocks = _blocks(size, _block_size(size, block_seconds / pairs.seconds()))
        parts = ((block, pairs.part(block)) for block in blocks)
        for block, statistics in play_parts(parts, executor, threads or 1):
            on_row(cells.fill(block, statistics))
    return cells.payoff()


def play_parts(
    parts: Iterable[tuple[Key, Pairs]], executor: Executor, threads: int
) -> Iterator[tuple[Key, EpisodeStatistics]]:
    """Yield the keys and the statistics of pairs in the order in which an executor ends them."""
    futures = {executor.submit(play_pairs, pairs, threads): key for key, pairs in parts}
    try:
        for future in as_completed(futures):
            # Popped, so that the statistics are not held twice.
            yield futures.pop(future), future.result()
    finally:
        # After an error or Ctrl-C.
        for future in futures:
            future.cancel()


@dataclass(frozen=True)
class Pairs:
    """Every one of some pursuers against every one of some evaders, as for `tournament`."""

    config: WorldConfig
    pursuers: TeamPolicy
    evaders: TeamPolicy
    seeds: Seeds
    """Shape (G, H)."""
    episodes: int
    play: Rollout

    def part(self, block: Block) -> Pairs:
        """Return the pairs of a block, with no other genomes."""
        pursuers, evaders = _part(self.pursuers, block.rows), _part(self.evaders, block.columns)
        return replace(self, pursuers=pursuers, evaders=evaders, seeds=self.seeds[block])

    def seconds(self) -> float:
        """Return the mean time in which one thread plays a pair, of pairs all over the matrix."""
        size = self.seeds.size
        numbers = np.linspace(0, size - 1, min(size, MEASURED_PAIRS)).astype(int).tolist()
        times: list[float] = []
        while numbers and sum(times) < MEASURED_SECONDS:
            g, h = divmod(numbers.pop(0), self.seeds.shape[1])
            began = time.perf_counter()
            play_pairs(self.part(Block(slice(g, g + 1), slice(h, h + 1))), 1)
            times.append(time.perf_counter() - began)
        return sum(times) / len(times)


def play_pairs(pairs: Pairs, threads: int | None) -> EpisodeStatistics:
    """Play G * H matches, row by row, wherever this is called."""
    rows, columns = np.indices(pairs.seeds.shape)
    matches = Matches.of(rows.ravel(), columns.ravel(), pairs.seeds.ravel())
    return pairs.play(
        pairs.config,
        pairs.pursuers,
        pairs.evaders,
        matches,
        episodes=pairs.episodes,
        threads=threads,
    )


class Block(NamedTuple):
    """A part of the matrix: some rows and columns."""

    rows: slice
    columns: slice


class _Cells:
    """The statistics of all pairs, shape (G, H, episodes, ...), filled block by block."""

    def __init__(self, size: tuple[int, int], episodes: int) -> None:
        self._shape = (*size, episodes)
        self._arrays: dict[str, NDArray[Any]] = {}
        self._played = 0

    def fill(self, block: Block, statistics: EpisodeStatistics) -> int:
        """Take the statistics of a block; return the number of episodes played so far."""
        for name in STATISTICS:
            found = getattr(statistics, name)
            if name not in self._arrays:
                self._arrays[name] = np.empty((*self._shape, *found.shape[2:]), found.dtype)
            cells = self._arrays[name][block]
            cells[...] = found.reshape(cells.shape)
        self._played += int(statistics.length.size)
        return self._played

    def payoff(self) -> Payoff:
        """Return the payoff, when all blocks are there."""
        # Capture rates and lengths keep single episodes, from which intervals are computed.
        means = {name: self._arrays[name].mean(axis=2) for name in MEANS}
        return Payoff(
            capture_rates=self._arrays["capture_rate"].astype(np.float32),
            lengths=self._arrays["length"].astype(np.int32),
            **means,
        )


def _count(team: TeamPolicy) -> int:
    return 1 if isinstance(team, str) else len(team.genomes)


def _part(team: TeamPolicy, numbers: slice) -> TeamPolicy:
    return team if isinstance(team, str) else Population(team.genomes[numbers], team.network)


def _block_size(size: tuple[int, int], pairs: float) -> tuple[int, int]:
    """Return rows and columns of blocks of about so many pairs, nearly square.

    A square block has the fewest genomes, which travel with it.
    """
    most = max(1, int(min(pairs, size[0] * size[1])))
    rows = min(size[0], isqrt(most))
    columns = min(size[1], most // rows)
    return min(size[0], most // columns), columns


def _blocks(size: tuple[int, int], block: tuple[int, int]) -> Iterator[Block]:
    for g in range(0, size[0], block[0]):
        for h in range(0, size[1], block[1]):
            rows = slice(g, min(g + block[0], size[0]))
            yield Block(rows, slice(h, min(h + block[1], size[1])))
