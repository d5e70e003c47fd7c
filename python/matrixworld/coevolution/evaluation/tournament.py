"""Tournaments: the payoff matrix of two archives, each genome against each."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.checks import check_integer, check_threads
from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.config import WorldConfig
from matrixworld.memory import EPISODE, check_memory
from matrixworld.policy import TeamPolicy, check_team
from matrixworld.rollout import EpisodeStatistics, Matches, Rollout, rollout


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
    rows = []
    n_evaders = _count(evaders)
    # The statistics of all episodes are kept until the end.
    check_memory("tournament", EPISODE * _count(pursuers) * n_evaders * episodes)
    for g in range(_count(pursuers)):
        # One row at a time, so that the progress can be reported.
        seeds = [evaluation_seed(seed, first[0] + g, first[1] + h) for h in range(n_evaders)]
        matches = Matches.of(g, np.arange(n_evaders), np.array(seeds, dtype=np.uint64))
        rows.append(play(config, pursuers, evaders, matches, worlds=episodes, threads=threads))
        on_row(len(rows) * n_evaders * episodes)
    return _payoff(rows)


def _count(team: TeamPolicy) -> int:
    return 1 if isinstance(team, str) else len(team.genomes)


def _payoff(rows: list[EpisodeStatistics]) -> Payoff:
    # Capture rates and lengths keep single episodes, from which intervals are computed.
    def stacked(name: str) -> NDArray[Any]:
        return np.stack([getattr(row, name) for row in rows])

    return Payoff(
        capture_rates=stacked("capture_rate").astype(np.float32),
        lengths=stacked("length").astype(np.int32),
        collisions=stacked("collisions").mean(axis=2),
        faults=stacked("faults").mean(axis=2),
        agent_steps=stacked("agent_steps").mean(axis=2),
        pursuer_survivors=stacked("pursuer_survivors").mean(axis=2),
        evader_survivors=stacked("evader_survivors").mean(axis=2),
    )
