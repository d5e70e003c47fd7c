"""Tournaments: the payoff matrix of two archives, each genome against each."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, as_completed
from functools import partial
from itertools import product
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_instance, check_integer, check_threads
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.types import Payoff
from matrixworld.play.matches import Plays
from matrixworld.play.rollout import Matches, Rollout, rollout
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import EnginePolicy, Population, check_team

Block = TypeVar("Block")

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
        Called after each row of the matrix with the number of episodes played so far.
    executor : concurrent.futures.Executor, optional
        Plays the rows, each with `threads` threads, by default one. Without an executor they are
        played here, one after the other. The result is the same.

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
    generations = (range(start, start + n) for start, n in zip(first, size, strict=True))
    seeds = np.array([evaluation_seed(seed, g, h) for g, h in product(*generations)], np.uint64)
    columns = np.arange(size[1])
    # One row at a time, so that the progress can be reported.
    rows = [
        partial(play, config, one, evaders, Matches.of(0, columns, row), episodes=episodes)
        for one, row in zip(each_genome(pursuers), seeds.reshape(size), strict=True)
    ]
    kept: dict[str, NDArray[Any]] = {}
    played = 0
    for row, statistics in play_blocks(rows, threads, executor):
        for name in STATISTICS:
            found = getattr(statistics, name)
            if name not in kept:
                kept[name] = np.empty((size[0], *found.shape), found.dtype)
            kept[name][row] = found
        played += statistics.length.size
        on_row(played)
    # Capture rates and lengths keep single episodes, from which intervals are computed.
    return Payoff(
        capture_rates=kept["capture_rate"].astype(np.float32),
        lengths=kept["length"].astype(np.int32),
        **{name: kept[name].mean(axis=2) for name in MEANS},
    )


def play_blocks(
    blocks: Sequence[Callable[..., Block]], threads: int | None, executor: Executor | None
) -> Iterator[tuple[int, Block]]:
    """Yield the number of each block of matches and what it returned.

    Blocks are functions of their threads, which are called here in order, or by an executor.
    """
    if executor is None:
        for number, play in enumerate(blocks):
            yield number, play(threads=threads)
        return
    check_instance("executor", executor, Executor)
    futures = {
        executor.submit(play, threads=threads or 1): number for number, play in enumerate(blocks)
    }
    try:
        for future in as_completed(futures):
            # Popped, so that the statistics are not held twice.
            yield futures.pop(future), future.result()
    finally:
        # After an error or Ctrl-C.
        for future in futures:
            future.cancel()


def team_size(team: Plays) -> int:
    """Return how many candidates a team has: its genomes, or one."""
    return len(team.genomes) if isinstance(team, Population) else 1


def each_genome(team: Plays) -> list[Any]:
    """Return each genome of a team as a population, or what else plays for it."""
    if not isinstance(team, Population):
        return [team]
    return [Population(genome[None], team.network) for genome in team.genomes]
