"""Tournaments: the payoff matrix of two archives, each genome against each."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, as_completed
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import (
    EPISODE_BYTES,
    check_instance,
    check_integer,
    check_memory,
    check_number,
    check_threads,
)
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.types import Payoff, Seeds
from matrixworld.play.rollout import EpisodeStatistics, Matches, Rollout, rollout
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import EnginePolicy, Population, check_team

BLOCK_SECONDS = 20.0
"""Seconds of work in a block that an executor plays: many times what it takes to hand it out, and
short enough to keep all workers busy to the end."""
MEASURED_SECONDS, MEASURED_PAIRS = 0.3, 20
"""Most seconds and pairs by which the work of a pair is measured."""

MEANS = ("collisions", "faults", "agent_steps", "pursuer_survivors", "evader_survivors")
"""Statistics of which a payoff holds the mean over the episodes."""
STATISTICS = ("capture_rate", "length", *MEANS)
"""All statistics that a payoff needs."""


def tournament(
    config: WorldConfig,
    pursuers: EnginePolicy,
    evaders: EnginePolicy,
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
    episodes = check_integer("episodes", episodes, 1)
    check_threads(threads)
    size = team_size(pursuers), team_size(evaders)
    # The statistics of all episodes are kept until the end.
    check_memory("tournament", episodes=EPISODE_BYTES * size[0] * size[1] * episodes)
    generations = (range(start, start + n) for start, n in zip(first, size, strict=True))
    seeds = np.array([evaluation_seed(seed, g, h) for g, h in product(*generations)], np.uint64)
    pairs = Pairs.all_of(config, pursuers, evaders, seeds, episodes, play)
    kept: dict[str, NDArray[Any]] = {}
    played = 0
    # One row at a time, so that the progress can be reported.
    blocks = play_blocks([pairs], size[1], threads, executor, block_seconds)
    for (_, block), statistics in blocks:
        for name in STATISTICS:
            found = getattr(statistics, name)
            if name not in kept:
                kept[name] = np.empty((len(seeds), *found.shape[1:]), found.dtype)
            kept[name][block] = found
        played += statistics.length.size
        on_row(played)
    cells = {name: array.reshape(*size, *array.shape[1:]) for name, array in kept.items()}
    # Capture rates and lengths keep single episodes, from which intervals are computed.
    return Payoff(
        capture_rates=cells["capture_rate"].astype(np.float32),
        lengths=cells["length"].astype(np.int32),
        **{name: cells[name].mean(axis=2) for name in MEANS},
    )


@dataclass(frozen=True)
class Pairs:
    """Pairs of pursuers and evaders that play one match each."""

    config: WorldConfig
    pursuers: EnginePolicy
    evaders: EnginePolicy
    matches: Matches
    episodes: int
    rollout: Rollout

    @classmethod
    def all_of(
        cls,
        config: WorldConfig,
        pursuers: EnginePolicy,
        evaders: EnginePolicy,
        seeds: Seeds,
        episodes: int,
        play: Rollout,
    ) -> Pairs:
        """Return all pairs, with the seed of each, row by row: evaders 0, 1, ... of pursuer 0."""
        rows, columns = np.indices((team_size(pursuers), team_size(evaders)))
        matches = Matches.of(rows.ravel(), columns.ravel(), seeds)
        return cls(config, pursuers, evaders, matches, episodes, play)

    def part(self, block: slice) -> Pairs:
        """Return some of the pairs, with no other genomes than theirs: they may travel."""
        pursuers, rows = _met(self.pursuers, self.matches.pursuer[block])
        evaders, columns = _met(self.evaders, self.matches.evader[block])
        matches = Matches.of(rows, columns, self.matches.seed[block])
        return replace(self, pursuers=pursuers, evaders=evaders, matches=matches)

    def play(self, threads: int | None) -> EpisodeStatistics:
        """Play all matches, wherever this is called."""
        sides = self.pursuers, self.evaders
        return self.rollout(
            self.config, *sides, self.matches, episodes=self.episodes, threads=threads
        )

    def seconds(self) -> float:
        """Return the mean time in which one thread plays a pair, of pairs from all of them."""
        count = len(self.matches.seed)
        numbers = np.linspace(0, count - 1, min(count, MEASURED_PAIRS)).astype(int).tolist()
        times: list[float] = []
        while numbers and sum(times) < MEASURED_SECONDS:
            number = numbers.pop(0)
            began = time.perf_counter()
            self.part(slice(number, number + 1)).play(1)
            times.append(time.perf_counter() - began)
        return sum(times) / len(times)


def play_blocks(
    each: Sequence[Pairs],
    most: int,
    threads: int | None,
    executor: Executor | None,
    block_seconds: float,
) -> Iterator[tuple[tuple[int, slice], EpisodeStatistics]]:
    """Yield the statistics of all pairs in blocks, each with its number in `each` and its slice.

    Here blocks of `most` pairs are played in order; an executor plays blocks that take about
    `block_seconds` in any order.
    """
    check_number("block_seconds", block_seconds, least=0.0, positive=True)
    size = most
    if executor is not None:
        check_instance("executor", executor, Executor)
        size = max(1, int(block_seconds / each[0].seconds()))
    blocks = (
        ((number, slice(first, first + size)), pairs)
        for number, pairs in enumerate(each)
        for first in range(0, len(pairs.matches.seed), size)
    )
    if executor is None:
        for key, pairs in blocks:
            yield key, pairs.part(key[1]).play(threads)
        return
    futures = {
        executor.submit(Pairs.play, pairs.part(key[1]), threads or 1): key for key, pairs in blocks
    }
    try:
        for future in as_completed(futures):
            # Popped, so that the statistics are not held twice.
            yield futures.pop(future), future.result()
    finally:
        # After an error or Ctrl-C.
        for future in futures:
            future.cancel()


def team_size(team: EnginePolicy) -> int:
    """Return how many candidates a team has: its genomes, or one."""
    return len(team.genomes) if isinstance(team, Population) else 1


def _met(team: EnginePolicy, numbers: NDArray[Any]) -> tuple[EnginePolicy, NDArray[Any]]:
    """Return the genomes of a team that play, and where each of `numbers` is among them."""
    if not isinstance(team, Population):
        return team, numbers
    met, places = np.unique(numbers, return_inverse=True)
    if len(met) == len(team.genomes):
        return team, numbers
    return Population(team.genomes[met], team.network), places
